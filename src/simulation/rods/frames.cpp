// SPDX-License-Identifier: MIT
#include "rods/frames.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace touchstone::sim {
namespace {

// 1 + cosine of the angle between tangents that count as opposite: below it, the quotient by it is mostly rounding.
constexpr double kOpposite = 1e-12;

// Length of the part of a unit vector across another one: below it, that part is mostly rounding, some 1e-16.
constexpr double kShortest = 1e-8;

}  // namespace

Vector3 parallel_transport(const Vector3& u, const Vector3& from, const Vector3& to) {
  const double cosine = from.dot(to);
  // Opposite tangents have no shortest rotation. Where an edge turns by 180 degrees in a substep, any frame is as good.
  if (cosine < -1 + kOpposite) return unit_perpendicular(u, to);
  const Vector3 axis = from.cross(to);
  return cosine * u + axis.cross(u) + (axis.dot(u) / (1 + cosine)) * axis;
}

Vector3 any_perpendicular(const Vector3& t) {
  Vector3::Index smallest = 0;
  t.cwiseAbs().minCoeff(&smallest);
  return t.cross(Vector3::Unit(smallest)).normalized();
}

Vector3 unit_perpendicular(const Vector3& u, const Vector3& t) {
  const Vector3 rest = u - u.dot(t) * t;
  const double length = rest.norm();
  return length > kShortest ? Vector3(rest / length) : any_perpendicular(t);
}

double signed_angle(const Vector3& u, const Vector3& v, const Vector3& axis) {
  return std::atan2(u.cross(v).dot(axis), u.dot(v));
}

Vector3 turned(const Vector3& u, const Vector3& axis, double angle) {
  return std::cos(angle) * u + std::sin(angle) * axis.cross(u);
}

}  // namespace touchstone::sim
