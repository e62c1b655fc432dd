// SPDX-License-Identifier: MIT
#include "fuzz/processes/line_process.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "fuzz/processes/no_reply.hpp"
#include "io/fail.hpp"

namespace touchstone::fuzz {

LineProcess::Start command_start(const std::string& command_line, const Limits& limits) {
  return [=] { return std::make_unique<PipeRun>(command_line, limits); };
}

LineProcess::LineProcess(Start start, const Limits& limits)
    : start_(std::move(start)), limits_(limits), run_(start_()) {}

void LineProcess::ask(std::string_view line, const std::function<void(std::string_view)>& read) {
  if (!run_) {
    run_ = start_();
    is_new_ = true;
  }
  // An interpreter takes some time to start, for the first time most of all.
  const auto restart = std::max(limits_.answer, std::chrono::milliseconds(2000));
  const auto time = is_first_ ? limits_.start : is_new_ ? restart : limits_.answer;
  const PipeRun::Exchange exchange = run_->exchange(line, time);
  using End = PipeRun::Exchange::End;
  is_first_ = is_new_ = false;
  try {
    const std::string said = exchange.line.empty() ? "" : "; it had said " + io::in_quotes(exchange.line);
    if (exchange.end == End::died) throw NoReply(FuzzFailure::crash, run_->child().story() + said);
    if (exchange.end == End::late) {
      throw NoReply(FuzzFailure::hang, "no reply within " + std::to_string(time.count()) +
                                           " ms (a program must flush its replies)" + said);
    }
    if (exchange.end != End::line) {
      throw NoReply(FuzzFailure::malformed, "it says more than it was asked, or too long a line" + said);
    }
    read(exchange.line);
  } catch (const NoReply&) {
    run_->child().kill();
    run_.reset();
    throw;
  }
}

}  // namespace touchstone::fuzz
