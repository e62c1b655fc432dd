// Solvers in shared libraries: the shipped example, and a plugin that misbehaves in every way.
// SPDX-License-Identifier: MIT
#include "fuzz/processes/plugin_solver.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <touchstone/error.hpp>

#include "io/temporary_folder.hpp"
#include "plugins/outside_solver.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using fuzz::Reply;

namespace {

/// A variable of the environment for a while.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) { ::setenv(name, value.c_str(), 1); }
  ~Variable() { ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

std::string error_of_loading(const std::string& path, const fuzz::Limits& limits = quick_limits()) {
  try {
    fuzz::load_plugin(path, limits);
  } catch (const Error& error) {
    return error.what();
  }
  return "loaded";
}

}  // namespace

TEST_CASE("the example plugin loads, knows its kinds and answers") {
  const auto solver = fuzz::load_plugin(TOUCHSTONE_EXAMPLE_PLUGIN, quick_limits());
  CHECK(solver->name() == TOUCHSTONE_EXAMPLE_PLUGIN);
  CHECK(solver->supports(Kind::edge_edge));
  CHECK(solver->supports(Kind::vertex_face));
  CHECK_FALSE(solver->supports(Kind::point_edge));
  CHECK_FALSE(solver->supports(Kind::point_point));
  const Reply hit = solver->ask(crossing_edges());
  CHECK(hit.state == Reply::State::answered);
  CHECK(hit.contact);
  REQUIRE(hit.toi);
  CHECK(std::fabs(*hit.toi - 0.5) < 1e-12);
  Query apart = crossing_edges();
  for (Vec3& corner : apart.end) corner.z += 3;
  for (Vec3& corner : apart.start) corner.z -= 3;
  apart.start[2].x = apart.start[3].x = apart.end[2].x = apart.end[3].x = 5;
  const Reply miss = solver->ask(apart);
  CHECK(miss.state == Reply::State::answered);
  CHECK_FALSE(miss.contact);
  VertexFace face;
  face.start = {{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  face.end = face.start;
  face.end[0].z = -3;
  const Reply falls = solver->ask(face);
  REQUIRE(falls.toi);
  CHECK(std::fabs(*falls.toi - 0.25) < 1e-12);
}

TEST_CASE("whatever a plugin does is a reply, and it is started again", "[slow]") {
  const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, quick_limits());
  struct Case {
    int what;
    Reply::State state;
    const char* detail;
  };
  using State = Reply::State;
  for (const Case& c : {Case{1, State::crashed, ""}, Case{2, State::crashed, ""},
                        Case{3, State::crashed, "exit status 5"}, Case{4, State::crashed, "exit status 0"},
                        Case{5, State::hung, "no answer within 1500 ms"}, Case{6, State::malformed, "returned 42"},
                        Case{11, State::hung, "no answer"}, Case{12, State::crashed, "signal 9"},
                        Case{13, State::crashed, "the last words"}, Case{15, State::answered, ""}}) {
    CAPTURE(c.what);
    const Reply reply = solver->ask(order(c.what));
    CHECK(reply.state == c.state);
    CAPTURE(reply.detail);
    CHECK(has(reply.detail, c.detail));
    CHECK(reply.detail.empty() == (c.state == State::answered));
    CHECK_FALSE(reply.contact);
    const Reply next = solver->ask(order(0));
    CHECK(next.state == State::answered);
  }
}

TEST_CASE("what a plugin claims arrives as it is") {
  const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, quick_limits());
  for (const int what : {7, 8}) {
    const Reply reply = solver->ask(order(what));
    CHECK(reply.state == Reply::State::answered);
    CHECK(reply.contact);
    REQUIRE(reply.toi);
    CHECK(std::isnan(*reply.toi));
  }
  CHECK(solver->ask(order(9)).toi == HUGE_VAL);
  const Reply only = solver->ask(order(10));
  CHECK(only.contact);
  CHECK_FALSE(only.toi);
  CHECK(solver->ask(order(16)).toi == 5.0);  // the fifth call in one process: none was lost or repeated
  CHECK(solver->ask(order(17)).toi == 3.0);  // the kind's number
  const Reply open = solver->ask(order(19));
  CHECK(open.toi == 2.0);  // no descriptor of ours
}

TEST_CASE("a plugin that cannot be used is an error that says why") {
  const TemporaryFolder folder;
  CHECK(has(error_of_loading(folder.path("none.so")), "no such plugin"));
  CHECK(has(error_of_loading(folder.path("")), "is a folder"));
  CHECK(has(error_of_loading(folder.write("text.so", "not a library")), "cannot be used"));
  CHECK(has(error_of_loading(TOUCHSTONE_NO_PLUGIN), "no function touchstone_solver"));
  struct Case {
    const char* order;
    const char* reason;
  };
  for (const Case& c : {Case{"init fails", "its init returned 7"}, Case{"init crashes", "while it was initialised"},
                        Case{"loading crashes", "while it was loaded"}, Case{"null", "null pointer"},
                        Case{"another version", "version 99"}, Case{"no kinds", "kinds are 0"},
                        Case{"unheard-of kinds", "kinds are 17"}, Case{"no solve", "solve is a null pointer"}}) {
    const Variable variable("BAD_PLUGIN", c.order);
    const std::string error = error_of_loading(TOUCHSTONE_BAD_PLUGIN);
    CAPTURE(c.order, error);
    CHECK(has(error, c.reason));
    CHECK(has(error, TOUCHSTONE_BAD_PLUGIN));
  }
  const Variable variable("BAD_PLUGIN", "init hangs");
  fuzz::Limits limits;
  limits.start = std::chrono::milliseconds(500);
  CHECK(has(error_of_loading(TOUCHSTONE_BAD_PLUGIN, limits), "takes longer than 500 ms"));
}

TEST_CASE("a plugin that cannot be started again is a finding, not an exception") {
  const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, quick_limits());
  CHECK(solver->ask(order(1)).state == Reply::State::crashed);
  {
    const Variable variable("BAD_PLUGIN", "init fails");
    const Reply reply = solver->ask(order(0));
    CHECK(reply.state == Reply::State::crashed);
    CHECK(has(reply.detail, "cannot be started again: its init returned 7"));
  }
  CHECK(solver->ask(order(0)).state == Reply::State::answered);
}

TEST_CASE("teardown is called at the end, a process that does not end is ended") {
  const TemporaryFolder folder;
  const Variable note("BAD_PLUGIN_NOTE", folder.path("note"));
  double process = 0;
  {
    const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, quick_limits());
    process = solver->ask(order(18)).toi.value();
  }
  CHECK(std::stoi(folder.read("note")) == static_cast<int>(process));
  CHECK(vanishes(static_cast<int>(process)));
  {
    const Variable variable("BAD_PLUGIN", "teardown hangs");
    const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, quick_limits());
    process = solver->ask(order(18)).toi.value();
  }
  CHECK(vanishes(static_cast<int>(process)));
}

TEST_CASE("a process that a plugin leaves behind is ended, too") {
  const TemporaryFolder folder;
  const Variable note("BAD_PLUGIN_NOTE", folder.path("note"));
  fuzz::Limits limits;
  limits.answer = std::chrono::milliseconds(5000);
  const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, limits);
  CHECK(solver->ask(order(14)).state == Reply::State::crashed);
  CHECK(vanishes(std::stoi(folder.read("note"))));
}

TEST_CASE("a daemon that a plugin starts is ended with the plugin's process", "[slow]") {
#ifndef __linux__
  WARN("only Linux lets a process adopt its descendants: daemons are not tested");
#else
  const TemporaryFolder folder;
  const Variable note("BAD_PLUGIN_NOTE", folder.path("note"));
  fuzz::Limits limits;
  limits.answer = std::chrono::milliseconds(5000);
  {
    const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, limits);
    SECTION("when the run ends") {
      CHECK(solver->ask(order(21)).state == Reply::State::answered);
      CHECK(::kill(std::stoi(folder.read("note")), 0) == 0);  // not before
    }
    SECTION("when the plugin crashes") {
      const Reply reply = solver->ask(order(22));
      CHECK(reply.state == Reply::State::crashed);
      CHECK(has(reply.detail, "signal 6"));
      CHECK(vanishes(std::stoi(folder.read("note"))));
    }
    SECTION("when the plugin hangs") {
      CHECK(solver->ask(order(21)).state == Reply::State::answered);
      CHECK(solver->ask(order(5)).state == Reply::State::hung);
      CHECK(vanishes(std::stoi(folder.read("note"))));
    }
  }
  CHECK(vanishes(std::stoi(folder.read("note"))));
  CHECK(::waitpid(-1, nullptr, WNOHANG) == -1);  // no child is left behind
#endif
}

TEST_CASE("a plugin gets so much memory and no more") {
#if TOUCHSTONE_SANITIZED
  skip("sanitizers map terabytes, so limits on memory are not tested");
#else
  fuzz::Limits limits = quick_limits();
  CHECK(fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, limits)->ask(order(20)).toi == 1.0);
  limits.memory = std::uint64_t{256} << 20;
  CHECK(fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, limits)->ask(order(20)).toi == 0.0);
#endif
}

TEST_CASE("asking a plugin costs microseconds") {
  const auto solver = fuzz::load_plugin(TOUCHSTONE_EXAMPLE_PLUGIN, quick_limits());
  const Query query = crossing_edges();
  double best = 1e9;
  for (int round = 0; round < 20; ++round) {
    constexpr int kQueries = 500;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kQueries; ++i) REQUIRE(solver->ask(query).contact);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / kQueries);
  }
  std::printf("plugin: %.2f us a query, the naive solver's own time included\n", best);
  CHECK(best < 200);  // on a busy machine; a new process for each query would take thousands
}
