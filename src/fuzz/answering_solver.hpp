// A solver that gives whole answers, not only claims: ours. Everything in them is compared with the judge's answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

class AnsweringSolver : public SolverUnderTest {
 public:
  virtual Answer answer(const Query& query) = 0;

  /// Only called where takes_curves().
  virtual Answer answer_curved(const CurvedQuery&, double /*t_max*/) { return {}; }
};

}  // namespace touchstone::fuzz
