// SPDX-License-Identifier: MIT
#include "filters/filters.hpp"

#include <optional>

#include "filters/boxes.hpp"
#include "filters/bracket.hpp"
#include "filters/entry.hpp"
#include "filters/planar_point_edge.hpp"
#include "filters/rescaled.hpp"
#include "filters/separating_direction.hpp"
#include "filters/shared_corner.hpp"

namespace touchstone::filters {

namespace {

/// What the shared corner and the boxes, which are tests at any scale, leave open.
Decision decide_by_products(const Question& question, Answer& answer) {
  const Query& query = question.query;
  // Before the separating directions: most queries that come so far touch, or have a root and pass each other by.
  Finding finding = Finding::uncertain;
  if (has_cubic(query.kind)) {
    finding = decide_in_brackets(question, answer);
  } else if (const std::optional<Query> edges = as_crossing_edges(query)) {
    finding = decide_in_brackets({*edges, question.t_max, question.exact_value, question.wanted}, answer);
    if (finding == Finding::contact) name_point_and_edge(answer);
  }
  if (finding != Finding::uncertain) {
    answer.level = Level::bracket;
    return {finding, Test::bracket};
  }

  const Test separation = test_that_separates(query);
  if (separation != Test::none) return {Finding::no_contact, separation};
  return {};
}

}  // namespace

Decision decide_by_filters(const Question& question, Answer& answer) {
  const Query& query = question.query;
  answer.level = Level::filter;
  if (touch_in_shared_corner(query, question.t_max, answer)) return {Finding::contact, Test::shared_corner};
  if (boxes_disjoint(query)) return {Finding::no_contact, Test::boxes};
  if (!seems_extreme(query)) {
    const Decision decision = decide_by_products(question, answer);
    if (decision.finding != Finding::uncertain) return decision;
    answer.level = Level::filter;
  }
  const std::optional<Query> scaled = rescaled(query);
  if (!scaled) return seems_extreme(query) ? decide_by_products(question, answer) : Decision();
  if (same_side(*scaled)) return {Finding::no_contact, Test::same_side};
  return decide_by_products({*scaled, question.t_max, question.exact_value, question.wanted}, answer);
}

Finding decide_by_filters(const Query& query, const Separation& separation, double t_max, Answer& answer) {
  answer.level = Level::filter;
  if (boxes_apart(query, separation.distance)) return Finding::no_contact;
  const RelativeCorners corners = relative_corners(query);
  if (separates_by(corners, between_closest_points(corners, query.kind), separation)) return Finding::no_contact;
  const Finding finding = decide_entry(query, separation, t_max, answer);
  if (finding != Finding::uncertain) {
    answer.level = Level::bracket;
    return finding;
  }
  const bool apart =
      (has_cubic(query.kind) && separates_by(corners, normal_at_mid_step(corners, query.kind), separation)) ||
      separates_by(corners, between_centres(corners), separation);
  return apart ? Finding::no_contact : Finding::uncertain;
}

}  // namespace touchstone::filters
