// The text of coplanar_gradient. It is compiled for several processors: see numbers/doubles/pack.hpp for what that
// forbids.
//
// At the time T the gradient of V by the corners, g, and the change of V in time, s = V'(T), give the gradient of the
// time: -(1 - T) g / s by the corners at t = 0, and -T g / s by those at t = 1. By u, w and r, V has the gradients w x
// r, r x u and n = u x w. At T, where V = 0 and n is not 0, all of them are multiples of n; and so an axis along which
// n is 0 at all times has exact zeros.
//
// Errors. Let e = 2^-53, and U be the bounds on the coordinates of u over the step, one along each axis; likewise W and
// R, and D_u, D_w, D_r of the velocities, where D_u <= 2 U. Of a cross product, as of w and r, M is the vector of
// bounds, W_i R_j + W_j R_i along the third axis. Its slope has the bounds M' = D_w i R_j + W_i D_r j + ...; half its
// second derivative D_w i D_r j + D_w j D_r i, at most M'. P = R . M for n = u x w bounds V. P' is the sum of D_u . M
// for w x r, D_w . M for r x u and D_r . M for n: it bounds V'. The same sum with M' is at most 4 P', and it bounds
// V''.
//   A coordinate: 8 e^2 U (see contact_values.hpp). A product of two: 24 e^2, low part 3 e. A cross product: the
//   difference of two products, 31 e^2 M, low part 4 e M.
//   V: 31 + 8 e^2 P from the operands, the products 8 e^2 P, low parts 3 e P, and two sums, 16 e^2 P: 63 e^2 P.
//   A velocity: 6 e^2 U, low part e D. In doubles: e D more. The slope of V at t, in doubles: 5 e D M from the
//   operands, 2 e D M from a product, and 8 e of all for the sums: 15 e P' and 18 e^2 P.
//   The offset of T from t, at most 2 e, is -V / S, with S the mean slope, which differs from that at t by at most 4 e
//   P'. The quotient is off by at most (63 e^2 P + 2 e |offset slope| + |offset| (19 e P' + 18 e^2 P)) / |S|, less than
//   (66 P + 48 P') e^2 / |slope| =: `later` where S is within a 2^-10th of the slope. Elsewhere the slope is below 2^16
//   e P', and s below 2^17 e P'. Its error's bound below, at least 4 P' later, is then too large for it.
//   A cross product at T: 31 e^2 M; its slope in doubles, 8 e M' and 12 e^2 M, times the offset; the product with the
//   offset, 2 e^2 M'; the sum with the low part, e (4 e M + 2 e M'); the second derivative, 4 e^2 M'; and the offset's
//   own error times M'. In all 35 e^2 M + 24 e^2 M' + later M'.
//   Sums of them for a corner: 10 e^2 of the sum of the three M. The product with the factor, without its one rounding
//   to a double: 22 e^2 of that sum.
//   s: products of a velocity and a cross product, 6 e^2 U M from the one, D times its error from the other, 8 e^2 D M
//   of their own, low part 3 e D M; 8 sums of such low parts: 96 e^2 P'. In all 18 e^2 P + 239 e^2 P' + 4 P' later.
//   The factor: the offset's error, and 16 e^2 of T or 1 - T and of s.
// The constants below have a reserve for the rounding of the bounds. With a relative 2^-58 of each, for a component,
// for s, and for T or 1 - T, a result is within a relative 2^-56 before its rounding. Then the rounded one is the true
// one or a double beside it, at a power of two as well.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include "filters/contact_values_steps.hpp"
#include "filters/coplanar_gradient.hpp"

namespace touchstone::filters {
namespace {

/// Of a moving difference of two corners: its velocity, and the bounds on both over the step.
struct Course {
  Precise<Coordinates> velocity;
  Coordinates most, fastest;
};

TOUCHSTONE_INLINE geometry::Frame<Course> courses_of(const Query& query) noexcept {
  const auto corner = corners_of(query);
  return geometry::frame_of(query.kind, [&corner](std::size_t i, std::size_t j) -> Course {
    const auto from = numbers::two_difference(corner(0, i), corner(0, j));
    const auto to = numbers::two_difference(corner(1, i), corner(1, j));
    const auto velocity = numbers::normalised(to - from);
    return {velocity, larger(magnitude(from.high), magnitude(to.high)), magnitude(velocity.high)};
  });
}

TOUCHSTONE_INLINE double sum_of_coordinates(const Coordinates& a) noexcept { return a.v[0] + a.v[1] + a.v[2]; }

/// The bounds on the coordinates of a cross product.
TOUCHSTONE_INLINE Coordinates cross_bounds(const Coordinates& a, const Coordinates& b) noexcept {
  return yzx(a) * zxy(b) + zxy(a) * yzx(b);
}
TOUCHSTONE_INLINE Coordinates cross_bounds(const Course& a, const Course& b) noexcept {
  return cross_bounds(a.most, b.most);
}
/// Those on its slope.
TOUCHSTONE_INLINE Coordinates slope_bounds(const Course& a, const Course& b) noexcept {
  return cross_bounds(a.fastest, b.most) + cross_bounds(a.most, b.fastest);
}

TOUCHSTONE_INLINE bool holds_in_all(const numbers::PackLanes<4>::Mask& mask) noexcept {
  return (mask[0] & mask[1] & mask[2]) != 0;
}

/// Whether each coordinate is 0, or such that no product here overflows, or underflows by more than the bounds allow.
TOUCHSTONE_INLINE auto in_range(const Coordinates& most) noexcept {
  return (most <= 0.0) | ((most >= 0x1p-200) & (most <= 0x1p200));
}

/// a x b at a time so much later, where it is `value` now.
TOUCHSTONE_INLINE Precise<Coordinates> cross_later(const Precise<Coordinates>& value, const Moving<Coordinates>& a,
                                                   const Course& a_course, const Moving<Coordinates>& b,
                                                   const Course& b_course, double later) noexcept {
  const Coordinates slope =
      cross_of_lanes(a_course.velocity.high, b.value.high) + cross_of_lanes(a.value.high, b_course.velocity.high);
  return numbers::normalised(Precise<Coordinates>{value.high, value.low + later * slope});
}

/// factor v, rounded once.
TOUCHSTONE_INLINE Coordinates rounded_product(const numbers::DoubleDouble& factor,
                                              const Precise<Coordinates>& v) noexcept {
  const Precise<Coordinates> factors = {in_each(v.high, factor.high), in_each(v.high, factor.low)};
  return numbers::rounded(factors * v);
}

/// What makes up the gradient, at the time of the contact.
struct GradientTerms {
  numbers::DoubleDouble time, rest, speed;         ///< T, 1 - T and s
  std::array<Precise<Coordinates>, 4> by_corners;  ///< g
  double time_error, speed_error;                  ///< of T and 1 - T, and of s
  Coordinates error;                               ///< of g
  numbers::PackLanes<4>::Mask zero;                ///< where g is 0
  bool in_range;                                   ///< elsewhere the errors mean nothing
};

TOUCHSTONE_INLINE GradientTerms gradient_terms(const Query& query, double toi, double toi_upper) noexcept {
  const double t = 1 - (1 - toi);  // exact_to_one
  const MovingFrame<Coordinates> at = moving_frame(query, t);
  const geometry::Frame<Course> course = courses_of(query);
  const auto& [u, w, r] = at.moving;
  const Precise<Coordinates> by_u = cross_of_lanes(w.value, r.value), by_w = cross_of_lanes(r.value, u.value);
  const double slope = sum_of_coordinates(course.u.velocity.high * by_u.high + course.w.velocity.high * by_w.high +
                                          course.r.velocity.high * at.normal.high);
  const double offset = toi == toi_upper ? toi - t : -numbers::rounded(precise_coplanarity(at)) / slope;
  const geometry::Frame<Precise<Coordinates>> by = {cross_later(by_u, w, course.w, r, course.r, offset),
                                                    cross_later(by_w, r, course.r, u, course.u, offset),
                                                    cross_later(at.normal, u, course.u, w, course.w, offset)};
  const Precise<Coordinates> products = course.u.velocity * by.u + course.w.velocity * by.w + course.r.velocity * by.r;

  const Coordinates u_bounds = cross_bounds(course.w, course.r), w_bounds = cross_bounds(course.r, course.u),
                    r_bounds = cross_bounds(course.u, course.w);
  const Coordinates slopes =
      slope_bounds(course.w, course.r) + slope_bounds(course.r, course.u) + slope_bounds(course.u, course.w);
  const double size = kUnitSquared * sum_of_coordinates(course.r.most * r_bounds);
  const double rate = kUnitSquared * sum_of_coordinates(course.u.fastest * u_bounds + course.w.fastest * w_bounds +
                                                        course.r.fastest * r_bounds);
  const double later = (66 * size + 48 * rate) / std::fabs(slope);
  return {numbers::two_sum(t, offset),
          numbers::two_difference(1 - t, offset),
          numbers::normalised(coordinate(products, 0) + coordinate(products, 1) + coordinate(products, 2)),
          geometry::gradient_by_corners(query.kind, by),
          later,
          18.5 * size + (240 + (4.5 / kUnitSquared) * later) * rate,
          (68.5 * kUnitSquared) * (u_bounds + w_bounds + r_bounds) + (24.5 * kUnitSquared + 1.5 * later) * slopes,
          r_bounds <= 0.0,
          std::fabs(offset) <= 0x1p-52 &&
              holds_in_all(in_range(course.u.most) & in_range(course.w.most) & in_range(course.r.most))};
}

inline bool gradient_at_contact(const Query& query, double toi, double toi_upper,
                                geometry::EndGradients& gradient) noexcept {
  constexpr double kLittle = 0x1p-58;
  const GradientTerms terms = gradient_terms(query, toi, toi_upper);
  const auto& corners = terms.by_corners;
  const bool at_end = toi == 1;
  const Coordinates least = smaller(smaller(magnitude(corners[0].high), magnitude(corners[1].high)),
                                    smaller(magnitude(corners[2].high), magnitude(corners[3].high)));
  const bool certain = terms.in_range && terms.speed_error <= kLittle * std::fabs(terms.speed.high) &&
                       terms.time_error <= kLittle * terms.time.high &&
                       (at_end || terms.time_error <= kLittle * terms.rest.high) &&
                       holds_in_all(terms.zero | (terms.error <= kLittle * least));
  if (!certain) return false;
  const numbers::DoubleDouble by_start = -(terms.rest / terms.speed), by_end = -(terms.time / terms.speed);
  const auto to_vector = [&terms](const Coordinates& v) {
    const Coordinates x = chosen(terms.zero, in_each(v, 0), v);
    return Vec3{x.v[0], x.v[1], x.v[2]};
  };
  for (std::size_t i = 0; i < 4; ++i) {
    gradient[0][i] = at_end ? Vec3{0, 0, 0} : to_vector(rounded_product(by_start, corners[i]));
    gradient[1][i] = to_vector(rounded_product(by_end, corners[i]));
  }
  return true;
}

}  // namespace
}  // namespace touchstone::filters
