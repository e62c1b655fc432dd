// The search for scenes of whole bodies about which a function is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/bodies/judge_bodies.hpp"

namespace touchstone::fuzz {

/// The name of a scene, from which it is made again.
struct BodyCase {
  families::BodyFamily family = families::BodyFamily::bodies_random;
  std::uint64_t seed = 1, index = 0;
};

/// "bodies_touch 1 17".
std::string case_text(const BodyCase& name);
std::optional<BodyCase> parse_body_case(std::string_view text);

/// Failures of one class and one question, by the simplest of the scenes.
struct BodyFinding {
  BodyFailure failure;
  std::uint64_t count = 0;
  BodyCase name;              ///< of the scene before it was shrunk
  families::BodyScene scene;  ///< shrunk
};

/// A finding for a person: the failure, the bodies and their motions.
std::string to_string(const BodyFinding& finding);

struct BodyFuzzSettings {
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> cases;
  std::optional<double> seconds;   ///< of the search; the shrinking may take as long again, but 10 at least
  int threads = 1;                 ///< with `cases` and no `seconds` no result but shrinking depends on it
  std::size_t most_findings = 0;   ///< that are shrunk and returned; 0: all
  std::optional<BodyCase> a_case;  ///< this one alone
};

struct BodyFuzzOutcome {
  std::uint64_t scenes = 0;  ///< asked and judged
  double seconds = 0;        ///< of the search
  std::vector<BodyFinding> findings;
  std::size_t kinds_of_failure = 0;  ///< the number of findings, those beyond `most_findings` included
  bool stopped = false;              ///< by the watch
};

/// Called a few times a second with the number of scenes so far; false ends the run.
using BodyWatch = std::function<bool(std::uint64_t)>;

/// Asks about scenes of every family in turn. The solver is called on several threads at a time.
BodyFuzzOutcome fuzz_bodies(const BodySolver& solver, const BodyFuzzSettings& settings, const BodyWatch& watch = {});

}  // namespace touchstone::fuzz
