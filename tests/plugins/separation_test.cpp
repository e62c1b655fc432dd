// Users' solvers learn the separation, or say that they take none.
// SPDX-License-Identifier: MIT
#include <string>

#include <touchstone/error.hpp>

#include "fuzz/processes/pipe_solver.hpp"
#include "fuzz/processes/plugin_solver.hpp"
#include "pipes/protocol.hpp"
#include "plugins/outside_solver.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using fuzz::Reply;

namespace {

constexpr Separation kQuarter = {0.25, Metric::euclidean};

template <class Make>
std::string error_of(const Make& make) {
  try {
    make();
  } catch (const Error& error) {
    return error.what();
  }
  return "made";
}

/// A program for the shell that answers `reply` to the separation's line and, to each query, the contact time `reply`
/// of that line.
std::string shell_program(const std::string& reply) {
  return "d=none; while read -r kind rest; do if [ \"$kind\" = separation ]; then d=${rest% *}; echo " + reply +
         "; else echo \"1 $d\"; fi; done";
}

}  // namespace

TEST_CASE("a plugin is told the separation and its metric") {
  const auto euclidean = fuzz::load_plugin(TOUCHSTONE_SEPARATION_PLUGIN, quick_limits(), kQuarter);
  CHECK(euclidean->ask(meeting_points()).toi == 0.25);
  const auto max = fuzz::load_plugin(TOUCHSTONE_SEPARATION_PLUGIN, quick_limits(), {0.25, Metric::max});
  CHECK(max->ask(meeting_points()).toi == 0.75);
  const auto touching = fuzz::load_plugin(TOUCHSTONE_SEPARATION_PLUGIN, quick_limits());
  CHECK(touching->ask(meeting_points()).toi == 0);
}

TEST_CASE("a plugin is told another separation before the query that it is for") {
  const auto solver = fuzz::load_plugin(TOUCHSTONE_SEPARATION_PLUGIN, quick_limits(), kQuarter);
  for (const double distance : {0.5, 0.125, 0.125, 1.0}) {
    solver->change_separation({distance, Metric::euclidean});
    CHECK(solver->ask(meeting_points()).toi == distance);
  }
  solver->change_separation({2, Metric::euclidean});
  const Reply refusal = solver->ask(meeting_points());
  CHECK(refusal.state == Reply::State::malformed);
  CHECK(has(refusal.detail, "refuses the separation"));
  solver->change_separation(kQuarter);
  CHECK(solver->ask(meeting_points()).toi == 0.25);
}

TEST_CASE("a program is told another separation before the query that it is for") {
  const auto solver = fuzz::run_command(shell_program("ok"), quick_limits(), kQuarter);
  for (const double distance : {0.5, 0.125, 0.125, 1.0}) {
    solver->change_separation({distance, Metric::euclidean});
    CHECK(solver->ask(meeting_points()).toi == distance);
  }
  const auto once =
      fuzz::run_command("read -r line; echo ok; while read -r line; do echo 0; done", quick_limits(), kQuarter);
  once->change_separation({0.5, Metric::euclidean});
  const Reply refusal = once->ask(meeting_points());  // it answers the second separation's line with '0'
  CHECK(refusal.state == Reply::State::malformed);
  CHECK(has(refusal.detail, "takes no separation"));
}

TEST_CASE("a plugin that takes no separation is an error that says so") {
  for (const auto& [path, distance] :
       {std::pair<std::string, double>{TOUCHSTONE_SEPARATION_PLUGIN, 2}, {TOUCHSTONE_EXAMPLE_PLUGIN, 0.25}}) {
    CAPTURE(path);
    const Separation separation = {distance, Metric::euclidean};
    CHECK(has(error_of([&, &path = path] { fuzz::load_plugin(path, quick_limits(), separation); }),
              "it takes no such separation (see touchstone_separation in touchstone/plugin.h)"));
  }
}

TEST_CASE("a program is told the separation each time that it starts") {
  CHECK(pipes::separation_line(kQuarter) == "separation 0x1p-2 euclidean\n");
  CHECK(pipes::separation_line({3, Metric::max}) == "separation 0x1.8p+1 max\n");
  CHECK(pipes::takes_separation("ok"));
  CHECK(pipes::takes_separation(" ok\r"));
  CHECK_FALSE(pipes::takes_separation("unsupported"));
  CHECK_FALSE(pipes::takes_separation("0"));

  const auto solver = fuzz::run_command(shell_program("ok"), quick_limits(), kQuarter);
  CHECK(solver->ask(meeting_points()).toi == 0.25);
  const auto one_shot = fuzz::run_command(
      "read -r line; echo ok; n=0; while read -r line; do n=$((n+1)); if [ $n -gt 4 ]; then exit 3; fi; echo 0; done",
      quick_limits(), kQuarter);
  CHECK(one_shot->ask(meeting_points()).state == Reply::State::crashed);
  CHECK(one_shot->ask(meeting_points()).state == Reply::State::answered);  // started again, and told again
}

TEST_CASE("a program that takes no separation is an error that says so") {
  for (const std::string reply : {"unsupported", "0", "'1 0.5'"}) {
    const std::string error = error_of([&] { fuzz::run_command(shell_program(reply), quick_limits(), kQuarter); });
    CAPTURE(error);
    CHECK(has(error,
              "takes no separation: it must answer the line 'separation 0x1p-2 euclidean' with 'ok', and it says"));
  }
  const std::string c_program =
      error_of([&] { fuzz::run_command(TOUCHSTONE_EXAMPLE_PROGRAM, quick_limits(), kQuarter); });
  CHECK(has(c_program, "and it says 'unsupported'"));
}

TEST_CASE_WITH("python3", "the example program in Python takes a Euclidean separation") {
  const std::string command = "python3 " TOUCHSTONE_EXAMPLES "/program.py";
  const auto solver = fuzz::run_command(command, quick_limits(), kQuarter);
  CHECK(solver->supports(Kind::point_point));
  CHECK(solver->ask(meeting_points()).contact);
  CHECK(has(error_of([&] {
              fuzz::run_command(command, quick_limits(), {0.25, Metric::max});
            }),
            "and it says 'unsupported'"));
}
