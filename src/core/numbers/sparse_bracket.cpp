// Brackets of sparse roots: found from a wide one, narrowed, and placed between doubles.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include "numbers/neighbours.hpp"
#include "numbers/sparse_root.hpp"
#include "numbers/sparse_values.hpp"

namespace touchstone::numbers {
namespace {

using Rewind = SparseScratch::Rewind;

/// The value at x / divisor and the slope there by x, both times divisor^(size - 1).
template <class N>
std::array<N, 2> value_and_slope(const Sparse* c, int size, const Sparse& x, const Sparse& divisor) noexcept {
  const N at(x);
  N value(c[size - 1]), slope, power(divisor);
  for (int i = size - 2; i >= 0; --i) {
    slope = multiply_add(slope, at, value);
    value = multiply_add(value, at, divisor.is_one() ? N(c[i]) : N(c[i]) * power);
    if (i > 0 && !divisor.is_one()) power = power * N(divisor);
  }
  return {value, slope};
}

/// About the least positive root of the polynomial with these coefficients, which is below 2^most and the only one
/// there: significand 2^exponent, 1/2 <= significand <= 1. Only a hint.
struct Hint {
  double significand;
  long exponent;
};
Hint least_root(const std::array<Approximation, 4>& c, int size, long most) noexcept {
  std::array<double, 4> scaled_to;
  const auto scale = [&](long exponent) {
    long greatest = c[0].exponent;
    for (int i = 1; i < size; ++i) {
      const Approximation& x = c[static_cast<std::size_t>(i)];
      if (x.significand != 0) greatest = std::max(greatest, x.exponent + i * exponent);
    }
    for (int i = 0; i < size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      scaled_to[at] = scaled(c[at], i * exponent - greatest);
    }
  };
  const auto value = [&](double t) {
    double sum = scaled_to[static_cast<std::size_t>(size - 1)];
    for (int i = size - 2; i >= 0; --i) sum = sum * t + scaled_to[static_cast<std::size_t>(i)];
    return sum;
  };
  const bool negative = c[0].significand < 0;
  // The exponents below which c[0] exceeds the sum of the others, and at which the root is passed.
  long low = most - 1, high = most;
  for (int i = 1; i < size; ++i) {
    const Approximation& x = c[static_cast<std::size_t>(i)];
    if (x.significand == 0) continue;
    const long difference = c[0].exponent - x.exponent;
    low = std::min(low, (difference - (difference < 0 ? i - 1 : 0)) / i - 3);
  }
  while (high - low > 1) {
    const long middle = low + (high - low) / 2;
    scale(middle);
    ((value(1) < 0) == negative ? low : high) = middle;
  }
  scale(high);
  double from = 0.5, to = 1, t = 0.75;
  constexpr int kIterations = 60;
  for (int i = 0; i < kIterations; ++i) {
    double sum = 0, slope = 0;
    for (int k = size - 1; k >= 0; --k) {
      slope = slope * t + sum;
      sum = sum * t + scaled_to[static_cast<std::size_t>(k)];
    }
    ((sum < 0) == negative ? from : to) = t;
    double next = t - sum / slope;
    if (!(next >= from && next <= to)) next = 0.5 * (from + to);
    const bool converged = std::fabs(next - t) <= 0x1p-51;
    t = next;
    if (converged) break;
  }
  return {t, high};
}

}  // namespace

SparseRoot SparseRoot::at_double(double time, int multiplicity, Doubt& doubt) {
  SparseRoot root;
  root.doubt_ = &doubt;
  root.multiplicity_ = multiplicity;
  root.become_exact(sparse(time), Sparse(1));
  root.lower_ = root.upper_ = time;
  root.settled_ = true;
  return root;
}

std::optional<SparseRoot> SparseRoot::simple(const Coefficients& p, int size, const Sparse& low, const Sparse& high,
                                             const Sparse& divisor, int sign_low, Doubt& doubt) {
  SparseRoot root;
  root.p_ = p;
  root.size_ = size;
  root.low_ = low;
  root.high_ = high;
  root.divisor_ = divisor;
  root.sign_low_ = sign_low;
  root.doubt_ = &doubt;
  if (root.locate()) return root;
  doubt.raise();
  return std::nullopt;
}

std::optional<SparseRoot> SparseRoot::between(const Sparse& low, const Sparse& high, const Polynomial<Sparse, 3>& p,
                                              int sign_low, Doubt& doubt) {
  const int size = actual_size(p.c.data(), 4);
  return simple(p.c, size, low, high, Sparse(1), sign_low, doubt);
}

void SparseRoot::become_exact(const Sparse& numerator, const Sparse& divisor) const {
  low_ = high_ = numerator;
  divisor_ = divisor;
  exact_ = true;
  near_.reset();
}

/// Where p's sign at x / divisor_, between low_ and high_, tells on which side of it the root is. False where x is not
/// inside.
bool SparseRoot::keep_side(const Sparse& x) const {
  if ((x - low_).sign() <= 0 || (high_ - x).sign() <= 0) return false;
  const int sign = sign_of_value(p_.data(), size_, x, divisor_);
  if (sign == 0) {
    become_exact(x, divisor_);
  } else {
    (sign == sign_low_ ? low_ : high_) = x;
  }
  return true;
}

/// By a Newton step from x, which is near the root.
bool SparseRoot::narrow_around(const Sparse& x) const {
  Approximation value, slope;
  {
    const Rewind rewind;
    const auto both =
        first_certain([&](auto n) { return value_and_slope<decltype(n)>(p_.data(), size_, x, divisor_); });
    value = approximate(both[0]);
    slope = approximate(both[1]);
  }
  if (value.significand == 0) {
    // Beside the bracket it would be another root of p.
    if ((x - low_).sign() <= 0 || (high_ - x).sign() <= 0) return false;
    become_exact(x, divisor_);
    return true;
  }
  if (slope.significand == 0) return false;
  const Approximation step = -(value / slope);
  const Sparse middle = x + sparse(step);
  for (const long bits : {40L, 10L, 1L}) {
    const Sparse margin = sparse(0.5, step.exponent - bits);
    const Sparse from = middle - margin, to = middle + margin;
    if ((from - low_).sign() <= 0 || (high_ - to).sign() <= 0) continue;
    const int sign_from = sign_of_value(p_.data(), size_, from, divisor_);
    if (sign_from == -sign_low_) continue;
    const int sign_to = sign_of_value(p_.data(), size_, to, divisor_);
    if (sign_to == sign_low_) continue;
    if (sign_from == 0) {
      become_exact(from, divisor_);
    } else if (sign_to == 0) {
      become_exact(to, divisor_);
    } else {
      low_ = from;
      high_ = to;
    }
    return true;
  }
  return false;
}
/// Narrows until q, a cubic that has this sign at the root or next to it, has it at the low end too, or at the high
/// one.
bool SparseRoot::narrow_until(const Coefficients& q, int sign, bool at_low) const {
  for (int round = 0; round < kRounds; ++round) {
    if (sign_of_value(q.data(), 4, at_low ? low_ : high_, divisor_) == sign) return true;
    if (exact_ || !narrow()) break;
  }
  return false;
}

bool SparseRoot::narrow() const { return exact_ || rebase() || narrow_around((low_ + high_) * sparse(0.5)); }

/// Finds a narrow bracket of the root in the wide one: from the end that is closer to the root, as a root that is close
/// to it is known best by its distance.
bool SparseRoot::locate() {
  if (locate_widely()) return true;
  const Sparse middle = (low_ + high_) * sparse(0.5);
  if (!keep_side(middle)) return false;
  if (exact_) return true;
  const bool from_low = (high_ - middle).is_zero();
  const Sparse base = from_low ? low_ : high_;
  const double direction = from_low ? 1 : -1;

  const bool whole = divisor_.is_one();
  std::array<Approximation, 4> near{};
  {
    const Rewind rewind;
    const auto coefficients = [&](const auto& c) {
      for (int i = 0; i < size_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        near[at] = approximate(Sparse(c[at]));
        if (i % 2 == 1) near[at].significand *= direction;
      }
    };
    const auto c = shifted<More>(p_.data(), size_, base, divisor_);
    if (std::all_of(c.begin(), c.begin() + size_, [](const More& x) { return x.sign() != 0; })) {
      coefficients(c);
    } else {
      coefficients(shifted<Sparse>(p_.data(), size_, base, divisor_));
    }
  }
  const Hint hint = least_root(near, size_, approximate(high_ - low_).exponent);
  if (const auto fraction = whole ? small_fraction(hint.significand) : std::nullopt) {
    SparseRoot same = *this;
    same.divisor_ = sparse(fraction->denominator);
    same.low_ = low_ * same.divisor_;
    same.high_ = high_ * same.divisor_;
    const Sparse x = base * same.divisor_ + sparse(direction * fraction->numerator, hint.exponent);
    // A root that is much closer to the fraction than the hint is known best by its distance from the fraction.
    constexpr long kCloser = 45;
    if (same.narrow_around(x) && (same.exact_ || approximate(same.high_ - x).exponent < hint.exponent - kCloser)) {
      *this = same;
      return true;
    }
  }
  return narrow_around(base + sparse(direction * hint.significand, hint.exponent));
}

void SparseRoot::settle() const {
  if (settled_) return;
  settled_ = true;
  const auto is_wide = [&] {  // for the distance of doubles
    const Rewind rewind;
    constexpr long kBits = 55;
    return !exact_ && (high_ - low_).bits() > high_.bits() - divisor_.bits() - kBits;
  };
  if (is_wide()) rebase();
  Approximation at = approximate(low_) / approximate(divisor_);
  double time = scaled(at, 0);
  constexpr int kSteps = 8;
  int i = 0;
  const auto below = [&](double x) {  // the sign of low - x
    const Rewind rewind;
    return (low_ - sparse(x) * divisor_).sign();
  };
  while (time > 0 && below(time) < 0 && i++ < kSteps) time = before(time);
  while (below(after(time)) >= 0 && i++ < kSteps) time = after(time);
  for (; i < kSteps; ++i) {
    if (exact_) {
      lower_ = time;
      upper_ = below(time) == 0 ? time : after(time);
      return;
    }
    const double next = after(time);
    const Sparse x = sparse(next) * divisor_;
    if ((high_ - x).sign() <= 0) {
      lower_ = time;
      upper_ = next;
      return;
    }
    keep_side(x);
    if (below(next) >= 0) time = next;
  }
  doubt_->raise();
}

}  // namespace touchstone::numbers
