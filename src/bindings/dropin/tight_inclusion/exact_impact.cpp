// SPDX-License-Identifier: MIT
#include "dropin/tight_inclusion/exact_impact.hpp"

#include <touchstone/answer.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>

namespace touchstone::dropin {

namespace {

Vec3 corner_of(const ticcd::Vector3& position) { return {position[0], position[1], position[2]}; }

Impact impact_of(const Answer& answer) { return {answer.contact, answer.toi}; }

}  // namespace

Query query_of(bool is_vertex_face, const Corners& start, const Corners& end) {
  Query query;
  query.kind = is_vertex_face ? Kind::vertex_face : Kind::edge_edge;
  query.start = {corner_of(start.a), corner_of(start.b), corner_of(start.c), corner_of(start.d)};
  query.end = {corner_of(end.a), corner_of(end.b), corner_of(end.c), corner_of(end.d)};
  return query;
}

Impact first_impact(const Query& query, double ms, double t_max) {
  return impact_of(solve(query, {.t_max = t_max, .separation = Separation{ms, Metric::max}, .wanted = Wanted::time}));
}

Impact first_impact_after_start(const Query& query, double ms, double t_max) {
  const Answer answer =
      solve(query, {.t_max = t_max, .separation = Separation{ms, Metric::max}, .wanted = Wanted::time});
  if (!answer.starts_within || ms == 0) return impact_of(answer);
  // A distance too small for a double is rounded to 0. The smaller separation is then 0, and the question is whether
  // the elements touch.
  const double most = distance(query, 0, Metric::max).value / 2;
  double smaller = ms / 2;
  while (smaller > most) smaller /= 2;
  return first_impact(query, smaller, t_max);
}

}  // namespace touchstone::dropin
