// Solvers that give the exact answer, except for one planted bug each.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <touchstone/solve.hpp>

#include "fuzz/answering_solver.hpp"
#include "fuzz/callable_solver.hpp"
#include "fuzz/engine.hpp"

namespace touchstone::tests {

inline fuzz::Reply right_reply(const Query& query) {
  const Answer answer = solve(query);
  fuzz::Reply reply;
  reply.contact = answer.contact;
  if (answer.contact) reply.toi = answer.toi;
  return reply;
}

/// A solver with the right reply, which `spoil` then changes.
inline fuzz::SolverFactory toy(std::function<void(const Query&, fuzz::Reply&)> spoil) {
  return [spoil] {
    return fuzz::callable_solver("toy", [spoil](const Query& query) {
      fuzz::Reply reply = right_reply(query);
      spoil(query, reply);
      return reply;
    });
  };
}

/// Whether the toys' bugs strike: on a quarter of all queries. The query alone decides it, so that no result depends
/// on the thread or the time of the call.
inline bool strikes(const Query& query) {
  const double first = query.start[0].x + query.end[0].y;
  return std::fmod(std::fabs(first), 4) == 1;
}

/// Gives whole answers, with `spoil` applied.
class WholeToy final : public fuzz::AnsweringSolver {
 public:
  explicit WholeToy(std::function<void(const Query&, Answer&)> spoil) : spoil_(std::move(spoil)) {}
  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }
  Answer answer(const Query& query) override {
    Answer answer = solve(query);
    spoil_(query, answer);
    return answer;
  }
  fuzz::Reply ask(const Query& query) override { return right_reply(query); }

 private:
  std::string name_ = "whole toy";
  std::function<void(const Query&, Answer&)> spoil_;
};

}  // namespace touchstone::tests
