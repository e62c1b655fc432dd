// Signs, quotients and comparisons at a near root. near_root_isolation.cpp finds the roots.
// SPDX-License-Identifier: MIT
#include "numbers/roots/near_root.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

#include "numbers/doubles/neighbours.hpp"
#include "numbers/integers/bounded_integers.hpp"

namespace touchstone::numbers {
namespace {

/// value * numerator^i * denominator^(size - 1 - i) summed over the coefficients: the sign of the polynomial at the
/// quotient, whose denominator is positive.
template <int C, int N>
int sign_at_quotient(const Polynomial<FixedInt<C>, 2>& q, const FixedInt<N>& numerator,
                     const FixedInt<N>& denominator) noexcept {
  return sign_of((q[0] * denominator + q[1] * numerator) * denominator + q[2] * numerator * numerator);
}

template <int Q, int C>
bool equal(const Polynomial<FixedInt<Q>, 2>& q, const Polynomial<FixedInt<C>, 3>& p) noexcept {
  for (int i = 0; i <= 2; ++i) {
    for (int limb = 0; limb < Q; ++limb) {
      if (q[i].limb(limb) != p[i].limb(limb)) return false;
    }
    for (int limb = Q; limb < C; ++limb) {
      if (p[i].limb(limb) != q[i].sign_mask()) return false;
    }
  }
  return true;
}

/// A quadratic and the cubic at whose root its sign is asked for. If the one is small, the other is.
template <int Q, int C>
std::pair<const Polynomial<FixedInt<Q>, 2>&, const Polynomial<FixedInt<C>, 3>&> in_fewest_limbs(
    const Polynomial<FixedInt<Q>, 2>& q, const Polynomial<FixedInt<C>, 3>& p) noexcept {
  return {q, p};
}
template <int C>
std::pair<Polynomial<FixedInt<1>, 2>, Polynomial<FixedInt<1>, 3>> in_fewest_limbs(
    const Polynomial<SmallInt, 2>& q, const Polynomial<FixedInt<C>, 3>& p) noexcept {
  std::pair<Polynomial<FixedInt<1>, 2>, Polynomial<FixedInt<1>, 3>> result;
  for (int i = 0; i <= 2; ++i) result.first[i] = q[i].widened<1>();
  for (int i = 0; i <= 3; ++i) result.second[i].set_limb(0, p[i].limb(0));
  return result;
}

/// Whether q is a multiple of p, of degree 2: where q is not zero, p's roots are q's.
template <int Q, int C>
bool proportional(const Polynomial<FixedInt<Q>, 2>& q, const Polynomial<FixedInt<C>, 3>& p) noexcept {
  return (q[2] * p[1] - p[2] * q[1]).is_zero() && (q[2] * p[0] - p[2] * q[0]).is_zero();
}

/// A double in [0, 1] as numerator / 2^k with k <= 60; the numerator is at most 2^60.
struct Dyadic {
  std::int64_t numerator, denominator;
};
std::optional<Dyadic> dyadic(double x) noexcept {
  constexpr int kGreatestShift = 60;
  if (x == 0) return Dyadic{0, 1};
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t significand = (bits & 0x000FFFFFFFFFFFFF) | 0x0010000000000000;
  const int zeros = std::countr_zero(significand);
  const int shift = 1075 - static_cast<int>(bits >> 52) - zeros;
  if (shift > kGreatestShift) return std::nullopt;
  return Dyadic{static_cast<std::int64_t>(significand >> zeros), std::int64_t{1} << shift};
}

/// The same for lesser doubles, such as times just after 0.
struct SmallDyadic {
  FixedInt<4> numerator, denominator;
};

std::optional<SmallDyadic> small_dyadic(double x) noexcept {
  constexpr double kLeast = 0x1p-190;  // its last bit is at least 2^-242
  if (!(x >= kLeast && x <= 1)) return std::nullopt;
  const int shift = 52 - std::ilogb(x);
  return SmallDyadic{FixedInt<4>::scaled(x, -shift), FixedInt<4>::scaled(1, -shift)};
}

}  // namespace

template <int Limbs>
NearRoot<Limbs> NearRoot<Limbs>::at_double(double time, int multiplicity, Doubt& doubt) {
  NearRoot root;
  root.doubt_ = &doubt;
  root.multiplicity_ = multiplicity;
  root.near_ = exact_pair(time);
  root.lower_ = root.upper_ = time;
  if (const auto exact = dyadic(time)) {
    root.exact_ = Fraction{exact->numerator, exact->denominator};
  } else if (const auto small = small_dyadic(time)) {
    root.exact_ =
        Quotient{small->numerator.template widened<6 * Limbs>(), small->denominator.template widened<6 * Limbs>()};
  } else {
    doubt.raise();
    root.exact_ = Fraction{0, 1};
  }
  return root;
}

template <int Limbs>
auto NearRoot<Limbs>::rational() const -> std::optional<Quotient> {
  if (const Quotient* quotient = std::get_if<Quotient>(&exact_)) return *quotient;
  const Fraction* fraction = std::get_if<Fraction>(&exact_);
  if (fraction == nullptr) return std::nullopt;
  const auto wide = [](std::int64_t x) { return FixedInt<1>::integer(x).template widened<6 * Limbs>(); };
  return Quotient{wide(fraction->numerator), wide(fraction->denominator)};
}

/// The sign of (root - time) for a double close by; 0 in doubt, too.
template <int Limbs>
int NearRoot<Limbs>::sign_of_rest(double time) const {
  if (const auto exact = dyadic(time)) {
    return sign_of_rest(FixedInt<1>::integer(exact->numerator), FixedInt<1>::integer(exact->denominator));
  }
  const auto small = small_dyadic(time);
  return small ? sign_of_rest(small->numerator, small->denominator) : raise_doubt();
}
template <int Limbs>
template <class N>
int NearRoot<Limbs>::sign_of_rest(const N& n, const N& d) const {
  if (const auto quotient = rational()) return sign_of(quotient->numerator * d - quotient->denominator * n);
  const auto& [p, degree, sign_after, reach] = std::get<Isolated>(exact_);
  if (!(std::fabs(near_.value.low) + near_.error < reach)) return raise_doubt();
  // p has no other root between this one and the double.
  return -sign_after * sign_of(((p[0] * d + p[1] * n) * d + p[2] * n * n) * d + p[3] * n * n * n);
}

/// x 2^126: two limbs and back by two bits.
template <int C>
FixedInt<C + 2> over_fine(const FixedInt<C>& x) noexcept {
  FixedInt<C + 2> result;
  for (int i = 1; i < C + 2; ++i) {
    const std::uint64_t low = i >= 2 ? x.limb(i - 2) >> 2 : 0, high = i <= C ? x.limb(i - 1) : x.sign_mask();
    result.set_limb(i, low | high << 62);
  }
  return result;
}

/// p at n / 2^126, times 2^(126 degree).
template <int C>
FixedInt<C + 4> fine_value(const FixedInt<C>& p0, const FixedInt<C>& p1, const FixedInt<C>& p2,
                           const FixedInt<2>& n) noexcept {
  return (p2 * n + over_fine(p1)) * n + over_fine(over_fine(p0));
}
template <int C>
FixedInt<C + 4> fine_value(const Polynomial<FixedInt<C>, 2>& p, const FixedInt<2>& n) noexcept {
  return fine_value(p[0], p[1], p[2], n);
}
template <int C>
FixedInt<C + 6> fine_value(const Polynomial<FixedInt<C>, 3>& p, const FixedInt<2>& n) noexcept {
  if (p[3].is_zero()) return over_fine(fine_value(p[0], p[1], p[2], n));
  return fine_value(p[1], p[2], p[3], n) * n + over_fine(over_fine(over_fine(p[0])));
}

/// Where two roots are close to each other, or a polynomial is almost zero at a root, double-doubles lose too many
/// bits. This is Newton iteration with exact values of p. Only p's signs on both sides prove that the root is between
/// them: there is no other root within reach. Sizes in bits: 192 L - 3 of p's coefficients and little more than 126 of
/// n, so that the sum of four terms is below 192 L - 3 + 3 * 126 + 3 <= 192 L + 383. Of q there are 128 L - 2 + 2 * 126
/// + 2.
template <int Limbs>
auto NearRoot<Limbs>::fine(const Isolated& root) const -> std::optional<Fine> {
  constexpr double kPerUnit = 1 / kFineUnit, kLeast = 0x1p-60, kFarthest = 0x1p100, kSlack = 1 + 0x1p-20;
  if (!(near_.value.high >= kLeast && near_.value.high < 1)) return std::nullopt;
  static_assert(kFineBits == 126, "as fine_value has it");
  const auto integer = [](double x) { return FineTime::scaled(std::nearbyint(x), 0); };
  const auto& p = root.p;
  const BoundedPair slope[] = {bounded(p[1]), bounded(p[2]) * exact_pair(2), bounded(p[3]) * exact_pair(3)};
  FineTime n = integer(near_.value.high * kPerUnit) + integer(near_.value.low * kPerUnit);
  double units = 1;  // of the way from near_; two roundings
  constexpr int kSteps = 6;
  for (int i = 0; i < kSteps; ++i) {
    const double value = bounded(fine_value(p, n)).value.high * (kFineUnit * kFineUnit * kFineUnit);
    const double steepness = value_at(slope, 3, bounded(n) * exact_pair(kFineUnit)).value.high;
    const double step = std::nearbyint(-value / steepness * kPerUnit);
    if (!(std::fabs(step) < kFarthest)) return std::nullopt;
    n = n + integer(step);
    units += std::fabs(step);
    if (std::fabs(step) <= 2) break;
  }
  const double moved = kSlack * units * kFineUnit;
  if (!(moved + kSlack * kFineReach * kFineUnit < root.reach)) return std::nullopt;
  const FineTime reach = FineTime::integer(kFineReach);
  const bool inside = fine_value(p, n - reach).sign() * fine_value(p, n + reach).sign() < 0;
  return inside ? std::optional(Fine{n, moved}) : std::nullopt;
}

template <int Limbs>
BoundedPair NearRoot<Limbs>::as_pair(const Fine& fine) {
  constexpr double kSlack = 1 + 0x1p-20;
  BoundedPair time = bounded(fine.n) * exact_pair(kFineUnit);
  time.error = kSlack * (time.error + kFineReach * kFineUnit);
  return time;
}

/// Makes near_ as good as a double-double allows, if it can.
template <int Limbs>
void NearRoot<Limbs>::sharpen() {
  Isolated* const root = std::get_if<Isolated>(&exact_);
  const auto closer = root != nullptr ? fine(*root) : std::nullopt;
  if (!closer) return;
  near_ = as_pair(*closer);
  root->reach -= closer->moved;
}

/// q at the root differs from q at the fine time by at most the bound on its slope in [0, 1] times the way. What both
/// times are beyond 1 counts in the factor.
template <int Limbs>
int NearRoot<Limbs>::fine_sign_at(const Quadratic& q, const Isolated& root) const {
  constexpr double kSlack = 1 + 0x1p-20;
  const auto closer = fine(root);
  if (!closer) return raise_doubt();
  BoundedPair value = bounded(fine_value(q, closer->n)) * exact_pair(kFineUnit * kFineUnit);
  const double slope = std::fabs(to_double(q[1])) + 2 * std::fabs(to_double(q[2]));
  value.error += kSlack * slope * kFineReach * kFineUnit;
  const int sign = value.sign();
  return sign != 0 ? sign : raise_doubt();
}

template <int Limbs>
void NearRoot<Limbs>::settle() {
  constexpr double kLeast = 0x1p-800;
  const auto lies_between_neighbours = [&] {
    const double nearest = near_.value.high, rest = near_.value.low;
    if (!(nearest >= kLeast && nearest <= 1)) return false;
    const double gap = rest > near_.error ? after(nearest) - nearest : nearest - before(nearest);
    return std::fabs(rest) + near_.error < gap;
  };
  if (!lies_between_neighbours()) {
    sharpen();
    if (!lies_between_neighbours()) return doubt_->raise();
  }
  const double nearest = near_.value.high, rest = near_.value.low;
  lower_ = upper_ = nearest;
  int side = rest > near_.error ? 1 : rest < -near_.error ? -1 : 0;
  if (side == 0) side = sign_of_rest(nearest);
  if (side < 0) lower_ = before(nearest);
  if (side > 0) upper_ = after(nearest);
  if (side == 0) *this = at_double(nearest, multiplicity_, *doubt_);
}

template <int Limbs>
template <class P>
BoundedPair NearRoot<Limbs>::value_of(const P& q, const BoundedPair& time) const {
  // Resting contact is mostly asked about at the ends of the step.
  if (lower_ == upper_ && lower_ == 0) return bounded(q[0]);
  if (lower_ == upper_ && lower_ == 1) return bounded(q[0] + q[1] + q[2]);
  const BoundedPair c[] = {bounded(q[0]), bounded(q[1]), bounded(q[2])};
  return value_at(c, 3, time);
}

template <int Limbs>
template <class P>
int NearRoot<Limbs>::sign_of_close(const P& q) const {
  if (is_zero(q)) return 0;
  if constexpr (std::is_same_v<P, SmallQuadratic>) {
    // Corners in one plane: what vanishes at the root is mostly a multiple of the root's own quadratic.
    const Isolated* const own = std::get_if<Isolated>(&exact_);
    if (own != nullptr && own->degree == 2) {
      const auto& [small, p] = in_fewest_limbs(q, own->p);
      if (proportional(small, p)) return 0;
    }
  }
  const BoundedPair value = value_of(q, near_);
  const int sign = value.sign();
  if (sign != 0) return sign;
  const Quadratic wide = widened(q);
  if (const Quotient* quotient = std::get_if<Quotient>(&exact_)) {
    return sign_at_quotient(wide, quotient->numerator, quotient->denominator);
  }
  const Isolated& root = std::get<Isolated>(exact_);
  if (const auto exact = sign_by_remainder(q, value, root)) return *exact;
  return certainly_vanishes(wide, root) ? 0 : fine_sign_at(wide, root);
}
template <int Limbs>
int NearRoot<Limbs>::close_sign_at(const Quadratic& q) const {
  return sign_of_close(q);
}
template <int Limbs>
int NearRoot<Limbs>::close_sign_at(const SmallQuadratic& q) const {
  return sign_of_close(q);
}

// Sizes in bits for L limbs, with C = 192 L - 3 of p and Q = 128 L - 3 of q, or Q + 1 of q's derivative. A linear q:
// C + 3 (Q + 1) + 2 <= 576 L - 4. Otherwise s is below Q + C + 1 <= 320 L - 5; l below Q + 320 L - 5 + 1 <= 448 L - 7;
// the last sum below 2 (448 L - 7) + Q + 2 <= 1024 L - 15. Each has its limbs. For two quadratics s has the role of l.
template <int Limbs>
bool NearRoot<Limbs>::certainly_vanishes(const Quadratic& q, const Isolated& root) const {
  const auto& p = root.p;
  if (q[2].is_zero() && q[1].is_zero()) return false;
  const auto here = [&](double numerator, double denominator) {
    // Of a root of p: is it this one? The quotient of two doubles within 2^-51 is off by less than 2^-49 of itself, and
    // the root by 2^-53 from the first of its two doubles. What 2^-20 took off the reach covers the rounding here.
    const double time = numerator / denominator;
    return std::fabs(time - near_.value.high) + 0x1p-49 * std::fabs(time) + 0x1p-52 < root.reach - near_.error;
  };
  if (q[2].is_zero()) {
    const auto n = -q[0], d = q[1];
    const bool common = (((p[0] * d + p[1] * n) * d + p[2] * n * n) * d + p[3] * n * n * n).is_zero();
    return common && here(to_double(n), to_double(d));
  }
  // Remainders of p by q, times powers of q's leading coefficient: s = q2 p - p3 t q, then l = q2 s - s2 q.
  // A quadratic p leaves s = q2 p - p2 q at once, which is zero where p and q are proportional.
  const auto common = [&](const auto& l0, const auto& l1) {
    const auto n = -l0;
    return ((q[0] * l1 + q[1] * n) * l1 + q[2] * n * n).is_zero() && here(to_double(n), to_double(l1));
  };
  if (p[3].is_zero()) {
    const auto s0 = q[2] * p[0] - p[2] * q[0];
    const auto s1 = q[2] * p[1] - p[2] * q[1];
    return s1.is_zero() ? s0.is_zero() : common(s0, s1);
  }
  const auto s0 = q[2] * p[0];
  const auto s1 = q[2] * p[1] - p[3] * q[0];
  const auto s2 = q[2] * p[2] - p[3] * q[1];
  const auto l0 = q[2] * s0 - s2 * q[0];
  const auto l1 = q[2] * s1 - s2 * q[1];
  if (l1.is_zero()) {
    if (!l0.is_zero()) return false;  // no common root
    // q divides p. The root that p has besides is p3's t = q1 / q2 - p2 / p3 = (q1 p3 - q2 p2) / (q2 p3).
    const BoundedPair q2 = bounded(q[2]), p3 = bounded(p[3]);
    const BoundedPair besides = bounded(q[1]) * p3 - q2 * bounded(p[2]) - near_ * (q2 * p3);
    return besides.sign() != 0;
  }
  return common(l0, l1);
}

// Let x be this root of p, and y the only root of q near it, a simple one. The sign of q(x) tells on which side of y x
// is, and so does the sign of p(y), as x is p's only root near y. With s the sign of p' at x and r that of q' near y:
//   p(y) has the sign s of (y - x), and q(x) the sign r of (x - y): q(x) has the sign -r s of p(y).
// A linear q has y = n / d, where p's sign is exact. Otherwise p(y) is, but for a positive factor, a linear remainder
// l0 + l1 y as in certainly_vanishes, with the sign of l1 (y - z) for z = -l0 / l1; and q(z) has the sign r of (z - y)
// if z is near, too. No number of bits is too many for that, whatever the distance of x and y.
//
// "Near" is proved at c, the double-double of x: q has the value v there, off by at most e, and the slope h, off by at
// most f. In [c - w, c + w], with f + |q''| w <= |h| / 2, q' keeps its sign. In [c - d, c + d], with
// d = 2 (|v| + e) / |h| and f + |q''| d <= |h| / 4, q changes by more than |v| + e on either side: y is there.
//
// Small coefficients, of 60 bits of p and 44 of q, leave 105 in s, 150 in l and 346 in the last sum.
template <int Limbs>
template <class Q>
std::optional<int> NearRoot<Limbs>::sign_by_remainder(const Q& given, const BoundedPair& value,
                                                      const Isolated& root) const {
  constexpr double kSlack = 1 + 0x1p-20;
  const BoundedPair slope = bounded(given[1]) + bounded(given[2]) * exact_pair(2) * BoundedPair{near_.value, 0};
  const Bounded v = rounded(value), h = rounded(slope);
  const int q_sign = h.sign(), p_sign = root.sign_after;
  const double steep = std::fabs(h.value), bend = kSlack * 2 * std::fabs(to_double(given[2]));
  const double reach = bend > 0 ? (0.5 * steep - kSlack * h.error) / (kSlack * bend) : 1;
  const double distance = kSlack * 2 * (std::fabs(v.value) + v.error) / steep;
  if (q_sign == 0 || !(kSlack * (h.error + bend * distance) <= 0.25 * steep)) return std::nullopt;
  if (!(kSlack * near_.error <= reach && distance < root.reach)) return std::nullopt;

  const auto& [q, p] = in_fewest_limbs(given, root.p);
  if (q[2].is_zero()) {
    const auto n = -q[0], d = q[1];
    return -q_sign * p_sign * d.sign() * sign_of(((p[0] * d + p[1] * n) * d + p[2] * n * n) * d + p[3] * n * n * n);
  }
  const auto by_linear = [&, &q = q](const auto& l0, const auto& l1) -> std::optional<int> {
    if (l1.is_zero()) return -q_sign * p_sign * l0.sign();
    const auto n = -l0;
    const double z = to_double(n) / to_double(l1), near = near_.value.high, way = std::fabs(z - near);
    const double error = 0x1p-49 * std::fabs(z) + 0x1p-51 * near;
    if (way - error > distance) return -q_sign * p_sign * l1.sign() * (near > z ? 1 : -1);
    if (!(way + error <= reach)) return std::nullopt;
    return p_sign * l1.sign() * sign_of((q[0] * l1 + q[1] * n) * l1 + q[2] * n * n);
  };
  if (p[3].is_zero()) {
    const auto sign = by_linear(q[2] * p[0] - p[2] * q[0], q[2] * p[1] - p[2] * q[1]);
    return sign ? std::optional(q[2].sign() * *sign) : std::nullopt;
  }
  const auto s0 = q[2] * p[0];
  const auto s1 = q[2] * p[1] - p[3] * q[0];
  const auto s2 = q[2] * p[2] - p[3] * q[1];
  return by_linear(q[2] * s0 - s2 * q[0], q[2] * s1 - s2 * q[1]);
}

template <int Limbs>
template <class P>
std::optional<double> NearRoot<Limbs>::quotient_of(const P& numerator, const P& denominator) const {
  // For n and d off by a and b, n / d is off by at most (a + |n / d| b) / (|d| - b); |n / d| is at most about 1.
  constexpr double kGreatestError = 0x1p-52;
  constexpr double kSlack = 1 + 0x1p-20;
  double quotient = 0;
  const auto is_good = [&](const BoundedPair& time) {
    const BoundedPair n = value_of(numerator, time), d = value_of(denominator, time);
    const double size = std::fabs(d.value.high);
    quotient = n.value.high / d.value.high;
    const double error = kSlack * (n.error + std::fabs(quotient) * d.error);
    return error <= kGreatestError * (size - kSlack * d.error);
  };
  if (!is_good(near_)) {
    const Isolated* const root = std::get_if<Isolated>(&exact_);
    const auto closer = root != nullptr ? fine(*root) : std::nullopt;
    if (!closer || !is_good(as_pair(*closer))) return std::nullopt;
  }
  return quotient > 0 ? std::min(quotient, 1.0) : 0.0;  // never -0
}
template <int Limbs>
std::optional<double> NearRoot<Limbs>::close_quotient(const Quadratic& numerator, const Quadratic& denominator) const {
  return quotient_of(numerator, denominator);
}
template <int Limbs>
std::optional<double> NearRoot<Limbs>::close_quotient(const SmallQuadratic& numerator,
                                                      const SmallQuadratic& denominator) const {
  // At a fraction of few bits both values are small integers: each rounds to a double, and then the quotient does, in
  // all by less than 2^-51.
  if (const Fraction* fraction = std::get_if<Fraction>(&exact_); fraction && fraction->denominator <= kLittle) {
    const auto at = SmallInt::integer(fraction->numerator), one = SmallInt::integer(fraction->denominator);
    const double n = to_double(value_at_quotient(numerator, at, one)),
                 d = to_double(value_at_quotient(denominator, at, one));
    if (d == 0) return std::nullopt;
    const double quotient = n / d;
    return quotient > 0 ? std::min(quotient, 1.0) : 0.0;  // never -0
  }
  return quotient_of(numerator, denominator);
}

template <int Limbs>
int NearRoot<Limbs>::compare(const NearRoot& other) const {
  const bool is_double = lower_ == upper_, other_is_double = other.lower_ == other.upper_;
  if (other_is_double) return compare(other.lower_);
  if (is_double) return -other.compare(lower_);
  if (upper_ <= other.lower_) return -1;
  if (lower_ >= other.upper_) return 1;
  // Between the same two doubles.
  const int sign = (near_ - other.near_).sign();
  if (sign != 0) return sign;
  const auto mine = rational(), others = other.rational();
  if (mine && others) return sign_of(mine->numerator * others->denominator - others->numerator * mine->denominator);
  if (mine) return -other.compare(*this);
  const auto& [p, degree, sign_after, reach] = std::get<Isolated>(exact_);
  if (others) {
    // The two roots of a quadratic are further apart than two doubles that are neighbours.
    if (degree > 2) return raise_doubt();
    const auto &n = others->numerator, &d = others->denominator;
    return ((p[0] * d + p[1] * n) * d + p[2] * n * n).is_zero() ? 0 : raise_doubt();
  }
  // Quadratics without a common factor t or t - 1 are as they were given, and so have room in Quadratic.
  const auto& [q, other_degree, other_sign_after, other_reach] = std::get<Isolated>(other.exact_);
  if (other_degree > 2) return raise_doubt();
  Quadratic narrow;
  for (int i = 0; i <= 2; ++i) {
    for (int limb = 0; limb < 2 * Limbs; ++limb) narrow[i].set_limb(limb, q[i].limb(limb));
  }
  if (!equal(narrow, q)) return raise_doubt();
  // A root of q that lies where q has one root only is the other root.
  const double apart = std::fabs(near_.value.high - other.near_.value.high) + 0x1p-52;
  const bool same =
      apart + near_.error + other.near_.error < other_reach && certainly_vanishes(narrow, std::get<Isolated>(exact_));
  return same ? 0 : raise_doubt();
}

template class NearRoot<1>;
template class NearRoot<2>;

}  // namespace touchstone::numbers
