// The reports of all shards of a sequence, put together.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sequence/results.hpp"

namespace touchstone::sequence {

/// The report of a shard, and the name of its file for messages.
struct ShardReport {
  std::string file;
  Report report;
};

/// The report of the whole run, the same as without shards.
/// @param shards  all shards of one run, in any order
/// @throws FileError  naming the shard that is missing, there twice, or of another run, and the frame that two shards
///                    read differently
Report merged(std::vector<ShardReport> shards);

}  // namespace touchstone::sequence
