// The names of elements and corners are the caller's: swapping elements, reversing edges and turning faces changes the
// names in the answer and nothing else.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <vector>

#include "laws/law.hpp"
#include "laws/names.hpp"
#include "support/static_contact.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 12;

Query relabelled(const Query& query, const Relabelling& relabelling) {
  Query result = query;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    result.start[i] = query.start[relabelling[i]];
    result.end[i] = query.end[relabelling[i]];
  }
  return result;
}

// Whether a + b t + c t^2 has a root in [low, high], or vanishes.
bool has_root(const mpq_class& a, const mpq_class& b, const mpq_class& c, const mpq_class& low, const mpq_class& high) {
  const mpq_class at_low = a + low * (b + low * c);
  const mpq_class at_high = a + high * (b + high * c);
  if (sgn(at_low) * sgn(at_high) <= 0) return true;
  const mpq_class turn_scaled = -b * sgn(c);  // the turning point times 2 |c|
  const mpq_class twice = 2 * abs(c);
  return sgn(c) != 0 && sgn(mpq_class(b * b - 4 * a * c)) >= 0 && low * twice < turn_scaled &&
         turn_scaled < high * twice;
}

// Whether the element of `count` corners from `first` on may have no length or no area at a time in [toi, toi_upper]:
// every component of its direction or normal has a root there. Only then may one place have several names.
bool may_be_degenerate(const Query& query, std::size_t first, std::size_t count, const Answer& answer) {
  if (count == 1) return false;
  const mpq_class low(answer.toi), high(answer.toi_upper);
  const auto component = [&](std::size_t corner, std::size_t axis) {  // of corner - first, as (constant, slope)
    const mpq_class start = mpq_class(coordinate(query.start[corner], axis)) - coordinate(query.start[first], axis);
    const mpq_class end = mpq_class(coordinate(query.end[corner], axis)) - coordinate(query.end[first], axis);
    return std::array<mpq_class, 2>{start, mpq_class(end - start)};
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (count == 2) {
      const auto u = component(first + 1, axis);
      if (!has_root(u[0], u[1], 0, low, high)) return false;
      continue;
    }
    const std::size_t j = (axis + 1) % 3;
    const std::size_t k = (axis + 2) % 3;
    const auto uj = component(first + 1, j), uk = component(first + 1, k);
    const auto wj = component(first + 2, j), wk = component(first + 2, k);
    const mpq_class a = uj[0] * wk[0] - uk[0] * wj[0];
    const mpq_class b = uj[0] * wk[1] + uj[1] * wk[0] - uk[0] * wj[1] - uk[1] * wj[0];
    const mpq_class c = uj[1] * wk[1] - uk[1] * wj[1];
    if (!has_root(a, b, c, low, high)) return false;
  }
  return true;
}

TEST_CASE("law: relabelling corners and swapping elements changes the names alone") {
  NameTally tally;
  check_law(kSeed, 150, every_family, 1, [&](const Query& query, Method method, Rng&) -> Finding {
    const Answer expected = solve(query, {.method = method});
    for (const Relabelling& relabelling : relabellings(query.kind)) {
      const Query other = relabelled(query, relabelling);
      const Answer found = solve(other, {.method = method});
      const auto degenerate = [&](std::size_t first, std::size_t count) {
        return may_be_degenerate(query, first, count, expected);
      };
      const std::string wrong = name_difference(query.kind, relabelling, expected, found, degenerate, tally);
      if (wrong.empty()) continue;
      return wrong + "\n    expected " + describe(expected) + "\n    found    " + describe(found) + "\n    asked    " +
             cpp_initializer(other);
    }
    return "";
  });
  std::printf("elements touched under the same name %zu, under another %zu\n", tally.same_names, tally.other_names);
  CHECK(tally.same_names > 10 * tally.other_names);
}

}  // namespace
}  // namespace touchstone::tests
