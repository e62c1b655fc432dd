// The names of elements and corners are the caller's: swapping elements, reversing edges and turning faces changes the
// names in the answer and nothing else.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <vector>

#include "laws/law.hpp"
#include "support/static_contact.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 12;

// relabelling[i] is the corner of the original query that corner i of the new one is.
using Relabelling = std::array<std::size_t, 4>;

// All relabellings of a kind but the identity.
const std::vector<Relabelling>& relabellings(Kind kind) {
  static const std::vector<Relabelling> edge_edge{{1, 0, 2, 3}, {0, 1, 3, 2}, {1, 0, 3, 2}, {2, 3, 0, 1},
                                                  {3, 2, 0, 1}, {2, 3, 1, 0}, {3, 2, 1, 0}};
  static const std::vector<Relabelling> vertex_face{
      {0, 2, 3, 1}, {0, 3, 1, 2}, {0, 2, 1, 3}, {0, 1, 3, 2}, {0, 3, 2, 1}};
  static const std::vector<Relabelling> point_edge{{0, 2, 1, 3}};
  static const std::vector<Relabelling> point_point{{1, 0, 2, 3}};
  switch (kind) {
    case Kind::edge_edge: return edge_edge;
    case Kind::vertex_face: return vertex_face;
    case Kind::point_edge: return point_edge;
    case Kind::point_point: return point_point;
  }
  return edge_edge;
}

Query relabelled(const Query& query, const Relabelling& relabelling) {
  Query result = query;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    result.start[i] = query.start[relabelling[i]];
    result.end[i] = query.end[relabelling[i]];
  }
  return result;
}

// The corners of the query that a feature rests on, as a set of bits; an overlap rests on both edges.
unsigned corners_of(Kind kind, const Answer& answer) {
  const auto first_of_b = static_cast<unsigned>(element_sizes(kind).a);
  unsigned corners = 0;
  for (const Feature feature : {answer.feature_a, answer.feature_b}) {
    switch (feature) {
      case Feature::a0:
      case Feature::v:
      case Feature::p: corners |= 1u; break;
      case Feature::a1: corners |= 2u; break;
      case Feature::a: corners |= 3u; break;
      case Feature::b0:
      case Feature::f0:
      case Feature::e0:
      case Feature::q: corners |= 1u << first_of_b; break;
      case Feature::b1:
      case Feature::f1:
      case Feature::e1: corners |= 2u << first_of_b; break;
      case Feature::b:
      case Feature::f01:
      case Feature::e: corners |= 3u << first_of_b; break;
      case Feature::f2: corners |= 4u << first_of_b; break;
      case Feature::f12: corners |= 6u << first_of_b; break;
      case Feature::f20: corners |= 5u << first_of_b; break;
      case Feature::f: corners |= 7u << first_of_b; break;
      case Feature::overlap: corners |= 15u; break;
      case Feature::none: break;
    }
  }
  return corners;
}

std::array<double, 4> corner_weights(Kind kind, const Answer& answer) {
  const ElementSizes sizes = element_sizes(kind);
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < sizes.a; ++i) weights[i] = answer.weights_a[i];
  for (std::size_t i = 0; i < sizes.b; ++i) weights[sizes.a + i] = answer.weights_b[i];
  return weights;
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

struct Tally {
  std::size_t same_names = 0;
  std::size_t other_names = 0;
};

// Empty when `found`, the answer to the relabelled query, says the same as `expected` in the new names.
std::string name_difference(const Query& query, const Relabelling& relabelling, const Answer& expected,
                            const Answer& found, Tally& tally) {
  if (expected.contact != found.contact) return "contact differs";
  if (!expected.contact) return "";
  if (expected.toi != found.toi || expected.toi_upper != found.toi_upper) return "the times differ";
  if (expected.nature != found.nature) return "the nature differs";
  if ((expected.feature_a == Feature::overlap) != (found.feature_a == Feature::overlap)) return "the overlap differs";
  if (expected.feature_a == Feature::overlap) return "";  // another end of the overlap is its first

  const unsigned found_corners = corners_of(query.kind, found);
  const std::array<double, 4> found_weights = corner_weights(query.kind, found);
  unsigned corners = 0;
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (found_corners >> i & 1) corners |= 1u << relabelling[i];
    weights[relabelling[i]] = found_weights[i];
  }
  const unsigned expected_corners = corners_of(query.kind, expected);
  const std::array<double, 4> expected_weights = corner_weights(query.kind, expected);
  const ElementSizes sizes = element_sizes(query.kind);
  for (const bool second : {false, true}) {
    const std::size_t first = second ? sizes.a : 0;
    const std::size_t count = second ? sizes.b : sizes.a;
    const unsigned element = ((1u << count) - 1) << first;
    if ((corners & element) != (expected_corners & element)) {
      if (!may_be_degenerate(query, first, count, expected)) return "another feature is touched";
      ++tally.other_names;
      continue;
    }
    ++tally.same_names;
    for (std::size_t i = first; i < first + count; ++i) {
      if (!(std::abs(weights[i] - expected_weights[i]) <= kWeightTolerance)) return "the weights differ";
    }
  }
  return "";
}

TEST_CASE("law: relabelling corners and swapping elements changes the names alone") {
  Tally tally;
  check_law(kSeed, 150, every_family, 1, [&](const Query& query, Method method, Rng&) -> Finding {
    const Answer expected = solve(query, method);
    for (const Relabelling& relabelling : relabellings(query.kind)) {
      const Query other = relabelled(query, relabelling);
      const Answer found = solve(other, method);
      const std::string wrong = name_difference(query, relabelling, expected, found, tally);
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
