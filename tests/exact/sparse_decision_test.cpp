// Queries of wildly different magnitudes: decided in sparse numbers as the exact level decides them.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include "exact/exact.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"
#include "support/wild_query.hpp"

namespace touchstone::tests {
namespace {

double drawn_t_max(std::uint64_t index, const Answer& whole) {
  if (index % 3 != 1 || !whole.contact) return 1;
  const double times[] = {whole.toi, whole.toi_upper, std::nextafter(whole.toi, 0.0),
                          std::fmin(1, std::nextafter(whole.toi_upper, 2.0))};
  return times[index / 3 % 4];
}

struct Tally {
  std::size_t decided = 0, all = 0, wrong = 0, contacts = 0;
};

std::string difference(const Answer& answer, const Answer& expected) {
  const std::string decision = decision_difference(answer, expected);
  return decision.empty() ? weight_difference(answer, expected) : decision;
}

void compare(const Query& query, double t_max, Tally& count) {
  ++count.all;
  const std::optional<Answer> answer = exact::decide_sparsely(query, t_max);
  if (!answer) return;
  ++count.decided;
  const Answer expected = exact::decide_exactly(query, t_max);
  count.contacts += expected.contact;
  const std::string wrong = difference(*answer, expected);
  if (!wrong.empty() && ++count.wrong <= 5) std::printf("%s\n", wrong.c_str());
  if (expected.contact) {
    const std::optional<Answer> time = exact::decide_sparsely(query, t_max, Wanted::time);
    count.wrong += !time || time->toi != expected.toi || time->toi_upper != expected.toi_upper;
  }
}

}  // namespace

TEST_CASE("sparse numbers decide queries of wild magnitudes as decide_exactly does, and most of them") {
  Rng rng(61);
  Tally count;
  for (std::size_t i = 0; i < effort(60000); ++i) {
    const Query query = wild_query(kKinds[i % 4], rng);
    compare(query, drawn_t_max(i / 4, exact::decide_exactly(query, 1)), count);
  }
  std::printf("%zu of %zu decided, %zu contacts, %zu wrong\n", count.decided, count.all, count.contacts, count.wrong);
  CHECK(count.wrong == 0);
  CHECK(count.contacts * 10 > count.all);
  CHECK(count.decided * 100 > count.all * 97);
}

TEST_CASE("sparse numbers decide every family as decide_exactly does") {
  Report report;
  std::size_t decided = 0;
  for_each_case(
      62, 300, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const double t_max = drawn_t_max(id.index, exact::decide_exactly(query, 1));
        const std::optional<Answer> answer = exact::decide_sparsely(query, t_max);
        decided += answer.has_value();
        report.add(id, query, answer ? difference(*answer, exact::decide_exactly(query, t_max)) : "");
      });
  std::printf("%zu of %zu queries decided\n", decided, report.checked());
  CHECK(decided * 100 > report.checked() * 90);
  report.finish();
}

}  // namespace touchstone::tests
