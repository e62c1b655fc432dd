// From where an animation is seen first, and its plots.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "view/animation.hpp"

namespace touchstone::view {

/// Where an animation is in space.
struct AnimationView {
  Triple centre{};                ///< of what it holds in all frames: what has a hue, and all if not much larger
  double radius = 1;              ///< no vertex that it holds is farther from the centre
  bool planar = false;            ///< all vertices are at one height z
  std::array<Triple, 3> basis{};  ///< unit vectors to the right, up and towards the reader
  std::array<double, 2> reach{};  ///< how far those vertices are from the centre to the right and up, by the radius

  /// A point to the right, up and towards the reader, from the centre, in units of the radius.
  Triple seen(const Triple& x) const noexcept;
};
AnimationView view_of(const Animation& animation);

/// A figure for each plot: the lines over time, and their names. The script adds a cursor and values.
std::string plots_html(const Animation& animation);

}  // namespace touchstone::view
