// `interval` is conservative: on every seeded family it misses nothing and its time is never late.
// SPDX-License-Identifier: MIT
#include <touchstone/certify.hpp>
#include <touchstone/solve.hpp>

#include "baselines/baseline.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 303;

std::string complaint(const Query& query, double t_max, double tolerance) {
  const Answer truth = solve(query, t_max);
  const baselines::Result result = baselines::solve_interval(query, t_max, tolerance);
  const Verdict verdict =
      judge({result.contact, result.contact ? std::optional<double>(result.toi) : std::nullopt}, truth);
  if (verdict == Verdict::holds || verdict == Verdict::phantom) return {};
  return std::string(name_of(verdict)) + " at tolerance " + hexfloat(tolerance) + " and t_max " + hexfloat(t_max) +
         ": said " + hexfloat(result.toi) + ", " + describe(truth);
}

TEST_CASE("interval misses nothing and is never late, at any scale and tolerance") {
  Report report;
  for_each_case(
      kSeed, 25, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        Rng rng = rng_of(id);
        const double tolerance = rng.pick(std::array<double, 4>{1e-2, 1e-4, 1e-6, 1e-9});
        report.add(id, query, complaint(query, 1.0, tolerance));
        report.add(id, query, complaint(query, rng.unit(), 1e-3));
      });
  report.finish();
}

TEST_CASE("interval is not merely cautious: most ordinary misses are told apart") {
  std::size_t misses = 0;
  std::size_t phantoms = 0;
  for (const Kind kind : kKinds) {
    for (std::size_t index = 0; index < effort(200); ++index) {
      const Query query = make(CaseId{Family::simulation, kind, kSeed, index});
      if (solve(query).contact) continue;
      ++misses;
      phantoms += baselines::solve_interval(query, 1.0, 1e-6).contact;
    }
  }
  CHECK(misses > 0);
  CHECK(phantoms * 20 < misses);
}

}  // namespace
}  // namespace touchstone::tests
