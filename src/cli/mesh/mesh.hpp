// `touchstone mesh`: is each step of an animation free of contact?
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/separation_options.hpp"
#include "io/answers/answer_writer.hpp"
#include "sequence/repairs.hpp"
#include "sequence/results.hpp"

namespace touchstone::cli {

struct MeshRunOptions {
  std::vector<std::string> files;  ///< as given; patterns are not expanded yet
  bool in_order = false;           ///< the files are frames in the order given, whatever their names are
  bool check = false;              ///< asks about each frame at rest
  bool as_parts = false;           ///< each argument is a part of one scene; with `check` each file is
  SeparationOption separation;
  std::optional<double> self;  ///< neighbours along edges that are shorter in sum are asked about touching alone
  sequence::PartOptions parts;
  sequence::RepairOptions repairs;
  bool clearance = false;  ///< asks for the least distance, too
  bool classes = false;    ///< asks how parts lie to each other, too
  int threads = 0;         ///< 0: all that the machine has
  std::optional<sequence::Shard> shard;
  std::string report, pairs, queries, prove;
  io::Numbers numbers = io::Numbers::decimals;  ///< of pairs
  bool json = false;                            ///< results as lines of JSON on standard output, the verdict beside it
  std::string html;                             ///< the page to write; empty: none
  bool resume = false;
  std::string topology, dataset;
  std::string velocity;  ///< the file of velocities that say the second frame; empty: none
  double dt = 0;
  bool triangulate = false;
};

int run_mesh(const MeshRunOptions& options);
void add_mesh(CLI::App& program, Command& command);

}  // namespace touchstone::cli
