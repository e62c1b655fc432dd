// Options whose value is a number.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "cli/shared/command_line/common_options.hpp"
#include "io/times.hpp"

namespace touchstone::cli {

/// An option whose value is a whole number from `least` to `most`.
template <class Number>
CLI::Option* add_whole_number(CLI::App& subcommand, const std::string& name, Number& value, const std::string& about,
                              std::uint64_t least = 0, std::uint64_t most = kMostNumber) {
  return subcommand.add_option(name, value, about)->type_name("N")->check([least, most](const std::string& text) {
    return check_whole_number(text, least, most);
  });
}

/// An option whose value is a finite number, decimal or hexfloat.
/// @param value  of a double or an optional one
/// @param words  of the range, and `is_right` whether a number is in it: see check_range
template <class Number>
CLI::Option* add_number(CLI::App& subcommand, const std::string& name, Number& value, const std::string& about,
                        const std::string& words, const std::function<bool(double)>& is_right) {
  return subcommand
      .add_option_function<std::string>(
          name, [&value](const std::string& text) { value = *io::parse_finite_double(text); }, about)
      ->check(check_range(words, is_right));
}

}  // namespace touchstone::cli
