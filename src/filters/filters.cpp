// SPDX-License-Identifier: MIT
#include "filters/filters.hpp"

#include "filters/bracket.hpp"
#include "filters/same_side.hpp"
#include "filters/separating_direction.hpp"

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

/// The proofs that do without the cubic.
Proof direction_proof(const Query& query) noexcept {
  if (boxes_disjoint(query)) return Proof::boxes;
  const RelativeCorners corners = relative_corners(query);
  if (separates(corners, between_closest_points(corners, query.kind))) return Proof::closest_points;
  if (has_cubic(query.kind) && separates(corners, normal_at_mid_step(corners, query.kind))) return Proof::normal;
  if (separates(corners, between_centres(corners))) return Proof::centres;
  return Proof::none;
}

void answer_no_contact(Level level, Answer& answer) noexcept {
  answer = Answer();
  answer.level = level;
}

}  // namespace

Proof separation_proof(const Query& query) noexcept {
  if (has_cubic(query.kind)) {
    const Frame frame = frame_of(query);
    if (same_side_all_along(coplanarity_coefficients(frame), coplanarity_bounds(frame))) return Proof::same_side;
  }
  return direction_proof(query);
}

Decision decide(const Query& query, double t_max, ExactSign exact_sign, Answer& answer) {
  if (!has_cubic(query.kind)) {
    if (direction_proof(query) == Proof::none) return Decision::uncertain;
    answer_no_contact(Level::filter, answer);
    return Decision::no_contact;
  }
  const Frame frame = frame_of(query);
  const auto coefficients = coplanarity_coefficients(frame);
  if (same_side_all_along(coefficients, coplanarity_bounds(frame)) || direction_proof(query) != Proof::none) {
    answer_no_contact(Level::filter, answer);
    return Decision::no_contact;
  }
  const Decision decision = bracket(query, frame, coefficients, t_max, exact_sign, answer);
  if (decision == Decision::no_contact) answer_no_contact(Level::bracket, answer);
  return decision;
}

}  // namespace touchstone::filters
