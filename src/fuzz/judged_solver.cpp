// SPDX-License-Identifier: MIT
#include "fuzz/judged_solver.hpp"

namespace touchstone::fuzz {

JudgedSolver::JudgedSolver(SolverUnderTest& solver, const Settings& settings)
    : solver_(solver),
      answering_(dynamic_cast<AnsweringSolver*>(&solver)),
      judge_(settings.judge),
      separation_(settings.separation),
      early_(settings.early) {}

Answer JudgedSolver::truth(const Query& query) const { return solve(query, separation_, judge_); }

JudgedReply JudgedSolver::ask(const Query& query, const Answer& truth) const {
  JudgedReply judged;
  if (answering_ == nullptr) {
    judged.reply = solver_.ask(query);
    judged.failure = failure_of(query, judged.reply, truth, early_, separation_);
    return judged;
  }
  const Answer answer = answering_->answer(query);
  judged.reply.contact = answer.contact;
  if (answer.contact) judged.reply.toi = answer.toi;
  judged.failure = failure_of(query.kind, answer, truth);
  return judged;
}

}  // namespace touchstone::fuzz
