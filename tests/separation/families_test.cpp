// Families with distances of their own keep what they promise, and the methods agree on them.
// SPDX-License-Identifier: MIT
#include <gmpxx.h>

#include <cmath>
#include <cstdio>

#include <touchstone/solve.hpp>

#include "oracle/elements_at.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 19;

bool separation_families(const FamilyInfo& family, Kind) { return family.group == Group::separation; }
bool every_family(const FamilyInfo&, Kind) { return true; }

/// The sign of the exact distance at a time less a separation, in rational numbers and by plain formulas.
int compared_at(const Query& query, double t, const Separation& separation) {
  const mpq_class distance(separation.distance);
  const mpq_class measured = measure(elements_at(query, mpq_class(t)), separation.metric);
  return sgn(
      mpq_class(measured - (separation.metric == Metric::euclidean ? mpq_class(distance * distance) : distance)));
}

void promises_hold(Metric metric) {
  Report report;
  std::size_t promised = 0, exactly = 0;
  for_each_case(kSeed, 60, separation_families, [&](const CaseId& id) {
    const Separated made = make_separated(id, metric);
    std::string wrong;
    if (!(std::isfinite(made.distance) && made.distance > 0)) wrong = "its distance is none";
    if (made.within_at) {
      const int sign = compared_at(made.query, *made.within_at, {made.distance, metric});
      if (sign > 0) wrong = "not within at " + hexfloat(*made.within_at);
      ++promised;
      exactly += sign == 0;
    }
    report.add(id, made.query, wrong.empty() ? "" : hexfloat(made.distance) + ": " + wrong);
  });
  std::printf("%s: %zu promises, %zu of them with exactly that distance\n", std::string(name_of(metric)).c_str(),
              promised, exactly);
  CHECK(2 * promised > report.checked());
  if (metric == Metric::euclidean) CHECK(4 * exactly > 3 * promised);
  report.finish();
}

/// The exact distance just before, at and after the time of an answer, by plain rational arithmetic.
std::string wrong_about_distance(const Query& query, const Separation& separation, const Answer& answer) {
  if (answer.starts_within != (compared_at(query, 0, separation) <= 0)) return "starts_within";
  if (!answer.contact) return compared_at(query, 1, separation) <= 0 ? "within at 1" : "";
  if (answer.toi != answer.toi_upper) {
    if (compared_at(query, answer.toi, separation) <= 0) return "within at toi, which is before the time";
    const bool stays = answer.nature == Nature::entering || answer.nature == Nature::sustained;
    // Where the elements only pass, they may be apart again at the next double.
    if (!stays || compared_at(query, answer.toi_upper, separation) <= 0) return "";
    const Answer later = solve(query, {.t_max = answer.toi_upper, .separation = separation, .method = Method::oracle});
    return later.contact ? "" : "apart up to toi_upper";
  }
  if (compared_at(query, answer.toi, separation) > 0) return "apart at toi, which is the time";
  if (answer.toi == 0) return "";
  return compared_at(query, std::nextafter(answer.toi, 0.0), separation) <= 0 ? "within before toi" : "";
}

void methods_agree(Metric metric, std::size_t count) {
  Report report;
  std::size_t contacts = 0;
  for_each_case(kSeed, count, every_family, [&](const CaseId& id) {
    const Separated made = make_separated(id, metric);
    const Separation separation = {made.distance, metric};
    const Answer exact = solve(made.query, {.separation = separation, .method = Method::exact});
    const Answer fast = solve(made.query, {.separation = separation, .method = Method::fast});
    contacts += exact.contact;
    std::string wrong = decision_difference(fast, exact);
    if (wrong.empty()) wrong = weight_difference(fast, exact);
    if (wrong.empty() && id.index % 8 == 0) wrong = wrong_about_distance(made.query, separation, exact);
    report.add(id, made.query,
               wrong.empty() ? "" : hexfloat(made.distance) + ": " + wrong + "\n    " + describe(exact));
  });
  std::printf("%s: %zu queries by fast and exact, %zu contacts\n", std::string(name_of(metric)).c_str(),
              report.checked(), contacts);
  CHECK((chosen_case() || 4 * contacts > report.checked()));
  report.finish();
}

void oracle_agrees(Metric metric) {
  Report report;
  for_each_case(kSeed + 1, 1, every_family, [&](const CaseId& id) {
    const Separated made = make_separated(id, metric);
    const Separation separation = {made.distance, metric};
    const Answer exact = solve(made.query, {.separation = separation, .method = Method::exact});
    const Answer oracle = solve(made.query, {.separation = separation, .method = Method::oracle});
    std::string wrong = decision_difference(exact, oracle);
    if (wrong.empty()) wrong = weight_difference(exact, oracle);
    report.add(id, made.query,
               wrong.empty() ? "" : hexfloat(made.distance) + ": " + wrong + "\n    " + describe(oracle));
  });
  report.finish();
}

}  // namespace

TEST_CASE("families with distances of their own are as near as they promise") {
  promises_hold(Metric::euclidean);
  promises_hold(Metric::max);
}
TEST_CASE("families with distances: fast and exact agree on Euclidean ones, and the distance is the exact one") {
  methods_agree(Metric::euclidean, 48);
}
TEST_CASE("families with distances: fast and exact agree on largest-axis ones, and the distance is the exact one") {
  methods_agree(Metric::max, 8);
}
TEST_CASE("patches whose roots are nearer to each other than 2^-3000") {
  const CaseId id{Family::gap_extreme, Kind::vertex_face, 2, 262};
  const Separated made = make_separated(id, Metric::euclidean);
  const Separation separation = {made.distance, Metric::euclidean};
  const Answer exact = solve(made.query, {.separation = separation, .method = Method::exact});
  const Answer oracle = solve(made.query, {.separation = separation, .method = Method::oracle});
  CHECK(decision_difference(exact, oracle) == "");
  CHECK(weight_difference(exact, oracle) == "");
}
TEST_CASE("families with distances: the oracle agrees", "[slow]") {
  oracle_agrees(Metric::euclidean);
  oracle_agrees(Metric::max);
}

}  // namespace touchstone::tests
