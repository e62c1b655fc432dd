// Error-free transformations and short double-double arithmetic (Dekker 1971, Knuth; see Ogita, Rump and Oishi 2005).
// Everything assumes round to nearest, one IEEE operation per operator, and no underflow in products (see the guards of
// the callers). No fused multiply-add, so that every machine takes the same steps.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::numbers {

/// An unevaluated sum high + low.
struct DoubleDouble {
  double high;
  double low;
};

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b) noexcept {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a - b exactly.
inline DoubleDouble two_difference(double a, double b) noexcept {
  const double difference = a - b;
  const double b_part = a - difference;
  return {difference, (a - (difference + b_part)) + (b_part - b)};
}

/// a * b exactly; |a|, |b| < 2^996 and the product either 0 or at least 2^-969.
inline DoubleDouble two_product(double a, double b) noexcept {
  constexpr double kSplitter = 0x1p27 + 1;
  const double a_scaled = kSplitter * a;
  const double a_high = a_scaled - (a_scaled - a);
  const double a_low = a - a_high;
  const double b_scaled = kSplitter * b;
  const double b_high = b_scaled - (b_scaled - b);
  const double b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

// The three below do not normalise: low parts grow by the few units in the last place that the callers' bounds allow.

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = two_sum(a.high, b.high);
  return {high.high, high.low + (a.low + b.low)};
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = two_difference(a.high, b.high);
  return {high.high, high.low + (a.low - b.low)};
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = two_product(a.high, b.high);
  return {high.high, high.low + (a.high * b.low + a.low * b.high)};
}

inline DoubleDouble operator*(double a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = two_product(a, b.high);
  return {high.high, high.low + a * b.low};
}

inline double rounded(const DoubleDouble& a) noexcept { return a.high + a.low; }

}  // namespace touchstone::numbers
