// Options about which wrong claims count.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <touchstone/names.hpp>

#include "certify/time_errors.hpp"
#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

/// "16ulps", or "1e-06": a fraction of the step. @param limit  with one of its members
std::string time_limit_text(const certify::TimeLimit& limit);

/// An option with such a value. @param take  is given the limit
void add_time_limit(CLI::App& subcommand, const std::string& name, const std::string& about,
                    const std::function<void(const certify::TimeLimit&)>& take);

/// The option --class with names, "missed,late". @param take  is given each of them
void add_class_option(CLI::App& subcommand, const std::vector<std::string>& names, const std::string& about,
                      const std::function<void(const std::string&)>& take);

/// "missed, late".
template <class Class>
std::string names_text(const std::vector<Class>& classes) {
  std::string text;
  for (const Class one : classes) text.append(text.empty() ? "" : ", ").append(name_of(one));
  return text;
}

}  // namespace touchstone::cli
