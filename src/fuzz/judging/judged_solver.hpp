// A solver under test together with the judge of its replies.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "fuzz/answering_solver.hpp"
#include "fuzz/case_name.hpp"
#include "fuzz/judging/failure.hpp"
#include "fuzz/settings.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// A reply and its failure, if any.
struct JudgedReply {
  Reply reply;
  std::optional<Failure> failure;
  bool allowed = false;  ///< there is none, by Allowance alone
  double seconds = 0;    ///< that the solver took
};

class JudgedSolver {
 public:
  /// @param settings  its judge gives the answers that count as the true ones; they must outlive this
  JudgedSolver(SolverUnderTest& solver, const Settings& settings);

  /// The judge's answer. The solver is not asked.
  Answer truth(const Asked& asked) const;

  /// Asks the solver and judges its reply: everything in a whole answer, or the claim of a solver that gives no more.
  JudgedReply ask(const Asked& asked, const Answer& truth) const;

 private:
  bool allows(const JudgedReply& judged, const Asked& asked, const Answer& truth) const;
  bool right_when_moved(const Reply& reply, const Asked& asked, double length) const;
  JudgedReply ask_straight(const Query& query, const Separation& separation, const Answer& truth) const;
  JudgedReply ask_curved(const CurvedQuery& query, double t_max, const Answer& truth) const;

  SolverUnderTest& solver_;
  AnsweringSolver* answering_;  ///< the same solver when it gives whole answers, else null
  Method judge_;
  bool own_separations_;
  const Allowance& allowance_;
};

}  // namespace touchstone::fuzz
