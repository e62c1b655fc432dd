// SPDX-License-Identifier: MIT
#include "view/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <touchstone/error.hpp>

namespace touchstone::view {

std::vector<std::uint32_t> AnimationShape::edges_without_face() const {
  std::vector<std::array<std::uint32_t, 2>> borders;
  borders.reserve(3 * faces.size());
  const auto sorted = [](std::uint32_t a, std::uint32_t b) {
    return std::array<std::uint32_t, 2>{std::min(a, b), std::max(a, b)};
  };
  for (const auto& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) borders.push_back(sorted(face[i], face[(i + 1) % 3]));
  }
  std::sort(borders.begin(), borders.end());
  std::vector<std::uint32_t> bare;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (!std::binary_search(borders.begin(), borders.end(), sorted(edges[i][0], edges[i][1]))) bare.push_back(i);
  }
  return bare;
}

std::size_t AnimationShape::vertex_count() const noexcept {
  std::size_t count = 0;
  for (const AnimationGroup& group : groups) count += group.vertices;
  return count;
}

AnimationElement AnimationShape::element(std::size_t group, MeshElement sort, std::uint32_t number) const noexcept {
  for (std::size_t g = 0; g < group; ++g) number += groups[g].count(sort);
  return {sort, number};
}

Animation::Animation(AnimationShape shape, std::vector<AnimationPlot> plots, const AnimationLimits& limits)
    : shape_(std::move(shape)), plots_(std::move(plots)), limits_(limits) {
  const std::size_t vertices = shape_.vertex_count();
  const std::size_t bytes_of_frame = std::max<std::size_t>(6 * vertices, 1);
  most_frames_ = std::min(limits_.frames, limits_.frame_bytes / bytes_of_frame);
  const std::size_t bytes_of_elements = 8 * shape_.edges.size() + 12 * shape_.faces.size();
  if (most_frames_ < 2 || bytes_of_elements > limits_.frame_bytes) {
    throw Error("--html: a page holds at most " + std::to_string(limits_.frame_bytes / 12) + " vertices and " +
                std::to_string(limits_.frame_bytes / 12) + " faces, and there are " + std::to_string(vertices) +
                " and " + std::to_string(shape_.faces.size()));
  }
  for (const AnimationPlot& plot : plots_) {
    for (const PlotSeries& series : plot.series) adds_up_.push_back(series.adds_up ? 1 : 0);
  }
}

void Animation::add_frame(double time, std::uint64_t number, const std::vector<double>& positions,
                          const std::vector<double>& values, const std::string& label) {
  const int exponent = frames_.empty() ? kAnyExponent : frames_.back().drawn.exponent;
  AnimationFrame frame{time, number, on_lattice(positions, exponent), {}, values, label};
  if (keeps_exact_) frame.exact = positions;
  // The last frame is always shown; when the next one comes, it goes if it is not one of every `stride_`.
  if (!frames_.empty() && (made_ - 1) % stride_ != 0) replace_last(frame);
  frames_.push_back(std::move(frame));
  ++made_;
  while (frames_.size() > most_frames_) leave_out_every_second();
  if (keeps_exact_ && frames_.size() * positions.size() * sizeof(double) > limits_.exact_bytes) {
    keeps_exact_ = false;
    for (AnimationFrame& each : frames_) each.exact = {};
  }
}

void Animation::replace_last(AnimationFrame& next) {
  for (std::size_t i = 0; i < adds_up_.size(); ++i) {
    if (adds_up_[i]) next.values[i] += frames_.back().values[i];
  }
  frames_.pop_back();
}

void Animation::leave_out_every_second() {
  stride_ *= 2;
  std::vector<AnimationFrame> all;
  all.swap(frames_);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && i % 2 == 0) replace_last(all[i]);
    frames_.push_back(std::move(all[i]));
  }
}

std::uint32_t Animation::pair(const AnimationPair& pair) {
  const auto [found, is_new] = numbers_.emplace(pair, static_cast<std::uint32_t>(pairs_.size()));
  if (is_new) pairs_.push_back(pair);
  return found->second;
}

void Animation::add_mark(const AnimationMark& mark) {
  if (marks_.size() < limits_.marks) {
    marks_.push_back(mark);
  } else {
    ++marks_left_out_;
  }
}

void Animation::add_story(AnimationStory story) {
  ++told_[static_cast<std::size_t>(story.sort)];
  stories_.push_back(std::move(story));
}

std::string Animation::name(const AnimationElement& element) const {
  using Sort = MeshElement;
  std::uint32_t number = element.number, first_vertex = 0;
  for (const AnimationGroup& group : shape_.groups) {
    const std::uint32_t count = group.count(element.sort);
    if (number >= count) {
      number -= count;
      first_vertex += group.vertices;
      continue;
    }
    const std::string of = group.name.empty() ? std::string() : fmt::format(" of {}", group.name);
    const std::uint32_t first = group.first_number;
    if (element.sort == Sort::edge && !shape_.edges_have_numbers) {
      const auto& corners = shape_.edges[element.number];
      return fmt::format("edge {}-{}{}", corners[0] - first_vertex + first, corners[1] - first_vertex + first, of);
    }
    if (element.sort == Sort::face && !shape_.face_numbers.empty()) {
      return fmt::format("face {}{}", shape_.face_numbers[element.number], of);
    }
    const std::string_view word =
        element.sort == Sort::vertex ? std::string_view(shape_.vertex_name) : name_of(element.sort);
    return fmt::format("{} {}{}", word, number + (element.sort == Sort::edge ? 0 : first), of);
  }
  throw Error("an animation has no such element");
}

}  // namespace touchstone::view
