// A certain contact's time driven to its neighbouring doubles, and its weights, by double-double evaluation.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "filters/filters.hpp"

namespace touchstone::filters {

/// A simple root of V in plain numbers: it lies in [t - radius, t + radius], where V' keeps the sign of `slope` and is at
/// least half of it (see BernsteinCubic::Root). At h away from t, h at most the radius, V' differs from `slope` by at most
/// slope_error + curvature h.
struct SimpleRoot {
  double t;  ///< 1 - t is a double
  double radius;
  double slope;
  double slope_error;
  double curvature;
};

/// Bounds U, W, R of the coordinates of u, w, r, their product, and the axis along which n is certainly not zero at the root.
struct ContactFrame {
  double u, w, r;
  double product;
  std::size_t axis;
};

/// What is to be said of one root of V.
enum class RootVerdict : std::uint8_t {
  contact,   ///< the elements touch there; the answer is written
  outside,   ///< they do not touch there
  too_late,  ///< the root lies after t_max
  uncertain  ///< a time, a side or a weight cannot be certified: a touched corner or border, for one
};

/// Decides a simple root of V. `inside` says that the side conditions are known to hold; otherwise they are decided
/// here. Asks `exact_value` when the time is too close to a double.
RootVerdict refine_root(const Query& query, const SimpleRoot& root, const ContactFrame& frame, bool inside,
                        double t_max, ExactValue exact_value, Answer& answer);

}  // namespace touchstone::filters
