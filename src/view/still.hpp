// Pictures of queries for readers without WebGL or scripts: a still one for pages, and a moving one that is a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace touchstone::view {

/// A picture as an SVG element: the elements at both ends of the step, faint, and where they meet or come closest, with
/// the paths of the corners and their names. The text does not depend on the machine's locale.
std::string still_of(const nlohmann::json& picture);

/// The same with the elements in motion, again and again, as an SVG file that needs no script. They rest a while where
/// they meet. What does not move pictures shows them there.
/// @param title  text: the answer in a sentence  @param about  text: more, for readers that ask for it
std::string moving_svg(const nlohmann::json& picture, const std::string& title, const std::string& about);

}  // namespace touchstone::view
