// The hue of each surface, cable and body of an animation, so that a reader tells them apart.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "view/animation.hpp"

namespace touchstone::view {

/// Red, green and blue from 0 to 255. The first hue is pale, for what is at rest while something moves; in the dark
/// pages have another one for it, --rest. The others are in the colours of Okabe and Ito, softened: readers with any
/// colour vision tell them apart on white and on black.
using Colour = std::array<std::uint8_t, 3>;
inline constexpr std::array<Colour, 8> kHues = {{{232, 235, 240},
                                                 {86, 150, 201},
                                                 {230, 166, 62},
                                                 {70, 168, 140},
                                                 {205, 140, 178},
                                                 {212, 118, 74},
                                                 {132, 196, 232},
                                                 {214, 204, 92}}};

/// By vertex: whether it leaves its first place by more than the rounding.
std::vector<char> moving_vertices(const Animation& animation);

/// By vertex: the number of its hue. A group with a name has one hue; in a group without, each set of vertices that
/// edges and faces connect has one. Where nothing moves, a set that is much larger than all others is pale. Of more
/// than seven sets some have the same hue.
std::vector<std::uint8_t> hues_of(const Animation& animation);

}  // namespace touchstone::view
