// Work in a process of its own: its result, its end and its memory.
// SPDX-License-Identifier: MIT
#include "report/own_process.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <memory>
#include <stdexcept>
#include <vector>

#include <touchstone/error.hpp>

#include "support/catch.hpp"
#include "support/skip.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;

namespace {

constexpr std::size_t kMegabyte = 1 << 20;

constexpr std::size_t kShadows = TOUCHSTONE_SANITIZED ? 10 : 1;  // a sanitizer's notes on each byte take memory, too

using Pieces = std::vector<std::unique_ptr<char[]>>;

/// So much memory in pieces as small as a simulation's, each of them touched.
Pieces take(std::size_t megabytes) {
  constexpr std::size_t kPiece = 4096;
  Pieces pieces;
  for (std::size_t i = 0; i < megabytes * kMegabyte / kPiece; ++i) pieces.push_back(std::make_unique<char[]>(kPiece));
  return pieces;
}

void nothing() {}

}  // namespace

TEST_CASE("what work returns in a process of its own arrives, and changes nothing else here") {
  int here = 1;
  std::array<double, 3> start{1, 2, 3};
  const auto run = report::run_in_own_process(nothing, [&] {
    here = 2;
    start[1] = 20;
    return start;
  });
  CHECK(run.value == std::array<double, 3>{1, 20, 3});
  CHECK(here == 1);
  CHECK(start[1] == 2);
}

TEST_CASE("the memory of a process is what it takes at its peak, whatever lay free here before") {
  if (TOUCHSTONE_THREAD_SANITIZED) {
    tests::skip("thread sanitizer maps memory ahead, so a process's own part is not told apart");
    return;
  }
  const auto little = report::run_in_own_process(nothing, [] { return 0; });
  if (!little.memory) {
    tests::skip("this system does not tell how much memory a process uses");
    return;
  }
  CHECK(*little.memory < kShadows * 8 * kMegabyte);
  Pieces pieces = take(64);
  const Pieces last = take(1);  // so that the others' place stays the allocator's when they are gone
  pieces.clear();
  const auto much = report::run_in_own_process(nothing, [] { return take(48).size(); });
  CHECK(*much.memory >= 48 * kMegabyte);
  CHECK(*much.memory < kShadows * 96 * kMegabyte);
  const auto before = report::run_in_own_process([] { take(48); }, [] { return take(32).size(); });
  CHECK(*before.memory >= 32 * kMegabyte);
  // The peak of what is prepared is forgotten where Linux offers that.
  if (::access("/proc/self/clear_refs", W_OK) == 0) CHECK(*before.memory < kShadows * 44 * kMegabyte);
}

TEST_CASE("what is prepared is there when the work begins, and what stays of it is not the work's memory") {
  Pieces pieces;
  const auto run = report::run_in_own_process([&] { pieces = take(48); }, [&] { return pieces.size(); });
  CHECK(run.value == 48 * 256);
  if (run.memory) CHECK(*run.memory < kShadows * 8 * kMegabyte);
}

TEST_CASE("work that fails in a process of its own is an error here") {
  CHECK_THROWS_WITH(report::run_in_own_process(nothing, []() -> int { throw std::runtime_error("no such scene"); }),
                    "no such scene");
  CHECK_THROWS_AS(report::run_in_own_process(nothing, []() -> int { throw std::runtime_error("no such scene"); }),
                  Error);
  CHECK_THROWS_WITH(report::run_in_own_process(nothing, []() -> int { ::_exit(0); }),
                    "a process ended before its work was done");
  CHECK_THROWS_WITH(report::run_in_own_process(nothing,
                                               []() -> int {
                                                 ::raise(SIGKILL);
                                                 return 1;
                                               }),
                    "a process was ended by Killed");
}
