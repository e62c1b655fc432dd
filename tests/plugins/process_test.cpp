// Child processes die with their parent.
// SPDX-License-Identifier: MIT
#include "fuzz/processes/child_process.hpp"

#ifdef __linux__
#include <sched.h>
#include <sys/mount.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>

#include "fuzz/processes/plugin_solver.hpp"
#include "io/temporary_folder.hpp"
#include "plugins/outside_solver.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("a plugin's process dies when its parent is killed, asleep or hanging") {
  for (const bool hangs : {false, true}) {
    fuzz::Pipe pipe;
    const pid_t parent = ::fork();
    REQUIRE(parent >= 0);
    if (parent == 0) {
      const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN);
      const int process = static_cast<int>(solver->ask(order(18)).toi.value());
      if (::write(pipe.write, &process, sizeof process) < 0) ::_exit(1);
      if (hangs) {
        solver->ask(order(5));
      }
      for (;;) ::pause();
    }
    int process = 0;
    REQUIRE(::read(pipe.read, &process, sizeof process) == sizeof process);
    REQUIRE(::kill(process, 0) == 0);
    ::kill(parent, SIGKILL);
    ::waitpid(parent, nullptr, 0);
    CHECK(vanishes(process));
  }
}

TEST_CASE("a plugin's daemon dies when the process that asks is killed") {
#ifndef __linux__
  WARN("only Linux lets a process adopt its descendants: daemons are not tested");
#else
  const TemporaryFolder folder;
  REQUIRE(::setenv("BAD_PLUGIN_NOTE", folder.path("note").c_str(), 1) == 0);
  fuzz::Pipe pipe;
  const pid_t parent = ::fork();
  REQUIRE(parent >= 0);
  if (parent == 0) {
    const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN);
    const char answered = solver->ask(order(21)).state == fuzz::Reply::State::answered ? 'y' : 'n';
    if (::write(pipe.write, &answered, 1) < 0) ::_exit(1);
    for (;;) ::pause();
  }
  char answered = 0;
  REQUIRE(::read(pipe.read, &answered, 1) == 1);
  CHECK(answered == 'y');
  const int daemon = std::stoi(folder.read("note"));
  CHECK(::kill(daemon, 0) == 0);
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  CHECK(vanishes(daemon));
  ::unsetenv("BAD_PLUGIN_NOTE");
#endif
}

#ifdef __linux__
TEST_CASE("what a process leaves in its group dies with it, also where there is no /proc") {
  fuzz::Pipe pipe;
  const pid_t parent = ::fork();
  REQUIRE(parent >= 0);
  if (parent == 0) {
    const bool own_mounts = ::unshare(CLONE_NEWNS) == 0 || ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
    const bool hidden = own_mounts && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                        ::mount("none", "/proc", "tmpfs", 0, nullptr) == 0;
    if (!hidden) ::_exit(1);
    fuzz::ChildProcess::Setup setup;
    setup.output = pipe.write;
    fuzz::ChildProcess child(setup, [] {
      const pid_t left = ::fork();
      while (left == 0) ::pause();
      if (::write(STDOUT_FILENO, &left, sizeof left) < 0) ::_exit(1);
    });
    child.wait_until(fuzz::ChildProcess::Clock::now() + std::chrono::seconds(20));
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(parent, &status, 0);
  if (status != 0) {
    skip("/proc cannot be hidden here");
    return;
  }
  pid_t left = 0;
  REQUIRE(::read(pipe.read, &left, sizeof left) == sizeof left);
  CHECK(vanishes(left));
}
#endif

TEST_CASE("many processes leave no zombie and no descriptor behind") {
  const auto free_descriptor = [] {
    const int descriptor = ::dup(0);
    ::close(descriptor);
    return descriptor;
  };
  const int before = free_descriptor();
  {
    const auto solver = fuzz::load_plugin(TOUCHSTONE_BAD_PLUGIN, quick_limits());
    for (int i = 0; i < 50; ++i) CHECK(solver->ask(order(12)).state == fuzz::Reply::State::crashed);
  }
  CHECK(free_descriptor() == before);
  CHECK(::waitpid(-1, nullptr, WNOHANG) == -1);  // no child at all
  CHECK(errno == ECHILD);
}
