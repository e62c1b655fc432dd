// Tests that cannot run here say why, and CTest shows them as "Skipped".
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "support/catch.hpp"

namespace touchstone::tests {

/// The exit status of a test program that skipped something and failed nowhere. tests/CMakeLists.txt tells it to CTest.
inline constexpr int kSkippedStatus = 77;

/// Prints "skipped: REASON". The test case returns after the call.
void skip(const std::string& reason);

/// Whether `skip` was called.
bool has_skipped();

/// The absolute path of a program that PATH finds now, not when the build was configured.
std::optional<std::string> find_tool(const std::string& tool);

/// Whether PATH finds `tool`. Skips with the package to install when PATH does not.
bool has_tool_or_skip(const std::string& tool);

}  // namespace touchstone::tests

/// TEST_CASE_WITH("groff", "the page is formatted") { ... }: a test case that needs an optional tool, and is skipped
/// where the tool is missing. CTest gives it the label optional-tools (see tests/CMakeLists.txt).
#define TEST_CASE_WITH(tool, name) TOUCHSTONE_TEST_CASE_AT_LINE(tool, name, __LINE__)
#define TOUCHSTONE_TEST_CASE_AT_LINE(tool, name, line) TOUCHSTONE_TEST_CASE_AS(tool, name, with_tool_at_line_, line)
#define TOUCHSTONE_TEST_CASE_AS(tool, name, prefix, line) TOUCHSTONE_TEST_CASE_BODY(tool, name, prefix##line)
#define TOUCHSTONE_TEST_CASE_BODY(tool, name, body)          \
  static void body();                                        \
  TEST_CASE(name, "[optional-tools]") {                      \
    if (::touchstone::tests::has_tool_or_skip(tool)) body(); \
  }                                                          \
  static void body()
