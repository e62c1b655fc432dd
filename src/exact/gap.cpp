// Why a narrower gap changes nothing but times and weights.
//
// Let the norm of a polynomial in t and d be the sum of the absolute values of its coefficients; the norm of a product
// is at most the product of the norms. Where the integers along axis k are at most X_k in absolute value, a coordinate
// of a moving corner has a norm of at most 3 X_k, and a difference of two corners one of at most 6 X_k: 2 X_k at t = 0
// and 4 X_k for its change. So the components of cross products have norms of at most 2 * 36 X_i X_j, sums of three of
// them 216 X_i X_j, and V has 3 * 72 * 6 X_x X_y X_z = 1296 X_x X_y X_z.
//
// Whether, when and in which features two elements touch in [0, 1] is told by the signs of V, of such components and
// sums, and of differences of coordinates, at and between their roots, and by where 0 and 1 lie among these. (The sign
// of a dot product is asked for collinear vectors only. There it is that of a product of differences along one axis.)
// The roots are continuous in d, with the same coincidences, multiplicities and order for all d in an interval, if the
// leading coefficients and the principal subresultant coefficients of all pairs of these polynomials, and of each and
// its derivative, have one sign in this interval, or are zero all over it (delineability: Collins, "Quantifier
// elimination for real closed fields by cylindrical algebraic decomposition", 1975). Each of them is a polynomial in d
// with integer coefficients: a determinant whose norm is at most the product of the norms of its rows. With v, q and l
// the norms of V, of quadratics and of differences, the largest are 54 v^4 of V's discriminant, v^2 q^3 of V and a
// quadratic, q^4 of two quadratics, and v l^3. Let 2^(S - 1) be at least all of these. Where d <= 2^-S, the lowest
// coefficient that is not zero, an integer, exceeds the sum of all later terms: such a polynomial is zero or has one
// sign for all d in (0, 2^-S].
//
// The time. At a time t in [0, 1], and a little beyond 1, V differs from the base's V_0 by at most d v. A first contact
// at exactly 0 or 1 stays there. Another one is restored where V_0 has a root t0 = n / 2^f of multiplicity m close to
// it: V_0(t0 + x) = x^m (g_m + g_(m+1) x + ...), and the g_i are integers over 2^(3 f). So it is at least
// |x|^m / 2^(3 f + 1) for |x| <= 2^-12, where |g_m| exceeds twice the sum of the later |g_i| 2^-12. Where this exceeds
// d v, V has no root at t0 + x. Hence:
// - for the narrowed d, and all smaller ones, no root is at t0 +- 2^-12. The root of the contact, which is continuous
//   in d, stays between these.
// - for the query's d, no root is farther from t0 than x with |x|^m > 2^(3 f + 1) d v, and closer than 2^-12. So the
//   root of the contact is that close to t0: much closer than the next double.
// - V at t0 is a polynomial in d with integer coefficients over 2^(3 f) and a norm of at most v: it has one sign for
//   all d up to the narrowed one, or is zero for all. So the root is before t0, at t0 or after it as in the narrowed
//   query.
//
// The weights are quotients of the base at t0, unless the denominator is too small there. Numerators and denominators
// change by at most twice their norm times the way to the root, and by d times their norm.
// SPDX-License-Identifier: MIT
#include "exact/gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "exact/corners.hpp"

namespace touchstone::exact {
namespace {

constexpr int kTimeBits = 6;         // f
constexpr int kNearbyBits = 12;      // of the distance within which the root of the contact stays
constexpr int kMostVolumeBits = 40;  // of v: V_0 at t0 and its derivatives, times 2^(3 f + 3), fit one word
constexpr int kLeastGap = 32;        // a narrower one is no gap
constexpr double kVolumeNorm = 1296, kQuadraticNorm = 216, kDifferenceNorm = 6;

/// The least n with x <= 2^n, for x >= 1; or one more.
int bits_of(double x) noexcept { return std::ilogb(x) + 1; }

/// The coordinates along one axis: multiples of 2^unit, and lesser ones, multiples of 2^least, below a gap.
struct Split {
  int unit = 0, least = 0;
  bool gapped = false;
};

Split split_along(const Query& query, double Vec3::*axis) {
  std::array<BitSpan, 8> spans;
  std::size_t count = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const Vec3* x : {&query.start[i], &query.end[i]}) {
      if (x->*axis == 0) continue;
      BitSpan span;
      span.add(x->*axis);
      std::size_t at = count++;  // the greatest first
      for (; at > 0 && spans[at - 1].high < span.high; --at) spans[at] = spans[at - 1];
      spans[at] = span;
    }
  }
  if (count == 0) return {};
  Split split;
  int low = spans[0].low, widest = kLeastGap - 1;
  for (std::size_t i = 1; i < count; ++i) {
    const int gap = low - spans[i].high;
    if (gap > widest) {
      widest = gap;
      split.gapped = true;
      split.unit = low;
    }
    low = std::min(low, spans[i].low);
  }
  split.least = low;
  if (!split.gapped) split.unit = low;
  return split;
}

using Point = Forms<Near<0>>::Point;
using SmallQuadratic = Forms<Near<0>>::Quadratic;

/// 2^(2 f) q(n / 2^f).
std::int64_t value_at(const SmallQuadratic& q, std::int64_t n) noexcept {
  return ((q[0].value() << (2 * kTimeBits)) + (q[1].value() * n << kTimeBits)) + q[2].value() * n * n;
}

/// A root of V_0 close to a contact.
struct BaseRoot {
  std::int64_t n = 0;  ///< it is at n / 2^f
  double way = 0;      ///< at least the distance of the contact
};

/// The weights within 2^-52. False where they stay open.
bool weigh(Kind kind, const geometry::Frame<Point>& frame, const geometry::Vector<SmallQuadratic>& normal,
           const std::array<double, 3>& size, const BaseRoot& root, double d, Answer& answer) {
  const bool edges = kind == Kind::edge_edge;
  if (answer.feature_a == Feature::overlap) return false;
  const bool inside_a = answer.feature_a == Feature::a;
  const bool inside_b =
      edges ? answer.feature_b == Feature::b
            : answer.feature_b != Feature::f0 && answer.feature_b != Feature::f1 && answer.feature_b != Feature::f2;
  if (!inside_a && !inside_b) return true;  // corners
  // |n / d - N / D| <= (|n - N| + |d - D|) / (|D| - |d - D|) for 0 <= n / d <= 1, and so below 2^-53.
  constexpr double kGreatestError = 0x1p-55;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t denominator = value_at(normal[k], root.n);
    const double norm = kQuadraticNorm * size[(k + 1) % 3] * size[(k + 2) % 3] * (1 << (2 * kTimeBits));
    const double error = (2 * root.way + d) * norm;
    if (!(error <= kGreatestError * std::fabs(static_cast<double>(denominator)))) continue;
    const std::int64_t first = value_at(geometry::first_numerator(frame, k), root.n);
    const std::int64_t second = value_at(geometry::second_numerator(edges, frame, k), root.n);
    const auto weight = [denominator](std::int64_t numerator) {
      const double quotient = static_cast<double>(numerator) / static_cast<double>(denominator);
      return quotient > 0 ? std::min(quotient, 1.0) : 0.0;  // never -0
    };
    if (edges) {
      const double a = weight(first), b = weight(second);
      if (inside_a) answer.weights_a = {1 - a, a, 0};
      if (inside_b) answer.weights_b = {1 - b, b, 0};
      return true;
    }
    const Feature face = answer.feature_b;
    const std::array<double, 3> weights = {weight(denominator - first - second), weight(first), weight(second)};
    answer.weights_b = {face == Feature::f12 ? 0 : weights[0], face == Feature::f20 ? 0 : weights[1],
                        face == Feature::f01 ? 0 : weights[2]};
    return true;
  }
  return false;
}

}  // namespace

std::optional<Gap> Gap::of(const Query& query) {
  if (query.kind != Kind::edge_edge && query.kind != Kind::vertex_face) return std::nullopt;
  static constexpr double Vec3::*axes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  std::array<Split, 3> splits;
  int spread = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    splits[k] = split_along(query, axes[k]);
    if (splits[k].gapped) spread = std::max(spread, splits[k].unit - splits[k].least);
  }
  if (spread == 0) return std::nullopt;

  std::optional<Gap> gap(std::in_place);
  gap->spread_ = spread;
  gap->base_.kind = gap->narrowed_.kind = query.kind;
  std::array<Query, 2> parts;  // the integers: h and l
  constexpr double kGreatest = 0x1p20;
  int high_bits = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double border = std::ldexp(1, splits[k].unit);
    double high = 1;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      for (const bool at_end : {false, true}) {
        const double x = (at_end ? query.end : query.start)[i].*axes[k];
        const bool is_low = std::fabs(x) < border;
        const double integer = std::ldexp(x, (is_low ? spread : 0) - splits[k].unit);
        const double size = std::fabs(integer);
        if (size > kGreatest) return std::nullopt;
        gap->size_[k] = std::max(gap->size_[k], size);
        if (!is_low) high = std::max(high, size);
        for (const bool part : {false, true}) {
          (at_end ? parts[part].end : parts[part].start)[i].*axes[k] = part == is_low ? integer : 0;
        }
      }
    }
    if (splits[k].gapped) high_bits = std::max(high_bits, bits_of(high));
  }
  const auto& size = gap->size_;
  const double least = std::min({size[0], size[1], size[2]});
  const int v = bits_of(kVolumeNorm * size[0] * size[1] * size[2]);
  const int q = bits_of(kQuadraticNorm * size[0] * size[1] * size[2] / least);
  const int l = bits_of(kDifferenceNorm * std::max({size[0], size[1], size[2]}));
  if (v > kMostVolumeBits) return std::nullopt;
  constexpr int kDiscriminantBits = 6;  // 54 < 2^6
  const int enough = 1 + std::max({kDiscriminantBits + 4 * v, 2 * v + 3 * q, 4 * q, v + 3 * l,
                                   3 * kNearbyBits + 3 * kTimeBits + v + 2});
  const int narrow = enough;
  if (narrow + high_bits > kMostBits<2> || spread <= narrow) return std::nullopt;
  gap->base_.start = parts[0].start;
  gap->base_.end = parts[0].end;
  const double d = std::ldexp(1, -narrow);
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const bool at_end : {false, true}) {
      const Vec3& h = (at_end ? parts[0].end : parts[0].start)[i];
      const Vec3& l_times = (at_end ? parts[1].end : parts[1].start)[i];
      (at_end ? gap->narrowed_.end : gap->narrowed_.start)[i] = {h.x + d * l_times.x, h.y + d * l_times.y,
                                                                 h.z + d * l_times.z};
    }
  }
  return gap;
}

bool Gap::restore(Answer& answer, Wanted wanted) const {
  if (!answer.contact || wanted == Wanted::contact) return true;
  const std::array<BitSpan, 3> spans = [] {
    BitSpan span;
    span.low = 0;
    span.high = kMostBits<0>;
    return std::array<BitSpan, 3>{span, span, span};
  }();
  const auto corners = moving_corners<Near<0>>(base_, spans);
  const bool edges = base_.kind == Kind::edge_edge;
  const auto frame = geometry::frame_of(edges, [&](std::size_t i, std::size_t j) { return difference(corners, i, j); });
  const auto normal = geometry::normal(frame);
  BaseRoot root;
  const bool at_end = answer.toi == answer.toi_upper && (answer.toi == 0 || answer.toi == 1);
  if (at_end) {
    root.n = answer.toi == 0 ? 0 : 1 << kTimeBits;
  } else {
    const double scaled = std::nearbyint(std::ldexp(answer.toi, kTimeBits));
    root.n = static_cast<std::int64_t>(scaled);
    const double t0 = std::ldexp(scaled, -kTimeBits);
    if (root.n == 0 || std::fabs(answer.toi - t0) > 0x1p-13 || std::fabs(answer.toi_upper - t0) > 0x1p-13) return false;
    // 2^(3 f) V_0(t0 + x) = g[0] + g[1] x + ...
    const auto cubic = geometry::dot(normal, frame.r);
    const std::int64_t n = root.n, c0 = cubic[0].value(), c1 = cubic[1].value(), c2 = cubic[2].value(),
                       c3 = cubic[3].value();
    constexpr int f = kTimeBits;
    const std::int64_t g[4] = {(((c0 << f) + c1 * n) * (1 << f) + c2 * n * n) * (1 << f) + c3 * n * n * n,
                               ((((c1 << f) + 2 * c2 * n) * (1 << f)) + 3 * c3 * n * n) * (1 << f),
                               ((c2 << f) + 3 * c3 * n) * (1 << (2 * f)), c3 * (std::int64_t{1} << (3 * f))};
    int m = 0;
    while (m < 4 && g[m] == 0) ++m;
    if (m == 0 || m == 4) return false;
    double later = 0;
    for (int i = m + 1; i < 4; ++i) later += std::fabs(static_cast<double>(g[i]));
    if (!(std::fabs(static_cast<double>(g[m])) > 2 * later * std::ldexp(1.0, -kNearbyBits))) return false;
    const int v = bits_of(kVolumeNorm * size_[0] * size_[1] * size_[2]);
    const int way_bits = (spread_ - (3 * f + 1 + v + 1)) / m;
    const bool is_exact = answer.toi == t0 && answer.toi_upper == t0;
    root.way = is_exact ? 0 : std::ldexp(1.0, -std::min(way_bits, 900));
    if (!is_exact) {
      if (!(root.way < t0 - std::nextafter(t0, 0.0))) return false;
      const bool before = answer.toi < t0;
      answer.toi = before ? std::nextafter(t0, 0.0) : t0;
      answer.toi_upper = before ? t0 : std::nextafter(t0, 2.0);
    }
  }
  if (wanted == Wanted::time) return true;
  const double d = std::ldexp(1.0, -std::min(spread_, 900));
  return weigh(base_.kind, frame, normal, size_, root, d, answer);
}

}  // namespace touchstone::exact
