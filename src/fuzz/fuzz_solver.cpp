// The public face of the engine, for programs that link touchstone::fuzz.
// SPDX-License-Identifier: MIT
#include <touchstone/fuzz.hpp>

#include <cmath>
#include <utility>

#include <touchstone/error.hpp>

#include "fuzz/callable_solver.hpp"
#include "fuzz/climb.hpp"
#include "fuzz/engine.hpp"
#include "fuzz/judging/finding_text.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

constexpr int kMostThreads = 1024;

families::Family family_of(const std::string& name) {
  const families::FamilyInfo* const family = families::find_family(name);
  if (family != nullptr && family->group == families::Group::curved) {
    throw InvalidQuery("the family \"" + name + "\" has curved queries; the solver takes straight ones");
  }
  if (family != nullptr) return family->family;
  throw InvalidQuery("there is no family of queries called \"" + name + "\"; touchstone fuzz --help lists them");
}

void check_fraction(const char* name, const std::optional<double>& value) {
  if (!value || (*value >= 0 && *value <= 1)) return;
  throw InvalidQuery(std::string(name) + " is " + fuzz::decimal_text(*value) + "; it must be in [0, 1]");
}

fuzz::Settings settings_of(const FuzzOptions& options) {
  if (options.cases == 0) throw InvalidQuery("cases is 0; at least one query must be asked");
  if (options.threads < 1 || options.threads > kMostThreads) {
    throw InvalidQuery("threads is " + std::to_string(options.threads) + "; it must be in [1, " +
                       std::to_string(kMostThreads) + "]");
  }
  check_fraction("early_fraction", options.early_fraction);
  check_fraction("late_fraction", options.late_fraction);
  check_fraction("near", options.near);
  for (const FuzzFailure failure : options.failures) {
    if (failure <= fuzz::kEveryFailure.back()) continue;
    throw InvalidQuery("one of the failures is " + std::to_string(static_cast<int>(failure)) +
                       "; it must be one of 0 to " + std::to_string(fuzz::kFailureClasses - 1));
  }
  if (options.climb > fuzz::kMostClimbSteps) {
    throw InvalidQuery("climb is " + std::to_string(options.climb) + "; it must be at most " +
                       std::to_string(fuzz::kMostClimbSteps));
  }
  for (const Kind kind : options.kinds) {
    if (kind <= kKinds.back()) continue;
    throw InvalidQuery("one of the kinds is " + std::to_string(static_cast<int>(kind)) + "; it must be one of 0 to " +
                       std::to_string(static_cast<int>(kKinds.back())));
  }
  if (!(options.separation.distance >= 0) || !std::isfinite(options.separation.distance)) {
    throw InvalidQuery("the separation is " + fuzz::decimal_text(options.separation.distance) +
                       "; it must be finite and not negative");
  }
  fuzz::Settings settings;
  settings.separation = options.separation;
  for (const std::string& name : options.families) settings.families.push_back(family_of(name));
  settings.kinds = options.kinds;
  settings.seed = options.seed;
  settings.cases = options.cases;
  settings.climb = options.climb;
  settings.threads = options.threads;
  settings.allowance.early = {options.early_ulps, options.early_fraction};
  if (options.late_ulps || options.late_fraction) {
    settings.allowance.late = certify::TimeLimit{options.late_ulps, options.late_fraction};
  }
  settings.allowance.near = options.near;
  settings.allowance.classes = options.failures;
  settings.most_findings = options.findings;
  return settings;
}

FuzzFinding public_finding(fuzz::Finding&& finding) {
  fuzz::Example& example = finding.example;
  return {finding.failure,
          fuzz::degeneracy_text(finding.degeneracy),
          finding.count,
          std::get<Query>(example.query),
          Claim{example.reply.contact, example.reply.toi, example.reply.toi_as_written},
          example.truth,
          std::move(example.detail),
          fuzz::case_text(example.name),
          example.separation};
}

}  // namespace

template <>
Names names_of<FuzzFailure>() noexcept {
  static constexpr std::string_view kNames[] = {"crash", "hang",    "malformed", "missed", "late",
                                                "nan",   "phantom", "early",     "differs"};
  return kNames;
}

std::string to_string(const FuzzFinding& finding) {
  fuzz::Reply reply;
  reply.contact = finding.claim.contact;
  reply.toi = finding.claim.toi;
  reply.toi_as_written = finding.claim.toi_as_written;
  if (finding.failure == FuzzFailure::crash) reply.state = fuzz::Reply::State::crashed;
  std::string text(name_of(finding.failure));
  if (finding.count > 1) text.append(" ").append(std::to_string(finding.count)).append(" times");
  text.append(", ").append(name_of(finding.query.kind)).append(": ").append(finding.degeneracy).append("\n");
  text.append(fuzz::corners_text(finding.query, "  "));
  text.append("  claim: ").append(fuzz::claim_text(reply)).append("\n");
  text.append("  exact: ").append(fuzz::truth_text(finding.truth)).append("\n");
  if (!finding.detail.empty()) text.append("  ").append(finding.detail).append("\n");
  return text;
}

FuzzReport fuzz_solver(const std::function<Claim(const Query&)>& solver, const FuzzOptions& options) {
  if (!solver) throw InvalidQuery("the solver is empty");
  const auto ask = [&solver](const Query& query) {
    const Claim claim = solver(query);
    fuzz::Reply reply;
    reply.contact = claim.contact;
    reply.toi = claim.toi;
    return reply;
  };
  const auto goes_on = [&options](const fuzz::Progress&) { return options.stop == nullptr || !*options.stop; };
  fuzz::SearchOutcome outcome =
      fuzz::run([&ask] { return fuzz::callable_solver("the solver", ask); }, settings_of(options), goes_on);
  FuzzReport report;
  report.queries = outcome.queries;
  report.failures = outcome.table.total().failed();
  report.allowed = outcome.allowed;
  report.kinds_of_failure = outcome.kinds_of_failure;
  report.stopped = outcome.stopped;
  for (fuzz::Finding& finding : outcome.findings) report.findings.push_back(public_finding(std::move(finding)));
  return report;
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
