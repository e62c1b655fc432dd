// SPDX-License-Identifier: MIT
#include "cli/shared/command_line/mesh_file_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/shared/command_line/common_options.hpp"
#include "frames/content.hpp"

namespace touchstone::cli {

void add_repair_options(CLI::App& subcommand, sequence::RepairOptions& repairs, bool& triangulate,
                        const std::string& weld) {
  subcommand.add_flag("--weld", repairs.weld, weld);
  subcommand.add_flag("--drop-degenerate", repairs.drop_degenerate,
                      "Leave out faces and edges that name a vertex twice, or the vertices of one before them");
  subcommand.add_flag("--triangulate", triangulate,
                      "Cut polygons of more than three corners into triangles that share the first corner");
}

void add_pair_options(CLI::App& subcommand, sequence::PartOptions& parts, const std::string& only,
                      const std::string& ignore) {
  const auto pair_of_names = [](const std::string& text) {
    return text.find(',') == std::string::npos ? "must be two names, such as A,B" : std::string();
  };
  CLI::Option* const only_between = subcommand.add_option("--only-between", parts.only_between, only);
  CLI::Option* const ignored = subcommand.add_option("--ignore", parts.ignored, ignore)->excludes(only_between);
  for (CLI::Option* const option : {only_between, ignored}) {
    option->type_name("A,B")->allow_extra_args(false)->check(pair_of_names);
  }
}

std::function<void()> add_clearance_option(CLI::App& subcommand, bool& clearance, const std::string& about) {
  CLI::Option* const separation = subcommand.get_option("--separation");
  CLI::Option* const metric = subcommand.get_option("--metric");
  const CLI::Option* const found = subcommand.add_flag("--clearance", clearance, about);
  metric->remove_needs(separation);
  return [=] {
    if (*metric && !*separation && !*found) throw CLI::RequiresError("--metric", "--separation or --clearance");
  };
}

void check_mesh_outputs(const std::vector<std::pair<std::string, std::string>>& outputs,
                        std::vector<std::string> inputs) {
  for (std::size_t i = 0, count = outputs.empty() ? 0 : inputs.size(); i < count; ++i) {
    const std::vector<std::string> beside = frames::files_beside(inputs[i]);
    inputs.insert(inputs.end(), beside.begin(), beside.end());
  }
  for (const auto& [option, output] : outputs) refuse_to_overwrite(output, inputs);
  refuse_one_file_twice(outputs);
}

}  // namespace touchstone::cli
