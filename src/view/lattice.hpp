// Positions as multiples of a power of two, in 16 bits each: for drawing only.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace touchstone::view {

/// Coordinate k of vertex i is about origin[k] + 2^exponent * steps[3 * i + k], within 2^(exponent - 1). One beyond
/// 2^1010 is drawn there.
struct LatticePositions {
  int exponent = 0;
  std::array<double, 3> origin{};
  std::vector<std::uint16_t> steps;

  /// Of a vertex as it is drawn.
  double coordinate(std::size_t vertex, std::size_t axis) const noexcept;
  std::array<double, 3> position(std::size_t vertex) const noexcept {
    return {coordinate(vertex, 0), coordinate(vertex, 1), coordinate(vertex, 2)};
  }
};

/// @param positions  three finite coordinates for each vertex
/// @param least_exponent  at least this exponent is taken. With the exponent of the frame before, a vertex at rest
///                        keeps its place
LatticePositions on_lattice(const std::vector<double>& positions, int least_exponent);

/// Less than every exponent.
inline constexpr int kAnyExponent = -5000;

}  // namespace touchstone::view
