// Queries whose coordinates along an axis are of two sizes with a wide gap of zero bits between them. The answer to the
// query with a narrower gap, which has fewer bits, gives the answer to the query.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::exact {

/// Along each axis the coordinates of a query, times a power of two, are integers h or products l d of integers l and
/// d = 2^-s, with the same s for all axes. For a variable d they are a family of queries: the query itself is that of
/// d = 2^-s, the base that of d = 0, and the narrowed query that of a greater d.
class Gap {
 public:
  /// Nothing where there is no such gap, or where it is too narrow for a proof.
  static std::optional<Gap> of(const Query& query);

  /// It has at most kMostBits<2> bits, and the same contact over [0, 1], nature and features as the query.
  const Query& narrowed() const noexcept { return narrowed_; }

  /// Makes the answer to the narrowed query the answer to the query, both over [0, 1]: with the query's time and
  /// weights. False where they stay open.
  bool restore(Answer& answer, Wanted wanted) const;

 private:
  Query base_, low_, narrowed_;             ///< in base_ and low_, the integers h and l, and 0 for the others
  std::array<double, 3> norm_ = {1, 1, 1};  ///< along each axis, of differences of corners; at least 1
  double volume_norm_ = 0;                  ///< of V
  int spread_ = 0, narrow_ = 0;             ///< s of the query and of the narrowed query
};

}  // namespace touchstone::exact
