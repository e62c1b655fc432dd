// Signs, quotients and comparisons at a sparse root.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "numbers/sparse_root.hpp"
#include "numbers/sparse_values.hpp"

namespace touchstone::numbers {

using Rewind = SparseScratch::Rewind;

int SparseRoot::sign_at(const Sparse* q, int size) const {
  size = actual_size(q, size);
  if (size == 0) return 0;
  if (size == 1) return q[0].sign();
  if (exact_) return sign_of_value(q, size, low_, divisor_);
  for (int round = 0; round < kRounds; ++round) {
    if (const int sign = quick_sign(q, size); sign != 0) return sign;
    if (round == 0 && is_near_zero() && narrow()) {
      if (exact_) break;
      continue;
    }
    const int first = sign_of_value(q, size, low_, divisor_), last = sign_of_value(q, size, high_, divisor_);
    if (first * last < 0) {
      constexpr int kPatience = 2;
      if (const auto sign = close_sign_at(q, size, first, round >= kPatience)) return *sign;
    }
    // Between its ends, a monotone q has none but the sign that it has at both of them, or at one.
    if (first * last >= 0 && is_monotone(q, size)) return first != 0 ? first : last;
    if (!narrow() || exact_) break;
  }
  return exact_ ? sign_of_value(q, size, low_, divisor_) : raise_doubt();
}

int SparseRoot::quick_sign_at(const Polynomial<Sparse, 2>& q) const {
  const int size = actual_size(q.c.data(), 3);
  if (size <= 1) return size == 0 ? 0 : q[0].sign();
  return exact_ ? 0 : quick_sign(q.c.data(), size);
}

int SparseRoot::quick_sign(const Sparse* q, int size) const {
  if (near_) return sign_near(q, size);
  const Rewind rewind;
  return value_near<Few>(q, size, 0).sign();
}

/// In the bracket; q's size is 2 or 3.
bool SparseRoot::is_monotone(const Sparse* q, int size) const {
  if (size == 2) return true;
  const Rewind rewind;
  const Sparse slope[] = {q[1], q[2] + q[2]};
  return sign_of_value(slope, 2, low_, divisor_) * sign_of_value(slope, 2, high_, divisor_) > 0;
}

/// The value of q anywhere in the bracket, times divisor^(size - 1), q's size being 2 or 3. On the way from low it
/// changes by at most the length of the bracket times its greatest slope, which it has at an end. A rougher bound on it
/// will do where so many bits of the value are certain then.
template <class N>
N SparseRoot::value_near(const Sparse* q, int size, int bits) const {
  N near = value_at<N>(q, size, low_, divisor_);
  if (exact_) return near;
  const long width = (high_ - low_).bits();
  long steepest = q[1].bits();
  if (size == 3) {
    // with time in [0, 1]
    const long bound = divisor_.bits() + std::max(steepest, q[2].bits() + 1) + 1;
    N rough = near;
    rough.error = std::max(near.error, width + bound) + 1;
    if (rough.value.bits() - 3 - bits >= rough.error) return rough;
    const Sparse slope[] = {q[1], q[2] + q[2]};
    const N first = value_at<N>(slope, 2, low_, divisor_), last = value_at<N>(slope, 2, high_, divisor_);
    steepest = std::max(first.most_bits(), last.most_bits());
  }
  near.error = std::max(near.error, width + steepest) + 1;
  return near;
}

/// The sign of q at the root r of p, where q has opposite signs at the ends of the bracket: `sign_low` at low. So q has
/// one root s in the bracket, as p has. It has the sign `sign_low` at r where r is before s, that is where p at s has
/// the sign that it has at high. The remainder of p by q, a linear one, has this sign, up to that of a power of q2.
std::optional<int> SparseRoot::close_sign_at(const Sparse* q, int size, int sign_low, bool at_any_cost) const {
  const auto& p = p_;
  const auto before = [&](int sign_of_p_at_s) { return sign_low * sign_of_p_at_s * -sign_low_; };
  if (size == 2) {
    const bool negative = q[1].sign() < 0;
    return before(sign_of_value(p.data(), size_, negative ? q[0] : -q[0], negative ? -q[1] : q[1]));
  }
  if (size_ == 2) {
    const bool negative = p[1].sign() < 0;
    return sign_of_value(q, size, negative ? p[0] : -p[0], negative ? -p[1] : p[1]);
  }
  // q2 p - p2 q, or q2^2 p - ..., see NearRoot::certainly_vanishes.
  const auto remainder = [&](auto n) {
    using N = decltype(n);
    const N q0(q[0]), q1(q[1]), q2(q[2]), p0(p[0]), p1(p[1]), p2(p[2]);
    if (size_ == 3) return std::array<N, 2>{q2 * p0 - p2 * q0, q2 * p1 - p2 * q1};
    const N p3(p[3]);
    const N s0 = q2 * p0, s1 = q2 * p1 - p3 * q0, s2 = q2 * p2 - p3 * q1;
    return std::array<N, 2>{q2 * s0 - s2 * q0, q2 * s1 - s2 * q1};
  };
  const int factor = size_ == 3 ? q[2].sign() : 1;
  const auto [first, last] = signs_of_linear(remainder, low_, high_, divisor_);
  if (first == last) return before(factor * first);
  if (!at_any_cost) return std::nullopt;
  // The remainder has a root in the bracket, or at one of its ends: q's sign there tells on which side of it s is.
  const int slope = sign_of_any([&](auto n) { return remainder(n)[1]; });
  const int at_root = sign_of_any([&](auto n) {
    using N = decltype(n);
    const auto l = remainder(n);
    return (N(q[0]) * l[1] - N(q[1]) * l[0]) * l[1] + N(q[2]) * l[0] * l[0];
  });
  // s is after the remainder's root where q has the sign `sign_low` at that.
  return before(factor * slope * at_root * sign_low);
}

int SparseRoot::compare(const SparseRoot& other) const {
  settle();
  other.settle();
  if (lower_ == upper_ || other.lower_ == other.upper_ || lower_ != other.lower_) {
    return lower_ != other.lower_ ? (lower_ < other.lower_ ? -1 : 1)
                                  : (upper_ > other.upper_) - (upper_ < other.upper_);
  }
  const Rewind rewind;
  if ((high_ * other.divisor_ - other.low_ * divisor_).sign() < 0) return -1;
  if ((low_ * other.divisor_ - other.high_ * divisor_).sign() > 0) return 1;
  return exact_ && other.exact_ ? 0 : raise_doubt();
}

double SparseRoot::quotient(const Polynomial<Sparse, 2>& numerator, const Polynomial<Sparse, 2>& denominator) const {
  if (!doubt_->quotients()) return 0;
  // For n and d off by e |d| each, n / d is off by at most e (1 + |n / d|) / (1 - e); |n / d| is at most about 1.
  constexpr int kGreatestError = -58;
  double quotient = 0;
  const auto is_good = [&](auto number) {
    using N = decltype(number);
    const Rewind rewind;
    const N d = value_near<N>(denominator.c.data(), 3, -kGreatestError);
    const N n = value_near<N>(numerator.c.data(), 3, -kGreatestError);
    if (std::max(n.error, d.error) - (d.value.bits() - 3) > kGreatestError) return false;
    quotient = scaled(approximate(n.value) / approximate(d.value), 0);
    return true;
  };
  if (is_near_zero()) narrow();
  for (int round = 0; round < kRounds; ++round) {
    if (is_good(Few()) || is_good(More())) return quotient > 0 ? std::min(quotient, 1.0) : 0.0;  // never -0
    if (exact_ || !narrow()) break;
  }
  doubt_->raise();
  return 0;
}

}  // namespace touchstone::numbers
