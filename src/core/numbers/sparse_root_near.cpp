// A sparse root as a base and a distance from it that is a double of any exponent: the quick way to a root and to signs
// there.
// SPDX-License-Identifier: MIT
#include <optional>

#include "numbers/sparse_root.hpp"
#include "numbers/sparse_values.hpp"

namespace touchstone::numbers {

using Rewind = SparseScratch::Rewind;

/// x, which is not negative, as a point without a slack. Nothing where it has too many bits, or the divisor is not 1.
std::optional<WidePoint> SparseRoot::point_at(const Sparse& x) const {
  const Approximation a = approximate(x);
  if (!divisor_.is_one() || !(x - sparse(a)).is_zero()) return std::nullopt;
  return WidePoint{a.significand, a.exponent, 0};
}

void SparseRoot::take(Sparse base, int side, const WideBracket& bracket) const {
  const Sparse near = base + sparse(side * bracket.low, bracket.exponent);
  const Sparse far = base + sparse(side * bracket.high, bracket.exponent);
  low_ = side > 0 ? near : far;
  high_ = side > 0 ? far : near;
  near_ = Near{base, side, bracket.point()};
}

/// Finds a narrow bracket in the wide one, where doubles know the root well by its distance from 0 or from an end.
bool SparseRoot::locate_widely() {
  std::optional<WideBracket> bracket;
  {
    const Rewind rewind;
    const auto low = point_at(low_), high = point_at(high_);
    if (low && high) {
      const WidePolynomial p(p_.data(), size_);
      bracket = p.bracket(low->significand == 0 ? std::nullopt : low, *high, sign_low_);
    }
  }
  if (bracket) take(Sparse(), 1, *bracket);
  return bracket || rebase_at(high_) || rebase_at(low_);
}

/// Makes the root known by its distance from a base that is in its bracket, and so close to it. False where doubles do
/// not know this distance well.
bool SparseRoot::rebase_at(Sparse base) const {
  std::optional<WideBracket> bracket;
  int side = 0;
  bool vanishes = false;
  {
    const Rewind rewind;
    const Sparse below = base - low_, above = high_ - base;
    if (below.sign() < 0 || above.sign() < 0) return false;
    const auto find = [&](auto n) {
      const auto c = shifted<decltype(n)>(p_.data(), size_, base, divisor_);
      const int sign = c[0].sign();
      side = sign * sign_low_;
      if (side == 0) return false;
      const WidePolynomial p(c.data(), size_), onwards = side > 0 ? p : p.mirrored();
      // Rounded, the end may be out of the bracket.
      constexpr double kInside = 1 - 0x1p-50;
      const Approximation end = approximate(side > 0 ? above : below);
      const WidePoint last{kInside * end.significand, end.exponent, 0};
      if (end.significand != 0 && onwards.sign_at(last) == -sign) bracket = onwards.bracket(std::nullopt, last, sign);
      return bracket.has_value();
    };
    if (!find(Few()) && !find(More()) && !find(Sparse())) {
      vanishes = side == 0 && below.sign() > 0 && above.sign() > 0;
    }
  }
  if (bracket) take(base, side, *bracket);
  if (vanishes) become_exact(base, divisor_);
  return bracket || vanishes;
}

/// A small fraction, where one is close, or else a double.
bool SparseRoot::rebase() const {
  if (!near_) return false;
  const Near near = *near_;
  const auto fraction = divisor_.is_one() && is_near_zero() ? small_fraction(near.distance.significand) : std::nullopt;
  if (fraction) {
    SparseRoot same = *this;
    same.divisor_ = sparse(fraction->denominator);
    same.low_ = low_ * same.divisor_;
    same.high_ = high_ * same.divisor_;
    // A root that is much closer to the fraction than the double is known best by its distance from the fraction.
    constexpr long kCloser = 45;
    if (same.rebase_at(sparse(fraction->numerator, near.distance.exponent)) &&
        (same.exact_ || same.near_->distance.exponent < near.distance.exponent - kCloser)) {
      low_ = same.low_;
      high_ = same.high_;
      divisor_ = same.divisor_;
      exact_ = same.exact_;
      near_ = same.near_;
      return true;
    }
  }
  return rebase_at(near.base + sparse(near.side * near.distance.significand, near.distance.exponent));
}

/// The sign of q at the root, where doubles know it; else 0.
int SparseRoot::sign_near(const Sparse* q, int size) const {
  const auto sign_of = [&](const WidePolynomial& from_base) {
    return (near_->side > 0 ? from_base : from_base.mirrored()).sign_at(near_->distance);
  };
  const Rewind rewind;
  if (is_near_zero() && divisor_.is_one()) return sign_of(WidePolynomial(q, size));
  const auto sign_by = [&](auto n) {
    const auto c = shifted<decltype(n)>(q, size, near_->base, divisor_);
    return sign_of(WidePolynomial(c.data(), size));
  };
  const int sign = sign_by(Few());
  return sign != 0 ? sign : sign_by(More());
}

}  // namespace touchstone::numbers
