// The message of what is refused.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include <touchstone/error.hpp>

namespace touchstone::tests {

inline std::string refusal_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace touchstone::tests
