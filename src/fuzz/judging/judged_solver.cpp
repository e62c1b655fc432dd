// SPDX-License-Identifier: MIT
#include "fuzz/judging/judged_solver.hpp"

#include <touchstone/curved.hpp>

namespace touchstone::fuzz {

JudgedSolver::JudgedSolver(SolverUnderTest& solver, const Settings& settings)
    : solver_(solver),
      answering_(dynamic_cast<AnsweringSolver*>(&solver)),
      judge_(settings.judge),
      own_separations_(settings.own_separations),
      early_(settings.early) {}

Answer JudgedSolver::truth(const Asked& asked) const {
  if (const auto* const curved = std::get_if<CurvedQuery>(&asked.query)) {
    return solve(*curved, {.t_max = asked.t_max, .separation = asked.separation, .method = judge_});
  }
  return solve(std::get<Query>(asked.query), {.separation = asked.separation, .method = judge_});
}

JudgedReply JudgedSolver::ask_curved(const CurvedQuery& query, double t_max, const Answer& truth) const {
  JudgedReply judged;
  if (answering_ == nullptr) {
    judged.reply = solver_.ask_curved(query, t_max);
    // A curved query is asked in this process, so that its time is a double and the judge needs no query.
    judged.failure = failure_of(Query(), judged.reply, truth, early_);
    return judged;
  }
  const Answer answer = answering_->answer_curved(query, t_max);
  judged.reply.contact = answer.contact;
  if (answer.contact) judged.reply.toi = answer.toi;
  judged.failure = failure_of(query.kind, answer, truth, t_max);
  return judged;
}

JudgedReply JudgedSolver::ask(const Asked& asked, const Answer& truth) const {
  const Separation& separation = asked.separation;
  if (own_separations_) solver_.change_separation(separation);
  if (const auto* const curved = std::get_if<CurvedQuery>(&asked.query)) return ask_curved(*curved, asked.t_max, truth);
  const auto& query = std::get<Query>(asked.query);
  JudgedReply judged;
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
