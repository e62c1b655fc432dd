// The closest points of two elements on straight lines, at all times from one until shortly after it, in doubles that
// carry their bounds along. entry.cpp describes the entry of a Euclidean separation with them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include "filters/separation/precise_closest.hpp"
#include "filters/separation/straight_differences.hpp"
#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

using numbers::Bounded;

/// Let c be the difference of the points whose parameters are those of `found`, at all times from its time until h
/// later. The closest points' difference is c - a u - b w, with corrections a and b of the free parameters: they solve
/// the linear equations that its products with u and w, or with u - w on the border s + q = 1, are 0.
class ClosestNear {
 public:
  /// @param found  at a time t in [0, 1]
  /// @param h      in [0, 1]
  ClosestNear(const Step& step, const PreciseClosest& found, double h) noexcept
      : domain_(step.domain),
        free_(free_parameters(step.domain, found.p)),
        found_(found),
        u_(near(found.u, slope_of(step.u), step.size, h)),
        w_(near(found.w, slope_of(step.w), step.size, h)) {
    const BoundedVector u_slope = slope_of(step.u), w_slope = slope_of(step.w);
    const Bounded s = Bounded{found.p.s, 0} + Bounded{found.ds, 0}, q = Bounded{found.p.q, 0} + Bounded{found.dq, 0};
    BoundedVector velocity = slope_of(step.r) - scaled(s, u_slope) - scaled(q, w_slope);
    BoundedVector c = near(found.c, velocity, step.size, h);
    cu_slope_ = dot(velocity, u_) + dot(c, u_slope);
    cw_slope_ = dot(velocity, w_) + dot(c, w_slope);
    const double error = kClosestError * step.size;
    cu_ = {found.cu, error * step.u_size + kUnit * std::fabs(found.cu)};
    cw_ = {found.cw, error * step.w_size + kUnit * std::fabs(found.cw)};
    difference_ = {found.difference, error * (step.u_size + step.w_size) + kUnit * std::fabs(found.difference)};
    uu_ = dot(u_, u_);
    ww_ = dot(w_, w_);
    uw_ = dot(u_, w_);
    const Bounded whole = {0.5 * h, 0.5 * h};
    const auto [a, b] = corrections_at(whole);
    const double most = std::fabs(a.value) + a.error + (std::fabs(b.value) + b.error);
    certain_ = most <= kMostCorrection && others_are_farther(whole, a, b);
    for (std::size_t k = 0; k < 3; ++k) {  // c - a u - b w, and its velocity
      c[k].error += most * step.size;
      velocity[k].error += most * (step.speed + 0x1p-50 * step.size);  // the slopes are off by roundings of u and w
    }
    fall_ = Bounded{-2, 0} * dot(c, velocity);
  }

  /// Whether the closest points of the elements are the only ones, and their parameters are free as those of `found`,
  /// at all these times.
  bool certain() const noexcept { return certain_; }
  /// How fast the square of the distance falls, at all these times.
  const Bounded& fall() const noexcept { return fall_; }

  /// Writes the contact's closest points at a time so much later, which is at most h. False where they are not known
  /// within 2^-52.
  bool name(Kind kind, const Bounded& later, Answer& answer) const noexcept {
    constexpr double kMostError = 0x1p-52;
    const auto [a, b] = corrections_at(later);
    if (!(a.error <= kMostError && b.error <= kMostError)) return false;
    name_closest(kind, found_.p.s + (found_.ds + a.value), found_.p.q + (found_.dq + b.value), free_, answer);
    answer.contact = true;
    return true;
  }

 private:
  using BoundedVector = geometry::Vector<Bounded>;
  struct Corrections {
    Bounded a, b;
  };

  static BoundedVector slope_of(const Vector (&v)[2]) noexcept {
    BoundedVector slope;
    for (std::size_t k = 0; k < 3; ++k) slope[k] = near_time(v[0][k], v[1][k], 0, 0).slope;
    return slope;
  }
  /// What is rounded from a double-double at the time of `found`, at all times until h later. The double-double is off
  /// by less than 80 e^2 S.
  static BoundedVector near(const Vector& v, const BoundedVector& slope, double size, double h) noexcept {
    BoundedVector found;
    for (std::size_t k = 0; k < 3; ++k) {
      found[k] = {v[k], kUnit * std::fabs(v[k]) + 0x1p-99 * size + h * (std::fabs(slope[k].value) + slope[k].error)};
    }
    return found;
  }
  static BoundedVector scaled(const Bounded& factor, const BoundedVector& v) noexcept {
    return {{factor * v[0], factor * v[1], factor * v[2]}};
  }

  Corrections corrections_at(const Bounded& later) const noexcept {
    const Bounded cu = cu_ + later * cu_slope_, cw = cw_ + later * cw_slope_;
    switch (free_) {
      case Free::none: break;
      case Free::s: return {cu / uu_, {}};
      case Free::q: return {{}, cw / ww_};
      case Free::sum: {
        const BoundedVector e = u_ - w_;
        const Bounded a = (later * (cu_slope_ - cw_slope_) - difference_) / dot(e, e);
        return {a, -a};
      }
      case Free::both: {
        const Bounded determinant = uu_ * ww_ - uw_ * uw_;
        return {(cu * ww_ - cw * uw_) / determinant, (cw * uu_ - cu * uw_) / determinant};
      }
    }
    return {};
  }

  /// Free parameters are then inside: see are_inside.
  static constexpr double kMostCorrection = 0x1p-22;

  bool others_are_farther(const Bounded& later, const Bounded& a, const Bounded& b) const noexcept {
    const Bounded along_u = cu_ + later * cu_slope_ - a * uu_ - b * uw_;
    const Bounded along_w = cw_ + later * cw_slope_ - a * uw_ - b * ww_;
    const Bounded w_minus_u =
        difference_ + later * (cw_slope_ - cu_slope_) - a * (uw_ - uu_) - b * (ww_ - uw_);  // the first two may cancel
    bool farther = true;
    for_each_multiplier(domain_, free_, found_.p, [&](int i, int j) {
      const int sign = j == 0 ? i * along_u.sign() : i == 0 ? j * along_w.sign() : j * w_minus_u.sign();
      farther &= sign > 0;
    });
    return farther;
  }

  Domain domain_;
  Free free_;
  const PreciseClosest& found_;
  BoundedVector u_, w_;
  Bounded cu_, cw_, difference_, cu_slope_, cw_slope_;
  Bounded uu_, ww_, uw_;
  bool certain_;
  Bounded fall_;
};

}  // namespace touchstone::filters
