// Doubles and fractions to integers, and from two ends of a step to a motion.
// SPDX-License-Identifier: MIT
#include "oracle/motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
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
  std::vector<Dyadic> dyadics;
  int unit = std::numeric_limits<int>::max();
  for (const double value : values) {
    dyadics.push_back(dyadic(value));
    unit = std::min(unit, dyadics.back().exponent);
  }
  std::vector<Integer> integers;
  for (const auto& number : dyadics) {
    Integer integer(number.significand);
    if (number.significand != 0) integer <<= static_cast<unsigned long>(number.exponent - unit);
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

/// The coordinates of one axis: of all corners at t = 0, then of all at t = 1.
template <class AnyQuery>
auto values_of_axis(const AnyQuery& query, std::size_t axis) {
  const std::size_t count = corner_count(query.kind);
  std::vector<decltype(coordinate(query.start[0], axis))> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(coordinate(query.start[i], axis));
  for (std::size_t i = 0; i < count; ++i) values.push_back(coordinate(query.end[i], axis));
  return values;
}

/// Sets the motion along one axis. `ends` has the order of values_of_axis.
void set_axis(Corners& corners, std::size_t axis, const Integer* ends, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    corners[i][axis] = Polynomial(ends[i], Integer(ends[count + i] - ends[i]));
  }
}

template <class AnyQuery>
Corners read_any_motion(const AnyQuery& query) {
  Corners corners;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto integers = to_common_unit(values_of_axis(query, axis));
    set_axis(corners, axis, integers.data(), corner_count(query.kind));
  }
  return corners;
}

template <class AnyQuery, class Value>
MeasuredMotion read_any_measured_motion(const AnyQuery& query, const Value& distance) {
  const std::size_t count = corner_count(query.kind);
  std::vector<Value> values;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto of_axis = values_of_axis(query, axis);
    values.insert(values.end(), of_axis.begin(), of_axis.end());
  }
  values.push_back(distance);
  const auto integers = to_common_unit(values);
  MeasuredMotion motion;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    set_axis(motion.corners, axis, integers.data() + 2 * count * axis, count);
  }
  motion.distance = integers.back();
  return motion;
}

/// The fraction that a double is.
Fraction exact_fraction(double value) {
  const Rational exact(value);
  const auto digits = [](const Integer& integer) {
    std::ostringstream text;
    text << integer;
    return text.str();
  };
  Fraction fraction;
  fraction.numerator = digits(exact.numerator());
  fraction.denominator = digits(exact.denominator());
  return fraction;
}

}  // namespace

Corners read_motion(const Query& query) { return read_any_motion(query); }
Corners read_motion(const RationalQuery& query) { return read_any_motion(query); }

MeasuredMotion read_measured_motion(const Query& query, double distance) {
  return read_any_measured_motion(query, distance);
}

MeasuredMotion read_measured_motion(const RationalQuery& query, double distance) {
  return read_any_measured_motion(query, exact_fraction(distance));
}

}  // namespace touchstone::oracle
