// From where an animation is seen first, and what stays of it without scripts.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "view/animation.hpp"

namespace touchstone::view {

/// Where an animation is in space.
struct AnimationView {
  Triple centre{};                ///< of what it holds in all frames: what moves, and all of it if not much larger
  double radius = 1;              ///< no vertex that it holds is farther from the centre
  bool planar = false;            ///< all vertices are at one height z
  std::array<Triple, 3> basis{};  ///< unit vectors to the right, up and towards the reader
  std::array<double, 2> reach{};  ///< how far those vertices are from the centre to the right and up, by the radius
};
AnimationView view_of(const Animation& animation);

/// A coordinate of a vertex as it is drawn.
double drawn_coordinate(const AnimationFrame& frame, std::size_t vertex, std::size_t axis) noexcept;

/// One frame as an SVG element, with the marks of that time: the frame of the first story, or the last one. Of many
/// elements some are left out.
std::string still_of(const Animation& animation, const AnimationView& view);

/// A figure for each plot: the lines over time, and their names. The script adds a cursor and values.
std::string plots_html(const Animation& animation);

}  // namespace touchstone::view
