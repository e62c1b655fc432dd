// The corners of a curved query, written afresh: rotations by quaternion products, curves by the Bernstein polynomials.
// Nothing here is shared with the exact level.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "oracle/motion.hpp"

namespace touchstone::oracle {
namespace {

/// q = w + x i + y j + z k, polynomials in t.
using Quaternion = std::array<Polynomial, 4>;

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],  //
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],  //
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],  //
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }

/// Multiplies doubles by the power of two 2^-unit, the largest that makes all of them integers.
class IntegerUnit {
 public:
  void add(double x) {
    if (x == 0) return;
    int exponent = 0;
    double fraction = std::ldexp(std::frexp(x, &exponent), 53);
    exponent -= 53;
    for (; std::fmod(fraction, 2) == 0; fraction /= 2) ++exponent;
    unit_ = empty_ ? exponent : std::min(unit_, exponent);
    empty_ = false;
  }
  Integer operator()(double x) const {
    int exponent = 0;
    const double fraction = std::ldexp(std::frexp(x, &exponent), 53);
    Integer integer(fraction);
    const int shift = exponent - 53 - unit_;
    if (x == 0) return Integer(0);
    if (shift >= 0) return integer <<= static_cast<unsigned long>(shift);
    return integer >>= static_cast<unsigned long>(-shift);  // the lost digits are zeros
  }

 private:
  bool empty_ = true;
  int unit_ = 0;
};

std::array<double, 3> coordinates(const Vec3& x) { return {x.x, x.y, x.z}; }

/// The sum of binomial(n, i) (1 - t)^(n - i) t^i b_i.
Polynomial bezier(const std::vector<Integer>& control) {
  const Polynomial later(Integer(0), Integer(1)), earlier(Integer(1), Integer(-1));
  std::vector<Polynomial> points;
  for (const Integer& point : control) points.emplace_back(point);
  for (; points.size() > 1; points.pop_back()) {  // de Casteljau's algorithm
    for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = earlier * points[i] + later * points[i + 1];
  }
  return points.front();
}

/// The corners, the product that they are multiplied by, and the distance, all in the same unit of length.
MeasuredMotion read_with(const CurvedQuery& query, double distance) {
  const std::size_t count = corner_count(query.kind);
  const auto on_curve = [&](std::size_t i) { return query.corners[i].motion == CurvedCorner::kOnCurve; };
  const auto motion_of = [&](std::size_t i) -> const RigidMotion& {
    return query.motions[static_cast<std::size_t>(query.corners[i].motion)];
  };

  IntegerUnit length;  // one for all axes, because bodies turn
  const auto measure = [&](const Vec3& x) {
    for (const double c : coordinates(x)) length.add(c);
  };
  length.add(distance);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t points = on_curve(i) ? static_cast<std::size_t>(query.corners[i].control_points) : 1;
    for (std::size_t k = 0; k < points; ++k) measure(query.corners[i].points[k]);
    if (on_curve(i)) continue;
    measure(motion_of(i).p0);
    measure(motion_of(i).p1);
  }

  // The corners in units of 1 / denominator, which is positive all over the step.
  Corners corners;
  std::array<Polynomial, 4> denominators;
  for (std::size_t i = 0; i < count; ++i) {
    const CurvedCorner& corner = query.corners[i];
    denominators[i] = Polynomial(Integer(1));
    if (on_curve(i)) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<Integer> control;
        for (std::size_t k = 0; k < static_cast<std::size_t>(corner.control_points); ++k) {
          control.push_back(length(coordinates(corner.points[k])[axis]));
        }
        corners[i][axis] = bezier(control);
      }
      continue;
    }
    const RigidMotion& motion = motion_of(i);
    IntegerUnit unit;
    for (std::size_t k = 0; k < 4; ++k) {
      unit.add(motion.q0[k]);
      unit.add(motion.q1[k]);
    }
    Quaternion q;
    for (std::size_t k = 0; k < 4; ++k) q[k] = bezier({unit(motion.q0[k]), unit(motion.q1[k])});
    Quaternion point = {Polynomial(Integer(0))};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis + 1] = Polynomial(length(coordinates(corner.points[0])[axis]));
    }
    const Quaternion turned = product(product(q, point), conjugate(q));
    denominators[i] = product(q, conjugate(q))[0];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Polynomial position = bezier({length(coordinates(motion.p0)[axis]), length(coordinates(motion.p1)[axis])});
      corners[i][axis] = turned[axis + 1] + denominators[i] * position;
    }
  }

  // To one denominator, their least common multiple. The lists are short.
  Polynomial common(Integer(1));
  for (std::size_t i = 0; i < count; ++i) {
    const Polynomial& own = denominators[i];
    common *= CGAL::integral_division(own, CGAL::gcd(common, own));
  }
  if (CGAL::sign(common.evaluate(Integer(0))) == CGAL::NEGATIVE) common = -common;
  for (std::size_t i = 0; i < count; ++i) {
    const Polynomial factor = CGAL::integral_division(common, denominators[i]);
    for (Polynomial& coordinate : corners[i]) coordinate *= factor;
  }
  return {corners, length(distance), common};
}

}  // namespace

Corners read_motion(const CurvedQuery& query) { return read_with(query, 0).corners; }

MeasuredMotion read_measured_motion(const CurvedQuery& query, double distance) { return read_with(query, distance); }

}  // namespace touchstone::oracle
