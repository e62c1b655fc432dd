// The question to the filters, and their decision.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::filters {

/// V(t) for a double t within a relative error of 2^-50, with its exact sign. A level below computes it where
/// doubles are not enough. A value that underflows is the least double of its sign.
using ExactValue = double (*)(const Query& query, double t);

/// Whether and when the elements of a valid query touch in [0, t_max].
struct Question {
  const Query& query;
  double t_max;
  ExactValue exact_value;
  Wanted wanted = Wanted::all;  ///< of a contact; more of the answer may be written
};

/// The knowledge of contact: in [0, t_max], or at one root of V.
enum class Outcome : std::uint8_t { uncertain, no_contact, contact };

/// The tests, in the order in which a query meets them.
enum class Test : std::uint8_t {
  same_side,
  shared_corner,
  boxes,
  bracket,
  separated,
  rescaled,  ///< the last two, asked about the rescaled query
  none
};

/// The decision of the filters: `uncertain` by no test, or something certain by one.
struct Decision {
  Outcome finding = Outcome::uncertain;
  Test test = Test::none;
};

}  // namespace touchstone::filters
