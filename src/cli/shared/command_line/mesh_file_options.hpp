// The options of commands that ask about meshes of files: repairs, rules between parts, threads.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

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

/// --clearance, after --separation and --metric: with it, --metric needs no --separation.
/// @param about  the sentence about it
/// @returns the check that --metric has one of both, for the callback of the command
std::function<void()> add_clearance_option(CLI::App& subcommand, bool& clearance, const std::string& about);

/// @param outputs  the options that name a file to write, and these names
/// @param inputs   files of meshes, beside which other ones may be read
/// @throws FileError, Error  as refuse_to_overwrite and refuse_one_file_twice
void check_mesh_outputs(const std::vector<std::pair<std::string, std::string>>& outputs,
                        std::vector<std::string> inputs);

}  // namespace touchstone::cli
