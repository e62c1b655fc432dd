// Numbers of 300 bits, by MPFR: the motion of constant rate as it is defined.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <mpfr.h>

#include <touchstone/curved_query.hpp>

namespace touchstone::tests {

class Big {
 public:
  Big(double x = 0) {
    mpfr_init2(x_, 300);
    mpfr_set_d(x_, x, MPFR_RNDN);
  }
  Big(const Big& other) : Big() { mpfr_set(x_, other.x_, MPFR_RNDN); }
  Big& operator=(const Big& other) {
    mpfr_set(x_, other.x_, MPFR_RNDN);
    return *this;
  }
  ~Big() { mpfr_clear(x_); }

  double to_double() const { return mpfr_get_d(x_, MPFR_RNDN); }
  int sign() const { return mpfr_sgn(x_); }

  friend Big operator+(const Big& a, const Big& b) { return apply(mpfr_add, a, b); }
  friend Big operator-(const Big& a, const Big& b) { return apply(mpfr_sub, a, b); }
  friend Big operator*(const Big& a, const Big& b) { return apply(mpfr_mul, a, b); }
  friend Big operator/(const Big& a, const Big& b) { return apply(mpfr_div, a, b); }
  friend bool operator<(const Big& a, const Big& b) { return mpfr_less_p(a.x_, b.x_) != 0; }
  friend Big sqrt(const Big& a) { return apply(mpfr_sqrt, a); }
  friend Big sin(const Big& a) { return apply(mpfr_sin, a); }
  friend Big atan2(const Big& y, const Big& x) { return apply(mpfr_atan2, y, x); }

 private:
  template <class F>
  static Big apply(F f, const Big& a) {
    Big result;
    f(result.x_, a.x_, MPFR_RNDN);
    return result;
  }
  template <class F>
  static Big apply(F f, const Big& a, const Big& b) {
    Big result;
    f(result.x_, a.x_, b.x_, MPFR_RNDN);
    return result;
  }

  mpfr_t x_;
};

using BigPoint = std::array<Big, 3>;
using BigQuaternion = std::array<Big, 4>;

inline Big dot(const BigQuaternion& a, const BigQuaternion& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

inline BigQuaternion unit(const std::array<double, 4>& q) {
  const BigQuaternion big = {q[0], q[1], q[2], q[3]};
  const Big length = sqrt(dot(big, big));
  return {big[0] / length, big[1] / length, big[2] / length, big[3] / length};
}

/// sin((1 - t) h) / sin(h) a + sin(t h) / sin(h) b for unit quaternions at the angle h.
inline BigQuaternion slerp(const BigQuaternion& a, const BigQuaternion& b, const Big& t) {
  // h = 2 atan2(|a - b|, |a + b|) is accurate for every h.
  BigQuaternion difference, sum;
  for (std::size_t k = 0; k < 4; ++k) {
    difference[k] = a[k] - b[k];
    sum[k] = a[k] + b[k];
  }
  const Big h = Big(2) * atan2(sqrt(dot(difference, difference)), sqrt(dot(sum, sum)));
  if (h.sign() == 0) return a;
  const Big from = sin((Big(1) - t) * h) / sin(h), to = sin(t * h) / sin(h);
  BigQuaternion q;
  for (std::size_t k = 0; k < 4; ++k) q[k] = from * a[k] + to * b[k];
  return q;
}

inline BigQuaternion lerp(const std::array<double, 4>& a, const std::array<double, 4>& b, const Big& t) {
  BigQuaternion q;
  for (std::size_t k = 0; k < 4; ++k) q[k] = (Big(1) - t) * Big(a[k]) + t * Big(b[k]);
  return q;
}

/// A point of the Bezier curve.
inline BigPoint on_curve(const CurvedCorner& corner, const Big& t) {
  std::array<BigPoint, 4> b;
  const std::size_t count = static_cast<std::size_t>(corner.control_points);
  for (std::size_t i = 0; i < count; ++i) b[i] = {corner.points[i].x, corner.points[i].y, corner.points[i].z};
  for (std::size_t left = count; left > 1; --left) {
    for (std::size_t i = 0; i + 1 < left; ++i) {
      for (std::size_t k = 0; k < 3; ++k) b[i][k] = (Big(1) - t) * b[i][k] + t * b[i + 1][k];
    }
  }
  return b[0];
}

/// Where the body's origin is.
inline BigPoint position_of(const RigidMotion& motion, const Big& t) {
  const auto& [a, b] = motion.inner;
  switch (motion.control_points) {
    case 3: return on_curve(CurvedCorner::on_curve({motion.p0, a, motion.p1}), t);
    case 4: return on_curve(CurvedCorner::on_curve({motion.p0, a, b, motion.p1}), t);
    default: return on_curve(CurvedCorner::on_curve({motion.p0, motion.p1}), t);
  }
}

/// The vector part of q X q* / |q|^2, and the position.
inline BigPoint placed(const BigQuaternion& q, const Vec3& point, const RigidMotion& motion, const Big& t) {
  const BigPoint x = {point.x, point.y, point.z};
  const BigPoint position = position_of(motion, t);
  // q X = (-v . X, w X + v x X), and then by q* = (w, -v).
  const Big w = Big(0) - (q[1] * x[0] + q[2] * x[1] + q[3] * x[2]);
  BigPoint inner, result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    inner[k] = q[0] * x[k] + q[1 + l] * x[m] - q[1 + m] * x[l];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    const Big turned = q[0] * inner[k] - w * q[1 + k] - (inner[l] * q[1 + m] - inner[m] * q[1 + l]);
    result[k] = turned / dot(q, q) + position[k];
  }
  return result;
}

/// A corner whose body turns at a constant rate.
inline BigPoint true_position(const CurvedQuery& query, std::size_t c, const Big& t) {
  const CurvedCorner& corner = query.corners[c];
  if (corner.motion == CurvedCorner::kOnCurve) return on_curve(corner, t);
  const RigidMotion& motion = query.motions[static_cast<std::size_t>(corner.motion)];
  return placed(slerp(unit(motion.q0), unit(motion.q1), t), corner.points[0], motion, t);
}

/// A corner as `solve` reads it.
inline BigPoint rational_position(const CurvedQuery& query, std::size_t c, const Big& t) {
  const CurvedCorner& corner = query.corners[c];
  if (corner.motion == CurvedCorner::kOnCurve) return on_curve(corner, t);
  const RigidMotion& motion = query.motions[static_cast<std::size_t>(corner.motion)];
  return placed(lerp(motion.q0, motion.q1, t), corner.points[0], motion, t);
}

}  // namespace touchstone::tests
