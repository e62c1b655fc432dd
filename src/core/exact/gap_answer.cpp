// The time and the weights of a query from the answer to the one with a narrower gap. gap.cpp has the terms: d, V and
// its norm v, and V_0 of the base.
//
// The time. At a time t in [0, 1], V differs from the base's V_0 by at most d v, and where |t| <= 1 + 2^-4 by at most
// 2 d v, for complex t, too. A first contact at exactly 0 or 1 stays there. Let V_0 have
// opposite signs at two times and differ from zero there by more than 2 d v, for the narrowed d. Then the root of the
// contact, which is continuous in d, stays between them. If V_0's slope is steeper than h between them, V_0 has one
// root there, and the root of the contact is at most 2 d v / h from it; as far from a time t as (|V_0(t)| + 2 d v) / h.
//
// Otherwise V_0 has a root t0 = n / 2^f of multiplicity m close to the time: V_0(t0 + x) = x^m (g_m + g_(m+1) x + ...),
// and the g_i are integers over 2^(3 f). For |x| <= R, with |g_m| >= 2 R times the sum of the later |g_i|, it is at
// least |g_m| |x|^m / 2. Let R be at most 2^-4, and this exceed 2 d v at |x| = R for the narrowed d. Then there for all
// lesser d, too, so that V has as many complex roots within R of t0 as V_0, m (Rouche's theorem), and the root of the
// contact stays among them. For the query's d, a root has |x|^m <= 4 d v / |g_m|. V at t0 is a polynomial in d with
// integer coefficients over 2^(3 f) and a norm of at most v; over 2^(2 f) and 3 v where it lacks a factor t - t0, and
// over 2^f and 9 v where it lacks two. d v <= 2^-(3 f + 3) makes its lowest term V_k(t0) d^k exceed the others: it
// has one sign, or is zero, for all d up to the narrowed one. So the root is before t0, at t0 or after it as in the
// narrowed query. If |x| is certainly less than to the next double, that is all. Otherwise the root is followed, for
// m <= 2. If V is zero at t0 for all d, it is a root of V / (t - t0), with m - 1 in place of m. For m = 1 it is the
// only root within R. For m = 2 it is the only one on its side of t0 if V has opposite signs at t0 and at the distance
// R, those of V_k(t0) and g_2. So two neighbouring doubles there at which V has opposite signs enclose it. Their first
// guess is |x|^m = |V_k(t0) d^k / g_m|.
//
// V at a double n / 2^e is a sum of 16 integers times powers of two, c_ij n^j 2^-(e j + s i), of |c_ij| <= 9 v <= 2^44
// and n < 2^53: each is below 2^203. Their sum, from the least power on, needs one bit to tell that what was shifted
// out is not zero.
//
// Where V is zero for all t and d, the root of the contact is followed as one of another of these polynomials: where a
// corner P touches an edge X Y, of a component of (P - X) x (Y - X), or of P - X for a corner X that P touches. Its
// norm, at most 2 L_i L_j or L_k, takes the place of v. Where V_0, or this one's, is zero for all t, the polynomial is
// divided by a power of d, which leaves its norm and, for d > 0, its roots.
//
// The weights are quotients of the base at t0 or, without t0, at a root of V_0 that is known as a double-double, unless
// the denominator is too small there. The root of the contact is near it, and d changes numerators and denominators by
// at most d times their norm.
// SPDX-License-Identifier: MIT
#include "exact/gap.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "exact/corners.hpp"
#include "exact/gap_bounds.hpp"
#include "numbers/bounded.hpp"
#include "numbers/bounded_integers.hpp"
#include "numbers/rational_roots.hpp"

namespace touchstone::exact {
namespace {

using numbers::Bounded;
using numbers::bounded;
using numbers::BoundedPair;
using Corners = Forms<Near<0>>::Corners;
using Point = Forms<Near<0>>::Point;
using SmallQuadratic = Forms<Near<0>>::Quadratic;

using Sum = numbers::FixedInt<4>;

/// The greatest integer <= x / 2^bits. Sets `lost` where that is not exact.
Sum shifted_down(const Sum& x, int bits, bool& lost) noexcept {
  const int limbs = bits / 64, offset = bits % 64;
  Sum result;
  for (int i = 0; i < 4; ++i) {
    const auto limb = [&](int at) { return at < 4 ? x.limb(at) : x.sign_mask(); };
    const int from = std::min(i + limbs, 4);
    result.set_limb(i, offset == 0 ? limb(from) : limb(from) >> offset | limb(from + 1) << (64 - offset));
    if (i < limbs) lost = lost || x.limb(i) != 0;
    if (i == limbs && offset != 0) lost = lost || x.limb(i) << (64 - offset) != 0;
  }
  return result;
}

using SmallCubic = Forms<Near<0>>::Cubic;

/// 2^(3 f) p(n / 2^f), for n / 2^f <= 1.
std::int64_t value_at(const SmallCubic& p, std::int64_t n) noexcept {
  constexpr int kOne = 1 << kTimeBits;
  return ((p[0].value() * kOne + p[1].value() * n) * kOne + p[2].value() * n * n) * kOne + p[3].value() * n * n * n;
}

/// g[0], g[1], g[2], g[3]: 2^(3 f) p(n / 2^f + x) = g[0] + g[1] x + ...
std::array<std::int64_t, 4> around(const SmallCubic& p, std::int64_t n) noexcept {
  constexpr int kOne = 1 << kTimeBits;
  const std::int64_t c1 = p[1].value(), c2 = p[2].value(), c3 = p[3].value();
  return {value_at(p, n), ((c1 * kOne + 2 * c2 * n) * kOne + 3 * c3 * n * n) * kOne,
          (c2 * kOne + 3 * c3 * n) * kOne * kOne, c3 * kOne * kOne * kOne};
}

/// V, or what is followed in its place, as a polynomial in t and d, or that divided by times t - t0: [i] holds the
/// coefficient of d^i.
class Followed {
 public:
  explicit Followed(const std::array<SmallCubic, 4>& by_power) : by_power_(by_power) {}

  const SmallCubic& base() const noexcept { return by_power_[0]; }
  bool is_zero() const {
    return std::all_of(by_power_.begin(), by_power_.end(), [](const SmallCubic& p) { return numbers::is_zero(p); });
  }

  /// Divided by the greatest power of d; not of zero.
  Followed without_power() const {
    std::size_t power = 0;
    while (numbers::is_zero(by_power_[power])) ++power;
    std::array<SmallCubic, 4> rest = {};
    for (std::size_t i = power; i < 4; ++i) rest[i - power] = by_power_[i];
    return Followed(rest);
  }

  /// 2^(3 f) V_i(n / 2^f), for n / 2^f <= 1.
  std::int64_t term_at(int i, std::int64_t n) const noexcept {
    return value_at(by_power_[static_cast<std::size_t>(i)], n);
  }

  /// The least k > 0 with V_k(n / 2^f) != 0; 4 if there is none.
  int lowest_term_at(std::int64_t n) const noexcept {
    int k = 1;
    while (k < 4 && term_at(k, n) == 0) ++k;
    return k;
  }

  /// V / (2^z t - o) for n / 2^f = o / 2^z in lowest terms, where V is zero for all d: the quotients are integers
  /// (Gauss's lemma), of at most three times V's norm.
  Followed without(std::int64_t n) const noexcept {
    const int zeros = n == 0 ? kTimeBits : std::min(kTimeBits, std::countr_zero(static_cast<std::uint64_t>(n)));
    const std::int64_t o = n >> zeros, power = std::int64_t{1} << (kTimeBits - zeros);
    std::array<SmallCubic, 4> quotients = {};
    for (std::size_t i = 0; i < 4; ++i) quotients[i] = *numbers::divided(by_power_[i], {o, power});
    return Followed(quotients);
  }

  /// The sign of V at a time in [0, 2) for d = 2^-spread.
  int sign_at(double time, int spread) const noexcept {
    struct Term {
      int exponent = 0;
      Sum value;
    };
    int log = 0;
    const double significand = std::ldexp(std::frexp(time, &log), 53);
    const int e = 53 - log;
    const numbers::FixedInt<1> n = numbers::FixedInt<1>::scaled(significand, 0);
    const auto square = n * n;
    const auto cube = square * n;
    std::array<Term, 16> terms;
    std::size_t count = 0;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const auto c = by_power_[static_cast<std::size_t>(i)][j].widened<1>();
        if (c.is_zero()) continue;
        const Term term = {-(e * j + spread * i), j == 0   ? c.widened<4>()
                                                  : j == 1 ? (c * n).widened<4>()
                                                  : j == 2 ? (c * square).widened<4>()
                                                           : c * cube};
        std::size_t at = count++;  // the least exponent first
        for (; at > 0 && terms[at - 1].exponent > term.exponent; --at) terms[at] = terms[at - 1];
        terms[at] = term;
      }
    }
    Sum sum;
    bool rest = false;  // sum is followed by a fraction in (0, 1)
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) sum = shifted_down(sum, terms[i].exponent - terms[i - 1].exponent, rest);
      sum = sum + terms[i].value;
    }
    return sum.sign() != 0 ? sum.sign() : rest ? 1 : 0;
  }

 private:
  std::array<SmallCubic, 4> by_power_;
};

/// How V changes with d: V's norm, and d = 2^-narrow of the narrowed query and 2^-spread of the query.
struct Change {
  double norm;
  int narrow, spread;
};

/// The root of the contact where V_0 has one simple root close to it, known as a double-double. Makes the answer's time
/// the query's.
std::optional<BoundedPair> root_near(const SmallCubic& base, const Change& change, Answer& answer) {
  const BoundedPair c[] = {bounded(base[0]), bounded(base[1]), bounded(base[2]), bounded(base[3])};
  const double c1 = c[1].value.high, c2 = c[2].value.high, c3 = c[3].value.high, start = answer.toi;
  const double slope = c1 + start * (2 * c2 + start * 3 * c3);
  const double narrow_change = 2 * std::ldexp(change.norm, -change.narrow);
  const double away = 2 * narrow_change / std::fabs(slope) + 0x1p-52;
  const double bend = 2 * std::fabs(c2) + 7 * std::fabs(c3);  // at least |V_0''| as far as 1 + 2^-4
  const double steep = std::fabs(slope) - kSlack * (2 * away * bend + 0x1p-48 * (std::fabs(c1) + bend));
  if (!(away < 0x1p-6 && steep >= 0.5 * std::fabs(slope))) return std::nullopt;
  const auto sign_at = [&](double time) {
    Bounded value = numbers::rounded(numbers::value_at(c, 4, numbers::exact_pair(time)));
    value.error += narrow_change;
    return value.sign();
  };
  if (sign_at(start - away) * sign_at(answer.toi_upper + away) >= 0) return std::nullopt;

  BoundedPair time = numbers::exact_pair(start);
  for (int step = 0; step < 2; ++step) {
    time = time - numbers::exact_pair(numbers::value_at(c, 4, time).value.high / slope);
    time.error = 0;
  }
  const BoundedPair value = numbers::value_at(c, 4, time);
  const double greatest = std::fabs(value.value.high) + value.error + 2 * std::ldexp(change.norm, -change.spread);
  time.error = kSlack * greatest / steep;
  const auto [nearest, rest] = time.value;
  const double before = std::nextafter(nearest, 0.0);
  const bool known = std::fabs(nearest - start) < 0.5 * away && std::fabs(rest) > time.error &&
                     std::fabs(rest) + time.error < nearest - before;
  if (!known) return std::nullopt;
  answer.toi = rest > 0 ? nearest : before;
  answer.toi_upper = rest > 0 ? std::nextafter(nearest, 2.0) : nearest;
  return time;
}

/// The neighbouring doubles around V's only root on one side (-1, 1) of t0 and less than `reach` from it, or the double
/// that it is; `way` is a guess of its distance.
std::optional<std::array<double, 2>> neighbours_of_root(const Followed& volume, int spread, double t0, int side,
                                                        int sign_at_t0, double way, double reach) {
  if (!(way < 0.5 * reach)) return std::nullopt;
  const double away = side > 0 ? 2 : -1;
  double time = t0 + side * way;
  const int before = volume.sign_at(time, spread) * sign_at_t0;
  if (before == 0) return std::array<double, 2>{time, time};
  constexpr int kSteps = 4;
  for (int i = 0; i < kSteps; ++i) {
    const double next = std::nextafter(time, before > 0 ? away : t0);
    const int there = volume.sign_at(next, spread) * sign_at_t0;
    if (there == 0) return std::array<double, 2>{next, next};
    if (there != before) return std::array<double, 2>{std::min(time, next), std::max(time, next)};
    time = next;
  }
  return std::nullopt;
}

/// The root of the contact where V_0 has a root t0 = n / 2^f beside it. Makes the answer's time the query's. V is made
/// where it is needed.
template <class MakeVolume>
std::optional<BoundedPair> root_beside(const SmallCubic& base, std::int64_t n, const Change& change,
                                       const MakeVolume& make_volume, Answer& answer) {
  const double t0 = std::ldexp(static_cast<double>(n), -kTimeBits);
  const std::array<std::int64_t, 4> g = around(base, n);
  std::size_t m = 0;
  while (m < 4 && g[m] == 0) ++m;
  if (m == 0 || m == 4) return std::nullopt;
  const double leading = std::fabs(static_cast<double>(g[m]));
  double later = 0;
  for (std::size_t i = m + 1; i < 4; ++i) later += std::fabs(static_cast<double>(g[i]));
  constexpr double kGreatestReach = 0x1p-4;
  const double reach = later > 0 ? std::min(kGreatestReach, leading / (2 * kSlack * later)) : kGreatestReach;
  const double power = m == 1 ? reach : m == 2 ? reach * reach : reach * reach * reach;
  if (!(leading * power > 4 * kSlack * std::ldexp(change.norm, 3 * kTimeBits - change.narrow))) return std::nullopt;
  if (!(std::fabs(answer.toi - t0) < 0.5 * reach && std::fabs(answer.toi_upper - t0) < 0.5 * reach)) {
    return std::nullopt;
  }
  if (answer.toi == t0 && answer.toi_upper == t0) return numbers::exact_pair(t0);

  // |x|^m <= 4 d v / |g_m|
  const int way_bits =
      (change.spread - 2 - 3 * kTimeBits - bits_of(change.norm) + std::ilogb(leading)) / static_cast<int>(m);
  const BoundedPair time = {{t0, 0}, std::ldexp(1.0, -std::min(way_bits, 900))};
  const bool before = answer.toi < t0;
  if (time.error < t0 - std::nextafter(t0, 0.0)) {
    answer.toi = before ? std::nextafter(t0, 0.0) : t0;
    answer.toi_upper = before ? t0 : std::nextafter(t0, 2.0);
    return time;
  }
  Followed volume = make_volume();
  int k = volume.lowest_term_at(n);
  for (; k == 4 && m > 1; k = volume.lowest_term_at(n)) {
    volume = volume.without(n);
    --m;
  }
  if (k == 4 || m > 2) return std::nullopt;
  const std::int64_t at_t0 = volume.term_at(k, n), beyond = around(volume.base(), n)[m];
  const bool opposite = (at_t0 > 0) != (beyond > 0);
  if (m == 1 ? opposite == before : !opposite) return std::nullopt;
  const double size = std::fabs(static_cast<double>(at_t0) / static_cast<double>(beyond));
  const int shift = k * change.spread;
  const double way = m == 1 ? std::ldexp(size, -shift)
                            : std::ldexp(std::sqrt(shift % 2 == 0 ? size : 2 * size), -(shift + shift % 2) / 2);
  const auto found = neighbours_of_root(volume, change.spread, t0, before ? -1 : 1, at_t0 > 0 ? 1 : -1, way, reach);
  if (!found) return std::nullopt;
  answer.toi = (*found)[0];
  answer.toi_upper = (*found)[1];
  return time;
}

constexpr std::array<BitSpan, 3> kSmallSpans = [] {
  BitSpan span;
  span.low = 0;
  span.high = kMostBits<0>;
  return std::array<BitSpan, 3>{span, span, span};
}();

Vec3 sum(const Vec3& h, const Vec3& l, int factor) noexcept {
  return {h.x + factor * l.x, h.y + factor * l.y, h.z + factor * l.z};
}

Corners corners_of(const Query& query) { return moving_corners<Near<0>>(query, kSmallSpans); }
geometry::Frame<Point> frame_of(Kind kind, const Corners& corners) {
  return geometry::frame_of(kind == Kind::edge_edge,
                            [&](std::size_t i, std::size_t j) { return difference(corners, i, j); });
}

/// A contact at the border of an element: of corner p and the edge x y, or of p and the corner x. Two points touch
/// without an edge: then y is x.
struct Touching {
  std::size_t p, x, y;
  bool at_x;
};
std::optional<Touching> touching(Kind kind, Feature a, Feature b) {
  if (kind == Kind::edge_edge) {
    const bool corner_a = a == Feature::a0 || a == Feature::a1, corner_b = b == Feature::b0 || b == Feature::b1;
    const std::size_t on_a = a == Feature::a1 ? 1 : 0, on_b = b == Feature::b1 ? 3 : 2;
    if (corner_a) return Touching{on_a, on_b, 5 - on_b, corner_b};
    if (corner_b) return Touching{on_b, 0, 1, false};
    return std::nullopt;
  }
  switch (b) {
    case Feature::q: return Touching{0, 1, 1, true};
    case Feature::e0: return Touching{0, 1, 2, true};
    case Feature::e1: return Touching{0, 2, 1, true};
    case Feature::e: return Touching{0, 1, 2, false};
    case Feature::f0: return Touching{0, 1, 2, true};
    case Feature::f1: return Touching{0, 2, 3, true};
    case Feature::f2: return Touching{0, 3, 1, true};
    case Feature::f01: return Touching{0, 1, 2, false};
    case Feature::f12: return Touching{0, 2, 3, false};
    case Feature::f20: return Touching{0, 3, 1, false};
    default: return std::nullopt;
  }
}

// Of weights: |n / d - N / D| <= (|n - N| + |d - D|) / (|D| - |d - D|) for 0 <= n / d <= 1, and so below 2^-52.
constexpr double kGreatestError = 0x1p-55;

double weight_of(const BoundedPair& numerator, const BoundedPair& denominator) noexcept {
  const double quotient = numerator.value.high / denominator.value.high;
  return quotient > 0 ? std::min(quotient, 1.0) : 0.0;  // never -0
}

/// The weight of corner y, within 2^-51, where corner p touches the edge x y at a time of the base.
std::optional<double> weight_on_edge(const Corners& corners, std::size_t p, std::size_t x, std::size_t y,
                                     const std::array<double, 3>& norm, const BoundedPair& time, double d) {
  const Point way = difference(corners, p, x), edge = difference(corners, y, x);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = [&](const Forms<Near<0>>::Linear& q) {
      BoundedPair result = bounded(q[1]) * time + bounded(q[0]);
      result.error += 2 * d * norm[k];
      return result;
    };
    const BoundedPair numerator = value(way[k]), denominator = value(edge[k]);
    const double error = 2 * std::max(numerator.error, denominator.error);
    if (error <= kGreatestError * std::fabs(denominator.value.high)) return weight_of(numerator, denominator);
  }
  return std::nullopt;
}

/// The weights of a point inside both edges or inside the face, within 2^-51, at a time of the base. False where they
/// stay open.
bool weigh_inside(Kind kind, const Corners& corners, const std::array<double, 3>& norm, const BoundedPair& time,
                  double d, Answer& answer) {
  const bool edges = kind == Kind::edge_edge;
  const geometry::Frame<Point> frame = frame_of(kind, corners);
  const auto normal = geometry::normal(frame);
  for (std::size_t k = 0; k < 3; ++k) {
    const double change = 2 * d * kQuadraticNorm * norm[(k + 1) % 3] * norm[(k + 2) % 3];
    const auto value = [&](const SmallQuadratic& q) {
      const BoundedPair c[] = {bounded(q[0]), bounded(q[1]), bounded(q[2])};
      BoundedPair result = numbers::value_at(c, 3, time);
      result.error += change;
      return result;
    };
    const SmallQuadratic f1 = geometry::first_numerator(frame, k), f2 = geometry::second_numerator(edges, frame, k);
    const BoundedPair denominator = value(normal[k]), first = value(f1), second = value(f2);
    const BoundedPair third = edges ? BoundedPair() : value(normal[k] - f1 - f2);
    const double error = 2 * std::max({denominator.error, first.error, second.error, third.error});
    if (!(error <= kGreatestError * std::fabs(denominator.value.high))) continue;
    const auto weight = [&](const BoundedPair& numerator) { return weight_of(numerator, denominator); };
    if (edges) {
      const double a = weight(first), b = weight(second);
      answer.weights_a = {1 - a, a, 0};
      answer.weights_b = {1 - b, b, 0};
    } else {
      answer.weights_b = {weight(third), weight(first), weight(second)};
    }
    return true;
  }
  return false;
}

/// The weights within 2^-51, at a time of the base. Those of corners are known. False where others stay open.
bool weigh(Kind kind, const Corners& corners, const std::array<double, 3>& norm, const BoundedPair& time, double d,
           Answer& answer) {
  if (kind == Kind::edge_edge && answer.feature_a == Feature::overlap) {
    // The answer has the weights of the corner that ends the overlap; its place on the other edge gives the others.
    const bool of_a = answer.weights_a[1] == 1;
    const std::size_t p = of_a ? 1 : answer.weights_b[1] == 1 ? 3 : 2, x = of_a ? 2 : 0;
    const auto weight = weight_on_edge(corners, p, x, x + 1, norm, time, d);
    if (weight) (of_a ? answer.weights_b : answer.weights_a) = {1 - *weight, *weight, 0};
    return weight.has_value();
  }
  const auto on_border = touching(kind, answer.feature_a, answer.feature_b);
  if (!on_border) return weigh_inside(kind, corners, norm, time, d, answer);
  const auto [p, x, y, at_x] = *on_border;
  if (at_x) return true;
  const auto weight = weight_on_edge(corners, p, x, y, norm, time, d);
  if (!weight) return false;
  if (kind != Kind::vertex_face) {
    (kind == Kind::edge_edge && x == 0 ? answer.weights_a : answer.weights_b) = {1 - *weight, *weight, 0};
  } else {
    answer.weights_b = {0, 0, 0};
    answer.weights_b[x - 1] = 1 - *weight;
    answer.weights_b[y - 1] = *weight;
  }
  return true;
}

/// Of a polynomial of corners that is of at most degree 3 in d, or 2. From its values at d = 0, 1, -1 and, for the
/// coefficient of d^3, those of the low parts alone. Each coordinate is h or l d, so that no sum is greater.
template <class Of>
Followed followed(const Of& polynomial, int degree, const SmallCubic& base, const Query& high, const Query& low) {
  std::array<SmallCubic, 2> at;  // 1, -1
  for (const int sign : {1, -1}) {
    Query query = high;
    for (std::size_t i = 0; i < 4; ++i) {
      query.start[i] = sum(high.start[i], low.start[i], sign);
      query.end[i] = sum(high.end[i], low.end[i], sign);
    }
    at[sign > 0 ? 0 : 1] = polynomial(corners_of(query));
  }
  std::array<SmallCubic, 4> by_power = {base, {}, {}, {}};
  if (degree == 3) by_power[3] = polynomial(corners_of(low));
  for (int j = 0; j < 4; ++j) {
    const std::int64_t odd = (at[0][j].value() - at[1][j].value()) / 2,
                       even = (at[0][j].value() + at[1][j].value()) / 2;
    by_power[1][j] = numbers::SmallInt::integer(odd - by_power[3][j].value());
    by_power[2][j] = numbers::SmallInt::integer(even - base[j].value());
  }
  return Followed(by_power);
}

/// The root of the contact, which is one of a polynomial's. Makes the answer's time the query's. Nothing where the root
/// stays open, or where the polynomial is zero for all t and d.
struct Root {
  std::optional<BoundedPair> time;
  bool is_zero = false;
};
template <class Of>
Root root_of(const Of& polynomial, int degree, const Query& high, const Query& low, const Change& change,
             Answer& answer) {
  const auto n = static_cast<std::int64_t>(std::nearbyint(std::ldexp(answer.toi, kTimeBits)));
  const auto find = [&](const SmallCubic& base, const auto& make) {
    return value_at(base, n) == 0 ? root_beside(base, n, change, make, answer) : root_near(base, change, answer);
  };
  const SmallCubic base = polynomial(corners_of(high));
  const auto make = [&] { return followed(polynomial, degree, base, high, low); };
  if (!numbers::is_zero(base)) return {find(base, make)};
  const Followed all = make();
  if (all.is_zero()) return {std::nullopt, true};
  const Followed rest = all.without_power();
  return {find(rest.base(), [&] { return rest; })};
}

/// A polynomial of degree 3 that is one of a lesser degree.
template <int D>
SmallCubic as_cubic(const numbers::Polynomial<numbers::SmallInt, D>& p) {
  SmallCubic result = {};
  for (int i = 0; i <= D; ++i) result[i] = p[i];
  return result;
}

/// root_of for V that is zero for all t and d, or for a kind without V.
std::optional<BoundedPair> root_of_border(const Query& high, const Query& low, const std::array<double, 3>& norm,
                                          Change change, Answer& answer) {
  const bool overlap = answer.feature_a == Feature::overlap;  // then all corners are on one line
  const auto found = overlap ? Touching{0, 2, 3, false} : touching(high.kind, answer.feature_a, answer.feature_b);
  if (!found) return std::nullopt;
  const auto [p, x, y, at_x] = *found;
  // The narrowed d was chosen for their norms, too.
  const auto is_small = [&change] { return bits_of(change.norm) <= kMostVolumeBits; };
  for (std::size_t k = 0; k < 3; ++k) {
    change.norm = std::max(kLeastVolume, kQuadraticNorm * norm[(k + 1) % 3] * norm[(k + 2) % 3]);
    if (!is_small()) return std::nullopt;
    const auto component = [&, p = p, x = x, y = y](const Corners& c) {
      return as_cubic(geometry::cross_component(difference(c, p, x), difference(c, y, x), k));
    };
    if (const Root root = root_of(component, 2, high, low, change, answer); root.time) return root.time;
  }
  for (std::size_t k = 0; k < 3 && at_x; ++k) {
    change.norm = std::max(kLeastVolume, norm[k]);
    const auto component = [&, p = p, x = x](const Corners& c) { return as_cubic(difference(c, p, x)[k]); };
    if (!is_small()) return std::nullopt;
    if (const Root root = root_of(component, 2, high, low, change, answer); root.time) return root.time;
  }
  return std::nullopt;
}

}  // namespace

bool Gap::restore(Answer& answer, Wanted wanted) const {
  if (!answer.contact || wanted == Wanted::contact) return true;
  std::optional<BoundedPair> time;
  if (answer.toi == answer.toi_upper && (answer.toi == 0 || answer.toi == 1)) {
    time = numbers::exact_pair(answer.toi);
  } else {
    const Change change = {volume_norm_, narrow_, spread_};
    const auto volume = [kind = base_.kind](const Corners& c) { return geometry::coplanarity(frame_of(kind, c)); };
    const bool has_volume = base_.kind == Kind::edge_edge || base_.kind == Kind::vertex_face;
    const Root root = has_volume ? root_of(volume, 3, base_, low_, change, answer) : Root{std::nullopt, true};
    time = root.is_zero ? root_of_border(base_, low_, norm_, change, answer) : root.time;
  }
  if (!time || wanted != Wanted::all) return time.has_value();
  const double d = std::ldexp(1.0, -std::min(spread_, 900));
  return weigh(base_.kind, corners_of(base_), norm_, *time, d, answer);
}

}  // namespace touchstone::exact
