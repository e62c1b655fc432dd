// SPDX-License-Identifier: MIT
#include "sim/linking.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/catch.hpp"

namespace touchstone::sim {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Integer3 = std::array<Integer, 3>;

/// The corners of both, times the power of two that makes integers of all their coordinates.
std::vector<Integer3> integers(const VectorX& q, const Loop& loop, int lowest_exponent) {
  std::vector<Integer3> corners;
  for (const Index p : loop) {
    Integer3 corner;
    for (std::size_t k = 0; k < 3; ++k) {
      int exponent = 0;
      const double fraction = std::frexp(position(q, p)[static_cast<Eigen::Index>(k)], &exponent);
      corner[k] = static_cast<std::int64_t>(std::ldexp(fraction, 53));
      if (corner[k] != 0) corner[k] <<= static_cast<unsigned>(exponent - lowest_exponent);
    }
    corners.push_back(corner);
  }
  return corners;
}

int lowest_exponent(const VectorX& q, const Loop& a, const Loop& b) {
  int lowest = std::numeric_limits<int>::max();
  for (const Loop* loop : {&a, &b}) {
    for (const Index p : *loop) {
      for (const double x : position(q, p)) {
        int exponent = 0;
        if (std::frexp(x, &exponent) != 0) lowest = std::min(lowest, exponent);
      }
    }
  }
  return lowest;
}

Integer3 difference(const Integer3& a, const Integer3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Integer3 cross(const Integer3& a, const Integer3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Integer dot(const Integer3& a, const Integer3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// From a direction that no scene is aligned with.
struct View {
  Integer3 right{1009, 307, -211}, up{-401, 911, 503}, towards = cross(right, up);

  struct Place {
    Integer x, y;
  };
  Place place(const Integer3& p) const { return {dot(right, p), dot(up, p)}; }
};

int side(const View::Place& a, const View::Place& b, const View::Place& p) {
  const Integer area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  if (area == 0) FAIL("three corners on one line of sight: the test needs another view");
  return area > 0 ? 1 : -1;
}

bool apart(const Integer& a0, const Integer& a1, const Integer& b0, const Integer& b1) {
  return std::max(a0, a1) < std::min(b0, b1) || std::max(b0, b1) < std::min(a0, a1);
}

}  // namespace

int linking_number(const VectorX& q, const Loop& a, const Loop& b) {
  const View view;
  const int lowest = lowest_exponent(q, a, b);
  const std::vector<Integer3> at_a = integers(q, a, lowest), at_b = integers(q, b, lowest);
  std::vector<View::Place> seen_a, seen_b;
  for (const Integer3& p : at_a) seen_a.push_back(view.place(p));
  for (const Integer3& p : at_b) seen_b.push_back(view.place(p));
  int a_over_b = 0, b_over_a = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t i1 = (i + 1) % a.size();
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t j1 = (j + 1) % b.size();
      const View::Place &a0 = seen_a[i], &a1 = seen_a[i1], &b0 = seen_b[j], &b1 = seen_b[j1];
      if (apart(a0.x, a1.x, b0.x, b1.x) || apart(a0.y, a1.y, b0.y, b1.y)) continue;
      const int to_b0 = side(a0, a1, b0);
      if (to_b0 == side(a0, a1, b1) || side(b0, b1, a0) == side(b0, b1, a1)) continue;
      // With u, w the edges and r between their starts, the point of a is above that of b by
      // -det(u, w, r) / (u x w . view).
      const Integer3 u = difference(at_a[i1], at_a[i]), w = difference(at_b[j1], at_b[j]);
      const Integer volume = dot(cross(u, w), difference(at_b[j], at_a[i]));
      if (volume == 0) FAIL("the loops touch");
      const int sign = dot(cross(u, w), view.towards) > 0 ? 1 : -1;
      ((volume > 0) == (sign < 0) ? a_over_b : b_over_a) += (volume > 0) == (sign < 0) ? sign : -sign;
    }
  }
  REQUIRE(a_over_b == b_over_a);  // both are the linking number
  return a_over_b;
}

double gauss_integral(const VectorX& q, const Loop& a, const Loop& b) {
  double sum = 0;
  const auto solid = [](const Vector3& x, const Vector3& y, const Vector3& z) {
    const double n = x.norm() * y.norm() * z.norm() + x.dot(y) * z.norm() + y.dot(z) * x.norm() + z.dot(x) * y.norm();
    return 2 * std::atan2(x.dot(y.cross(z)), n);
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t between = std::max(i, j) - std::min(i, j);
      if (&a == &b && (between <= 1 || between + 1 == a.size())) continue;
      // The solid angle of the parallelogram of differences (Arai, "A rigorous extension algorithm ...", 2013).
      const Vector3 a0 = position(q, a[i]), a1 = position(q, a[(i + 1) % a.size()]);
      const Vector3 b0 = position(q, b[j]), b1 = position(q, b[(j + 1) % b.size()]);
      sum += solid(b0 - a0, b0 - a1, b1 - a1) + solid(b1 - a1, b1 - a0, b0 - a0);
    }
  }
  return sum / (4 * std::numbers::pi);
}

}  // namespace touchstone::sim
