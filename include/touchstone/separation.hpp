// Touchstone: the minimum separation of a question. Two elements with a thickness meet before they touch.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace touchstone {

/// How the distance of two points is measured.
enum class Metric : std::uint8_t {
  euclidean,  ///< the length of their difference
  max         ///< the largest absolute coordinate of their difference: the L-infinity metric
};

/// The metric's name in files and on the command line: "euclidean" or "max". Empty for a value that is none of them.
std::string_view metric_name(Metric metric) noexcept;

/// A distance that two elements are to keep. They are in contact while their distance is at most `distance`. The
/// distance of two elements is the least distance of a point of one and a point of the other.
///
/// With distance 0, contact is touching: every answer is bit for bit the one without a separation, in both metrics.
struct Separation {
  double distance = 0;                ///< in the coordinates' unit of length; finite and not negative, compared exactly
  Metric metric = Metric::euclidean;  ///< how a distance is measured
};

}  // namespace touchstone
