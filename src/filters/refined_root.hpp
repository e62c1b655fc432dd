// A certain contact's time driven to its neighbouring doubles, and its weights, by double-double evaluation.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "filters/bernstein_cubic.hpp"
#include "filters/filters.hpp"

namespace touchstone::filters {

/// Bounds U, W, R of the coordinates of u, w, r, and the axis along which n is certainly not zero at the root.
struct ContactFrame {
  double u, w, r;
  std::size_t axis;
};

/// What is to be said of one root of V.
enum class RootVerdict : std::uint8_t {
  contact,    ///< the elements touch there; the answer is written
  outside,    ///< they do not touch there
  too_late,   ///< the root lies after t_max
  uncertain   ///< a time, a side or a weight cannot be certified: a touched corner or border, for one
};

/// Decides a simple root of V, given as BernsteinCubic certifies it. `inside` says that the side conditions are known to
/// hold; otherwise they are decided here. Asks `exact_sign` when the time is too close to a double.
RootVerdict refine_root(const Query& query, const BernsteinCubic& cubic, const BernsteinCubic::Root& root,
                        const ContactFrame& frame, bool inside, double t_max, ExactSign exact_sign, Answer& answer);

}  // namespace touchstone::filters
