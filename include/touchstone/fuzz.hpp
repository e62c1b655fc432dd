// Touchstone: find queries, and whole steps of meshes, on which your solver is wrong. This header belongs to a second
// library: link touchstone::fuzz.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/certify.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/names.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The ways in which a solver's reply to a query can be wrong, worst first.
enum class FuzzFailure : std::uint8_t {
  crash,      ///< the solver threw an exception, or its process ended
  hang,       ///< the solver did not return in time; only a solver in a process of its own has a time limit
  malformed,  ///< no answer at all, a time before the step, or a whole answer that breaks the promises of Answer
  missed,     ///< the solver denies a contact that exists
  late,       ///< the time lies after the exact one: a step of that length passes through
  nan,        ///< the solver claims a contact at a time that is not a number
  phantom,    ///< the solver claims a contact that does not exist
  early,      ///< the time lies before the exact one by more than the options allow
  differs     ///< a whole answer whose upper time, nature, features or weights are not the exact ones
};

/// "crash", "hang", "malformed", "missed", "late", "nan", "phantom", "early", "differs".
template <>
Names names_of<FuzzFailure>() noexcept;

/// Which queries fuzz_solver makes, and which times it accepts.
struct FuzzOptions {
  /// The seed of the random queries. The queries are the same for the same seed on every machine.
  std::uint64_t seed = 1;

  /// The number of queries to make, at least 1, in equal parts for all chosen families and kinds.
  std::uint64_t cases = 100'000;

  /// The number of hill-climbing steps from each query towards queries that are hard for doubles. The solver is asked
  /// after each step too.
  std::uint64_t climb = 0;

  /// The kinds of query; empty for all.
  std::vector<Kind> kinds;

  /// The names of the query families, as `touchstone fuzz --help` lists them; empty for all.
  std::vector<std::string> families;

  /// What the solver is asked about each query: the first time at which the elements are within this separation. The
  /// solver is not told; it is your function that knows.
  Separation separation = {};

  /// The greatest allowed distance of a claimed time before the exact one, as a number of doubles. Without this and
  /// early_fraction every distance is allowed.
  std::optional<std::uint64_t> early_ulps;

  /// The same as a fraction of the step, in [0, 1].
  std::optional<double> early_fraction;

  /// The greatest distance of a claimed time after the exact one that is no failure, as a number of doubles: from the
  /// largest double <= the exact time on. Without this and late_fraction there is none.
  std::optional<std::uint64_t> late_ulps;

  /// The same as a fraction of the step, in [0, 1].
  std::optional<double> late_fraction;

  /// A contact that does not exist is no failure where the elements come within this part of the query's greatest
  /// coordinate of being in contact, in [0, 1].
  double near = 0;

  /// The failures to look for; empty for all.
  std::vector<FuzzFailure> failures;

  /// The greatest number of findings to shrink and return; 0 for all.
  std::size_t findings = 32;

  /// The number of threads, 1 to 1024, that call the solver at the same time. The report is the same for any number.
  int threads = 1;

  /// When this becomes true, the search and the shrinking end soon, and the report has what was found so far;
  /// null: they run to their end.
  const std::atomic<bool>* stop = nullptr;
};

/// All failures of one class on queries that are degenerate in one way, shown by the simplest such query.
struct FuzzFinding {
  FuzzFailure failure = FuzzFailure::missed;  ///< The class of the failure.
  std::string degeneracy;   ///< The degeneracy in words: "sustained, a0 against b, V = n = 0 at all times".
  std::uint64_t count = 0;  ///< The number of queries that failed in this way.
  Query query;              ///< The shrunk query: it still fails in this way, and a person can read its coordinates.
  Claim claim;              ///< The solver's claim about `query`; its time may be any double, NaN too.
  Answer truth;             ///< The exact answer to `query`.
  std::string detail;       ///< More about the failure, such as the message of the exception of a crash.
  std::string case_name;    ///< The name of the query before it was shrunk, for `touchstone fuzz --case "..."`.
  Separation separation;    ///< What the solver was asked: FuzzOptions::separation.
};

/// The finding as a few lines of text: class, degeneracy, corners, claim and exact answer.
std::string to_string(const FuzzFinding& finding);

/// The result of fuzz_solver.
struct FuzzReport {
  std::uint64_t queries = 0;          ///< The number of queries that were asked and judged.
  std::uint64_t failures = 0;         ///< The number of queries with a wrong reply.
  std::uint64_t allowed = 0;          ///< Those with a reply that late_ulps and the options after it alone let pass.
  std::size_t kinds_of_failure = 0;   ///< The number of findings, including those beyond FuzzOptions::findings.
  std::vector<FuzzFinding> findings;  ///< The findings, at most FuzzOptions::findings of them.
  bool stopped = false;               ///< Whether FuzzOptions::stop ended the call.
};

/// Asks `solver` for the first contact in [0, 1] of many queries that are degenerate, nearly degenerate or extreme, and
/// judges its claims by exact arithmetic. Every call happens in the default floating-point environment. After a
/// failure, the solver is called with simpler queries of the same sort, to shrink the query. An exception from the
/// solver is the failure `crash`.
/// @param solver   the solver: its claim about a query
/// @param options  which queries, and which times are accepted
/// @return the failures found
/// @throws InvalidQuery  for options without meaning: an unknown family or kind, no cases, a fraction outside [0, 1]
FuzzReport fuzz_solver(const std::function<Claim(const Query&)>& solver, const FuzzOptions& options = {});

/// What a simulator's collision detection answers about a whole mesh in a step, in which each vertex moves on a
/// straight line. What is left out is not judged.
struct StepReply {
  /// The fraction of the step, in [0, 1], that it holds to be free of contact, with its end.
  std::optional<double> free;

  /// The first time in [0, 1] at which two elements are in contact, and 0 if two are at the start; infinity: at none.
  std::optional<double> first_contact;

  /// The pairs that its broad phase proposes, in any order: every pair that comes into contact must be among them.
  std::optional<std::vector<MeshPair>> candidates;
};

/// Two replies are equal when all of their parts are; the order of the candidates, and of the elements of one sort in a
/// pair, does not matter. @param a  one @param b  the other one
bool operator==(const StepReply& a, const StepReply& b);

/// The function under test: a mesh with all of its edges, and the positions at both ends of the step.
using StepSolver = std::function<StepReply(const Mesh&, const Positions& x0, const Positions& x1)>;

/// Which steps fuzz_steps makes, and which replies it accepts.
struct StepFuzzOptions {
  std::uint64_t seed = 1;  ///< The steps are the same for the same seed on every machine.

  std::uint64_t cases = 10'000;  ///< The number of steps to make, at least 1, from all chosen families in turn.

  /// When it is given, the search ends after this time; else, after all cases.
  std::optional<double> seconds;

  std::vector<std::string> families;  ///< The names of the families, as `touchstone fuzz-steps --help` lists them.

  bool separations = true;  ///< Whether meshes may have a separation; without, all steps are about touching.
  bool groups = true;       ///< Whether meshes may have groups of vertices that do not collide.

  /// Whether a free step may end in its first contact. Without, it must end before.
  bool may_end_in_contact = false;

  /// A free step that is shorter than this part, in [0, 1], of the way to the first contact is a failure: a stall.
  double stall = 1e-3;

  /// The greatest allowed part of the step, in [0, 1], between a reply's time and a later first contact. Without it,
  /// every one but a stall is allowed.
  std::optional<double> early_fraction;

  /// The greatest part of the step, in [0, 1], by which `first_contact` may lie after the exact time.
  double late_fraction = 0;

  /// Whether the solver is asked twice, and must say the same.
  bool twice = true;

  std::size_t findings = 32;  ///< The greatest number of findings to shrink and return; 0 for all.
  int threads = 1;            ///< The number of threads, 1 to 1024, that call the solver at the same time.
  const std::atomic<bool>* stop = nullptr;  ///< When this becomes true, the call ends soon; null: it runs to its end.
};

/// All failures of one class that a question has, shown by the simplest step.
struct StepFuzzFinding {
  FuzzFailure failure = FuzzFailure::missed;  ///< The class of the failure.
  std::string question;     ///< "free", "first contact", "candidates", or "all" for a crash and replies that differ.
  std::string detail;       ///< The elements and the times, for a person.
  std::uint64_t count = 0;  ///< The number of steps that failed in this way.
  Mesh mesh;                ///< The shrunk mesh.
  std::vector<double> x0;   ///< The positions of its vertices at the start: x y z x y z ...
  std::vector<double> x1;   ///< The same at the end.
  std::string case_name;    ///< The name of the step before it was shrunk.
};

/// The finding as a few lines of text. @param finding  which
std::string to_string(const StepFuzzFinding& finding);

/// The result of fuzz_steps.
struct StepFuzzReport {
  std::uint64_t steps = 0;                ///< The number of steps that were asked and judged.
  std::uint64_t failures = 0;             ///< The number of steps with a wrong reply.
  std::size_t kinds_of_failure = 0;       ///< The number of findings, including those beyond StepFuzzOptions::findings.
  std::vector<StepFuzzFinding> findings;  ///< The findings, at most StepFuzzOptions::findings of them.
  std::vector<std::string> left_out;      ///< What no mesh had, as the options say: "separations", "groups".
  bool stopped = false;                   ///< Whether StepFuzzOptions::stop ended the call.
};

/// Asks `solver` about steps of small meshes that are hard, as simulators meet them, and judges its replies by the
/// exact answers to all pairs of elements, each asked by itself. No tree is used. A pair is left out only if the least
/// coordinates of one element in the step are greater than all of the other one's along some axis, by more than the
/// separation. The pairs are those of Mesh::may_collide, with the separations of Mesh::separation. After a failure, the
/// solver is called with simpler steps, to shrink it: fewest elements first, then numbers that a person reads. An
/// exception from the solver is the failure `crash`.
/// @param solver   the function under test
/// @param options  which steps, and which replies are accepted
/// @return the failures found
/// @throws InvalidQuery  for options without meaning: an unknown family, no cases, a fraction outside [0, 1]
StepFuzzReport fuzz_steps(const StepSolver& solver, const StepFuzzOptions& options = {});

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
