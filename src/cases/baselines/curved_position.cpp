// SPDX-License-Identifier: MIT
#include "baselines/curved_position.hpp"

#include <algorithm>

namespace touchstone::baselines {
namespace {

double largest(const Vec3& x) { return std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)}); }

Vec3 scaled(const Vec3& x, int exponent) {
  return {std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)};
}

}  // namespace

double angular_speed(const RigidMotion& motion) {
  const auto dot = [](const std::array<double, 4>& a, const std::array<double, 4>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  };
  const double aa = dot(motion.q0, motion.q0), ab = dot(motion.q0, motion.q1), bb = dot(motion.q1, motion.q1);
  double wedge = 0;  // the sum of its components' squares, so that small turns do not cancel
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double component = motion.q0[i] * motion.q1[j] - motion.q0[j] * motion.q1[i];
      wedge += component * component;
    }
  }
  const double way = aa - 2 * ab + bb;  // |q1 - q0|^2
  double nearest = std::min(aa, bb);    // the least |q(t)|^2
  if (way > 0 && aa - ab > 0 && bb - ab > 0) nearest = std::min(nearest, wedge / way);
  return wedge == 0 ? 0 : 2 * std::sqrt(wedge) / nearest;
}

CurvedCorners::CurvedCorners(const CurvedQuery& query) : query_(query) {
  double length = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (corner.motion == CurvedCorner::kOnCurve) {
      for (int k = 0; k < corner.control_points; ++k) {
        length = std::max(length, largest(corner.points[static_cast<std::size_t>(k)]));
      }
      continue;
    }
    const RigidMotion& motion = query.motions[static_cast<std::size_t>(corner.motion)];
    length = std::max({length, largest(corner.points[0]), largest(motion.p0), largest(motion.p1)});
  }
  if (length > 0) std::frexp(length, &exponent_);
  for (CurvedCorner& corner : query_.corners) {
    for (Vec3& point : corner.points) point = scaled(point, -exponent_);
  }
  for (RigidMotion& motion : query_.motions) {
    motion.p0 = scaled(motion.p0, -exponent_);
    motion.p1 = scaled(motion.p1, -exponent_);
    double most = 0;
    for (std::size_t k = 0; k < 4; ++k) most = std::max({most, std::fabs(motion.q0[k]), std::fabs(motion.q1[k])});
    int power = 0;
    std::frexp(most, &power);
    for (double& c : motion.q0) c = std::ldexp(c, -power);
    for (double& c : motion.q1) c = std::ldexp(c, -power);
  }
}

}  // namespace touchstone::baselines
