// An animation to show: elements, their positions in frames, and where pairs of them meet. Its size is bounded: of more
// frames than fit, every second one is left out, as often as needed.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/query.hpp>

#include "view/lattice.hpp"

namespace touchstone::view {

using Triple = std::array<double, 3>;

/// The numbers count over all groups.
struct AnimationElement {
  MeshElement sort = MeshElement::vertex;
  std::uint32_t number = 0;

  auto operator<=>(const AnimationElement&) const = default;
};
using AnimationPair = std::pair<AnimationElement, AnimationElement>;

/// Vertices, edges and faces that are counted by themselves. The groups of an animation follow one another.
struct AnimationGroup {
  std::string name;  ///< text, "body 2"; empty: names of elements do without
  std::uint32_t vertices = 0, edges = 0, faces = 0;
  std::uint32_t first_number = 0;  ///< of the first vertex and the first face

  std::uint32_t count(MeshElement sort) const noexcept {
    return sort == MeshElement::edge ? edges : sort == MeshElement::face ? faces : vertices;
  }
};

/// Corners are numbers of vertices over all groups. The edges of faces are there, too, where they are elements.
struct AnimationShape {
  std::vector<AnimationGroup> groups;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::uint32_t> points;        ///< vertices that are drawn as dots
  std::vector<float> radii;                 ///< by vertex, of its edges without a face, and of its dot; empty: all thin
  std::string vertex_name;                  ///< "particle"
  std::vector<std::uint32_t> face_numbers;  ///< of each face; empty: they are counted
  bool edges_have_numbers = true;           ///< false: edges are named by their corners

  std::size_t vertex_count() const noexcept;
  /// Of an edge without a face, or of a dot, whose ends are equal: the lesser one of its ends.
  double radius(std::uint32_t a, std::uint32_t b) const noexcept {
    return radii.empty() ? 0 : std::min(radii[a], radii[b]);
  }
  /// The numbers of the edges that are no border of a face: cables and wires.
  std::vector<std::uint32_t> edges_without_face() const;

  /// The element of a group that has this number in it.
  AnimationElement element(std::size_t group, MeshElement sort, std::uint32_t number) const noexcept;
};

/// How a pair is marked.
enum class MarkSort : std::uint8_t { close, contact, crossing };

struct AnimationMark {
  double time = 0;
  Triple point{};
  std::uint32_t pair = 0;
  MarkSort sort = MarkSort::contact;
};

/// What is told about a pair at a time, in the list beside the picture.
struct AnimationStory {
  double time = 0;
  Triple point{};
  std::uint32_t pair = 0;
  MarkSort sort = MarkSort::contact;
  std::string heading;  ///< text
  std::string html;     ///< what follows when the reader opens it
};

/// A line of a plot over time: its name, and whether values of frames that are left out are added to the next frame's.
struct PlotSeries {
  std::string name;
  bool adds_up = false;
};
struct AnimationPlot {
  std::string title;  ///< text: "energy [J]"
  std::vector<PlotSeries> series;
};

struct AnimationFrame {
  double time = 0;
  std::uint64_t number = 0;
  LatticePositions drawn;
  std::vector<double> exact;   ///< the coordinates themselves; empty where they do not fit
  std::vector<double> values;  ///< of the series of all plots, in their order
  std::string label;           ///< text, such as the name of its file; may be empty
};

/// What a page may hold.
struct AnimationLimits {
  std::size_t frame_bytes = std::size_t{64} << 20;  ///< of the positions that are drawn
  std::size_t exact_bytes = std::size_t{16} << 20;  ///< of the coordinates themselves
  std::size_t frames = 1024;
  std::size_t marks = 200'000;  ///< those beyond are counted only
  std::size_t stories = 200;    ///< of each sort
};

class Animation {
 public:
  /// @throws Error where not even two frames fit
  Animation(AnimationShape shape, std::vector<AnimationPlot> plots, const AnimationLimits& limits = {});

  /// The next frame. @param positions  three finite coordinates for each vertex  @param values  of the plots' series
  void add_frame(double time, std::uint64_t number, const std::vector<double>& positions,
                 const std::vector<double>& values, const std::string& label = {});

  /// The number of a pair, for marks and stories.
  std::uint32_t pair(const AnimationPair& pair);

  void add_mark(const AnimationMark& mark);
  /// Whether the list has room for a story of this sort.
  bool has_room(MarkSort sort) const noexcept { return told_[static_cast<std::size_t>(sort)] < limits_.stories; }
  void add_story(AnimationStory story);

  const AnimationShape& shape() const noexcept { return shape_; }
  const std::vector<AnimationPlot>& plots() const noexcept { return plots_; }
  const AnimationLimits& limits() const noexcept { return limits_; }
  const std::vector<AnimationFrame>& frames() const noexcept { return frames_; }
  const std::vector<AnimationPair>& pairs() const noexcept { return pairs_; }
  const std::vector<AnimationMark>& marks() const noexcept { return marks_; }
  const std::vector<AnimationStory>& stories() const noexcept { return stories_; }
  std::size_t frames_made() const noexcept { return made_; }
  std::size_t marks_left_out() const noexcept { return marks_left_out_; }
  bool has_exact() const noexcept { return keeps_exact_; }

  /// "edge 12 of body 2"
  std::string name(const AnimationElement& element) const;

 private:
  void replace_last(AnimationFrame& next);
  void leave_out_every_second();

  AnimationShape shape_;
  std::vector<AnimationPlot> plots_;
  AnimationLimits limits_;
  std::size_t most_frames_;
  std::vector<char> adds_up_;  // by series of all plots
  std::vector<AnimationFrame> frames_;
  std::size_t made_ = 0, stride_ = 1;
  bool keeps_exact_ = true;
  std::map<AnimationPair, std::uint32_t> numbers_;
  std::vector<AnimationPair> pairs_;
  std::vector<AnimationMark> marks_;
  std::size_t marks_left_out_ = 0;
  std::vector<AnimationStory> stories_;
  std::array<std::size_t, 3> told_{};
};

}  // namespace touchstone::view
