// SPDX-License-Identifier: MIT
#include "filters/filters.hpp"

#include <optional>

#include "filters/apart/boxes.hpp"
#include "filters/apart/separating_direction.hpp"
#include "filters/apart/shared_corner.hpp"
#include "filters/bracket.hpp"
#include "filters/planar_point_edge.hpp"
#include "filters/rescaled.hpp"
#include "filters/separation/entry.hpp"

namespace touchstone::filters {

namespace {

BracketFinding decide_in_any_brackets(const Question& question, Answer& answer) {
  BracketFinding found;
  if (has_cubic(question.query.kind)) {
    found = decide_in_brackets(question, answer);
  } else if (const std::optional<Query> edges = as_crossing_edges(question.query)) {
    found = decide_in_brackets({*edges, question.t_max, question.exact_value, question.wanted}, answer);
    if (found.finding == Outcome::contact) name_point_and_edge(answer);
  }
  answer.level = found.finding == Outcome::uncertain ? Level::filter : Level::bracket;
  return found;
}

Decision decide_by_direction(const Query& query, Test test) {
  return separated(query) ? Decision{Outcome::no_contact, test} : Decision();
}

}  // namespace

Decision decide_by_filters(const Question& question, Answer& answer) {
  const Query& query = question.query;
  answer.level = Level::filter;
  if (touch_in_shared_corner(query, question.t_max, answer)) return {Outcome::contact, Test::shared_corner};
  if (boxes_disjoint(query)) return {Outcome::no_contact, Test::boxes};

  // Before the separating direction: most queries that come so far touch, or have a root and pass each other by.
  const BracketFinding found = decide_in_any_brackets(question, answer);
  if (found.finding != Outcome::uncertain) return {found.finding, Test::bracket};
  const bool extreme = seems_extreme(query);  // then the direction is tried once, on the rescaled query
  if (!extreme && !found.close) {
    const Decision decision = decide_by_direction(query, Test::separated);
    if (decision.finding != Outcome::uncertain) return decision;
  }
  const std::optional<Query> scaled = rescaled(query);
  if (!scaled) return extreme ? decide_by_direction(query, Test::separated) : Decision();
  const BracketFinding now =
      decide_in_any_brackets({*scaled, question.t_max, question.exact_value, question.wanted}, answer);
  if (now.finding != Outcome::uncertain) return {now.finding, Test::rescaled};
  return now.close ? Decision() : decide_by_direction(*scaled, Test::rescaled);
}

Outcome decide_by_filters(const Query& query, const Separation& separation, double t_max, Answer& answer,
                          numbers::BoundedPair* time) {
  answer.level = Level::filter;
  if (boxes_apart(query, separation.distance)) return Outcome::no_contact;
  const RelativeCorners corners = relative_corners(query);
  if (separates_by(corners, between_closest_points(corners, query.kind), separation)) return Outcome::no_contact;
  const Outcome finding = decide_entry(query, separation, t_max, answer, time);
  if (finding != Outcome::uncertain) {
    answer.level = Level::bracket;
    return finding;
  }
  const bool apart =
      (has_cubic(query.kind) && separates_by(corners, normal_at_mid_step(corners, query.kind), separation)) ||
      separates_by(corners, between_centres(corners), separation);
  return apart ? Outcome::no_contact : Outcome::uncertain;
}

}  // namespace touchstone::filters
