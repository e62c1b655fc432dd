// The near roots of a polynomial in [0, 1], each with what proves that it is the only one there.
// SPDX-License-Identifier: MIT
#include "numbers/roots/near_root.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "numbers/doubles/neighbours.hpp"
#include "numbers/integers/bounded_integers.hpp"
#include "numbers/roots/located_root.hpp"
#include "numbers/roots/rational_roots.hpp"

namespace touchstone::numbers {
namespace {

/// n / d = q + (n - q d) / d for a double q near it. The rest r is off by r.error, and its low part is left out; d's
/// high part is off by less than 2^-51 of itself, and the division rounds.
BoundedPair quotient_of(const BoundedPair& n, const BoundedPair& d) noexcept {
  constexpr double kSlack = 1 + 0x1p-20;
  const double q = n.value.high / d.value.high;
  const BoundedPair r = n - exact_pair(q) * d;
  const double rest = r.value.high / d.value.high;
  const double error =
      kSlack * (r.error + std::fabs(r.value.low)) / std::fabs(d.value.high) + 0x1p-50 * std::fabs(rest) + kUnderflow;
  if (!(d.error <= 0x1p-53 * std::fabs(d.value.high))) return {{q, 0}, std::numeric_limits<double>::infinity()};
  return {two_sum(q, rest), error};
}

/// n / d for 0 < n < d < 2^53 as a double-double, and between which doubles it lies. What the rounded quotient leaves,
/// n - quotient d, is a double, and so its sign is exact; divided by d it rounds once.
struct Divided {
  BoundedPair near;
  double lower, upper;
};
Divided divided(double n, double d) noexcept {
  const double quotient = n / d, rest = std::fma(-quotient, d, n), low = rest / d;
  return {{two_sum(quotient, low), 2 * kRounding * std::fabs(low)},
          rest < 0 ? before(quotient) : quotient,
          rest > 0 ? after(quotient) : quotient};
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

/// x / 2^times, rounded down; times < 64.
SmallInt halved(SmallInt x, int times) noexcept { return SmallInt::integer(x.value() >> times); }
template <int N>
FixedInt<N> halved(const FixedInt<N>& x, int times) noexcept {
  FixedInt<N> result;
  if (times == 0) return x;
  for (int i = 0; i < N; ++i) {
    const std::uint64_t above = i + 1 < N ? x.limb(i + 1) : x.sign_mask();
    result.set_limb(i, x.limb(i) >> times | above << (64 - times));
  }
  return result;
}

/// The polynomial without the power of two that all its coefficients have, where that leaves less than 60 bits of each.
template <int N>
std::optional<Polynomial<SmallInt, 3>> narrowed(const Polynomial<FixedInt<N>, 3>& p) noexcept {
  constexpr std::int64_t kLimit = std::int64_t{1} << 60;
  int limb = 0;
  std::uint64_t any = 0;
  for (; any == 0; ++limb) {
    for (const FixedInt<N>& c : p.c) any |= c.limb(limb);
  }
  --limb;
  Polynomial<SmallInt, 3> result;
  for (int i = 0; i <= 3; ++i) {
    FixedInt<N> upper;
    for (int k = 0; k < N; ++k) upper.set_limb(k, limb + k < N ? p[i].limb(limb + k) : p[i].sign_mask());
    const FixedInt<N> reduced = halved(upper, std::countr_zero(any));
    const auto low = static_cast<std::int64_t>(reduced.limb(0));
    if (low <= -kLimit || low >= kLimit || !(FixedInt<N>::integer(low) - reduced).is_zero()) return std::nullopt;
    result[i] = SmallInt::integer(low);
  }
  return result;
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

}  // namespace

template <int Limbs>
void NearRoots<Limbs>::push(Root&& root) {
  if (doubt_.raised() || root.compare(limit_) > 0) return;
  roots_[static_cast<std::size_t>(size_++)] = std::move(root);
}

template <int Limbs>
void NearRoots<Limbs>::push_double(double time, int multiplicity) {
  push(Root::at_double(time, multiplicity, doubt_));
}

/// For 0 < n < d < 2^53.
template <int Limbs>
void NearRoots<Limbs>::push_fraction(std::int64_t n, std::int64_t d, int multiplicity) {
  const auto [near, lower, upper] = divided(static_cast<double>(n), static_cast<double>(d));
  if (lower == upper) return push_double(lower, multiplicity);
  const std::int64_t divisor = std::gcd(n, d);
  Root root;
  root.exact_ = typename Root::Fraction{n / divisor, d / divisor};
  root.near_ = near;
  root.lower_ = lower;
  root.upper_ = upper;
  root.multiplicity_ = multiplicity;
  root.doubt_ = &doubt_;
  push(std::move(root));
}

/// When it lies in (0, 1).
template <int Limbs>
template <class N>
void NearRoots<Limbs>::push_quotient(const N& numerator, const N& denominator, int multiplicity) {
  const bool negative = denominator.sign() < 0;
  const N n = negative ? -numerator : numerator, d = negative ? -denominator : denominator;
  if (n.sign() <= 0 || (n - d).sign() >= 0) return;
  constexpr std::int64_t kExactlyDoubles = std::int64_t{1} << 53;
  if (small(d, kExactlyDoubles)) return push_fraction(low_limb(n), low_limb(d), multiplicity);
  const BoundedPair c[] = {bounded(-n), bounded(d)};
  const auto located = locate(c, 2, 0, 1, -1, hint_between(c, 2, 0, 1, -1));
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
  const double near = hint_between(c.data(), size, low, high, sign_low);
  if constexpr (std::is_same_v<P, SmallCubic>) {
    if (size == 4 && has_few_bits(p)) {
      const auto root = rational_root_near(p, near);
      const double time = root ? static_cast<double>(root->n) / static_cast<double>(root->d) : 0;
      // It is the root inside if it certainly is inside: a quotient rounds by less than 2^-52 of itself.
      if (time * (1 - 0x1p-50) > low && time * (1 + 0x1p-50) < high && divided(p, *root)) {
        return push_fraction(root->n, root->d, 1);
      }
    }
  }
  const auto located = locate(c.data(), size, low, high, sign_low, near);
  if (!located) return doubt_.raise();
  Root root;
  root.exact_ = typename Root::Isolated{widened_cubic<Limbs>(p), size - 1, -sign_low, located->reach};
  root.near_ = located->near;
  root.doubt_ = &doubt_;
  root.settle();
  push(std::move(root));
}

template <int Limbs>
void NearRoots<Limbs>::isolate(const Cubic& p) {
  if (const auto small = narrowed(p)) return isolate_all(*small);
  isolate_all(p);
}
template <int Limbs>
void NearRoots<Limbs>::isolate(const SmallCubic& p) {
  std::uint64_t any = 0;
  for (const SmallInt c : p.c) any |= static_cast<std::uint64_t>(c.value());
  const int zeros = std::countr_zero(any);
  SmallCubic reduced;
  for (int i = 0; i <= 3; ++i) reduced[i] = halved(p[i], zeros);
  isolate_all(reduced);
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
  if constexpr (std::is_same_v<P, SmallCubic>) {
    if (size == 3 ? isolate_rational_quadratic(p) : variations > 1 && isolate_rational_cubic(p)) return;
  }
  if (variations == 1) return push_simple(p, size, 0, 1, signs[0]);
  if (size == 3) return isolate_quadratic(p);
  isolate_cubic(p);
}

/// Of a quadratic whose discriminant is a square.
template <int Limbs>
bool NearRoots<Limbs>::isolate_rational_quadratic(const SmallCubic& p) {
  const auto product = wide_product(p[0], p[2]);
  const auto twice = product + product;
  const auto root = exact_root(wide_product(p[1], p[1]) - (twice + twice));
  if (!root) return false;
  const SmallInt apart = SmallInt::integer(p[2].sign() < 0 ? -*root : *root), twice_leading = p[2] + p[2];
  if (*root == 0) {
    push_quotient(-p[1], twice_leading, 2);
  } else {
    push_quotient(-p[1] - apart, twice_leading, 1);
    push_quotient(-p[1] + apart, twice_leading, 1);
  }
  return true;
}

/// Of a cubic of few bits that has a rational root inside, if one is found. A repeated root is a root of p', too, and
/// is rational: the discriminant of p' is a square then.
template <int Limbs>
bool NearRoots<Limbs>::isolate_rational_cubic(const SmallCubic& p) {
  if (!has_few_bits(p)) return false;
  const auto solve_beside = [&](double near) {
    const auto root = rational_root_near(p, near);
    auto rest = root ? divided(p, *root) : std::nullopt;
    if (!rest) return false;
    int multiplicity = 1;
    while (const auto next = divided(*rest, *root)) {
      rest = next;
      ++multiplicity;
    }
    isolate_inside(*rest, 4 - multiplicity);
    push_fraction(root->n, root->d, multiplicity);
    sort_last();
    return true;
  };
  const auto square = wide_product(p[2], p[2]) - wide_product(p[1] + p[1] + p[1], p[3]);
  if (const auto apart = exact_root(square)) {
    const double middle = -to_double(p[2]), leading = 3 * to_double(p[3]), way = static_cast<double>(*apart);
    if (solve_beside((middle - way) / leading) || (*apart != 0 && solve_beside((middle + way) / leading))) return true;
  }
  return solve_beside(hint_of_first(p));
}

/// Puts the last root, which was just pushed, in its place.
template <int Limbs>
void NearRoots<Limbs>::sort_last() {
  for (int i = size_ - 1; i > 0; --i) {
    auto &root = roots_[static_cast<std::size_t>(i)], &before = roots_[static_cast<std::size_t>(i - 1)];
    if (before->compare(*root) < 0) break;
    std::swap(root, before);
  }
}

/// The two roots of a quadratic, middle -+ apart. The discriminant is exact, so that `apart` is off by less than 2^-49
/// of itself, from the conversion, the root and the division: the closer the roots, the better they are known.
template <int Limbs>
template <class P>
void NearRoots<Limbs>::push_close(const P& p, const BoundedPair& middle, double apart) {
  for (const double way : {-apart, apart}) {
    Root root;
    root.near_ = middle + exact_pair(way);
    root.near_.error += 0x1p-49 * apart;
    const int sign_after = way < 0 ? -p[2].sign() : p[2].sign();
    root.exact_ =
        typename Root::Isolated{widened_cubic<Limbs>(p), 2, sign_after, (2 - 0x1p-20) * apart - root.near_.error};
    root.doubt_ = &doubt_;
    root.settle();
    push(std::move(root));
  }
  // Root::compare relies on it that a double lies between the two.
  if (size_ >= 2) {
    const auto &first = *roots_[static_cast<std::size_t>(size_ - 2)],
               &second = *roots_[static_cast<std::size_t>(size_ - 1)];
    if (first.upper() == second.upper() && first.lower() == second.lower()) doubt_.raise();
  }
}

/// With two variations: it has the leading coefficient's sign at both ends, and its vertex lies inside.
template <int Limbs>
template <class P>
void NearRoots<Limbs>::isolate_quadratic(const P& p) {
  const auto product = wide_product(p[0], p[2]);
  const auto twice = product + product;
  const auto exact_discriminant = wide_product(p[1], p[1]) - (twice + twice);
  const int discriminant = exact_discriminant.sign();
  if (discriminant < 0) return;
  if (discriminant == 0) return push_quotient(-p[1], p[2] + p[2], 2);
  const BoundedPair c[] = {bounded(p[0]), bounded(p[1]), bounded(p[2])};
  const double vertex = c[1].value.high / (-2 * c[2].value.high);
  const double apart = 0.5 * std::sqrt(to_double(exact_discriminant)) / std::fabs(c[2].value.high);
  constexpr double kClose = 0x1p-12;
  if (apart < kClose * vertex) return push_close(p, quotient_of(-c[1], c[2] + c[2]), apart);
  const int sign = p[0].sign();
  if (!(vertex > 0 && vertex < 1) || value_at(c, 3, exact_pair(vertex)).sign() != -sign) return doubt_.raise();
  push_simple(p, 3, 0, vertex, sign);
  push_simple(p, 3, vertex, 1, -sign);
}

/// The sign of three times the blossom of the cubic c at x, y, z, or 0 where it is uncertain. Its Bernstein
/// coefficients over [low, high] are the blossoms at low and high. Doubles mostly suffice.
int blossom_sign(const BoundedPair* c, double x, double y, double z) noexcept {
  const auto blossom = [&](auto exact, auto coefficient) {
    const auto a = exact(x), b = exact(y), d = exact(z), three = exact(3);
    return (three * coefficient(0) + coefficient(1) * (a + b + d) + coefficient(2) * (a * b + b * d + d * a) +
            three * coefficient(3) * (a * b * d))
        .sign();
  };
  const int sign = blossom([](double t) { return Bounded{t, 0}; }, [&](int i) { return rounded(c[i]); });
  return sign != 0 ? sign : blossom(exact_pair, [&](int i) { return c[i]; });
}

SmallInt times_integer(SmallInt x, std::int64_t n) noexcept { return x * SmallInt::integer(n); }
template <int N>
FixedInt<N> times_integer(const FixedInt<N>& x, std::int64_t n) noexcept {
  const FixedInt<N + 1> product = x * FixedInt<1>::integer(n);
  FixedInt<N> result;
  for (int i = 0; i < N; ++i) result.set_limb(i, product.limb(i));
  return result;
}

/// Of a cubic whose roots almost coincide, where one of them is a double of few bits, n / 2^k, for n odd. Then
/// 2^k t - n divides p, and the quotient a has integer coefficients (Gauss's lemma): a2 = p3 / 2^k,
/// a1 = (p2 + n a2) / 2^k, a0 = (p1 + n a1) / 2^k and p0 + n a0 = 0. The divisions leave no remainder where the last
/// one holds. Without it nothing is used, so that the sums need no room beyond p's.
template <int Limbs>
template <class P>
bool NearRoots<Limbs>::isolate_beside_double(const P& p) {
  constexpr int kMostBits = 6;
  const double inflection = -to_double(p[2]) / (3 * to_double(p[3]));
  if (!(inflection > 0x1p-7 && inflection < 1 - 0x1p-7)) return false;
  std::int64_t n = static_cast<std::int64_t>(std::nearbyint(inflection * (1 << kMostBits)));
  const double time = static_cast<double>(n) / (1 << kMostBits);
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(n));
  n >>= zeros;
  const int k = kMostBits - zeros;
  P a = {};
  a[2] = halved(p[3], k);
  a[1] = halved(p[2] + times_integer(a[2], n), k);
  a[0] = halved(p[1] + times_integer(a[1], n), k);
  // p is (2^k t - n) a, coefficient by coefficient
  const auto doubled = [k](const auto& x) { return times_integer(x, std::int64_t{1} << k); };
  const bool divides = (p[0] + times_integer(a[0], n)).is_zero() && (doubled(a[2]) - p[3]).is_zero() &&
                       (doubled(a[1]) - times_integer(a[2], n) - p[2]).is_zero() &&
                       (doubled(a[0]) - times_integer(a[1], n) - p[1]).is_zero();
  if (!divides) return false;
  // Not where n / 2^k is a root of a, too. The sum needs more room than p's.
  const auto d = FixedInt<1>::integer(std::int64_t{1} << k), m = FixedInt<1>::integer(n);
  const auto wide = [](const auto& x) { return x.template widened<3 * Limbs>(); };
  if (((wide(a[0]) * d + wide(a[1]) * m) * d + wide(a[2]) * m * m).is_zero()) return false;
  isolate_inside(a, 3);
  push_double(time, 1);
  sort_last();
  return true;
}

/// With two or three variations.
template <int Limbs>
template <class P>
void NearRoots<Limbs>::isolate_cubic(const P& p) {
  Pairs c;
  for (int i = 0; i < 4; ++i) c[static_cast<std::size_t>(i)] = bounded(p[i]);
  const BoundedPair square = c[2] * c[2], bend = square - exact_pair(3) * c[1] * c[3];
  constexpr double kAlmostTriple = 0x1p-16;
  if (std::fabs(bend.value.high) < kAlmostTriple * square.value.high && isolate_beside_double(p)) return;
  // Without a root of its derivative it is monotone, even where the three roots almost coincide.
  if (bend.sign() < 0) {
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

  std::array<int, 5> one{};  // the sign at the start of a part with one root; 0: without a root
  int before = p[0].sign();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double low = ends[i], high = ends[i + 1];
    const int after = i + 2 == count ? (p[0] + p[1] + p[2] + p[3]).sign() : blossom_sign(c.data(), high, high, high);
    const std::array<int, 4> signs = {before, blossom_sign(c.data(), low, low, high),
                                      blossom_sign(c.data(), low, high, high), after};
    before = after;
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

/// When it has a repeated root, or a single real one; three roots that almost coincide are in doubt. The discriminant
/// is (4 (b^2 - 3ac)(c^2 - 3bd) - (bc - 9ad)^2) / 3. A double root is (9ad - bc) / (2 (b^2 - 3ac)), a triple one -b /
/// 3a.
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
  const int discriminant = (twice + twice - ad9_bc * ad9_bc).sign();
  if (discriminant > 0) return doubt_.raise();
  // Of a repeated root and another one, and of a single real root, p changes its sign at the latter only. It is in (0,
  // 1) iff p's signs at 0 and at 1 differ.
  const int sign = d.sign();
  const bool other_inside = (a + b + c + d).sign() != sign;
  if (discriminant < 0) {
    if (other_inside) push_simple(p, 4, 0, 1, sign);
    return;
  }
  if (b2_3ac.is_zero()) return push_quotient(-b, thrice(a), 3);

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

template class NearRoots<1>;
template class NearRoots<2>;

}  // namespace touchstone::numbers
