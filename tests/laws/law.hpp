// A law: a relation between the answer to a query and the answer to one derived from it. It holds for every query.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <initializer_list>
#include <optional>
#include <string>

#include <touchstone/solve.hpp>

#include "support/answer_check.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

namespace touchstone::tests {

inline bool every_family(const FamilyInfo&, Kind) { return true; }
inline bool dyadic_families(const FamilyInfo& family, Kind) { return family.dyadic; }

/// The result of a law: nothing when it does not apply to the query, an empty string when it holds, and otherwise the
/// violation in words.
using Finding = std::optional<std::string>;

/// Checks `law(query, method, rng)` by Method::fast and Method::exact, or by the methods given, on `count` cases of
/// every wanted family and kind, and that it applies to at least `least_share` of them.
template <typename Wanted, typename Law>
void check_law(std::uint64_t seed, std::size_t count, Wanted&& wanted, double least_share, Law&& law,
               std::initializer_list<Method> methods = {Method::fast, Method::exact}) {
  Report report;
  std::size_t cases = 0;
  for_each_case(seed, count, wanted, [&](const CaseId& id) {
    for (const Method method : methods) {
      Rng rng = rng_of(id);
      const Query query = make(id.family, id.kind, rng);
      ++cases;
      const Finding finding = law(query, method, rng);
      if (!finding) continue;
      report.add(id, query, finding->empty() ? "" : (method == Method::fast ? "fast: " : "exact: ") + *finding);
    }
  });
  std::printf("seed %llu: the law applied to %zu of %zu\n", static_cast<unsigned long long>(seed), report.checked(),
              cases);
  CHECK(static_cast<double>(report.checked()) >= least_share * static_cast<double>(cases));
  report.finish();
}

/// Empty when both answers decide alike and their weights are within the tolerance.
inline std::string difference(const Answer& expected, const Answer& found, const Query& asked) {
  std::string wrong = decision_difference(expected, found);
  if (wrong.empty()) wrong = weight_difference(expected, found);
  if (wrong.empty()) return "";
  return wrong + "\n    expected " + describe(expected) + "\n    found    " + describe(found) + "\n    asked    " +
         cpp_initializer(asked);
}

}  // namespace touchstone::tests
