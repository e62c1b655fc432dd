// SPDX-License-Identifier: MIT
#include "exact/corners.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "numbers/common_denominator.hpp"

namespace touchstone::exact {
namespace {

Point moving(const std::array<Exact, 3>& start, const std::array<Exact, 3>& end) {
  Point point;
  for (std::size_t k = 0; k < 3; ++k) point[k] = Linear{{start[k], end[k] - start[k]}};
  return point;
}

}  // namespace

std::array<Point, 4> moving_corners(const Query& query) {
  const std::size_t count = corner_count(query.kind);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Vec3& x : {query.start[i], query.end[i]}) {
      largest = std::max({largest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
    }
  }
  // Products of ordinary size keep the double estimates of roots useful; they are exact either way.
  constexpr int kOrdinary = 200;
  int exponent = 0;
  if (largest > 0) std::frexp(largest, &exponent);
  const bool scale = exponent > kOrdinary || exponent < -kOrdinary;
  const Exact factor = numbers::power_of_two(-exponent);
  const auto exact = [&](const Vec3& x) {
    std::array<Exact, 3> c = {Exact(x.x), Exact(x.y), Exact(x.z)};
    if (scale) {
      for (Exact& coordinate : c) coordinate = coordinate * factor;
    }
    return c;
  };
  std::array<Point, 4> corners;
  for (std::size_t i = 0; i < count; ++i) corners[i] = moving(exact(query.start[i]), exact(query.end[i]));
  return corners;
}

std::array<Point, 4> moving_corners(const RationalQuery& query) {
  const std::size_t count = corner_count(query.kind);
  std::vector<std::pair<std::string_view, std::string_view>> fractions;
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto* corners : {&query.start, &query.end}) {
      for (const Fraction& f : (*corners)[i]) fractions.emplace_back(f.numerator, f.denominator);
    }
  }
  std::vector<Exact> integers = numbers::over_common_denominator(fractions);
  long largest = 0;
  for (const Exact& x : integers) largest = std::max(largest, numbers::approximate(x).exponent);
  const Exact factor = numbers::power_of_two(-largest);
  for (Exact& x : integers) x = x * factor;
  std::array<Point, 4> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const Exact* c = &integers[6 * i];
    corners[i] = moving({c[0], c[1], c[2]}, {c[3], c[4], c[5]});
  }
  return corners;
}

}  // namespace touchstone::exact
