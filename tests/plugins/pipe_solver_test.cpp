// Solvers that are programs: the shipped examples, and a program that misbehaves in every way.
// SPDX-License-Identifier: MIT
#include "fuzz/processes/pipe_solver.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "fuzz/judging/failure.hpp"
#include "fuzz/processes/pipe_run.hpp"
#include "io/temporary_folder.hpp"
#include "pipes/protocol.hpp"
#include "plugins/outside_solver.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using fuzz::Reply;

namespace {

std::string bad_program(const std::string& order = "") {
  return "python3 " TOUCHSTONE_SOURCE_DIR "/tests/plugins/bad_program.py " + order;
}

std::string error_of_starting(const std::string& command, const fuzz::Limits& limits = quick_limits()) {
  try {
    fuzz::run_command(command, limits);
  } catch (const Error& error) {
    return error.what();
  }
  return "started";
}

}  // namespace

TEST_CASE("the example program in C says which kinds it takes, and answers") {
  const auto solver = fuzz::run_command(TOUCHSTONE_EXAMPLE_PROGRAM, quick_limits());
  CHECK(solver->name() == TOUCHSTONE_EXAMPLE_PROGRAM);
  CHECK(solver->supports(Kind::edge_edge));
  CHECK(solver->supports(Kind::vertex_face));
  CHECK_FALSE(solver->supports(Kind::point_edge));
  CHECK_FALSE(solver->supports(Kind::point_point));
  const auto start = std::chrono::steady_clock::now();
  constexpr int kQueries = 300;
  for (int i = 0; i < kQueries; ++i) {
    const Reply reply = solver->ask(crossing_edges());
    REQUIRE(reply.state == Reply::State::answered);
    REQUIRE(reply.contact);
    REQUIRE(std::fabs(reply.toi.value() - 0.5) < 1e-12);
  }
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  std::printf("program in C: %.1f us a query\n", time.count() / kQueries);
}

TEST_CASE_WITH("python3", "the example program in Python answers") {
  const auto solver = fuzz::run_command("python3 " TOUCHSTONE_EXAMPLES "/program.py", quick_limits());
  CHECK_FALSE(solver->supports(Kind::edge_edge));
  CHECK(solver->supports(Kind::point_point));
  CHECK(solver->ask(meeting_points()).toi == 0.5);
  CHECK_FALSE(solver->ask(order(3)).contact);
}

TEST_CASE_WITH("python3", "whatever a program does is a reply, and it is started again") {
  const auto solver = fuzz::run_command(bad_program(), quick_limits());
  CHECK_FALSE(solver->supports(Kind::point_edge));
  CHECK(solver->supports(Kind::point_point));
  struct Case {
    int what;
    Reply::State state;
    const char* detail;
  };
  using State = Reply::State;
  for (const Case& c :
       {Case{1, State::crashed, "exit status 3"}, Case{2, State::crashed, "signal 9"},
        Case{3, State::hung, "no answer within 1500 ms"}, Case{4, State::malformed, "'what?' is no answer"},
        Case{5, State::malformed, "is no answer"}, Case{7, State::malformed, "more than 1024 bytes"},
        Case{8, State::hung, "it had said '0'"}, Case{9, State::crashed, "exit status 0; it had said '0'"},
        Case{10, State::malformed, ""}, Case{15, State::crashed, "the last words"}, Case{16, State::hung, ""},
        Case{17, State::malformed, "unsupported"}, Case{20, State::malformed, "'' is no answer"}}) {
    CAPTURE(c.what);
    const Reply reply = solver->ask(order(c.what));
    CAPTURE(reply.detail);
    CHECK(reply.state == c.state);
    CHECK(has(reply.detail, c.detail));
    CHECK_FALSE(reply.detail.empty());
    CHECK(solver->ask(order(0)).state == State::answered);
  }
}

TEST_CASE_WITH("python3", "what is said without being asked is a finding, at the latest with the next query") {
  const auto solver = fuzz::run_command(bad_program(), quick_limits());
  const Reply first = solver->ask(order(6));
  if (first.state == Reply::State::answered) {  // the second line came too late to be seen
    const Reply second = solver->ask(order(0));
    CHECK(second.state == Reply::State::malformed);
  } else {
    CHECK(first.state == Reply::State::malformed);
    CHECK(has(first.detail, "more than it was asked"));
  }
  CHECK(solver->ask(order(0)).state == Reply::State::answered);
}

TEST_CASE_WITH("python3", "what a program claims arrives as it is, in pieces too") {
  const auto solver = fuzz::run_command(bad_program(), quick_limits());
  const Reply nan = solver->ask(order(11));
  REQUIRE(nan.toi);
  CHECK(std::isnan(*nan.toi));
  const Reply only = solver->ask(order(12));
  CHECK(only.contact);
  CHECK_FALSE(only.toi);
  CHECK(solver->ask(order(14)).toi == 0.125);
  CHECK(solver->ask(order(13)).toi == 8.0);  // four first queries and three before: none was lost or repeated
}

TEST_CASE_WITH("python3", "a program that stops reading is a finding, and no signal kills us") {
  const auto solver = fuzz::run_command(bad_program(), quick_limits());
  CHECK(solver->ask(order(19)).state == Reply::State::answered);
  CHECK(solver->ask(order(0)).state == Reply::State::hung);
  CHECK(solver->ask(order(0)).state == Reply::State::answered);
}

TEST_CASE("a command that gives no answers is an error that says why") {
  CHECK(has(error_of_starting(""), "empty"));
  CHECK(has(error_of_starting("  "), "empty"));
  CHECK(has(error_of_starting("/nowhere/solver"), "No such file or directory"));
  CHECK(has(error_of_starting("/nowhere/solver 'by shell'"), "/nowhere/solver"));
  CHECK(has(error_of_starting("true"), "exit status 0"));
  CHECK(has(error_of_starting("cat"), "is no answer"));  // it repeats the query
  CHECK(has(error_of_starting("yes"), "gives no answers"));
}

TEST_CASE_WITH("python3", "a program that gives no answers is an error that says why") {
  CHECK(has(error_of_starting(bad_program("exits")), "no licence found"));
  CHECK(has(error_of_starting(bad_program("garbage")), "'hello' is no answer"));
  CHECK(has(error_of_starting(bad_program("unsupported")), "supports no kind"));
  fuzz::Limits limits;
  limits.start = std::chrono::milliseconds(500);
  CHECK(has(error_of_starting(bad_program("hangs"), limits), "no answer within 500 ms"));
}

TEST_CASE("a command may be a line for the shell") {
  const auto solver = fuzz::run_command("while read line; do echo '1 0.5'; done", quick_limits());
  CHECK(solver->ask(order(0)).toi == 0.5);
}

TEST_CASE_WITH("python3", "a program ends with its solver") {
  int process = 0;
  for (const bool hangs : {false, true}) {
    {
      const auto solver = fuzz::run_command(bad_program(), quick_limits());
      process = static_cast<int>(solver->ask(order(18)).toi.value());
      if (hangs) CHECK(solver->ask(order(3)).state == Reply::State::hung);
    }
    CHECK(vanishes(process));
  }
}

TEST_CASE_WITH("python3", "a daemon that a program starts is ended with the program") {
#ifndef __linux__
  WARN("only Linux lets a process adopt its descendants: daemons are not tested");
#else
  const TemporaryFolder folder;
  const std::string note = folder.path("note");
  fuzz::Limits limits;
  limits.answer = std::chrono::milliseconds(10'000);
  {
    const auto solver = fuzz::run_command(bad_program(note), limits);
    SECTION("when the run ends") {
      CHECK(solver->ask(order(21)).state == Reply::State::answered);
      CHECK(::kill(std::stoi(folder.read("note")), 0) == 0);  // not before
    }
    SECTION("when the program ends") {
      const Reply reply = solver->ask(order(22));
      CHECK(reply.state == Reply::State::crashed);
      CHECK(has(reply.detail, "exit status 3"));
    }
  }
  CHECK(vanishes(std::stoi(folder.read("note"))));
#endif
}

TEST_CASE_WITH("python3", "a program that says much on standard error before it answers is not waited for in vain") {
  fuzz::Limits limits;
  limits.answer = std::chrono::milliseconds(10'000);
  fuzz::PipeRun run(bad_program(), limits);
  for (int i = 0; i < 3; ++i) {
    const auto exchange = run.exchange(pipes::query_line(order(23)), limits.start);
    CHECK(exchange.end == fuzz::PipeRun::Exchange::End::line);
    CHECK(exchange.line == "0");
  }
  // A pipe holds a third of 200,000 bytes: the program goes on only when they are read.
  CHECK(run.idle_waits() == 0);
}

TEST_CASE("a program that has closed its standard error answers on") {
  const auto solver = fuzz::run_command(std::string(TOUCHSTONE_EXAMPLE_PROGRAM) + " 2>&-", quick_limits());
  for (int i = 0; i < 3; ++i) CHECK(solver->ask(crossing_edges()).contact);
}

TEST_CASE("a program's time counts as it is written") {
  const auto said = [](const std::string& time) {
    // The shell answers every query with this time.
    return fuzz::run_command("while read line; do echo '1 " + time + "'; done", quick_limits())->ask(meeting_points());
  };
  const Answer truth = solve(meeting_points());
  REQUIRE(truth.toi == 0.5);
  const auto failure = [&](const std::string& time) {
    const auto found = fuzz::failure_of(meeting_points(), said(time), truth, {std::uint64_t{0}, {}});
    return found ? std::string(name_of(found->failure)) : "";
  };
  CHECK(failure("0.5") == "");
  CHECK(failure("0.50000000000000000001") == "late");
  CHECK(failure("0.49999999999999999999") == "");
  CHECK(failure("-1e-400") == "malformed");
  CHECK(failure("0x1.0000000000001p-1") == "late");
}
