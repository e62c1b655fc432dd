// A set of queries that the methods are asked, in an order without meaning, with their exact answers: of one kind, or
// steps of whole bodies.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "baselines/body_baseline.hpp"

namespace touchstone::report {

struct QuerySet {
  std::string name;   ///< "simulation/edge-edge": lower-case letters, digits, '-' and '/'; files are named after it
  std::string about;  ///< the origin of the queries: one sentence without its full stop
  Kind kind = Kind::edge_edge;
  Separation separation;  ///< what every query asks about
  std::vector<Query> queries;
  std::vector<CurvedQuery> curved;             ///< in place of the others: the queries of a set of curved motion
  std::vector<baselines::MovingBodies> steps;  ///< in place of the others: the steps of a set of whole bodies
  std::vector<Answer> truth;  ///< by Method::exact, one for each query or step; times and contacts alone of steps

  std::size_t size() const noexcept { return queries.size() + curved.size() + steps.size(); }
  bool is_curved() const noexcept { return !curved.empty(); }
  bool is_of_bodies() const noexcept { return !steps.empty(); }
  std::string_view kind_name() const noexcept { return is_of_bodies() ? "bodies" : name_of(kind); }

  /// use(queries), with those that the set has.
  template <class Use>
  void with_queries(Use&& use) const {
    if (is_of_bodies()) {
      use(steps);
    } else if (is_curved()) {
      use(curved);
    } else {
      use(queries);
    }
  }

  std::size_t contacts() const noexcept {
    std::size_t count = 0;
    for (const Answer& answer : truth) count += answer.contact;
    return count;
  }
};

}  // namespace touchstone::report
