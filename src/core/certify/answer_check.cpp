// Comparisons of answers, and the conditions that an answer must satisfy by itself.
// SPDX-License-Identifier: MIT
#include "certify/answer_check.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace touchstone::certify {
namespace {

bool same_bits(double a, double b) {
  std::uint64_t x = 0, y = 0;
  std::memcpy(&x, &a, sizeof x);
  std::memcpy(&y, &b, sizeof y);
  return x == y;
}

bool same_bits(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return same_bits(a[0], b[0]) && same_bits(a[1], b[1]) && same_bits(a[2], b[2]);
}

// Which corners a feature rests on, as a set of bits; 0 when the kind has no such feature on that element.
unsigned support_a(Kind kind, Feature feature) {
  if (kind == Kind::edge_edge) {
    return feature == Feature::a0 ? 1 : feature == Feature::a1 ? 2 : feature == Feature::a ? 3 : 0;
  }
  return feature == (kind == Kind::vertex_face ? Feature::v : Feature::p) ? 1 : 0;
}

unsigned support_b(Kind kind, Feature feature) {
  switch (kind) {
    case Kind::edge_edge:
      return feature == Feature::b0 ? 1 : feature == Feature::b1 ? 2 : feature == Feature::b ? 3 : 0;
    case Kind::point_edge:
      return feature == Feature::e0 ? 1 : feature == Feature::e1 ? 2 : feature == Feature::e ? 3 : 0;
    case Kind::point_point: return feature == Feature::q ? 1 : 0;
    case Kind::vertex_face: break;
  }
  switch (feature) {
    case Feature::f0: return 1;
    case Feature::f1: return 2;
    case Feature::f2: return 4;
    case Feature::f01: return 3;
    case Feature::f12: return 6;
    case Feature::f20: return 5;
    case Feature::f: return 7;
    default: return 0;
  }
}

std::string weights_malformation(const std::array<double, 3>& weights, unsigned support) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(weights[i] >= 0 && weights[i] <= 1)) return "a weight is outside [0, 1]";
    if ((support >> i & 1) == 0 && weights[i] != 0) return "a weight is not zero off the feature";
  }
  // Sums of at most three doubles in [0, 1]: their rounding is far below the tolerance.
  const double sum = weights[0] + weights[1] + weights[2];
  return std::abs(sum - 1) <= kWeightTolerance ? "" : "the weights do not sum to 1 within 2^-49";
}

}  // namespace

std::string decision_difference(const Answer& one, const Answer& other) {
  if (one.contact != other.contact) return "contact differs";
  if (!one.contact) return "";
  if (one.toi != other.toi) return "toi differs";
  if (one.toi_upper != other.toi_upper) return "toi_upper differs";
  if (one.nature != other.nature) return "nature differs";
  if (one.feature_a != other.feature_a) return "feature_a differs";
  if (one.feature_b != other.feature_b) return "feature_b differs";
  if (one.starts_within != other.starts_within) return "starts_within differs";
  if (one.trend != other.trend) return "trend differs";
  return "";
}

std::string weight_difference(const Answer& one, const Answer& other) {
  if (!one.contact || !other.contact) return "";
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(one.weights_a[i] - other.weights_a[i]) <= kWeightTolerance)) return "weights_a differ";
    if (!(std::abs(one.weights_b[i] - other.weights_b[i]) <= kWeightTolerance)) return "weights_b differ";
  }
  return "";
}

std::string bit_difference(const Answer& one, const Answer& other, bool levels) {
  if (one.contact != other.contact) return "contact differs";
  if (levels && one.level != other.level) return "level differs";
  if (!same_bits(one.toi, other.toi)) return "toi differs";
  if (!same_bits(one.toi_upper, other.toi_upper)) return "toi_upper differs";
  if (one.nature != other.nature) return "nature differs";
  if (one.starts_within != other.starts_within || one.trend != other.trend) return "starts_within or trend differs";
  if (one.feature_a != other.feature_a || one.feature_b != other.feature_b) return "features differ";
  if (!same_bits(one.weights_a, other.weights_a) || !same_bits(one.weights_b, other.weights_b)) {
    return "weights differ in their bits";
  }
  return "";
}

std::string malformation(Kind kind, const Answer& answer, double t_max) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!answer.contact) {
    if (answer.toi != kInfinity || answer.toi_upper != kInfinity) return "a time is finite without contact";
    if (answer.nature != Nature::none) return "a nature without contact";
    if (answer.trend != Trend::none || answer.starts_within) return "a trend or a start without contact";
    if (answer.feature_a != Feature::none || answer.feature_b != Feature::none) return "a feature without contact";
    return "";
  }
  if (!(answer.toi >= 0 && answer.toi_upper <= t_max)) return "a time is outside [0, t_max]";
  if (answer.toi_upper != answer.toi && answer.toi_upper != std::nextafter(answer.toi, 2.0)) {
    return "the times are neither equal nor neighbours";
  }
  const bool has_cubic = kind == Kind::edge_edge || kind == Kind::vertex_face;
  const bool of_cubic = answer.nature == Nature::crossing || answer.nature == Nature::grazing;
  const bool of_separation = answer.trend != Trend::none;
  if (answer.nature == Nature::none || (of_cubic && !has_cubic && !of_separation))
    return "a nature that the kind does not have";
  const bool overlap = answer.feature_a == Feature::overlap;
  if (overlap != (answer.feature_b == Feature::overlap)) return "only one element overlaps";
  if (overlap && kind != Kind::edge_edge) return "an overlap of a kind that has none";
  const unsigned a = overlap ? 3 : support_a(kind, answer.feature_a);
  const unsigned b = overlap ? 3 : support_b(kind, answer.feature_b);
  if (a == 0 || b == 0) return "a feature that the kind does not have";
  if (const std::string wrong = weights_malformation(answer.weights_a, a); !wrong.empty()) return "a: " + wrong;
  if (const std::string wrong = weights_malformation(answer.weights_b, b); !wrong.empty()) return "b: " + wrong;
  return "";
}

}  // namespace touchstone::certify
