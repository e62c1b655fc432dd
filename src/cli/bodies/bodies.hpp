// `touchstone bodies`: is each step between the recorded poses of rigid bodies free of contact?
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <touchstone/bodies.hpp>

#include "cli/bodies/pose_file.hpp"
#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/separation_options.hpp"
#include "sequence/parts/part_rules.hpp"
#include "sequence/repairs.hpp"

namespace touchstone::cli {

/// Into how many arcs --slerp cuts a step first: times around a contact are then narrow.
inline constexpr int kSlerpArcs = 64;

struct BodiesRunOptions {
  std::vector<std::string> files;  ///< of the bodies, as given; patterns are not expanded yet
  std::string poses;               ///< the file of poses
  std::optional<QuaternionOrder> order;
  Turn turn = Turn::shorter;
  bool slerp = false;                             ///< turns are read as turns at a constant rate
  int slerp_arcs = BodyScrewOptions().most_arcs;  ///< the most of them
  SeparationOption separation;
  sequence::PartOptions rules;  ///< a body is a part
  sequence::RepairOptions repairs;
  bool triangulate = false;
  bool check_start = true;  ///< asks about intersections at the start of the first step
  bool clearance = false;   ///< asks for the least distance in each pose, too
  int threads = 0;          ///< 0: all that the machine has
  bool json = false;        ///< steps as lines of JSON on standard output, the verdict beside it
  std::string html;         ///< the page to write; empty: none
  std::string prove;        ///< the folder of proofs; empty: none
  std::string free_step;    ///< the table of poses to write at which each step may end; empty: none
};

int run_bodies(const BodiesRunOptions& options);
void add_bodies(CLI::App& program, Command& command);

}  // namespace touchstone::cli
