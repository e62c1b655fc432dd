// The entry filter near the limits of its bounds, against the exact level.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>
#include <string>

#include <touchstone/solve.hpp>

#include "seeded/rng.hpp"
#include "separation/entry_cases.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

/// The counts of one difficulty.
struct Judged {
  std::size_t asked = 0, filter = 0, bracket = 0, entries = 0, wrong = 0;
};

void judge(const EntryCase& entry, const std::string& label, Judged& judged) {
  const Separation& separation = entry.separation;
  if (!(separation.distance > 0)) return;
  ++judged.asked;
  const Answer fast = solve(entry.query, {.t_max = entry.t_max, .separation = separation, .method = Method::fast});
  if (fast.level == Level::exact) return;
  ++(fast.level == Level::filter ? judged.filter : judged.bracket);
  judged.entries += fast.contact && fast.nature == Nature::entering;
  const Answer exact = solve(entry.query, {.t_max = entry.t_max, .separation = separation, .method = Method::exact});
  std::string wrong = decision_difference(fast, exact);
  if (wrong.empty()) wrong = weight_difference(fast, exact);
  if (wrong.empty()) return;
  constexpr std::size_t kPrinted = 3;
  if (++judged.wrong > kPrinted) return;
  FAIL_CHECK(label << ", separation " << hexfloat(separation.distance) << " " << name_of(separation.metric)
                   << ", t_max " << hexfloat(entry.t_max) << ": " << wrong << "\n  fast  " << describe(fast)
                   << "\n  exact " << describe(exact) << "\n  " << cpp_initializer(entry.query));
}

/// @param effort_per_kind  the number of cases of each difficulty for edges and faces
template <std::size_t N>
Judged attack(Metric metric, const std::array<Difficulty, N>& difficulties, std::size_t effort_per_kind) {
  Judged all;
  for (const Difficulty difficulty : difficulties) {
    const auto d = static_cast<std::size_t>(difficulty);
    Judged judged;
    for (std::size_t i = 0; i < effort(effort_per_kind); ++i) {
      for (const Kind kind : kKinds) {
        const bool has_face_or_edges = kind == Kind::edge_edge || kind == Kind::vertex_face;
        if (!has_face_or_edges && i % 4 != 0) continue;
        Rng rng(seeded::seed_of_stream(12 + d, 4 * i + static_cast<std::size_t>(kind)));
        judge(make_entry(kind, difficulty, metric, rng),
              std::string(kDifficultyNames[d]) + " " + std::string(name_of(kind)) + " " + std::to_string(i), judged);
      }
    }
    std::printf("%s: %zu asked, %zu by filter, %zu by bracket, of them %zu entries\n", kDifficultyNames[d],
                judged.asked, judged.filter, judged.bracket, judged.entries);
    CHECK(judged.wrong == 0);
    all.asked += judged.asked;
    all.bracket += judged.bracket;
    all.entries += judged.entries;
  }
  std::printf("%zu asked, %zu by bracket, of them %zu entries\n", all.asked, all.bracket, all.entries);
  return all;
}

void attack_bounds(Metric metric, std::size_t effort_per_kind) {
  const Judged all = attack(metric, kDifficulties, effort_per_kind);
  // Otherwise the comparisons above would show nothing.
  if (!whole_effort("the share that the filter decides")) return;
  CHECK(2 * all.bracket > all.asked);
  CHECK(3 * all.entries > all.asked);
}

}  // namespace

TEST_CASE("Euclidean entries near the limits of the filter's bounds are the exact ones") {
  attack_bounds(Metric::euclidean, 120);
}
TEST_CASE("largest-axis entries near the limits of the filter's bounds are the exact ones") {
  attack_bounds(Metric::max, 60);
}

TEST_CASE("entries at turns, ties and doubles are the exact ones") {
  for (const Metric metric : {Metric::max, Metric::euclidean}) attack(metric, kFailingConditions, 120);
}

}  // namespace touchstone::tests
