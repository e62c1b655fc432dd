// SPDX-License-Identifier: MIT
#include "numbers/near_root.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace touchstone::numbers {
namespace {

/// x as a double-double. Limbs from the third on count as long as they reach the 106 bits of one: with a top limb of
/// one bit, the next two have 128. What is left out is below 2^-127 |x|. Each of the four sums behind the second half
/// rounds low parts, which are below 5 * 2^-53 |x|, to at most 14 * 2^-106 |x| in all; the bound is below 2^-101 |x|.
/// One limb is exact.
template <int Limbs>
BoundedPair bounded(const FixedInt<Limbs>& x) noexcept {
  constexpr double kRelative = 0x1p-101;
  const bool negative = x.sign() < 0;
  const FixedInt<Limbs> magnitude = negative ? -x : x;
  int top = Limbs - 1;
  while (top > 0 && magnitude.limb(top) == 0) --top;
  const auto half = [](std::uint64_t limb, bool high) {
    return static_cast<double>(static_cast<std::uint32_t>(high ? limb >> 32 : limb));
  };
  double unit = 1;  // of the limb
  for (int i = 0; i < top; ++i) unit *= 0x1p64;
  DoubleDouble sum = two_sum(half(magnitude.limb(top), true) * 0x1p32 * unit, half(magnitude.limb(top), false) * unit);
  for (int i = top - 1; i >= 0 && i >= top - 2; --i) {
    unit *= 0x1p-64;
    for (const bool high : {true, false}) {
      const double part = half(magnitude.limb(i), high) * (high ? 0x1p32 * unit : unit);
      sum = sum + DoubleDouble{part, 0};
    }
  }
  sum = normalised(sum);
  if (negative) sum = {-sum.high, -sum.low};
  return {sum, top == 0 ? 0 : kRelative * std::fabs(sum.high)};
}

BoundedPair bounded(SmallInt x) noexcept {
  const std::int64_t low = x.value() & 0xFFFFFFFF;
  return {two_sum(static_cast<double>(x.value() - low), static_cast<double>(low)), 0};
}

Bounded rounded(const BoundedPair& x) noexcept { return {x.value.high, std::fabs(x.value.low) + x.error}; }

BoundedPair value_at(const BoundedPair* c, int size, const BoundedPair& t) noexcept {
  BoundedPair value = c[size - 1];
  for (int i = size - 2; i >= 0; --i) value = value * t + c[i];
  return value;
}

/// A double near the one root of a polynomial in (low, high), by safeguarded Newton iteration; only a hint. A flat
/// polynomial needs its value in double-doubles.
double hint(const BoundedPair* c, int size, double low, double high, int sign_low, bool closely) noexcept {
  if (size == 2) return -c[0].value.high / c[1].value.high;
  double t = 0.5 * (low + high);
  if (size == 3) {
    const double c0 = c[0].value.high, c1 = c[1].value.high, c2 = c[2].value.high;
    const double sum = -0.5 * (c1 + std::copysign(std::sqrt(std::max(0.0, c1 * c1 - 4 * c0 * c2)), c1));
    for (const double root : {sum / c2, c0 / sum}) {
      if (root > low && root < high) t = root;
    }
  }
  constexpr int kIterations = 60;
  for (int i = 0; i < kIterations; ++i) {
    double value = c[size - 1].value.high;
    double slope = (size - 1) * value;
    for (int k = size - 2; k >= 0; --k) {
      value = value * t + c[k].value.high;
      if (k > 0) slope = slope * t + k * c[k].value.high;
    }
    if (closely) value = value_at(c, size, exact_pair(t)).value.high;
    ((value < 0) == (sign_low < 0) ? low : high) = t;
    double next = t - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool converged = std::fabs(next - t) <= 0x1p-49 * t;
    t = next;
    if (converged) break;
  }
  return t;
}

struct Located {
  BoundedPair near;
  double reach;  ///< the polynomial has no other root so close to `near`
};

/// The one root of a polynomial in (low, high) inside [0, 1], a simple one; `sign_low` is the polynomial's sign at low,
/// and the other one is its sign at high. Nothing where the bounds are not good enough.
///
/// At t, a hint, p has the value v, off by at most e, and the slope s, off by at most f. In [-1, 2], p' changes by at
/// most `bend` times the way, bend = 2 |c2| + 12 |c3| >= |p''|. Let d = 2 (|v| + e) / |s|. If f + bend d <= |s| / 4,
/// then p' keeps its sign within d of t and is at least 3/4 |s|: on the way d, p changes by more than |v| + e, so that
/// exactly one root lies within d. It is the one in (low, high): t lies there; and where `high` is within d of t, p has
/// the sign at `high` that it takes after that root, when s has this sign. Likewise for `low`. The root is at
/// t - V / S, with V the true value and S a mean of p' on the way, off by at most q |s| for q = (f + bend d) / |s|.
/// With 1 / (1 - q) <= 1 + 2 q for q <= 1/2, the offset -v / s is off by at most (1 + 2 q) (e + q |v|) / |s| and its
/// own rounding; the rounding of v to a double counts in e. The factor is for the rounding of these lines. Where
/// f + bend w <= |s| / 2, p' keeps its sign within w of t, so that no other root is there; `reach` is w less d.
std::optional<Located> locate_from(double t, const BoundedPair* c, int size, int sign_low) noexcept {
  constexpr double kSlack = 1 + 0x1p-20;
  const Bounded v = rounded(value_at(c, size, exact_pair(t)));
  Bounded slope = {0, 0};
  for (int k = size - 1; k > 0; --k) {
    slope = slope * Bounded{t, 0} + Bounded{static_cast<double>(k), 0} * rounded(c[k]);
  }
  const auto magnitude = [&](int k) { return k < size ? std::fabs(c[k].value.high) : 0; };
  const double bend = kSlack * (2 * magnitude(2) + 12 * magnitude(3));
  const double steep = std::fabs(slope.value);
  const double distance = kSlack * 2 * (std::fabs(v.value) + v.error) / steep;
  const double q = kSlack * (slope.error + bend * distance) / steep;
  if (!(q <= 0.25 && distance <= 1 && slope.value * sign_low < 0)) return std::nullopt;
  const double offset = -v.value / slope.value;
  const double error =
      kSlack * ((1 + 2 * q) * (v.error + q * std::fabs(v.value)) / steep + kRounding * std::fabs(offset)) + kUnderflow;
  const double reach = bend > 0 ? std::min(1.0, (0.5 * steep - slope.error) / (kSlack * bend)) : 1.0;
  return Located{{two_sum(t, offset), error}, (reach - distance) / kSlack};
}

std::optional<Located> locate(const BoundedPair* c, int size, double low, double high, int sign_low) noexcept {
  constexpr double kGoodError = 0x1p-60;
  const auto located = locate_from(hint(c, size, low, high, sign_low, false), c, size, sign_low);
  if (located && located->near.error <= kGoodError * located->near.value.high) return located;
  const auto closer = locate_from(hint(c, size, low, high, sign_low, true), c, size, sign_low);
  return closer ? closer : located;
}

/// value * numerator^i * denominator^(size - 1 - i) summed over the coefficients: the sign of the polynomial at the
/// quotient, whose denominator is positive.
template <int C, int N>
int sign_at_quotient(const Polynomial<FixedInt<C>, 2>& q, const FixedInt<N>& numerator,
                     const FixedInt<N>& denominator) noexcept {
  return sign_of((q[0] * denominator + q[1] * numerator) * denominator + q[2] * numerator * numerator);
}

/// Whether x < limit, for x >= 0.
bool small(SmallInt x, std::int64_t limit) noexcept { return x.value() < limit; }
template <int N>
bool small(const FixedInt<N>& x, std::int64_t limit) noexcept {
  for (int i = 1; i < N; ++i) {
    if (x.limb(i) != 0) return false;
  }
  return x.limb(0) < static_cast<std::uint64_t>(limit);
}

std::int64_t low_limb(SmallInt x) noexcept { return x.value(); }
template <int N>
std::int64_t low_limb(const FixedInt<N>& x) noexcept {
  return static_cast<std::int64_t>(x.limb(0));
}

template <int Limbs>
Polynomial<FixedInt<3 * Limbs>, 3> widened_cubic(const Polynomial<FixedInt<3 * Limbs>, 3>& p) noexcept {
  return p;
}
template <int Limbs>
Polynomial<FixedInt<3 * Limbs>, 3> widened_cubic(const Polynomial<SmallInt, 3>& p) noexcept {
  Polynomial<FixedInt<3 * Limbs>, 3> result;
  for (int i = 0; i <= 3; ++i) result[i] = p[i].template widened<3 * Limbs>();
  return result;
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

double after(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }
double before(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1); }

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
  const auto exact = dyadic(time);
  if (!exact) return raise_doubt();
  const auto n = FixedInt<1>::integer(exact->numerator), d = FixedInt<1>::integer(exact->denominator);
  if (const auto quotient = rational()) return sign_of(quotient->numerator * d - quotient->denominator * n);
  const auto& [p, degree, reach] = std::get<Isolated>(exact_);
  if (!(std::fabs(near_.value.low) + near_.error < reach)) return raise_doubt();
  const int sign = sign_of(((p[0] * d + p[1] * n) * d + p[2] * n * n) * d + p[3] * n * n * n);
  // p is monotone from the root to `time`: beyond the root it has the sign that its slope has there.
  const BoundedPair c[] = {bounded(p[1]), bounded(p[2]) * exact_pair(2), bounded(p[3]) * exact_pair(3)};
  const int slope = value_at(c, 3, near_).sign();
  return slope != 0 ? -sign * slope : raise_doubt();
}

/// p at n / 2^bits, times 2^(bits degree), `one` being 2^bits.
template <int C>
FixedInt<C + 6> fine_value(const Polynomial<FixedInt<C>, 3>& p, const FixedInt<2>& n, const FixedInt<2>& one) noexcept {
  return ((p[3] * n + p[2] * one) * n + p[1] * one * one) * n + p[0] * one * one * one;
}
template <int C>
FixedInt<C + 4> fine_value(const Polynomial<FixedInt<C>, 2>& p, const FixedInt<2>& n, const FixedInt<2>& one) noexcept {
  return (p[2] * n + p[1] * one) * n + p[0] * one * one;
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
  const auto integer = [](double x) { return FineTime::scaled(std::nearbyint(x), 0); };
  const FineTime one = integer(kPerUnit);
  const auto& p = root.p;
  const BoundedPair slope[] = {bounded(p[1]), bounded(p[2]) * exact_pair(2), bounded(p[3]) * exact_pair(3)};
  FineTime n = integer(near_.value.high * kPerUnit) + integer(near_.value.low * kPerUnit);
  double units = 1;  // of the way from near_; two roundings
  constexpr int kSteps = 6;
  for (int i = 0; i < kSteps; ++i) {
    const double value = bounded(fine_value(p, n, one)).value.high * (kFineUnit * kFineUnit * kFineUnit);
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
  const bool inside = fine_value(p, n - reach, one).sign() * fine_value(p, n + reach, one).sign() < 0;
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
  const FineTime one = FineTime::scaled(1, -kFineBits);
  BoundedPair value = bounded(fine_value(q, closer->n, one)) * exact_pair(kFineUnit * kFineUnit);
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
  const BoundedPair c[] = {bounded(q[0]), bounded(q[1]), bounded(q[2])};
  return value_at(c, 3, time);
}

template <int Limbs>
template <class P>
int NearRoot<Limbs>::sign_of_close(const P& q) const {
  if (is_zero(q)) return 0;
  const int sign = value_of(q, near_).sign();
  if (sign != 0) return sign;
  const Quadratic wide = widened(q);
  if (const Quotient* quotient = std::get_if<Quotient>(&exact_)) {
    return sign_at_quotient(wide, quotient->numerator, quotient->denominator);
  }
  const Isolated& root = std::get<Isolated>(exact_);
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

template <int Limbs>
template <class P>
double NearRoot<Limbs>::quotient_of(const P& numerator, const P& denominator) const {
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
    if (!closer || !is_good(as_pair(*closer))) doubt_->raise();
  }
  return quotient > 0 ? std::min(quotient, 1.0) : 0.0;  // never -0
}
template <int Limbs>
double NearRoot<Limbs>::close_quotient(const Quadratic& numerator, const Quadratic& denominator) const {
  return quotient_of(numerator, denominator);
}
template <int Limbs>
double NearRoot<Limbs>::close_quotient(const SmallQuadratic& numerator, const SmallQuadratic& denominator) const {
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
  const auto& [p, degree, reach] = std::get<Isolated>(exact_);
  if (others) {
    // The two roots of a quadratic are further apart than two doubles that are neighbours.
    if (degree > 2) return raise_doubt();
    const auto &n = others->numerator, &d = others->denominator;
    return ((p[0] * d + p[1] * n) * d + p[2] * n * n).is_zero() ? 0 : raise_doubt();
  }
  // Quadratics without a common factor t or t - 1 are as they were given, and so have room in Quadratic.
  const auto& [q, other_degree, other_reach] = std::get<Isolated>(other.exact_);
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

template <int Limbs>
void NearRoots<Limbs>::push(Root&& root) {
  if (doubt_.raised() || root.compare(limit_) > 0) return;
  roots_[static_cast<std::size_t>(size_++)] = std::move(root);
}

template <int Limbs>
void NearRoots<Limbs>::push_double(double time, int multiplicity) {
  push(Root::at_double(time, multiplicity, doubt_));
}

/// When it lies in (0, 1).
template <int Limbs>
template <class N>
void NearRoots<Limbs>::push_quotient(const N& numerator, const N& denominator, int multiplicity) {
  const bool negative = denominator.sign() < 0;
  const N n = negative ? -numerator : numerator, d = negative ? -denominator : denominator;
  if (n.sign() <= 0 || (n - d).sign() >= 0) return;
  const BoundedPair c[] = {bounded(-n), bounded(d)};
  const auto located = locate(c, 2, 0, 1, -1);
  if (!located) return doubt_.raise();
  Root root;
  constexpr std::int64_t kSmall = std::int64_t{1} << 61;
  if (small(d, kSmall)) {
    root.exact_ = typename Root::Fraction{low_limb(n), low_limb(d)};
  } else {
    root.exact_ = typename Root::Quotient{n.template widened<6 * Limbs>(), d.template widened<6 * Limbs>()};
  }
  root.near_ = located->near;
  root.multiplicity_ = multiplicity;
  root.doubt_ = &doubt_;
  root.settle();
  push(std::move(root));
}

template <int Limbs>
template <class P>
void NearRoots<Limbs>::push_simple(const P& p, int size, double low, double high, int sign_low) {
  Pairs c;
  for (int i = 0; i < size; ++i) c[static_cast<std::size_t>(i)] = bounded(p[i]);
  const auto located = locate(c.data(), size, low, high, sign_low);
  if (!located) return doubt_.raise();
  Root root;
  root.exact_ = typename Root::Isolated{widened_cubic<Limbs>(p), size - 1, located->reach};
  root.near_ = located->near;
  root.doubt_ = &doubt_;
  root.settle();
  push(std::move(root));
}

template <int Limbs>
void NearRoots<Limbs>::isolate(const Cubic& p) {
  isolate_all(p);
}
template <int Limbs>
void NearRoots<Limbs>::isolate(const SmallCubic& p) {
  isolate_all(p);
}

template <int Limbs>
template <class P>
void NearRoots<Limbs>::isolate_all(P p) {
  using Number = typename decltype(p.c)::value_type;
  int size = 4;
  while (p[size - 1].is_zero()) --size;
  int at_zero = 0;
  while (p[0].is_zero()) {
    for (int i = 0; i + 1 < size; ++i) p[i] = p[i + 1];
    p[--size] = Number();
    ++at_zero;
  }
  if (at_zero > 0) push_double(0, at_zero);
  const auto at_one = [&] {
    auto sum = p[0];
    for (int i = 1; i < size; ++i) sum = sum + p[i];
    return sum;
  };
  int ones = 0;
  while (size > 1 && at_one().is_zero()) {  // synthetic division by t - 1
    for (int i = size - 2; i > 0; --i) p[i] = p[i] + p[i + 1];
    for (int i = 0; i + 1 < size; ++i) p[i] = p[i + 1];
    p[--size] = Number();
    ++ones;
  }
  isolate_inside(p, size);
  if (ones > 0) push_double(1, ones);
}

/// Of a polynomial that vanishes neither at 0 nor at 1.
template <int Limbs>
template <class P>
void NearRoots<Limbs>::isolate_inside(const P& p, int size) {
  if (size == 1) return;
  if (size == 2) return push_quotient(-p[0], p[1], 1);
  const auto twice = p[0] + p[0];
  const auto thrice = twice + p[0];
  const int signs[4] = {p[0].sign(), size == 3 ? (twice + p[1]).sign() : (thrice + p[1]).sign(),
                        size == 3 ? 0 : (thrice + p[1] + p[1] + p[2]).sign(), (p[0] + p[1] + p[2] + p[3]).sign()};
  int variations = 0;
  int previous = signs[0];
  for (const int sign : signs) {
    variations += sign == -previous && sign != 0;
    if (sign != 0) previous = sign;
  }
  if (variations == 0) return;
  if (variations == 1) return push_simple(p, size, 0, 1, signs[0]);
  if (size == 3) return isolate_quadratic(p);
  isolate_cubic(p);
}

/// With two variations: it has the leading coefficient's sign at both ends, and its vertex lies inside.
template <int Limbs>
template <class P>
void NearRoots<Limbs>::isolate_quadratic(const P& p) {
  const auto product = wide_product(p[0], p[2]);
  const auto twice = product + product;
  const int discriminant = (wide_product(p[1], p[1]) - (twice + twice)).sign();
  if (discriminant < 0) return;
  if (discriminant == 0) return push_quotient(-p[1], p[2] + p[2], 2);
  const BoundedPair c[] = {bounded(p[0]), bounded(p[1]), bounded(p[2])};
  const double vertex = c[1].value.high / (-2 * c[2].value.high);
  const int sign = p[0].sign();
  if (!(vertex > 0 && vertex < 1) || value_at(c, 3, exact_pair(vertex)).sign() != -sign) return doubt_.raise();
  push_simple(p, 3, 0, vertex, sign);
  push_simple(p, 3, vertex, 1, -sign);
}

/// The signs of three times the Bernstein coefficients of c over [low, high], that is of the blossom's values; 0 where
/// uncertain.
std::array<int, 4> bernstein_signs(const BoundedPair* c, double low, double high) noexcept {
  const BoundedPair three = exact_pair(3);
  const auto blossom = [&](double x, double y, double z) {
    const BoundedPair a = exact_pair(x), b = exact_pair(y), d = exact_pair(z);
    return (three * c[0] + c[1] * (a + b + d) + c[2] * (a * b + b * d + d * a) + three * c[3] * (a * b * d)).sign();
  };
  return {blossom(low, low, low), blossom(low, low, high), blossom(low, high, high), blossom(high, high, high)};
}

/// With two or three variations.
template <int Limbs>
template <class P>
void NearRoots<Limbs>::isolate_cubic(const P& p) {
  Pairs c;
  for (int i = 0; i < 4; ++i) c[static_cast<std::size_t>(i)] = bounded(p[i]);
  // Without a root of its derivative it is monotone, even where the three roots almost coincide.
  if ((c[2] * c[2] - exact_pair(3) * c[1] * c[3]).sign() < 0) {
    const int sign = p[0].sign();
    if ((p[0] + p[1] + p[2] + p[3]).sign() != sign) push_simple(p, 4, 0, 1, sign);
    return;
  }
  // Between its critical points and its inflection a cubic is monotone and convex or concave.
  const double c1 = c[1].value.high, c2 = c[2].value.high, c3 = c[3].value.high;
  std::array<double, 5> ends = {0, 1, 1, 1, 1};
  std::size_t count = 1;
  const double discriminant = c2 * c2 - 3 * c1 * c3;
  if (discriminant > 0) {
    const double root = std::sqrt(discriminant), sum = -(c2 + std::copysign(root, c2));
    double first = sum / (3 * c3), second = c1 / sum;
    if (first > second) std::swap(first, second);
    for (const double point : {first, second}) {
      if (point > ends[count - 1] && point < 1) ends[count++] = point;
    }
  } else if (const double inflection = -c2 / (3 * c3); inflection > 0 && inflection < 1) {
    ends[count++] = inflection;
  }
  ends[count++] = 1;

  const int at_one = (p[0] + p[1] + p[2] + p[3]).sign();
  std::array<int, 5> one{};  // the sign at the start of a part with one root; 0: without a root
  for (std::size_t i = 0; i + 1 < count; ++i) {
    std::array<int, 4> signs = bernstein_signs(c.data(), ends[i], ends[i + 1]);
    if (i == 0) signs[0] = p[0].sign();
    if (i + 2 == count) signs[3] = at_one;
    const bool certain = signs[0] != 0 && signs[3] != 0;
    const bool none = certain && signs[0] == signs[3] && signs[1] == signs[0] && signs[2] == signs[0];
    // From one sign to the other with at most one turn, whatever the uncertain one is.
    const bool single = certain && signs[0] != signs[3] && (signs[1] == signs[0] || signs[2] == signs[3]);
    if (!none && !single) return push_repeated(widened_cubic<Limbs>(p));
    if (single) one[i] = signs[0];
  }
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if (one[i] != 0) push_simple(p, 4, ends[i], ends[i + 1], one[i]);
  }
}

/// When it certainly has a repeated root; otherwise its roots are in doubt. The discriminant is
/// (4 (b^2 - 3ac)(c^2 - 3bd) - (bc - 9ad)^2) / 3. A double root is (9ad - bc) / (2 (b^2 - 3ac)), a triple one -b / 3a.
///
/// Sizes in bits, with C = 192 L - 3 of the coefficients: b^2 - 3ac and c^2 - 3bd below 2 C + 2 = 384 L - 4, bc - 9ad
/// below 2 C + 4 = 384 L - 2, the products below (768 L - 8) + 2 and 768 L - 4. Each has its limbs.
template <int Limbs>
void NearRoots<Limbs>::push_repeated(const Cubic& p) {
  const auto thrice = [](const auto& x) { return x + x + x; };
  const auto &d = p[0], &c = p[1], &b = p[2], &a = p[3];
  const auto b2_3ac = b * b - thrice(a * c);
  const auto c2_3bd = c * c - thrice(b * d);
  const auto ad9_bc = thrice(thrice(a * d)) - b * c;
  const auto product = b2_3ac * c2_3bd;
  const auto twice = product + product;
  if (!(twice + twice - ad9_bc * ad9_bc).is_zero()) return doubt_.raise();
  if (b2_3ac.is_zero()) return push_quotient(-b, thrice(a), 3);

  // The other root is in (0, 1) iff p's signs at 0 and at 1 differ, and then it is the one where p changes its sign.
  const int sign = d.sign();
  const bool other_inside = (a + b + c + d).sign() != sign;
  const auto denominator = b2_3ac + b2_3ac;
  if (!other_inside) return push_quotient(ad9_bc, denominator, 2);
  const double repeated = to_double(ad9_bc) / to_double(denominator);
  const double other = -to_double(b) / to_double(a) - 2 * repeated;
  const double middle = 0.5 * (repeated + other);
  const bool other_first = other < repeated;
  if (!(middle > 0 && middle < 1)) {  // the repeated root is far outside
    const int side = (bounded(ad9_bc) - exact_pair(other_first ? 1 : 0) * bounded(denominator)).sign();
    if (side * denominator.sign() != (other_first ? 1 : -1)) return doubt_.raise();
    return push_simple(p, 4, 0, 1, sign);
  }
  const int side = (bounded(ad9_bc) - exact_pair(middle) * bounded(denominator)).sign() * denominator.sign();
  const BoundedPair pairs[] = {bounded(d), bounded(c), bounded(b), bounded(a)};
  const int at_middle = value_at(pairs, 4, exact_pair(middle)).sign();
  if (side != (other_first ? 1 : -1) || at_middle != (other_first ? -sign : sign)) return doubt_.raise();
  if (other_first) push_simple(p, 4, 0, middle, sign);
  push_quotient(ad9_bc, denominator, 2);
  if (!other_first) push_simple(p, 4, middle, 1, sign);
}

template class NearRoot<1>;
template class NearRoot<2>;
template class NearRoots<1>;
template class NearRoots<2>;

}  // namespace touchstone::numbers
