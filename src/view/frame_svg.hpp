// Frames of an animation as SVG: a still picture for pages, and a moving one that is a file by itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "view/animation_view.hpp"

namespace touchstone::view {

/// One frame as an SVG element, with the marks of that time: the frame of the first story, or the last one. Of many
/// elements some are left out.
std::string still_of(const Animation& animation, const AnimationView& view);

/// All frames, or every second one as often as needed, one after the other again and again: an SVG file that needs no
/// script, for a page, slides or a paper. What does not move pictures shows the frame of still_of.
/// @param title  text  @param about  text: a sentence that says what one sees
/// @param unit   of the times that the picture says: "s", or empty for t = 0.5
std::string moving_svg(const Animation& animation, const std::string& title, const std::string& about,
                       const std::string& unit = {});

}  // namespace touchstone::view
