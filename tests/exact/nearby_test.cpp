// The level with near times against the exact level, on every family of hard queries.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include "exact/exact.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"
#include "support/wild_query.hpp"

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

/// By a rung with near times; nothing where they leave a doubt, or where the coordinates have too many bits.
std::optional<Answer> decide_nearby(const Query& query, double t_max, Wanted wanted = Wanted::all) {
  exact::Rung rung = exact::Rung::exact_any;
  const Answer answer = exact::decide(query, t_max, wanted, &rung);
  return rung <= exact::Rung::near_two ? std::optional(answer) : std::nullopt;
}

/// Small integers, often in a plane, with a shared corner or at rest in part; along one axis they are times many powers
/// of two or have many bits, up to `spread` in all.
Query uneven(Kind kind, int spread, Rng& rng) {
  static constexpr double Vec3::*members[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  Query query;
  query.kind = kind;
  const int reach = 1 << rng.between(0, rng.one_in(4) ? 20 : 3);
  const int wide = rng.between(0, 2), flat = rng.one_in(4) ? (wide + rng.between(1, 2)) % 3 : -1;
  const int rarity = rng.between(1, 6);
  const bool fine = rng.one_in(3);
  const auto corner = [&] {
    Vec3 x;
    for (int k = 0; k < 3; ++k) {
      double& coordinate = x.*members[k];
      coordinate = k == flat ? 0 : rng.between(-reach, reach);
      if (k == wide && rng.one_in(rarity)) {
        if (fine) coordinate += std::ldexp(rng.between(-7, 7), rng.between(-40, 0));
        coordinate = std::ldexp(coordinate, rng.between(std::min(0, 25 - spread), 0));
      }
    }
    return x;
  };
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.start[i] = corner();
    query.end[i] = rng.one_in(4) ? query.start[i] : corner();
  }
  if (rng.one_in(4)) query.start[2] = query.start[0];
  if (rng.one_in(4)) query.end[2] = query.end[0];
  return query;
}

}  // namespace

TEST_CASE("the near rungs answer as decide_exactly does, or not at all") {
  Report report;
  std::size_t answers = 0, few_bits = 0, answers_of_few = 0;
  for_each_case(
      17, 2000, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const double t_max = t_max_of(id.index, exact::decide_exactly(query, 1));
        const std::optional<Answer> nearby = decide_nearby(query, t_max);
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

TEST_CASE("the exact level answers queries of wild magnitudes as decide_exactly does") {
  Rng rng(31);
  std::array<std::size_t, exact::kRungs> answers{};
  std::size_t contacts = 0;
  for (std::size_t i = 0; i < effort(8000); ++i) {
    const Query query = wild_query(kKinds[i % 4], rng);
    const double t_max = t_max_of(i / 4, exact::decide_exactly(query, 1));
    const Answer expected = exact::decide_exactly(query, t_max);
    exact::Rung rung{};
    const Answer answer = exact::decide(query, t_max, Wanted::all, &rung);
    ++answers[static_cast<std::size_t>(rung)];
    contacts += expected.contact;
    INFO(i);
    REQUIRE(decision_difference(answer, expected) == "");
    REQUIRE(weight_difference(answer, expected) == "");
    for (const Wanted wanted : {Wanted::contact, Wanted::time, Wanted::features}) {
      const Answer less = exact::decide(query, t_max, wanted);
      REQUIRE(less.contact == expected.contact);
      if (wanted == Wanted::contact) continue;
      REQUIRE(less.toi == expected.toi);
      REQUIRE(less.toi_upper == expected.toi_upper);
    }
  }
  CAPTURE(answers);
  CHECK(answers[static_cast<std::size_t>(exact::Rung::exact_any)] > 0);
  CHECK(contacts * 10 > 2 * effort(8000));
}

TEST_CASE("the near rungs answer as decide_exactly does where one axis has many bits, or not at all") {
  constexpr int kQueries = 15000;
  Rng rng(29);
  int answers = 0, contacts = 0;
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge}) {
    for (int n = 0; n < kQueries; ++n) {
      const Query query = uneven(kind, rng.between(60, 90), rng);
      const Answer expected = exact::decide_exactly(query, 1);
      const double t_max = t_max_of(static_cast<std::uint64_t>(n), expected);
      const Answer until = t_max == 1 ? expected : exact::decide_exactly(query, t_max);
      const std::optional<Answer> nearby = decide_nearby(query, t_max);
      if (!nearby) continue;
      ++answers;
      contacts += until.contact;
      std::string wrong = decision_difference(*nearby, until);
      if (wrong.empty()) wrong = weight_difference(*nearby, until);
      INFO(cpp_initializer(query) << " up to " << t_max << "\n" << describe(*nearby) << "\n" << describe(until));
      REQUIRE(wrong == "");
    }
  }
  std::printf("%d of %d queries decided, %d contacts\n", answers, 3 * kQueries, contacts);
  CHECK(answers * 100 > 3 * kQueries * 95);
  CHECK(contacts > 5000);
}

}  // namespace touchstone::tests
