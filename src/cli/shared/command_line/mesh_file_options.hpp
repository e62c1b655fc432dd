// The options of commands that ask about meshes of files: repairs, rules between parts, threads.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/shared/command_line/command.hpp"
#include "sequence/parts/part_rules.hpp"
#include "sequence/repairs.hpp"

namespace touchstone::cli {

/// --weld, --drop-degenerate and --triangulate.
/// @param weld  the sentences about --weld
void add_repair_options(CLI::App& subcommand, sequence::RepairOptions& repairs, bool& triangulate,
                        const std::string& weld);

/// --only-between and --ignore, which exclude each other.
/// @param only, ignore  the sentences about them
void add_pair_options(CLI::App& subcommand, sequence::PartOptions& parts, const std::string& only,
                      const std::string& ignore);

/// --threads, on which no result depends.
void add_threads_option(CLI::App& subcommand, int& threads);

}  // namespace touchstone::cli
