// Laws of curved queries: see law.hpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include <touchstone/curved.hpp>

#include "families/curved_parts.hpp"
#include "laws/law.hpp"

namespace touchstone::tests {

/// A curved query, and what it is asked about.
struct CurvedAsked {
  CurvedQuery query;
  Separation separation;
  double t_max = 1;
};

inline Answer answer_to(const CurvedAsked& asked, Method method) {
  return solve(asked.query, {.t_max = asked.t_max, .separation = asked.separation, .method = method});
}

/// Whether a family is asked about separations. In the others numbers differ by hundreds of binary digits, and exact
/// arithmetic then takes up to a second.
inline bool asks_separations(Family family) {
  return family != Family::long_quaternion && family != Family::curved_scale && family != Family::large_turn;
}

/// Checks `law(asked, method, rng)` by Method::fast and Method::exact on `count` cases of every family of curved
/// queries and every kind, and that it applies to at least `least_share` of them. One case in six asks about a
/// separation.
template <typename Law>
void check_curved_law(std::uint64_t seed, std::size_t count, double least_share, Law&& law) {
  constexpr std::size_t kPrinted = 5;
  std::size_t cases = 0, checked = 0, failed = 0;
  for (const FamilyInfo& family : curved_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < effort(count); ++index) {
        const CaseId id{family.family, kind, seed, index};
        for (const Method method : {Method::fast, Method::exact}) {
          Rng rng = rng_of(id);
          // Few cases of each family and kind have separations among them, too.
          const std::uint64_t turn =
              index + static_cast<std::uint64_t>(family.family) + static_cast<std::uint64_t>(kind);
          const Metric metric = turn % 12 == 5 ? Metric::max : Metric::euclidean;
          const CurvedSeparated made = make_curved_separated(id.family, id.kind, metric, rng);
          const double distance = turn % 6 == 5 && asks_separations(family.family) ? made.distance : 0;
          const CurvedAsked asked{made.sample.query, {distance, metric}, made.sample.t_max};
          ++cases;
          const Finding finding = law(asked, method, rng);
          if (!finding) continue;
          ++checked;
          if (finding->empty() || ++failed > kPrinted) continue;
          FAIL_CHECK(case_name(id) << (method == Method::fast ? " fast: " : " exact: ") << *finding << "\n  t_max "
                                   << hexfloat(asked.t_max) << ", distance " << hexfloat(distance) << " "
                                   << name_of(metric) << "\n"
                                   << curved_text(asked.query));
        }
      }
    }
  }
  std::printf("seed %llu: the law applied to %zu of %zu\n", static_cast<unsigned long long>(seed), checked, cases);
  CHECK(checked > 0);
  CHECK(static_cast<double>(checked) >= least_share * static_cast<double>(cases));
  CHECK(failed == 0);
}

/// Empty when both answers say the same; in the largest-axis metric, which has several nearest points, without features
/// and weights.
inline std::string curved_difference(const Answer& expected, const Answer& found, const CurvedAsked& asked) {
  std::string wrong;
  if (asked.separation.distance > 0 && asked.separation.metric == Metric::max) {
    const bool same = expected.contact == found.contact && expected.toi == found.toi &&
                      expected.toi_upper == found.toi_upper && expected.nature == found.nature &&
                      expected.trend == found.trend && expected.starts_within == found.starts_within;
    if (!same) wrong = "the answers differ";
  } else {
    wrong = decision_difference(expected, found);
    if (wrong.empty()) wrong = weight_difference(expected, found);
  }
  if (wrong.empty()) return "";
  return wrong + "\n    expected " + describe(expected) + "\n    found    " + describe(found) + "\n    asked\n" +
         curved_text(asked.query);
}

/// Whether the mapped query has the same answer.
inline Finding same_answer(const CurvedAsked& asked, const std::optional<CurvedAsked>& mapped, Method method) {
  if (!mapped) return std::nullopt;
  return curved_difference(answer_to(asked, method), answer_to(*mapped, method), *mapped);
}

/// Arithmetic that notes whether it is exact.
class Exactly {
 public:
  bool holds() const { return holds_; }

  /// Knuth's two-sum.
  double sum(double a, double b) {
    const double sum = a + b, part = sum - a;
    const double error = (a - (sum - part)) + (b - part);
    if (!(error == 0)) holds_ = false;
    return sum;
  }
  Vec3 sum(const Vec3& a, const Vec3& b) { return {sum(a.x, b.x), sum(a.y, b.y), sum(a.z, b.z)}; }

  double times_power(double x, int exponent) {
    const double result = std::ldexp(x, exponent);
    if (!std::isfinite(result) || std::ldexp(result, -exponent) != x) holds_ = false;
    return result;
  }

  double middle(double a, double b) { return times_power(sum(a, b), -1); }
  Vec3 middle(const Vec3& a, const Vec3& b) { return {middle(a.x, b.x), middle(a.y, b.y), middle(a.z, b.z)}; }
  Quaternion middle(const Quaternion& a, const Quaternion& b) {
    return {middle(a[0], b[0]), middle(a[1], b[1]), middle(a[2], b[2]), middle(a[3], b[3])};
  }

 private:
  bool holds_ = true;
};

}  // namespace touchstone::tests
