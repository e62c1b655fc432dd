// Poses of bodies over time, as recorders write them: a table with a row for each body and time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/bodies.hpp>

namespace touchstone::cli {

/// What a file of poses holds.
struct RecordedPoses {
  std::vector<double> times;              ///< ascending, two or more
  std::vector<std::vector<Pose>> bodies;  ///< the poses of each body: one a time, or none for a body at rest

  std::string time_spacing;         ///< spacing_text of the time of the greatest magnitude
  std::size_t not_unit = 0;         ///< the quaternions whose length differs from 1 by more than a thousandth
  std::uint64_t not_unit_row = 0;   ///< the row of the first of them
  std::vector<std::string> unread;  ///< the names of columns that say nothing about poses

  /// A time within a step, rounded.
  double time_in(std::size_t step, double fraction) const noexcept;

  std::size_t at_rest() const noexcept;
  /// The pose of a body at a time; of a body at rest, that of its own frame.
  Pose at(std::size_t body, std::size_t time) const;
};

/// "times are doubles, which are 256 apart there", for a time beside which doubles are more than a microsecond apart
/// where it is in seconds; nothing for others.
std::string spacing_text(double time);

/// Reads io::CsvRecords. The first line names the columns, in any order and any case. Without such a line they are
/// time, body, x, y, z and the quaternion in the order `order`. Numbers are the nearest doubles.
/// @param bodies  their names
/// @throws FileError  naming the row: for a body of another name, a number that is not finite, a zero quaternion, and
///                    times of a body that do not ascend; naming body and time: for a pose that is missing
RecordedPoses read_poses(const std::string& file, const std::vector<std::string>& bodies,
                         std::optional<QuaternionOrder> order);

}  // namespace touchstone::cli
