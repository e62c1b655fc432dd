// Every baseline answers any finite query at any tolerance: in range, and after bounded work.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "baselines/baseline.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 304;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string complaint(const baselines::Baseline& method, const Query& query, double t_max, double tolerance) {
  const baselines::Result result = method.solve(query, t_max, tolerance);
  const bool in_range = result.contact ? result.toi >= 0 && result.toi <= t_max : result.toi == kInfinity;
  if (in_range) return {};
  return std::string(method.name) + ": contact " + (result.contact ? "1" : "0") + " at " + hexfloat(result.toi);
}

TEST_CASE("every baseline answers in range for every family, t_max and tolerance") {
  Report report;
  const std::array<double, 7> tolerances{0.0, 1e-300, 1e-9, 1e-3, 1e9, -1.0, std::nan("")};
  for_each_case(
      kSeed, 20, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        Rng rng = rng_of(id);
        for (const baselines::Baseline& method : baselines::methods()) {
          if (!method.supports(id.kind)) continue;
          const double t_max = rng.pick(std::array<double, 4>{1.0, 0.0, 0.3, 0x1p-1074});
          // A tolerance that no image can reach uses up all the steps of `interval`, on most contacts: a few are
          // enough.
          const bool slow = method.name == "interval" && id.index > 0;
          const double tolerance = slow ? 1e-3 : rng.pick(tolerances);
          report.add(id, query, complaint(method, query, t_max, tolerance));
        }
      });
  report.finish();
}

TEST_CASE("every baseline gets through coordinates at both ends of the doubles") {
  Rng rng(kSeed);
  const std::array<double, 6> extremes{
      0.0, 0x1p-1074, -0x1p-1074, std::numeric_limits<double>::max(), -std::numeric_limits<double>::max(), 1.0};
  for (const Kind kind : kKinds) {
    for (std::size_t i = 0; i < effort(400); ++i) {
      Query query;
      query.kind = kind;
      for_each_coordinate(query, [&](double& x) { x = rng.pick(extremes); });
      for (const baselines::Baseline& method : baselines::methods()) {
        if (!method.supports(kind)) continue;
        INFO(cpp_initializer(query));
        CHECK(complaint(method, query, 1.0, 1e-3) == "");
      }
    }
  }
}

}  // namespace
}  // namespace touchstone::tests
