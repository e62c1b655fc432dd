// Error-free transformations and short double-double arithmetic (Dekker 1971, Knuth; see Ogita, Rump and Oishi 2005),
// for doubles and for packs of them. Everything assumes round to nearest, one IEEE operation per operator, and no
// underflow in products (see the guards of the callers). Nothing is contracted; where a file is compiled for a
// processor with fused multiply-add, the low part of a product, which is exact either way, comes from one. The inline
// namespace keeps functions of such files apart from those of the others. All are inlined: packs of several coordinates
// would go through memory otherwise.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::numbers {
#ifdef __FMA__
inline namespace fused {
inline double multiply_subtract(double a, double b, double c) noexcept { return __builtin_fma(a, b, -c); }
#else
inline namespace unfused {
#endif

/// An unevaluated sum high + low.
template <class N>
struct DoubleDoubleOf {
  N high;
  N low;
};
using DoubleDouble = DoubleDoubleOf<double>;

/// a + b exactly.
template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> two_sum(N a, N b) noexcept {
  const N sum = a + b;
  const N b_virtual = sum - a;
  return {sum, (a - (sum - b_virtual)) + (b - b_virtual)};
}

/// a - b exactly.
template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> two_difference(N a, N b) noexcept {
  const N difference = a - b;
  const N b_virtual = a - difference;
  return {difference, (a - (difference + b_virtual)) + (b_virtual - b)};
}

/// a * b exactly; |a|, |b| < 2^996 and the product either 0 or at least 2^-969.
template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> two_product(N a, N b) noexcept {
  const N product = a * b;
#ifdef __FMA__
  return {product, multiply_subtract(a, b, product)};
#else
  constexpr double kSplitter = 0x1p27 + 1;
  const N a_scaled = kSplitter * a;
  const N a_high = a_scaled - (a_scaled - a);
  const N a_low = a - a_high;
  const N b_scaled = kSplitter * b;
  const N b_high = b_scaled - (b_scaled - b);
  const N b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
#endif
}

/// The same number with the smallest low part: at most half a unit in the last place of the high part.
template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> normalised(const DoubleDoubleOf<N>& a) noexcept {
  return two_sum(a.high, a.low);
}

// The operators below do not normalise. Low parts grow by a few units in the last place; the callers' bounds allow
// for that.

template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> operator-(const DoubleDoubleOf<N>& a) noexcept {
  return {-a.high, -a.low};
}

template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> operator+(const DoubleDoubleOf<N>& a,
                                                          const DoubleDoubleOf<N>& b) noexcept {
  const DoubleDoubleOf<N> high = two_sum(a.high, b.high);
  return {high.high, high.low + (a.low + b.low)};
}

template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> operator-(const DoubleDoubleOf<N>& a,
                                                          const DoubleDoubleOf<N>& b) noexcept {
  const DoubleDoubleOf<N> high = two_difference(a.high, b.high);
  return {high.high, high.low + (a.low - b.low)};
}

template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> operator*(const DoubleDoubleOf<N>& a,
                                                          const DoubleDoubleOf<N>& b) noexcept {
  const DoubleDoubleOf<N> high = two_product(a.high, b.high);
  return {high.high, high.low + (a.high * b.low + a.low * b.high)};
}

template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> operator*(const N& a, const DoubleDoubleOf<N>& b) noexcept {
  const DoubleDoubleOf<N> high = two_product(a, b.high);
  return {high.high, high.low + a * b.low};
}

template <class N>
[[gnu::always_inline]] inline N rounded(const DoubleDoubleOf<N>& a) noexcept {
  return a.high + a.low;
}

/// a / b of normalised operands, off by less than 16 e^2 of it, e = 2^-53: e^2 from the product, 4 e^2 from the rest,
/// which is below 2 e a, 4 e^2 from its quotient, and some for b's low part there.
template <class N>
[[gnu::always_inline]] inline DoubleDoubleOf<N> operator/(const DoubleDoubleOf<N>& a,
                                                          const DoubleDoubleOf<N>& b) noexcept {
  const N first = a.high / b.high;
  return normalised(DoubleDoubleOf<N>{first, rounded(a - first * b) / b.high});
}

}  // namespace fused, unfused
}  // namespace touchstone::numbers
