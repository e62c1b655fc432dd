// The options that fuzz and fuzz-steps have in common.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::cli {

/// --solver-command, a program under test.
CLI::Option* add_command_option(CLI::App& subcommand, std::string& command, const std::string& about);

/// --limit, of a program's or plugin's reply.
void add_limit_option(CLI::App& subcommand, double& seconds, const std::string& about);

/// --seed, --cases and --seconds. @param things  that are asked: "queries"
std::vector<CLI::Option*> add_search_options(CLI::App& subcommand, std::uint64_t& seed,
                                             std::optional<std::uint64_t>& cases, std::optional<double>& seconds,
                                             const std::string& things);

/// --out, --findings and --threads. @param about_out  what is written to the folder
void add_finding_options(CLI::App& subcommand, std::string& out, const std::string& about_out, std::size_t& findings,
                         int& threads);

/// "Families: one another", in lines of the width of a help text.
std::string listed(std::string line, const std::vector<std::string_view>& names);

}  // namespace touchstone::cli
