// The engine as a library: touchstone/fuzz.hpp.
// SPDX-License-Identifier: MIT
#include <touchstone/fuzz.hpp>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "fuzz/case_name.hpp"
#include "support/catch.hpp"

using namespace touchstone;

namespace {

Claim right(const Query& query) {
  const Answer answer = solve(query);
  return {answer.contact, answer.toi};
}

FuzzOptions quick() {
  FuzzOptions options;
  options.cases = 4000;
  return options;
}

std::string text_of(const FuzzReport& report) {
  std::string text = std::to_string(report.queries).append(" ").append(std::to_string(report.failures)).append("\n");
  for (const FuzzFinding& finding : report.findings)
    text.append(to_string(finding)).append(finding.case_name).append("\n");
  return text;
}

}  // namespace

TEST_CASE("a callable that is right is found right") {
  const FuzzReport report = fuzz_solver(right, quick());
  CHECK(report.queries == 4000);
  CHECK(report.failures == 0);
  CHECK(report.findings.empty());
  CHECK(report.kinds_of_failure == 0);
}

TEST_CASE("a callable's findings are complete, and the same on any number of threads") {
  const auto late_on_faces = [](const Query& query) {
    Claim claim = right(query);
    if (query.kind == Kind::vertex_face && claim.contact) claim.toi = 1.0;
    return claim;
  };
  FuzzOptions options = quick();
  options.climb = 1;
  options.findings = 10;
  const FuzzReport report = fuzz_solver(late_on_faces, options);
  CHECK(report.queries == 8000);
  CHECK(report.failures > 500);
  CHECK(report.kinds_of_failure > 10);
  REQUIRE(report.findings.size() == 10);
  for (const FuzzFinding& finding : report.findings) {
    CHECK(finding.failure == FuzzFailure::late);
    CHECK(finding.query.kind == Kind::vertex_face);
    CHECK(finding.claim.toi == 1.0);
    CHECK(solve(finding.query).toi == finding.truth.toi);
    CHECK(finding.truth.toi < 1);
    CHECK(fuzz::parse_case_text(finding.case_name).has_value());
    const std::string text = to_string(finding);
    CHECK(text.rfind("late", 0) == 0);
    CHECK(text.find("vertex-face: " + finding.degeneracy + "\n  v   (") != std::string::npos);
    CHECK(text.find("\n  claim: contact at 1\n  exact: contact ") != std::string::npos);
  }
  options.threads = 3;
  CHECK(text_of(fuzz_solver(late_on_faces, options)) == text_of(report));
}

TEST_CASE("a callable's tolerance is allowed, counted, and nothing beyond it") {
  // Late by three doubles, wherever there is room for them.
  const auto late = [](const Query& query) {
    Claim claim = right(query);
    for (int i = 0; claim.contact && i < 3; ++i) claim.toi = std::nextafter(*claim.toi, 2.0);
    return claim;
  };
  FuzzOptions options = quick();
  const FuzzReport all = fuzz_solver(late, options);
  CHECK(all.failures > 500);
  CHECK(all.allowed == 0);
  options.late_ulps = 3;
  CHECK(fuzz_solver(late, options).failures == 0);
  CHECK(fuzz_solver(late, options).allowed == all.failures);
  options.late_ulps = 2;
  CHECK(fuzz_solver(late, options).failures == all.failures);
  options.late_ulps.reset();
  options.late_fraction = 0x1p-50;
  CHECK(fuzz_solver(late, options).failures == 0);
  options = quick();
  options.failures = {FuzzFailure::missed, FuzzFailure::phantom};
  CHECK(fuzz_solver(late, options).failures == 0);
  CHECK(fuzz_solver(late, options).allowed == all.failures);

  // A contact within a thousandth of the greatest coordinate, in the largest-axis metric.
  const auto wide = [](const Query& query) {
    double greatest = 0;
    for (const auto* const corners : {&query.start, &query.end}) {
      for (const Vec3& x : *corners) greatest = std::max({greatest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
    }
    Claim claim = right(query);
    claim.contact = claim.contact || solve(query, {.separation = {greatest / 1000, Metric::max}}).contact;
    if (!right(query).contact) claim.toi.reset();
    return claim;
  };
  options = quick();
  const FuzzReport phantoms = fuzz_solver(wide, options);
  CHECK(phantoms.failures > 50);
  options.near = 0.002;
  CHECK(fuzz_solver(wide, options).failures == 0);
  CHECK(fuzz_solver(wide, options).allowed == phantoms.failures);
  options.near = 1e-9;
  CHECK(fuzz_solver(wide, options).failures > 10);
}

TEST_CASE("what a callable throws is a crash that keeps its message") {
  const FuzzReport report = fuzz_solver(
      [](const Query& query) -> Claim {
        if (query.kind == Kind::point_point) throw std::runtime_error("points are hard");
        return right(query);
      },
      quick());
  CHECK(report.failures == 1000);
  REQUIRE_FALSE(report.findings.empty());
  CHECK(report.findings.front().failure == FuzzFailure::crash);
  CHECK(report.findings.front().detail == "exception: points are hard");
  CHECK(to_string(report.findings.front()).find("claim: none: it crashed") != std::string::npos);
}

TEST_CASE("a callable that changes the floating-point environment spoils neither the queries nor the verdicts") {
  const auto rude = [](const Query& query) {
    REQUIRE(std::fegetround() == FE_TONEAREST);
    const Claim claim = right(query);
    std::fesetround(FE_UPWARD);
    return claim;
  };
  const FuzzReport clean = fuzz_solver(right, quick());
  const FuzzReport after = fuzz_solver(rude, quick());
  std::fesetround(FE_TONEAREST);
  CHECK(text_of(after) == text_of(clean));
  CHECK(after.failures == 0);

  // The queries are the same too: the findings of a solver that is wrong on some of them do not change.
  const auto wrong = [](const Query& query) {
    Claim claim = right(query);
    if (claim.contact) claim.toi = 1.0;
    return claim;
  };
  const auto wrong_and_rude = [&](const Query& query) {
    const Claim claim = wrong(query);
    std::fesetround(FE_UPWARD);
    return claim;
  };
  const FuzzReport one = fuzz_solver(wrong, quick());
  const FuzzReport other = fuzz_solver(wrong_and_rude, quick());
  std::fesetround(FE_TONEAREST);
  CHECK(one.failures > 0);
  CHECK(text_of(one) == text_of(other));
}

TEST_CASE("kinds, families and earliness are the caller's choice") {
  FuzzOptions options = quick();
  options.kinds = {Kind::point_edge};
  options.families = {"lattice2"};
  const auto at_zero = [](const Query& query) {
    CHECK(query.kind == Kind::point_edge);
    Claim claim = right(query);
    if (claim.contact) claim.toi = 0.0;
    return claim;
  };
  CHECK(fuzz_solver(at_zero, options).failures == 0);
  options.early_fraction = 0.5;
  const std::uint64_t by_half = fuzz_solver(at_zero, options).failures;
  options.early_ulps = 0;
  CHECK(by_half > 0);
  CHECK(fuzz_solver(at_zero, options).failures > by_half);
}

TEST_CASE("options without meaning are refused") {
  const auto refuses = [](auto&& change) {
    FuzzOptions options = quick();
    change(options);
    CHECK_THROWS_AS(fuzz_solver(right, options), InvalidQuery);
  };
  refuses([](FuzzOptions& options) { options.cases = 0; });
  refuses([](FuzzOptions& options) { options.threads = 0; });
  refuses([](FuzzOptions& options) { options.threads = 1025; });
  refuses([](FuzzOptions& options) { options.families = {"lattice9"}; });
  refuses([](FuzzOptions& options) { options.kinds = {Kind::edge_edge, Kind(77)}; });
  refuses([](FuzzOptions& options) { options.early_fraction = -0.5; });
  refuses([](FuzzOptions& options) { options.early_fraction = std::numeric_limits<double>::quiet_NaN(); });
  CHECK_THROWS_AS(fuzz_solver({}, quick()), InvalidQuery);
}
