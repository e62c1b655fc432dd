// Doubles and fractions to integers, and from two ends of a step to a motion.
// SPDX-License-Identifier: MIT
#include "oracle/motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace touchstone::oracle {
namespace {

/// significand * 2^exponent, the significand an odd integer or zero.
struct Dyadic {
  double significand;
  int exponent;
};

Dyadic dyadic(double value) {
  if (value == 0) return {0, std::numeric_limits<int>::max()};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);  // normalizes subnormals too
  auto significand = static_cast<std::int64_t>(std::ldexp(fraction, std::numeric_limits<double>::digits));
  exponent -= std::numeric_limits<double>::digits;
  while (significand % 2 == 0) {
    significand /= 2;
    ++exponent;
  }
  return {static_cast<double>(significand), exponent};
}

double coordinate(const Vec3& position, std::size_t axis) {
  return axis == 0 ? position.x : axis == 1 ? position.y : position.z;
}

std::vector<Integer> to_common_unit(const std::vector<double>& values) {
  std::vector<Dyadic> parts;
  int unit = std::numeric_limits<int>::max();
  for (const double value : values) {
    parts.push_back(dyadic(value));
    unit = std::min(unit, parts.back().exponent);
  }
  std::vector<Integer> integers;
  for (const auto& part : parts) {
    Integer integer(part.significand);
    if (part.significand != 0) integer <<= static_cast<unsigned long>(part.exponent - unit);
    integers.push_back(integer);
  }
  return integers;
}

std::vector<Integer> to_common_unit(const std::vector<Fraction>& values) {
  Integer unit(1);
  for (const auto& value : values) {
    const Integer denominator(value.denominator);
    unit = CGAL::integral_division(unit, CGAL::gcd(unit, denominator)) * denominator;
  }
  std::vector<Integer> integers;
  for (const auto& value : values) {
    integers.push_back(Integer(value.numerator) * CGAL::integral_division(unit, Integer(value.denominator)));
  }
  return integers;
}

Fraction coordinate(const std::array<Fraction, 3>& position, std::size_t axis) { return position[axis]; }

template <class AnyQuery>
Corners read_any_motion(const AnyQuery& query) {
  const std::size_t count = corner_count(query.kind);
  Corners corners;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<decltype(coordinate(query.start[0], axis))> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(coordinate(query.start[i], axis));
    for (std::size_t i = 0; i < count; ++i) values.push_back(coordinate(query.end[i], axis));
    const auto integers = to_common_unit(values);
    for (std::size_t i = 0; i < count; ++i) {
      corners[i][axis] = Polynomial(integers[i], Integer(integers[count + i] - integers[i]));
    }
  }
  return corners;
}

}  // namespace

Corners read_motion(const Query& query) { return read_any_motion(query); }
Corners read_motion(const RationalQuery& query) { return read_any_motion(query); }

}  // namespace touchstone::oracle
