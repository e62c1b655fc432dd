// A subcommand of the program: a function that adds it to the parser, and an exit status.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <touchstone/names.hpp>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace touchstone::cli {

inline constexpr int kAllHold = 0;   ///< exit status: done, and every claim holds
inline constexpr int kRefuted = 1;   ///< exit status: some claim is refuted
inline constexpr int kBadInput = 2;  ///< exit status: bad usage or bad input

/// Runs the chosen subcommand. It returns the exit status, and throws Error, Interrupted or an exception of the
/// standard library. Each subcommand has a function add_NAME(program, command), which adds the subcommand's arguments
/// to the parser; parsing them sets `command`.
using Command = std::function<int()>;

/// The names that an option for a value of E takes.
template <class E>
std::vector<std::string> all_names() {
  const Names names = names_of<E>();
  return {names.begin(), names.end()};
}

}  // namespace touchstone::cli
