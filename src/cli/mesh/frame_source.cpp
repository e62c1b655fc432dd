// SPDX-License-Identifier: MIT
#include "cli/mesh/frame_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <touchstone/error.hpp>

#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "frames/content.hpp"
#include "io/fail.hpp"
#include "io/sha256.hpp"
#include "io/times.hpp"
#include "sequence/checks.hpp"

namespace touchstone::cli {
namespace {

using frames::Frame;
using sequence::FrameName;

/// How an array is read that has no elements.
frames::ReadOptions array_options(const frames::ReadOptions& reading) {
  frames::ReadOptions array;
  array.dataset = reading.dataset;
  array.checkpoint = reading.checkpoint;
  return array;
}

constexpr const char* kAdvice =
    "--in-order takes the files as the frames of one animation in the order given, and --check --in-order asks about "
    "each by itself; --parts asks about the parts of one scene together, and with --check at rest";

std::vector<FrameName> frames_to_check(const MeshRunOptions& options, const frames::ReadOptions& reading) {
  const auto gaps = options.check ? sequence::Gaps::allowed : sequence::Gaps::refused;
  const auto files = options.in_order ? sequence::as_given(options.files)
                                      : sequence::in_order(sequence::expand_patterns(options.files), gaps, kAdvice);
  auto names = sequence::frames_of(files, reading);
  // An animation may hold a frame or return to it, but not be one frame all the time.
  const bool moves = std::any_of(names.begin(), names.end(), [&](const FrameName& name) {
    return name.index > 0 || !sequence::same_file(name.file, files.front());
  });
  if (options.check || !moves) sequence::refuse_repeats(files);
  if (options.check && names.empty()) throw Error("there is no frame in these files");
  if (!options.velocity.empty()) {
    if (names.size() != 1) {
      throw Error(
          fmt::format("--velocity: goes from one frame, and there are {}; without it each step goes from frame "
                      "to frame",
                      names.size()));
    }
    const auto format = frames::known_format_of(options.velocity);
    if (format && *format < frames::Format::npy) {
      io::fail(options.velocity,
               "is a mesh, whose positions are no velocities; --velocity takes an array, or text (.csv, .txt) with a "
               "row x,y,z for each vertex");
    }
    const bool is_text = frames::has_text_rows(options.velocity);
    const std::size_t count = is_text ? 1 : frames::frame_count(options.velocity, array_options(reading));
    if (count != 1) {
      io::fail(options.velocity, fmt::format("has {} frames; velocities are those of one step", grouped(count)));
    }
    names.push_back({options.velocity});
    names.back().shown_as = fmt::format("{} + {} {}", names.front().label(), options.dt, names.back().label());
  }
  if (!options.check && names.size() < 2) {
    throw Error(fmt::format("a step needs two frames, and there {} only {}; --check asks about frames at rest",
                            names.size() == 1 ? "is" : "are", names.size()));
  }
  return names;
}

/// The frame after the time dt: each coordinate is rounded once.
std::shared_ptr<const Frame> moved(const Frame& start, const FrameName& velocities, double dt,
                                   const frames::ReadOptions& reading, const sequence::Repairs& repairs) {
  const Frame velocity = frames::has_text_rows(velocities.file)
                             ? frames::read_text_frame(velocities.file, array_options(reading))
                             : frames::read_frame(velocities.file, 0, array_options(reading));
  const std::size_t vertices = start.topology->vertex_count;
  if (velocity.topology->vertex_count != vertices || velocity.topology->dimension != start.topology->dimension) {
    io::fail(velocities.file, fmt::format("has {} velocities of {} coordinates; the frame has {} vertices of {}",
                                          velocity.topology->vertex_count, velocity.topology->dimension, vertices,
                                          start.topology->dimension));
  }
  auto frame = std::make_shared<Frame>(start);
  for (std::size_t i = 0; i < frame->positions.size(); ++i) {
    frame->positions[i] = std::fma(dt, velocity.positions[i], frame->positions[i]);
  }
  frame->digest = io::sha256(fmt::format("{} {} {}", start.digest, velocity.digest, io::hexfloat(dt)));
  sequence::check_positions(*frame, velocities);
  repairs.check_welds(*frame, velocities);
  return frame;
}

std::vector<sequence::ScenePart> parts_of(const MeshRunOptions& options, const frames::ReadOptions& reading) {
  if (!options.as_parts) return {};
  return options.check ? sequence::parts_at_rest(options.files, reading)
                       : sequence::moving_parts(options.files, reading);
}

}  // namespace

bool may_differ(const MeshRunOptions& options) { return options.check && options.in_order; }

FrameSource::FrameSource(const MeshRunOptions& options)
    : options_(options),
      reading_{options.topology, options.dataset, options.triangulate, throw_if_interrupted},
      parts_(parts_of(options, reading_)),
      names_(options.as_parts ? sequence::frames_of(parts_) : frames_to_check(options, reading_)),
      repairs_(options.repairs, may_differ(options)),
      scene_(parts_, reading_, options.repairs) {}

std::optional<sequence::SceneFacts> FrameSource::scene() const {
  if (parts_.empty() || options_.check) return std::nullopt;
  return sequence::facts_of(parts_);
}

std::vector<std::string> FrameSource::files() const {
  std::vector<std::string> files;
  const auto take = [&](const std::vector<FrameName>& frames) {
    for (const FrameName& name : frames) {
      if (name.index == 0) files.push_back(name.file);
    }
  };
  for (const sequence::ScenePart& part : parts_) take(part.frames);
  if (parts_.empty()) take(names_);
  if (!options_.topology.empty()) files.push_back(options_.topology);
  return files;
}

std::shared_ptr<const Frame> FrameSource::read(std::size_t index) {
  const FrameName& name = names_[index];
  if (!parts_.empty()) return std::make_shared<Frame>(scene_.read(index));
  if (first_ != nullptr && !options_.velocity.empty()) return moved(*first_, name, options_.dt, reading_, repairs_);
  const auto earlier = first_ == nullptr ? nullptr : first_->topology;
  auto frame = std::make_shared<Frame>(frames::read_frame(name.file, name.index, reading_, earlier));
  repairs_.mend(*frame, name);
  sequence::check_positions(*frame, name);
  if (first_ == nullptr) first_ = frame;
  return frame;
}

const std::string& FrameSource::elements_file(std::size_t index) const {
  return options_.topology.empty() ? names_[index].file : options_.topology;
}

}  // namespace touchstone::cli
