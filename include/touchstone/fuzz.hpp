// Touchstone: break a solver of your own. In a library of its own: link touchstone::fuzz.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/certify.hpp>
#include <touchstone/query.hpp>

namespace touchstone {

/// What can be wrong with what a solver says of a query; worst first.
enum class FuzzFailure : std::uint8_t {
  crash,      ///< it threw, or its process ended
  hang,       ///< it did not return in time; only solvers in a process of their own are given a time
  malformed,  ///< no answer at all, a time before the step, or a whole answer that breaks its own promises
  missed,     ///< contact denied, but there is one
  late,       ///< its time lies after the exact one: stepping there would pass through
  nan,        ///< contact claimed at a time that is no number
  phantom,    ///< contact claimed, but there is none
  early,      ///< its time lies before the exact one by more than is allowed
  differs     ///< of a whole answer: upper time, nature, features or weights are not the exact ones
};

std::string_view fuzz_failure_name(FuzzFailure failure) noexcept;  ///< "crash", "missed", ...

struct FuzzOptions {
  std::uint64_t seed = 1;         ///< the queries are the same ones for the same seed, on every machine
  std::uint64_t cases = 100'000;  ///< how many to make, shared out evenly to all families and kinds; not 0
  std::uint64_t climb =
      0;  ///< steps of hill climbing from each towards queries that are hard for doubles, each asked too
  std::vector<Kind> kinds;                  ///< empty: all
  std::vector<std::string> families;        ///< names as `touchstone fuzz --help` lists them; empty: all
  std::optional<std::uint64_t> early_ulps;  ///< how many doubles before the exact time a claimed time may lie
  std::optional<double> early_share;        ///< the same as a share of the step, in [0, 1]; without both: any distance
  std::size_t findings = 32;                ///< how many to shrink and return at most; 0: all
  int threads = 1;  ///< from so many the solver is called at a time, 1 to 1024; the report is the same for any number
};

/// Failures of one class on queries that are degenerate in one way, shown by the simplest query of them.
struct FuzzFinding {
  FuzzFailure failure = FuzzFailure::missed;
  std::string degeneracy;   ///< for a person: "sustained, a0 against b, V = n = 0 at all times"
  std::uint64_t count = 0;  ///< how many queries failed in this way
  Query query;              ///< shrunk: still fails in this way, with coordinates that a person can read
  Claim claim;              ///< what the solver says of it; its time may be anything
  Answer truth;             ///< the exact answer
  std::string detail;       ///< of a crash, the exception's message and the like
  std::string case_name;    ///< of the query that it was shrunk from: touchstone fuzz --case "..."
};

/// The finding on some lines: class, degeneracy, corners, claim and exact answer.
std::string to_string(const FuzzFinding& finding);

struct FuzzReport {
  std::uint64_t queries = 0;         ///< asked and judged
  std::uint64_t failures = 0;        ///< queries of which something wrong was said
  std::size_t kinds_of_failure = 0;  ///< findings, those beyond FuzzOptions::findings included
  std::vector<FuzzFinding> findings;
};

/// Asks `solver` for the first contact in [0, 1] of many queries that are degenerate, nearly so, or extreme, and judges
/// what it says by exact arithmetic. It is called in the default floating-point environment, again and again on queries
/// like one that it failed on, and may throw: that is a crash, found and shrunk like the rest.
/// @throws InvalidQuery  for options that mean nothing: an unknown family, no cases, a share outside [0, 1]
FuzzReport fuzz_solver(const std::function<Claim(const Query&)>& solver, const FuzzOptions& options = {});

}  // namespace touchstone
