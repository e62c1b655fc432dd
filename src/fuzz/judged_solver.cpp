// SPDX-License-Identifier: MIT
#include "fuzz/judged_solver.hpp"

namespace touchstone::fuzz {

JudgedSolver::JudgedSolver(SolverUnderTest& solver, const Settings& settings)
    : solver_(solver),
      answering_(dynamic_cast<AnsweringSolver*>(&solver)),
      judge_(settings.judge),
      own_separations_(settings.own_separations),
      early_(settings.early) {}

Answer JudgedSolver::truth(const Asked& asked) const { return solve(asked.query, asked.separation, judge_); }

JudgedReply JudgedSolver::ask(const Asked& asked, const Answer& truth) const {
  const auto& [query, separation] = asked;
  JudgedReply judged;
  if (own_separations_) solver_.change_separation(separation);
  if (answering_ == nullptr) {
    judged.reply = solver_.ask(query);
    judged.failure = failure_of(query, judged.reply, truth, early_, separation);
    return judged;
  }
  const Answer answer = answering_->answer(query);
  judged.reply.contact = answer.contact;
  if (answer.contact) judged.reply.toi = answer.toi;
  judged.failure = failure_of(query.kind, answer, truth);
  return judged;
}

}  // namespace touchstone::fuzz
