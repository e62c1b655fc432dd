// SPDX-License-Identifier: MIT
#include "cli/mesh/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <utility>

#include <touchstone/error.hpp>
#include <touchstone/version.hpp>

#include "cli/mesh/frame_source.hpp"
#include "cli/mesh/mesh_animation.hpp"
#include "cli/mesh/output.hpp"
#include "cli/shared/animation_file.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/mesh_file_options.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/stoppable.hpp"
#include "cli/shared/progress/waiting_line.hpp"
#include "cli/shared/proofs/motion_proofs.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/times.hpp"
#include "sequence/checks.hpp"
#include "sequence/element_names.hpp"
#include "sequence/frame_list.hpp"
#include "sequence/parts/own_neighbours.hpp"
#include "sequence/report_json.hpp"

namespace touchstone::cli {
namespace {

using frames::Frame;
using sequence::FrameName;
using sequence::Question;

void check_files(const MeshRunOptions& options, const std::vector<std::string>& inputs) {
  if (options.pairs == "-") throw Error("--pairs: name a file to write");
  if (options.html == "-") throw Error("--html: name a file to write");
  if (options.json && options.report == "-")
    throw Error("--report: standard output has the lines of --json; name a file");
  const std::optional<std::string> journal = journal_path(options.report);
  if (options.resume && options.report == "-")
    throw Error("--resume: name the report's file, standard output has none");
  if (options.resume && !journal) {
    throw Error(fmt::format("--resume: {} is a pipe or device, and keeps nothing of an earlier run; name a file",
                            io::printable(options.report)));
  }
  std::vector<std::pair<std::string, std::string>> outputs;
  if (!options.report.empty() && options.report != "-") {
    outputs.emplace_back("--report", options.report);
    if (journal) outputs.emplace_back("--report", *journal);
  }
  if (!options.pairs.empty()) outputs.emplace_back("--pairs", options.pairs);
  if (!options.html.empty()) outputs.emplace_back("--html", options.html);
  for (const Kind kind : kKinds) {
    if (options.queries.empty()) break;
    const auto folder = std::filesystem::path(options.queries) / name_of(kind);
    for (const char* name : {"contacts.csv", "folds.csv"}) {
      outputs.emplace_back("--queries", (folder / name).string());
    }
  }
  MotionProofs::add_files(options.prove, outputs);
  check_mesh_outputs(outputs, inputs);
}

sequence::Heading heading_for(const MeshRunOptions& options, const FrameSource& source) {
  const std::vector<FrameName>& names = source.names();
  sequence::Heading heading;
  heading.program = version();
  heading.question = options.check ? Question::rest : Question::steps;
  heading.separation = options.separation.separation;
  heading.clearance = options.clearance;
  heading.classes = options.classes;
  if (heading.separation.distance == 0 && !heading.clearance) {
    heading.separation.metric = Metric::euclidean;  // it has no meaning
  }
  if (!options.velocity.empty()) heading.dt = options.dt;
  heading.scene = source.scene();
  heading.frame_count = names.size();
  std::vector<std::string> labels;
  for (const auto& name : names) labels.push_back(name.label());
  heading.list_digest = sequence::digest_of(labels);
  heading.shard = options.shard;
  const std::size_t items = sequence::item_count(heading.question, names.size());
  if (options.shard && options.shard->count > items) {
    throw Error(fmt::format("--shard {}/{}: there {} only {}, which at most {} can divide", options.shard->number,
                            options.shard->count, items == 1 ? "is" : "are",
                            counted(items, options.check ? "frame" : "step"), counted(items, "shard")));
  }
  return heading;
}

/// The names of parts belong to one mesh.
void check_parts(const MeshRunOptions& options, const std::vector<FrameName>& names) {
  if ((options.parts.empty() && !options.classes) || !may_differ(options) || names.size() == 1) return;
  throw Error(
      "--in-order: with --check each file is a mesh by itself, and parts are those of one mesh; check the files "
      "one by one");
}

/// The number of a vertex among the points.
std::uint32_t point_of(const proofs::MotionElements& elements, MeshIndex vertex) {
  const auto& points = elements.points;
  return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), vertex) - points.begin());
}

/// The elements of a motion. All of the mesh may move.
proofs::MotionElements motion_elements(const Mesh& mesh) {
  proofs::MotionElements elements{
      mesh.vertex_count(), proofs::colliding_vertices(mesh.edges(), mesh.points()), mesh.edges(), mesh.faces(), {}};
  const MeshElements all = mesh.elements();
  elements.groups = proofs::motion_groups(all.rules);
  for (const auto& [pair, distance] : all.pair_separations) {  // of --self: zero
    const auto first = pair.kind == Kind::edge_edge ? pair.first : point_of(elements, pair.first);
    const auto second = pair.kind == Kind::point_point ? point_of(elements, pair.second) : pair.second;
    elements.touching.push_back({pair.kind, first, second});
  }
  std::sort(elements.touching.begin(), elements.touching.end());
  return elements;
}

/// The positions of a frame; one in the plane has z = 0.
proofs::MotionFrame motion_frame(const Frame& frame) {
  const auto dimension = static_cast<std::size_t>(frame.topology->dimension);
  proofs::MotionFrame positions(frame.topology->vertex_count);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double* const x = &frame.positions[dimension * v];
    positions[v] = {x[0], x[1], dimension == 3 ? x[2] : 0};
  }
  return positions;
}

/// Checks frames one after the other.
class Checker {
 public:
  Checker(const MeshRunOptions& options, const FrameSource& source, MeshOutput& output,
          const sequence::Heading& heading, int threads, MotionProofs* proofs, MeshAnimation* animation)
      : options_(options),
        source_(source),
        names_(source.names()),
        output_(output),
        question_(heading.question),
        separation_(heading.separation),
        parts_(heading.parts),
        range_(sequence::range_of(heading)),
        how_{threads, heading.clearance, heading.classes, &interruption()},
        proofs_(proofs),
        animation_(animation) {}

  /// The mesh of the first frame, which was made already.
  void start_with(std::shared_ptr<const frames::Topology> topology, Mesh mesh) {
    topology_ = std::move(topology);
    mesh_ = std::move(mesh);
  }

  /// @param index  the frame's place in the sequence; they come in order
  void take(std::size_t index, std::shared_ptr<const Frame> frame) {
    const FrameName& name = names_[index];
    if (before_ != nullptr && !may_differ(options_)) {
      sequence::check_same_elements(*before_->topology, names_[index - 1], *frame->topology, name);
      if (!parts_.empty() || how_.classes) {
        sequence::check_same_parts(*before_->topology, names_[index - 1], *frame->topology, name);
      }
    }
    if (question_ == Question::rest && frame->topology != topology_) {
      mesh_ = sequence::mesh_of(*frame->topology, separation_, source_.elements_file(index), parts_);
      topology_ = frame->topology;
    }
    sequence::FrameEntry entry{name.label(), frame->digest};
    if (may_differ(options_)) entry.facts = sequence::facts_of(mesh_, *topology_);
    output_.add_frame(std::move(entry));
    const std::shared_ptr<const Frame> before = std::exchange(before_, frame);
    const bool rest = question_ == Question::rest || index == 0;
    if (rest) check(*frame, *frame);
    if (question_ == Question::steps && before != nullptr) check(*before, *frame);
    if (proofs_ != nullptr) proofs_->add(motion_frame(*frame));
    if (animation_ != nullptr) animation_->add_frame(index, name.label(), *frame);
  }

 private:
  /// Finds the next result, which is about these frames, or takes it from an earlier run.
  void check(const Frame& before, const Frame& after) {
    sequence::Finished next{sequence::result_at(question_, range_, results_), {before.digest}};
    if (next.result.step) next.digests.push_back(after.digest);
    const bool known = results_ < output_.finished().size();
    if (known) {
      const sequence::Finished& earlier = output_.finished()[results_];
      for (std::size_t i = 0; i < next.digests.size(); ++i) {
        if (earlier.digests[i] != next.digests[i]) refuse_changed(names_[next.result.frame + i]);
      }
      next.result = earlier.result;
    } else {
      ask(next.result, before, after);
    }
    ++results_;
    if (animation_ != nullptr) animation_->add_result(next.result, before, after);
    output_.add(std::move(next), before, after, known);
  }

  /// @param result  names its frame, and whether it is about a step
  void ask(sequence::Result& result, const Frame& before, const Frame& after) {
    const std::size_t index = result.frame;
    std::string what = io::printable(names_[index].label());
    if (result.step) what += " -> " + io::printable(names_[index + 1].label());
    waiting_.begin(fmt::format("{} of {}: {}", results_ + 1, sequence::result_count(question_, range_), what));
    result = stoppable([&] {
      return result.step ? sequence::check_step(mesh_, before, after, index, how_)
                         : sequence::check_frame(mesh_, before, index, how_);
    });
    waiting_.end();
  }

  [[noreturn]] void refuse_changed(const FrameName& name) const {
    const std::string what = options_.as_parts ? name.label() + ": a file of this frame"
                             : name.several    ? fmt::format("{}: frame {}", io::printable(name.file), name.index)
                                               : io::printable(name.file) + ": it";
    throw Error(fmt::format("{} has changed since {} was written; remove that to begin again", what,
                            io::printable(output_.finished_file())));
  }

  const MeshRunOptions& options_;
  const FrameSource& source_;
  const std::vector<FrameName>& names_;
  MeshOutput& output_;
  Question question_;
  Separation separation_;
  sequence::PartRules parts_;
  sequence::Range range_;
  sequence::CheckOptions how_;
  MotionProofs* proofs_;                              ///< null: no proofs are asked for
  MeshAnimation* animation_;                          ///< null: no page is asked for
  std::shared_ptr<const frames::Topology> topology_;  ///< of mesh_
  Mesh mesh_;
  std::shared_ptr<const Frame> before_;
  std::size_t results_ = 0;
  WaitingLine waiting_;
};

std::string question_for_person(Question question, const Separation& separation) {
  if (question == Question::rest) return "Is each frame free of intersections?";
  return separation.distance > 0
             ? "Do all elements stay apart in each step? (" + separation_for_person(separation) + ")"
             : std::string("Is each step between neighbouring frames free of contact?");
}

}  // namespace

int run_mesh(const MeshRunOptions& options) {
  FrameSource source(options);
  const std::vector<FrameName>& names = source.names();
  check_files(options, source.files());
  check_parts(options, names);
  sequence::Heading heading = heading_for(options, source);
  const Question question = heading.question;
  const Separation separation = heading.separation;
  const sequence::Range range = sequence::range_of(heading);
  const int threads = thread_count(options.threads);

  // The first frame is read alone: the other ones share its elements.
  const auto start = options.self ? source.read(0) : nullptr;  // it says which pairs are neighbours, for shards, too
  const auto first = range.first == 0 && start != nullptr ? start : source.read(range.first);
  if (start != nullptr) {
    sequence::check_same_elements(*start->topology, names.front(), *first->topology, names[range.first]);
  }
  const std::string& first_file = source.elements_file(range.first);
  heading.parts = sequence::part_rules_of(*first->topology, options.parts, first_file);
  Mesh mesh = sequence::mesh_of(*first->topology, separation, first_file, heading.parts);
  if (options.classes) sequence::check_has_classes(*first->topology, first_file);
  if (!may_differ(options)) heading.facts = sequence::facts_of(mesh, *first->topology);
  if (options.self) {
    const Positions positions(start->positions, start->topology->dimension);
    WaitingLine waiting;
    waiting.begin("the neighbours of --self");
    const auto pairs = stoppable([&] {
      return sequence::own_neighbours(mesh, positions, *options.self, {threads, &interruption()});
    });
    waiting.end();
    heading.self = {*options.self, pairs.size(), start->digest};
    mesh = sequence::touching_alone(mesh, pairs);
  }
  std::optional<MotionProofs> proofs;  // a folder that is refused is found before a journal is made
  if (!options.prove.empty()) proofs.emplace(options.prove, motion_elements(mesh), separation, threads);
  std::optional<io::OutputFile> page;
  std::optional<MeshAnimation> animation;
  if (!options.html.empty()) {
    page.emplace(options.html);
    animation.emplace(mesh, first->topology, separation);
  }
  MeshOutput output(options, heading);
  if (!output.finished().empty()) {
    print_error(fmt::format("touchstone: {} of {} results are those of {}\n", grouped(output.finished().size()),
                            grouped(sequence::result_count(question, range)), io::printable(output.finished_file())));
  }
  Checker checker(options, source, output, heading, threads, proofs ? &*proofs : nullptr,
                  animation ? &*animation : nullptr);
  checker.start_with(first->topology, std::move(mesh));

  // The next frame is read while the steps before it are checked. A oneTBB pipeline around both would keep its threads
  // from the check, which has most of the work.
  // Where no thread can be started, it is read when it is asked for.
  const auto policy = threads > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
  std::shared_ptr<const Frame> frame = first;
  for (std::size_t index = range.first; index < range.last; ++index) {
    throw_if_interrupted();
    std::future<std::shared_ptr<const Frame>> next;
    if (index + 1 < range.last) {
      next = std::async(policy, [&source, index] { return source.read(index + 1); });
    }
    checker.take(index, std::move(frame));
    if (next.valid()) frame = next.get();
  }
  if (proofs) proofs->commit();
  const bool all_free = output.finish() && (!proofs || proofs->contacts() == 0);
  std::string summary = proofs ? proofs->summary() : std::string();
  if (animation) {
    const std::uint64_t size =
        animation->write(*page, question_for_person(question, separation), output.counts_summary());
    page->commit();
    summary += animation_summary(options.html, size);
  }
  if (options.json) {
    print_error(summary);
  } else if (!summary.empty() && options.report != "-") {
    auto console = io::OutputFile::standard_output();
    console.write(summary);
    console.commit();
  }
  return all_free ? kAllHold : kRefuted;
}

}  // namespace touchstone::cli
