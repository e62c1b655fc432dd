// Queries whose corners are on turning bodies or on curves, read from arrays.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <touchstone/curved_query.hpp>

namespace touchstone::python {

struct CurvedQueries {
  Kind kind = Kind::edge_edge;
  std::vector<CurvedQuery> all;
  bool single = false;  ///< one query, whose answer is no array
};

}  // namespace touchstone::python
