// Touchstone: the separation that two elements are to keep, and distances.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include <touchstone/answer.hpp>
#include <touchstone/names.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// How the distance of two points is measured.
enum class Metric : std::uint8_t {
  euclidean,  ///< the length of their difference
  max         ///< the largest absolute coordinate of their difference: the L-infinity metric
};

/// "euclidean", "max".
template <>
Names names_of<Metric>() noexcept;

/// A distance that two elements are to keep. They are in contact while their distance is at most `distance`. The
/// distance of two elements is the least distance of a point of one and a point of the other.
///
/// With distance 0, contact is touching: every answer is bit for bit the one without a separation, in both metrics.
struct Separation {
  double distance = 0;                ///< in the coordinates' unit of length; finite and not negative, compared exactly
  Metric metric = Metric::euclidean;  ///< how a distance is measured
};

/// The distance of two elements, and where it is attained.
struct Distance {
  /// The double nearest to the exact distance; of two equally near ones the one with an even last bit. Infinity for a
  /// distance that is too large for a double.
  double value = 0;

  Feature feature_a = Feature::none;  ///< the part of the first element that holds its closest point
  Feature feature_b = Feature::none;  ///< the same of the second element

  /// Barycentric coordinates of the closest points, as in Answer, each within 2^-50 of its true value.
  std::array<double, 3> weights_a{};
  std::array<double, 3> weights_b{};  ///< the same on the second element
};

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
