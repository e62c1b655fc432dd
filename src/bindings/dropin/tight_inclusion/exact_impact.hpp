// A query of Tight-Inclusion's interface as one of Touchstone's, and its answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <tight_inclusion/types.hpp>
#include <touchstone/query.hpp>

namespace touchstone::dropin {

/// The corner positions that Tight-Inclusion's functions take one by one, at one end of the step.
struct Corners {
  const ticcd::Vector3& a;
  const ticcd::Vector3& b;
  const ticcd::Vector3& c;
  const ticcd::Vector3& d;
};

/// The query with these corners: a b against c d, or the vertex a against the triangle b c d.
Query query_of(bool is_vertex_face, const Corners& start, const Corners& end);

/// An answer in Tight-Inclusion's terms.
struct Impact {
  bool exists;  ///< whether the elements come within the separation
  double toi;   ///< the greatest double that is not after the first time; infinity without an impact
};

/// The answer to the query with the separation `ms` along the axes.
/// @throws InvalidQuery  as solve(query, {ms, Metric::max}, t_max)
Impact first_impact(const Query& query, double ms, double t_max);

/// The same, but elements that are within `ms` at the start without touching are asked about a smaller separation: the
/// first of ms/2, ms/4, ... that is at most half of their distance.
/// @throws InvalidQuery  as solve(query, {ms, Metric::max}, t_max)
Impact first_impact_after_start(const Query& query, double ms, double t_max);

}  // namespace touchstone::dropin
