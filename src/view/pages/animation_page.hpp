// The page of an animation.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "view/animation.hpp"
#include "view/pages/html.hpp"

namespace touchstone::view {

/// All strings are text.
struct AnimationWords {
  std::string title;
  std::string subtitle;               ///< a sentence that says what one sees
  std::string summary;                ///< several lines
  std::string time_unit;              ///< "s"; empty: times are numbers of frames
  std::string number;                 ///< what the numbers of frames count: "step"
  std::string between;                ///< a sentence: how vertices move between frames
  std::string mark_names;             ///< a sentence: what marks stand for
  std::string crossing = "crossing";  ///< the word for marks of that sort
  std::string command{};              ///< as a Page has it
};

/// Writes the page, frame by frame: it may be large. @returns its bytes
std::uint64_t write_animation_page(const Animation& animation, const AnimationWords& words, const Sink& sink);

}  // namespace touchstone::view
