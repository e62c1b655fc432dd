// SPDX-License-Identifier: MIT
#include "filters/filters.hpp"

#include "filters/bracket.hpp"
#include "filters/planar_point_edge.hpp"
#include "filters/same_side_by_ends.hpp"
#include "filters/separating_direction.hpp"
#include "filters/shared_corner.hpp"

namespace touchstone::filters {
namespace {

/// A plane that separates the elements all along.
Proof direction_proof(const Query& query) noexcept {
  const RelativeCorners corners = relative_corners(query);
  if (separates(corners, between_closest_points(corners, query.kind))) return Proof::closest_points;
  if (has_cubic(query.kind) && separates(corners, normal_at_mid_step(corners, query.kind))) return Proof::normal;
  return separates(corners, between_centres(corners)) ? Proof::centres : Proof::none;
}

/// The bracket level.
Decision decide_by_roots(const Query& query, double t_max, Want want, ExactValue exact_value, Answer& answer) {
  // Computed again: keeping it from the first test would slow down the many queries that the first test settles.
  const Frame frame = frame_of(query);
  return bracket(query, frame, coplanarity_coefficients(frame), t_max, want, exact_value, answer);
}

/// The same of a point-edge query, when it is planar.
Decision decide_in_plane(const Query& query, double t_max, Want want, ExactValue exact_value, Answer& answer) {
  Query edges;
  if (!as_crossing_edges(query, edges)) return Decision::uncertain;
  const Decision decision = decide_by_roots(edges, t_max, want, exact_value, answer);
  if (decision == Decision::contact) name_point_and_edge(answer);
  return decision;
}

}  // namespace

bool same_side(const Query& query) noexcept { return has_cubic(query.kind) && certain_same_side_by_ends(query); }

Proof separation_proof(const Query& query) noexcept {
  if (same_side(query)) return Proof::same_side;
  return boxes_disjoint(query) ? Proof::boxes : direction_proof(query);
}

Decision decide(const Query& query, double t_max, Want want, ExactValue exact_value, Answer& answer) {
  answer.level = Level::filter;
  if (touch_in_shared_corner(query, t_max, answer)) return Decision::contact;
  if (boxes_disjoint(query)) return Decision::no_contact;
  // Before the other proofs of separation: of what comes so far most touch, or have a root and pass beside each other.
  const Decision decision = has_cubic(query.kind)            ? decide_by_roots(query, t_max, want, exact_value, answer)
                            : query.kind == Kind::point_edge ? decide_in_plane(query, t_max, want, exact_value, answer)
                                                             : Decision::uncertain;
  if (decision != Decision::uncertain) {
    answer.level = Level::bracket;
    return decision;
  }
  return direction_proof(query) != Proof::none ? Decision::no_contact : Decision::uncertain;
}

}  // namespace touchstone::filters
