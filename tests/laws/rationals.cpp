// Rational coordinates: other fractions of the same value, thirds of everything, and offsets that no double holds.
// SPDX-License-Identifier: MIT
#include <gmpxx.h>

#include <touchstone/contact_times.hpp>

#include "laws/law.hpp"
#include "laws/time_sets.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 15;

Fraction fraction(const mpq_class& value) { return {value.get_num().get_str(), value.get_den().get_str()}; }

// The query with f(mpq_class) in place of every coordinate, written by `write(mpq_class)`.
template <typename Map, typename Write>
RationalQuery rational(const Query& query, Map&& map, Write&& write) {
  RationalQuery result;
  result.kind = query.kind;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.start[i][axis] = write(map(mpq_class(coordinate(query.start[i], axis)), axis));
      result.end[i][axis] = write(map(mpq_class(coordinate(query.end[i], axis)), axis));
    }
  }
  return result;
}

mpq_class same(const mpq_class& x, std::size_t) { return x; }

Finding same_answer(const Query& query, const RationalQuery& asked, Method method) {
  const Answer expected = solve(query, {.method = method});
  const Answer found = solve(asked, {.method = method});
  const std::string wrong = difference(expected, found, query);
  return wrong.empty() ? wrong : "as fractions (the query asked is the original): " + wrong;
}

TEST_CASE("law: a fraction is its value, however it is written") {
  check_law(kSeed, 40, every_family, 1, [](const Query& query, Method method, Rng& rng) -> Finding {
    // Fractions that are not reduced, with either sign. They are still doubles, so the level is the same too.
    const mpz_class factor = rng.between(1, 12) * (rng.one_in(2) ? 1 : -1);
    const RationalQuery asked = rational(query, same, [&](const mpq_class& x) {
      return Fraction{mpz_class(x.get_num() * factor).get_str(), mpz_class(x.get_den() * factor).get_str()};
    });
    const Query without_minus_zero = mapped_corners(query, [](const Vec3& corner) { return corner + Vec3{}; });
    const Answer expected = solve(without_minus_zero, {.method = method});
    const Answer found = solve(asked, {.method = method});
    const std::string wrong = bit_difference(expected, found, true);
    return wrong.empty() ? wrong : wrong + "\n    " + describe(expected) + "\n    " + describe(found);
  });
}

TEST_CASE("law: a third of every coordinate changes nothing") {
  check_law(kSeed, 40, every_family, 1, [](const Query& query, Method method, Rng&) {
    const auto third = [](const mpq_class& x, std::size_t) { return mpq_class(x / 3); };
    return same_answer(query, rational(query, third, fraction), method);
  });
}

TEST_CASE("law: an offset that no double holds changes nothing") {
  check_law(kSeed, 40, every_family, 1, [](const Query& query, Method method, Rng&) {
    static const std::array<mpq_class, 3> offsets{mpq_class(1, 3), mpq_class(-2, 7), mpq_class(123456789, 1000)};
    const auto moved = [](const mpq_class& x, std::size_t axis) { return mpq_class(x + offsets[axis]); };
    return same_answer(query, rational(query, moved, fraction), method);
  });
}

TEST_CASE("law: contact_times of rationals is that of the doubles they are, and of a third of them") {
  check_law(kSeed, 40, every_family, 1,
            [](const Query& query, Method, Rng&) -> Finding {
              const TimeSet expected = contact_times(query);
              const std::string wrong = set_difference(expected, contact_times(rational(query, same, fraction)));
              if (!wrong.empty()) return wrong;
              const auto third = [](const mpq_class& x, std::size_t) { return mpq_class(x / 3); };
              return set_difference(expected, contact_times(rational(query, third, fraction)));
            },
            {Method::exact});
}

TEST_CASE("law: the oracle takes the same rationals") {
  check_law(kSeed, 10, every_family, 1,
            [](const Query& query, Method method, Rng&) {
              const auto third = [](const mpq_class& x, std::size_t) { return mpq_class(x / 3); };
              return same_answer(query, rational(query, third, fraction), method);
            },
            {Method::oracle});
}

}  // namespace
}  // namespace touchstone::tests
