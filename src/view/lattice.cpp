// SPDX-License-Identifier: MIT
#include "view/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::view {
namespace {

/// Farther out nothing is drawn: with this, sums and lengths of drawn coordinates do not overflow.
constexpr double kFarthest = 0x1p1010;

constexpr double kMostSteps = 65534;  // one less than 16 bits hold, as both ends are rounded

/// The least power of two, not below 2^-1022, by which the extent is at most kMostSteps.
int exponent_for(double low, double high) {
  // Halves, as the difference of two doubles may overflow.
  const double half = high / 2 - low / 2;
  if (!(half > 0)) return -1022;
  int exponent = std::max(std::ilogb(half) - 16, -1022);
  while (std::ldexp(half, 1 - exponent) > kMostSteps) ++exponent;
  return exponent;
}

/// x / 2^exponent, rounded to an integer.
double steps_of(double x, int exponent) { return std::nearbyint(std::ldexp(x, -exponent)); }

double drawn(double x) { return std::clamp(x, -kFarthest, kFarthest); }

}  // namespace

double LatticePositions::coordinate(std::size_t vertex, std::size_t axis) const noexcept {
  return origin[axis] + std::ldexp(static_cast<double>(steps[3 * vertex + axis]), exponent);
}

LatticePositions on_lattice(const std::vector<double>& positions, int least_exponent) {
  LatticePositions result;
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], drawn(positions[i]));
    high[i % 3] = std::max(high[i % 3], drawn(positions[i]));
  }
  if (positions.empty()) low = high = {};
  result.exponent = least_exponent;
  for (std::size_t k = 0; k < 3; ++k) {
    // Below this spacing the quotients would overflow.
    const double largest = std::max(std::abs(low[k]), std::abs(high[k]));
    const int finest = largest > 0 ? std::max(std::ilogb(largest) - 1000, -1022) : -1022;
    result.exponent = std::max({result.exponent, exponent_for(low[k], high[k]), finest});
  }
  std::array<double, 3> first{};
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = steps_of(low[k], result.exponent);
    result.origin[k] = std::ldexp(first[k], result.exponent);
  }
  result.steps.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double step = steps_of(drawn(positions[i]), result.exponent) - first[i % 3];
    result.steps.push_back(static_cast<std::uint16_t>(std::clamp(step, 0.0, 65535.0)));
  }
  return result;
}

}  // namespace touchstone::view
