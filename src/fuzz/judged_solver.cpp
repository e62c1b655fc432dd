// SPDX-License-Identifier: MIT
#include "fuzz/judged_solver.hpp"

namespace touchstone::fuzz {

JudgedSolver::JudgedSolver(SolverUnderTest& solver, Method judge, const EarlyLimit& early)
    : solver_(solver), answering_(dynamic_cast<AnsweringSolver*>(&solver)), judge_(judge), early_(early) {}

Answer JudgedSolver::truth(const Query& query) const { return solve(query, judge_); }

JudgedReply JudgedSolver::ask(const Query& query, const Answer& truth) const {
  JudgedReply judged;
  if (answering_ == nullptr) {
    judged.reply = solver_.ask(query);
    judged.failure = failure_of(query, judged.reply, truth, early_);
    return judged;
  }
  const Answer answer = answering_->answer(query);
  judged.reply.contact = answer.contact;
  if (answer.contact) judged.reply.toi = answer.toi;
  judged.failure = failure_of(query.kind, answer, truth);
  return judged;
}

}  // namespace touchstone::fuzz
