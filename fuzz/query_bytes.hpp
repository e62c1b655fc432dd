// A query from any bytes, so that few bytes easily make a degenerate one: small integers, shared corners, equal
// coordinates and their neighbours.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/query.hpp>

#include "targets.hpp"

namespace touchstone::fuzzing {

struct Question {
  Query query;  ///< finite
  double t_max = 1;
};

/// Any bytes make a question. Bytes beyond those that are needed change nothing.
Question question_from(Bytes input);

/// Bytes that make exactly this query with t_max 1, as short as possible. -0 and all finite values are kept.
std::string bytes_for(const Query& query);

}  // namespace touchstone::fuzzing
