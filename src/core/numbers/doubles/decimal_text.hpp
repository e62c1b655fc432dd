// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <string>

namespace touchstone::numbers {

/// The shortest decimal that reads back as the same double: "0.1", "inf". No locale changes it.
inline std::string decimal_text(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

}  // namespace touchstone::numbers
