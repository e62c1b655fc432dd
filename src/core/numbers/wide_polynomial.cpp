// SPDX-License-Identifier: MIT
#include "numbers/wide_polynomial.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numbers/exact_number.hpp"

namespace touchstone::numbers {
namespace {

/// Less than any exponent that counts, and room to add to it.
constexpr long kNoExponent = std::numeric_limits<long>::min() / 4;

/// Terms that are so much smaller than the greatest one are left out.
constexpr long kLeastExponent = -900;
/// More than some of them in all, and than what underflows.
constexpr double kLeftOut = 0x1p-890;

/// 2^exponent; 0 below 2^kLeastExponent. The exponent is at most 0.
double power(long exponent) noexcept {
  return exponent < kLeastExponent ? 0 : std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

}  // namespace

/// approximate is off by a relative 2^-52.
Rough::Rough(const Sparse& x) noexcept {
  const Approximation a = approximate(x);
  value = a.significand;
  error = 0x1p-52 * std::fabs(a.significand);
  exponent = a.exponent;
}

/// A bound that is beyond the number itself is as good as none.
Rough::Rough(const Sparse::Part& x) noexcept {
  if (x.value.is_zero()) {
    if (x.error > kNoError / 2) {
      error = 1;
      exponent = x.error;
    }
    return;
  }
  *this = Rough(x.value);
  const long above = x.error - exponent;
  if (above > 0) {
    value = 0;
    error = 1;
    exponent = x.error + 2;  // |value| 2^exponent <= 2^exponent < 2^error
  } else {
    error += std::max(power(above), x.error > kNoError / 2 ? 0x1p-900 : 0);
  }
}

WidePoint WideBracket::point() const noexcept {
  const double middle = 0.5 * (low + high);
  // Half the length and three roundings.
  return {middle, exponent, 0.5 * (high - low) / middle * (1 + 0x1p-40) + 0x1p-50};
}

WidePolynomial WidePolynomial::mirrored() const noexcept {
  WidePolynomial result = *this;
  for (const std::size_t i : {1U, 3U}) result.c_[i].value = -result.c_[i].value;
  return result;
}

WidePolynomial::Window WidePolynomial::window(long exponent) const noexcept {
  long greatest = kNoExponent;
  for (int i = 0; i < size_; ++i) {
    const Rough& c = c_[static_cast<std::size_t>(i)];
    if (c.value != 0 || c.error != 0) greatest = std::max(greatest, c.exponent + i * exponent);
  }
  Window result;
  for (int i = 0; i < size_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Rough& c = c_[at];
    if (c.value == 0 && c.error == 0) continue;
    const double unit = power(c.exponent + i * exponent - greatest);
    result.c[at] = c.value * unit;
    result.error[at] = c.error * unit;
  }
  return result;
}

/// Let a = sum |c_i| x^i. Horner's scheme with 6 roundings is off by at most 6.1 2^-53 a < 2^-50 a. The coefficients'
/// errors add sum e_i x^i. For x (1 + d), |d| <= slack <= 2^-8, a term c_i x^i changes by at most i slack (1 + slack)^2
/// < 1.02 i slack of itself, and those of the errors become at most 1.03 times greater. The sums of the bound are of
/// terms that are not negative, and off by less than a relative 2^-49. The rest of the factor 1.05, more than 2^-56 a,
/// is for what is left out or underflows, below kLeftOut: x is at least 1/8, and so is a at least 2^-10.
int WidePolynomial::sign_in(const Window& window, double x, double slack) const noexcept {
  double value = 0, size = 0, error = 0, slope = 0;
  for (int i = size_ - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    value = value * x + window.c[at];
    slope = slope * x + size;
    size = size * x + std::fabs(window.c[at]);
    error = error * x + window.error[at];
  }
  return sign_of(value, 1.05 * (error + 0x1p-50 * size) + 1.02 * slack * (slope * x));
}

int WidePolynomial::sign_at(const WidePoint& x) const noexcept {
  if (size_ == 1) return sign_at_zero();
  return sign_in(window(x.exponent), x.significand, x.slack);
}

/// With x and y, 0 <= x < y <= 1, for the ends: three times the blossom's values, c0 + c1 (a + b + d) / 3 + c2 (a b +
/// a d + b d) / 3 + c3 a b d at (x, x, x), (x, x, y), (x, y, y) and (y, y, y). All sums but the last one are of terms
/// that are not negative. Each of the four products is off by at most 7 roundings, and the last sum by 3 more: less
/// than 2^-49 of the sum of the products' sizes. An x below 2^kLeastExponent is taken as 0, which counts as left out.
/// For a small x, all products may be less than a c0 that is left out.
std::array<int, 4> WidePolynomial::bernstein_signs(const std::optional<WidePoint>& low,
                                                   const WidePoint& high) const noexcept {
  const Window w = window(high.exponent);
  const double y = high.significand;
  if (low && low->exponent > high.exponent) return {};
  const double x = low ? low->significand * power(low->exponent - high.exponent) : 0;
  const auto blossom_sign = [&w](double a, double b, double d) {
    const std::array<double, 4> factors = {3, a + b + d, a * b + (a + b) * d, 3 * (a * b * d)};
    double value = 0, size = 0, error = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value += w.c[i] * factors[i];
      size += std::fabs(w.c[i]) * factors[i];
      error += w.error[i] * factors[i];
    }
    return sign_of(value, 1.05 * (error + 0x1p-49 * size) + kLeftOut);
  };
  return {blossom_sign(x, x, x), blossom_sign(x, x, y), blossom_sign(x, y, y), blossom_sign(y, y, y)};
}

/// Where, of two terms with different signs, the later one overtakes the earlier one as the greatest: about the least
/// positive root. Only a hint.
std::optional<long> WidePolynomial::crossing_exponent() const noexcept {
  int i = 0;
  while (i + 1 < size_) {
    const Rough& from = c_[static_cast<std::size_t>(i)];
    int next = -1;
    long least = 0;
    for (int j = i + 1; j < size_; ++j) {
      const Rough& to = c_[static_cast<std::size_t>(j)];
      if (to.value == 0) continue;
      const long overtakes = (from.exponent - to.exponent) / (j - i);
      if (next < 0 || overtakes <= least) {
        next = j;
        least = overtakes;
      }
    }
    if (next < 0) return std::nullopt;
    if ((from.value < 0) != (c_[static_cast<std::size_t>(next)].value < 0)) return least;
    i = next;
  }
  return std::nullopt;
}

std::optional<WideBracket> WidePolynomial::bracket(const std::optional<WidePoint>& low, const WidePoint& high,
                                                   int sign_low) const noexcept {
  if (sign_low == 0) return std::nullopt;
  WidePoint from, to = high;
  if (low) {
    from = *low;
  } else {
    // So near to 0, c0 exceeds the others.
    constexpr long kBelow = 3;
    long least = to.exponent - kBelow;
    for (int i = 1; i < size_; ++i) {
      const Rough& c = c_[static_cast<std::size_t>(i)];
      if (c.value == 0 && c.error == 0) continue;
      const long difference = c_[0].exponent - c.exponent;
      least = std::min(least, difference / i - kBelow);
    }
    from = {0.5, least, 0};
    if (sign_at(from) != sign_low) return std::nullopt;
  }
  // Makes a point that is inside, and hardly ever a root, an end of the bracket.
  const auto take = [&](long exponent) {
    constexpr double kUnlikely = 0x1.5bf0a8b145769p-1;  // e / 4
    const WidePoint x = {kUnlikely, exponent, 0};
    const int sign = sign_at(x);
    if (sign != 0) (sign == sign_low ? from : to) = x;
    return sign != 0;
  };
  if (const auto hint = crossing_exponent()) {
    for (const long exponent : {*hint - 1, *hint + 3}) {
      if (exponent > from.exponent && exponent < to.exponent) take(exponent);
    }
  }
  while (to.exponent - from.exponent > 1) {
    const long middle = from.exponent + (to.exponent - from.exponent) / 2;
    if (!take(middle)) return std::nullopt;
  }
  const Window here = window(to.exponent);
  double a = from.significand * (from.exponent < to.exponent ? 0.5 : 1), b = to.significand;
  if (!(a < b)) return std::nullopt;

  double t = 0.5 * (a + b);
  {
    double x = a, y = b;
    constexpr int kIterations = 60;
    for (int i = 0; i < kIterations; ++i) {
      double value = 0, slope = 0;
      for (int k = size_ - 1; k >= 0; --k) {
        slope = slope * t + value;
        value = value * t + here.c[static_cast<std::size_t>(k)];
      }
      ((value < 0) == (sign_low < 0) ? x : y) = t;
      double next = t - value / slope;
      if (!(next >= x && next <= y)) next = 0.5 * (x + y);
      const bool converged = std::fabs(next - t) <= 0x1p-51;
      t = next;
      if (converged) break;
    }
  }
  for (const double margin : {0x1p-44, 0x1p-36}) {
    const double before = t - margin * t, after = t + margin * t;
    const bool below = before <= a || sign_in(here, before, 0) == sign_low;
    const bool above = after >= b || sign_in(here, after, 0) == -sign_low;
    if (below && above) return WideBracket{std::max(before, a), std::min(after, b), to.exponent};
  }
  return std::nullopt;
}

}  // namespace touchstone::numbers
