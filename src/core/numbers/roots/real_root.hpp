// Real roots of polynomials with exact coefficients, and the signs of other polynomials there.
// Signs are exact, zero included: no approximation of the root decides them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "numbers/integers/exact_number.hpp"
#include "numbers/integers/fixed_int.hpp"
#include "numbers/roots/coefficients.hpp"
#include "numbers/roots/polynomial.hpp"
#include "numbers/roots/root_bracket.hpp"

namespace touchstone::numbers {

/// The coefficients times one power of two that makes the largest about 1, for hints. Each is within a relative error
/// of 2^-52 where it does not underflow. Zero beyond p's size.
struct ScaledDoubles {
  std::array<double, kMostDegree + 1> c;
  long exponent;  ///< coefficient i is about c[i] 2^exponent
};
ScaledDoubles scaled_to_doubles(Coefficients p);

/// The value of a polynomial of degree at most kMostDegree, from coefficients within a relative error of 2^-51, at any
/// time between `lower`, in [0, 1], and the next double: off by at most `error`, which is NaN or infinite where nothing
/// is known.
struct ValueNear {
  double value;
  double error;
};
ValueNear value_near(const double* c, int size, double lower) noexcept;

/// One real root in [0, 1]: either a rational, or the only root of a polynomial inside an open dyadic interval, where
/// that polynomial changes sign. Its functions cache narrower intervals, const ones too: two threads must not share it.
class RealRoot {
 public:
  /// numerator / denominator; the denominator is not zero.
  static RealRoot rational(const Exact& numerator, const Exact& denominator, int multiplicity);

  /// The one root of p, a simple one, in the open interval (low, high) inside [0, 1]; p(low) and p(high) have opposite
  /// signs, `sign_low` being p(low)'s. p's leading coefficient is not zero.
  static RealRoot isolated(Coefficients p, const Exact& low, const Exact& high, int sign_low);

  /// Of this root in the polynomial that was isolated.
  int multiplicity() const { return multiplicity_; }
  void set_multiplicity(int multiplicity) { multiplicity_ = multiplicity; }

  /// Numerator and denominator, which is positive, of a root that is held as a rational. A rational root may be held
  /// otherwise.
  const Exact& numerator() const { return numerator_; }
  const Exact& denominator() const { return denominator_; }

  /// The neighbouring doubles around the root: the largest double <= it and the smallest >= it.
  double lower() const { return lower_; }
  double upper() const { return upper_; }

  /// The sign of q at the root; exact.
  int sign_at(Coefficients q) const;
  /// The same, tried in doubles first.
  int quick_sign_at(Coefficients q) const;
  template <class R, int D>
  int sign_at(const Polynomial<R, D>& q) const {
    if constexpr (!std::is_same_v<R, Exact> && D <= 2) {
      if (small_denominator_ != 0) return sign_at_small_rational(q);
    }
    const int sign = sign_in_doubles(q);
    return sign != 0 ? sign : sign_at(Coefficients(to_exact(q)));
  }

  /// The sign of q just after the root: at all t in (root, root + delta) for some delta > 0. Zero only for q == 0.
  int sign_after(Coefficients q) const;
  template <class R, int D>
  int sign_after(const Polynomial<R, D>& q) const {
    const int sign = sign_at(q);
    return sign != 0 ? sign : sign_after(Coefficients(to_exact(q)));
  }

  /// The sign of q just before the root. Zero only for q == 0.
  int sign_before(Coefficients q) const;
  template <class R, int D>
  int sign_before(const Polynomial<R, D>& q) const {
    const int sign = sign_at(q);
    return sign != 0 ? sign : sign_before(Coefficients(to_exact(q)));
  }

  /// The sign of (this - other), of (this - value); exact.
  int compare(const RealRoot& other) const;
  int compare(const Exact& value) const;

  /// 1 - this root.
  RealRoot reversed() const;

  /// numerator(root) / denominator(root) within an absolute error of 2^-50.5, given that the quotient lies in [0, 1]
  /// and the denominator is not zero at the root.
  double quotient(Coefficients numerator, Coefficients denominator) const;
  template <class R>
  double quotient(const Polynomial<R, 2>& numerator, const Polynomial<R, 2>& denominator) const {
    const Polynomial<Exact, 2> exact_numerator = to_exact(numerator);
    const Polynomial<Exact, 2> exact_denominator = to_exact(denominator);
    return quotient(Coefficients(exact_numerator), Coefficients(exact_denominator));
  }

  /// numerator(root) / denominator(root), or one of the two doubles beside it; neither is zero at the root. Infinity
  /// beyond the greatest double, and never 0.
  double ratio(Coefficients numerator, Coefficients denominator) const;

  /// For a person: "1/3", "root of 3 t^3 + -1 t + -1 in [0x1.8p-1, 0x1.9p-1]".
  std::string to_string() const;

 private:
  RealRoot() = default;

  template <class R, int D>
  int sign_in_doubles(const Polynomial<R, D>& q) const {
    std::array<double, D + 1> c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = to_double(q.c[i]);
    return certain_sign(c.data(), D + 1);
  }

  /// At a rational root of two small integers: q times the square of the denominator, without overflow as long as
  /// |q's coefficients| < 2^(64 Limbs - 1).
  template <int Limbs, int D>
  int sign_at_small_rational(const Polynomial<FixedInt<Limbs>, D>& q) const {
    using Factor = FixedInt<1>;
    const Factor n = Factor::integer(small_numerator_);
    const Factor d = Factor::integer(small_denominator_);
    const auto linear = q[0] * d + q[1] * n;
    if constexpr (D == 1) {
      return sign_of(linear);
    } else {
      return sign_of(linear * d + q[2] * n * n);
    }
  }

  /// The sign at the root of a polynomial of degree at most kMostDegree, from coefficients within a relative error of
  /// 2^-51; 0 when uncertain.
  int certain_sign(const double* c, int size) const {
    const ValueNear value = value_near(c, size, lower_);
    return value.value > value.error ? 1 : value.value < -value.error ? -1 : 0;
  }

  Exact homogeneous_value(Coefficients q, int degree) const;  ///< q(root) times denominator_^degree, of a rational root
  int sign_beside(Coefficients q, int side) const;            // side 1: just after, -1: just before
  void find_small_integers();
  void find_neighbouring_doubles();
  double estimate() const;
  Coefficients polynomial() const { return {degree_ <= kShort ? p_.data() : long_p_.data(), degree_ + 1}; }
  bool vanishes_at_isolated(Coefficients q) const;
  void become_rational(const Exact& value);

  bool is_rational_ = false;
  int multiplicity_ = 1;
  Exact numerator_, denominator_;  // of a rational root; the denominator is positive
  static constexpr std::int64_t kSmall = std::int64_t{1} << 60;
  // The same in integers below kSmall; 0 and 0 where they are larger.
  std::int64_t small_numerator_ = 0, small_denominator_ = 0;
  int degree_ = 0;  // of the polynomial of an isolated root
  static constexpr int kShort = 3;
  std::array<Exact, kShort + 1> p_;  // for a degree up to kShort
  std::vector<Exact> long_p_;        // for a higher one
  RootBracket bracket_;              // no wider than between the neighbouring doubles
  mutable RootBracket narrow_;       // the narrowest so far
  double lower_ = 0, upper_ = 0;
};

/// Roots, ascending and distinct. The first few, all roots of the polynomials of straight motion, need no allocation.
class RootList {
 public:
  RootList() noexcept {}  // NOLINT(modernize-use-equals-default): the roots are not made yet
  RootList(RootList&& other) noexcept {
    for (int i = 0; i < other.stored_; ++i) push(std::move(other.begin()[i]));
    more_ = std::move(other.more_);
  }
  RootList& operator=(RootList&&) = delete;
  ~RootList() { std::destroy_n(begin(), stored_); }

  int size() const { return stored_ + static_cast<int>(more_.size()); }
  const RealRoot& operator[](int i) const {
    if (i >= kStored) return more_[static_cast<std::size_t>(i - kStored)];
    return std::launder(reinterpret_cast<const RealRoot*>(storage_))[i];
  }
  void push(RealRoot&& root) {
    if (stored_ == kStored) return more_.push_back(std::move(root));
    ::new (static_cast<void*>(begin() + stored_++)) RealRoot(std::move(root));
  }

 private:
  RealRoot* begin() noexcept { return std::launder(reinterpret_cast<RealRoot*>(storage_)); }

  static constexpr int kStored = 6;

  alignas(RealRoot) unsigned char storage_[kStored * sizeof(RealRoot)];
  int stored_ = 0;
  std::vector<RealRoot> more_;  // after the stored ones
};

/// The distinct roots of p in the closed interval [0, limit], 0 <= limit <= 1, ascending, each with its multiplicity
/// over the real line. p has formal degree at most kMostDegree and is not identically zero.
RootList isolate_roots(Coefficients p, const Exact& limit);

/// Whether p has certainly no root in [0, 1]: its Bernstein coefficients have one sign, those at the ends strictly. R
/// leaves room for sums of 6 coefficients.
template <class R, int D>
bool has_no_root(const Polynomial<R, D>& p) {
  const int first = sign_of(p[0]);
  if (first == 0) return false;
  const auto agrees = [first](const R& inner) { return first * sign_of(inner) >= 0; };
  if constexpr (D == 1) {
    return sign_of(p[0] + p[1]) == first;
  } else if constexpr (D == 2) {
    return sign_of(p[0] + p[1] + p[2]) == first && agrees(p[0] + p[0] + p[1]);
  } else {
    static_assert(D == 3);
    const R twice = p[0] + p[0];
    const R thrice = twice + p[0];
    return sign_of(p[0] + p[1] + p[2] + p[3]) == first && agrees(thrice + p[1]) && agrees(thrice + p[1] + p[1] + p[2]);
  }
}

template <class R, int D>
RootList isolate_roots(const Polynomial<R, D>& p, const Exact& limit) {
  if (has_no_root(p)) return {};
  return isolate_roots(Coefficients(to_exact(p)), limit);
}

}  // namespace touchstone::numbers
