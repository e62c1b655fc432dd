// SPDX-License-Identifier: MIT
#include "filters/filters.hpp"

#include "filters/bracket.hpp"
#include "filters/same_side.hpp"
#include "filters/separating_direction.hpp"
#include "filters/shared_corner.hpp"

namespace touchstone::filters {
namespace {

Vector difference(const Vec3& a, const Vec3& b) noexcept { return {{a.x - b.x, a.y - b.y, a.z - b.z}}; }

/// Edge-edge: u = a1 - a0, w = b1 - b0, r = b0 - a0. Vertex-face: u = f1 - f0, w = f2 - f0, r = v - f0.
Frame frame_of(const Query& q) noexcept {
  if (q.kind == Kind::edge_edge) {
    return {difference(q.start[1], q.start[0]), difference(q.start[3], q.start[2]), difference(q.start[2], q.start[0]),
            difference(q.end[1], q.end[0]),     difference(q.end[3], q.end[2]),     difference(q.end[2], q.end[0])};
  }
  return {difference(q.start[2], q.start[1]), difference(q.start[3], q.start[1]), difference(q.start[0], q.start[1]),
          difference(q.end[2], q.end[1]),     difference(q.end[3], q.end[1]),     difference(q.end[0], q.end[1])};
}

bool has_cubic(Kind kind) noexcept { return kind == Kind::edge_edge || kind == Kind::vertex_face; }

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
    if (same_side_all_along(coplanarity_coefficients(frame), coplanarity_bounds(frame))) return Proof::same_side;
  }
  RelativeCorners corners;
  const Proof proof = likely_direction(query, corners);
  return proof != Proof::none ? proof : other_direction(query, corners);
}

Decision decide(const Query& query, double t_max, Want want, ExactSign exact_sign, Answer& answer) {
  answer.level = Level::filter;
  RelativeCorners corners;
  if (!has_cubic(query.kind)) {
    if (touch_in_shared_corner(query, t_max, answer)) return Decision::contact;
    const bool proved = likely_direction(query, corners) != Proof::none || other_direction(query, corners) != Proof::none;
    return proved ? Decision::no_contact : Decision::uncertain;
  }
  const Frame frame = frame_of(query);
  const auto coefficients = coplanarity_coefficients(frame);
  if (same_side_all_along(coefficients, coplanarity_bounds(frame))) return Decision::no_contact;
  if (touch_in_shared_corner(query, t_max, answer)) return Decision::contact;
  if (likely_direction(query, corners) != Proof::none) return Decision::no_contact;
  const Decision decision = bracket(query, frame, coefficients, t_max, want, exact_sign, answer);
  if (decision == Decision::uncertain) {
    return other_direction(query, corners) != Proof::none ? Decision::no_contact : Decision::uncertain;
  }
  answer.level = Level::bracket;
  return decision;
}

}  // namespace touchstone::filters
