// Still pictures, for readers without WebGL or scripts.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace touchstone::view {

/// A picture as an SVG element: the elements at both ends of the step, faint, and where they meet or come closest, with
/// the paths of the corners and their names. The text does not depend on the machine's locale.
std::string still_of(const nlohmann::json& picture);

}  // namespace touchstone::view
