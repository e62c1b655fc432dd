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

/// For a root of V that is certainly a crossing of both interiors: the complete answer, or no contact when the root lies
/// after t_max, or uncertain when a time or a weight cannot be certified (a time that is a double, for one).
Decision refine_contact(const Query& query, const BernsteinCubic& cubic, const BernsteinCubic::Root& root,
                        const ContactFrame& frame, double t_max, Answer& answer) noexcept;

}  // namespace touchstone::filters
