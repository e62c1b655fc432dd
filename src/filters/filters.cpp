// SPDX-License-Identifier: MIT
#include "filters/filters.hpp"

#include "filters/bracket.hpp"
#include "filters/same_side.hpp"
#include "filters/separating_direction.hpp"
#include "filters/shared_corner.hpp"

namespace touchstone::filters {
namespace {

/// Proofs that do without the cubic: first those that often succeed, then those that are only worth their time before
/// exact arithmetic.
Proof likely_direction(const Query& query, RelativeCorners& corners) noexcept {
  if (boxes_disjoint(query)) return Proof::boxes;
  corners = relative_corners(query);
  return separates(corners, between_closest_points(corners, query.kind)) ? Proof::closest_points : Proof::none;
}

Proof other_direction(const Query& query, const RelativeCorners& corners) noexcept {
  if (has_cubic(query.kind) && separates(corners, normal_at_mid_step(corners, query.kind))) return Proof::normal;
  return separates(corners, between_centres(corners)) ? Proof::centres : Proof::none;
}

}  // namespace

Proof separation_proof(const Query& query) noexcept {
  if (has_cubic(query.kind)) {
    const Frame frame = frame_of(query);
    if (certain_same_side(frame, coplanarity_coefficients(frame))) return Proof::same_side;
  }
  RelativeCorners corners;
  const Proof proof = likely_direction(query, corners);
  return proof != Proof::none ? proof : other_direction(query, corners);
}

bool same_side(const Query& query, Cubic& cubic) noexcept {
  if (!has_cubic(query.kind)) return false;
  cubic.frame = frame_of(query);
  cubic.coefficients = coplanarity_coefficients(cubic.frame);
  return certain_same_side(cubic.frame, cubic.coefficients);
}

Decision decide(const Query& query, const Cubic& cubic, double t_max, Want want, ExactSign exact_sign, Answer& answer) {
  answer.level = Level::filter;
  if (touch_in_shared_corner(query, t_max, answer)) return Decision::contact;
  RelativeCorners corners;
  if (likely_direction(query, corners) != Proof::none) return Decision::no_contact;
  Decision decision = Decision::uncertain;
  if (has_cubic(query.kind)) {
    decision = bracket(query, cubic.frame, cubic.coefficients, t_max, want, exact_sign, answer);
    if (decision != Decision::uncertain) answer.level = Level::bracket;
  }
  if (decision == Decision::uncertain && other_direction(query, corners) != Proof::none) return Decision::no_contact;
  return decision;
}

}  // namespace touchstone::filters
