// SPDX-License-Identifier: MIT
#include "laws/names.hpp"

#include <cmath>

#include "support/answer_check.hpp"
#include "support/query_families.hpp"

namespace touchstone::tests {
namespace {

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

}  // namespace

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

std::string name_difference(Kind kind, const Relabelling& relabelling, const Answer& expected, const Answer& found,
                            const MayBeDegenerate& may_be_degenerate, NameTally& tally) {
  if (expected.contact != found.contact) return "contact differs";
  if (!expected.contact) return "";
  if (expected.toi != found.toi || expected.toi_upper != found.toi_upper) return "the times differ";
  if (expected.nature != found.nature) return "the nature differs";
  if ((expected.feature_a == Feature::overlap) != (found.feature_a == Feature::overlap)) return "the overlap differs";
  if (expected.feature_a == Feature::overlap) return "";  // another end of the overlap is its first

  const unsigned found_corners = corners_of(kind, found);
  const std::array<double, 4> found_weights = corner_weights(kind, found);
  unsigned corners = 0;
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    if (found_corners >> i & 1) corners |= 1u << relabelling[i];
    weights[relabelling[i]] = found_weights[i];
  }
  const unsigned expected_corners = corners_of(kind, expected);
  const std::array<double, 4> expected_weights = corner_weights(kind, expected);
  const ElementSizes sizes = element_sizes(kind);
  for (const bool second : {false, true}) {
    const std::size_t first = second ? sizes.a : 0;
    const std::size_t count = second ? sizes.b : sizes.a;
    const unsigned element = ((1u << count) - 1) << first;
    if ((corners & element) != (expected_corners & element)) {
      if (!may_be_degenerate(first, count)) return "another feature is touched";
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

}  // namespace touchstone::tests
