// The level with near times against the exact level, on every family of hard queries.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include "exact/exact.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

/// Ends of the time range around a contact.
double t_max_of(std::uint64_t index, const Answer& whole) {
  if (index % 3 != 1) return 1;
  if (!whole.contact) return 0.5;
  const double times[] = {whole.toi, whole.toi_upper, std::nextafter(whole.toi, 0.0),
                          std::fmin(1, std::nextafter(whole.toi_upper, 2.0))};
  return times[index / 3 % 4];
}

}  // namespace

TEST_CASE("decide_nearby answers as decide_exactly does, or not at all") {
  Report report;
  std::size_t answers = 0, few_bits = 0, answers_of_few = 0;
  for_each_case(
      17, 2000, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const double t_max = t_max_of(id.index, exact::decide_exactly(query, 1));
        const std::optional<Answer> nearby = exact::decide_nearby(query, t_max);
        answers += nearby.has_value();
        if (info(id.family).dyadic) {
          ++few_bits;
          answers_of_few += nearby.has_value();
        }
        std::string wrong;
        if (nearby) {
          const Answer expected = exact::decide_exactly(query, t_max);
          wrong = decision_difference(*nearby, expected);
          if (wrong.empty()) wrong = weight_difference(*nearby, expected);
          if (!wrong.empty()) wrong += "\n    " + describe(*nearby) + "\n    " + describe(expected);
        }
        report.add(id, query, wrong);
      });
  std::printf("%zu of %zu queries decided; with few bits %zu of %zu\n", answers, report.checked(), answers_of_few,
              few_bits);
  CHECK(answers_of_few * 100 > few_bits * 95);
  report.finish();
}

}  // namespace touchstone::tests
