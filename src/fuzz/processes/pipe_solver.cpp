// SPDX-License-Identifier: MIT
#include "fuzz/processes/pipe_solver.hpp"

#include <array>
#include <utility>

#include <touchstone/error.hpp>

#include "fuzz/processes/give_up.hpp"
#include "fuzz/processes/pipe_run.hpp"
#include "io/fail.hpp"
#include "io/queries/kind_of_file.hpp"
#include "pipes/protocol.hpp"

namespace touchstone::fuzz {
namespace {

/// Two elements at rest, far from each other.
Query plain_query(Kind kind) {
  Query query;
  query.kind = kind;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const double n = static_cast<double>(i);
    query.start[i] = query.end[i] = {4 * n, n * n, 1 + n};
  }
  return query;
}

class PipeSolver : public SolverUnderTest {
 public:
  PipeSolver(const std::string& command_line, const Limits& limits, const Separation& separation)
      : name_(command_line), limits_(limits), separation_(separation) {
    const std::string trouble = launch();
    if (!trouble.empty()) throw Error(io::in_quotes(name_) + ": " + trouble);
    first_answers();
  }

  const std::string& name() const override { return name_; }
  bool supports(Kind kind) const override { return supported_[static_cast<std::size_t>(kind)]; }

  void change_separation(const Separation& separation) override { separation_ = separation; }

  Reply ask(const Query& query) override {
    std::string trouble = start();
    if (!trouble.empty()) return give_up(run_, Reply::State::crashed, "it cannot be started again: " + trouble);
    if (told_ != separation_.distance) trouble = tell_separation(limits_.answer);
    if (!trouble.empty()) return give_up(run_, Reply::State::malformed, trouble);
    bool supported = true;
    Reply reply = exchange(query, limits_.answer, supported);
    if (supported) return reply;
    return give_up(run_, Reply::State::malformed,
                   "it says 'unsupported', but has answered a query of this kind before");
  }

 private:
  /// Finds out which kinds the program takes. A query that fails now is asked again later, and is a finding then.
  void first_answers() {
    std::string trouble;
    bool any = false;
    for (const Kind kind : kKinds) {
      bool supported = true;
      // An interpreter takes some time to start.
      const Reply reply = exchange(plain_query(kind), any ? limits_.answer : limits_.start, supported);
      supported_[static_cast<std::size_t>(kind)] = supported;
      const bool answered = run_ != nullptr;  // one that says 'unknown' goes on
      if (answered && supported && !any) {
        any = true;
        first_ = kind;
      }
      if (!answered && trouble.empty()) trouble = reply.detail;
      if (!answered && !any) break;  // the other kinds would fail in the same way
    }
    if (any) return;
    if (trouble.empty()) trouble = "it supports no kind of query";
    throw Error(io::in_quotes(name_) + ": the solver's command gives no answers: " + trouble);
  }

  /// Starts the program and tells it the separation. @returns the reason when it does not take that, else nothing
  /// @throws Error when it cannot be started
  std::string launch() {
    run_ = std::make_unique<PipeRun>(name_, limits_);
    told_ = 0;
    return separation_.distance == 0 ? std::string() : tell_separation(limits_.start);
  }

  /// @returns the reason when the program does not take it, else nothing
  std::string tell_separation(std::chrono::milliseconds time) {
    const std::string line = pipes::separation_line(separation_);
    const PipeRun::Exchange exchange = run_->exchange(line, time);
    told_ = separation_.distance;
    const bool said = exchange.end == PipeRun::Exchange::End::line;
    if (said && pipes::takes_separation(exchange.line)) return {};
    return "the solver's command takes no separation: it must answer the line " +
           io::in_quotes(line.substr(0, line.size() - 1)) + " with 'ok'" +
           (said ? ", and it says " + io::in_quotes(exchange.line) : ", and it says nothing");
  }

  /// Starts the program again if it does not run. @returns the reason when it cannot run, else nothing
  std::string start() {
    if (run_) return {};
    try {
      const std::string trouble = launch();
      if (!trouble.empty()) return trouble;
    } catch (const Error& error) {
      return error.what();
    }
    bool supported = true;
    const Reply reply = exchange(plain_query(first_), limits_.start, supported);
    return run_ ? std::string() : reply.detail;
  }

  Reply exchange(const Query& query, std::chrono::milliseconds time, bool& supported) {
    if (!run_) {
      const std::string trouble = launch();
      if (!trouble.empty()) return give_up(run_, Reply::State::crashed, trouble);
    }
    const PipeRun::Exchange exchange = run_->exchange(pipes::query_line(query), time);
    using End = PipeRun::Exchange::End;
    const std::string said = exchange.line.empty() ? "" : "; it had said " + io::in_quotes(exchange.line);
    switch (exchange.end) {
      case End::died: return give_up(run_, Reply::State::crashed, run_->child().story() + said);
      case End::late:
        return give_up(run_, Reply::State::hung,
                       "no answer within " + std::to_string(time.count()) + " ms (are answers flushed?)" + said);
      case End::too_long:
        return give_up(
            run_, Reply::State::malformed,
            "a line of more than " + std::to_string(limits_.line) + " bytes: " + io::in_quotes(exchange.line));
      case End::unasked:
        return give_up(run_, Reply::State::malformed,
                       "it says more than it was asked: " + io::in_quotes(exchange.line));
      case End::line: break;
    }
    const auto answer = pipes::read_answer_line(exchange.line);
    if (!answer) return give_up(run_, Reply::State::malformed, io::in_quotes(exchange.line) + " is no answer");
    supported = answer->supported;
    if (!answer->known) return no_answer(Reply::State::malformed, "it says 'unknown'");
    Reply reply;
    reply.contact = answer->contact;
    reply.toi = answer->toi;
    reply.toi_as_written = answer->toi_as_written;
    return reply;
  }

  std::string name_;
  Limits limits_;
  Separation separation_;
  double told_ = 0;  ///< the distance that the program knows
  std::array<bool, 4> supported_{};
  Kind first_ = Kind::edge_edge;  ///< one that it supports
  std::unique_ptr<PipeRun> run_;
};

}  // namespace

std::unique_ptr<SolverUnderTest> run_command(const std::string& command_line, const Limits& limits,
                                             const Separation& separation) {
  return std::make_unique<PipeSolver>(command_line, limits, separation);
}

}  // namespace touchstone::fuzz
