// Queries whose corners are on turning bodies or on curves, read from arrays.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <touchstone/curved_query.hpp>

namespace touchstone::python {

struct CurvedQueries {
  using BoundToPython = void;

  Kind kind = Kind::edge_edge;
  std::vector<CurvedQuery> all;
  bool single = false;  ///< one query, whose answer is no array

  // Of those with a body that takes the longer of two turns, as it was given:
  std::size_t longer_turns = 0;       ///< how many
  std::size_t first_longer_turn = 0;  ///< the row of the first one

  bool is_single() const noexcept { return single; }
  std::size_t count() const noexcept { return all.size(); }
  const CurvedQuery& at(std::size_t q) const noexcept { return all[q]; }
};

}  // namespace touchstone::python
