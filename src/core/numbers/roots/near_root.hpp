// Real roots in [0, 1] of polynomials with integer coefficients of a fixed number of limbs, each known as a
// double-double with a bound on its error, and the signs of other polynomials there. Doubles decide where their bounds
// allow it, and integers of fixed sizes what doubles leave open, above all whether a polynomial vanishes at a root.
// What both leave open raises a doubt: real_root.hpp decides everything, and takes longer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <variant>

#include "numbers/doubles/bounded.hpp"
#include "numbers/integers/fixed_int.hpp"
#include "numbers/integers/small_int.hpp"
#include "numbers/roots/polynomial.hpp"
#include "numbers/roots/real_root.hpp"

namespace touchstone::numbers {

/// A sticky flag, as those of floating-point exceptions are, raised where a root, a sign or a quotient stays open. Each
/// decision has one. Its roots keep a pointer to it, and computing goes on with any value. The flag is read once, at
/// the end: where it is raised, the result is worth nothing.
class Doubt {
 public:
  void raise() noexcept { raised_ = true; }
  bool raised() const noexcept { return raised_; }

 private:
  bool raised_ = false;
};

template <int Limbs>
class NearRoots;

/// A root of a polynomial with coefficients |c| < 2^(192 Limbs - 3), where other polynomials of degree at most 2, with
/// coefficients |c| < 2^(128 Limbs - 3), have signs and quotients. Coefficients are FixedInt of at most so many limbs,
/// or SmallInt: then |c| < 2^60, and those of the other polynomials are below 2^kMostSmallBits. Where a polynomial of
/// more limbs has greater coefficients, it raises the doubt, which outlives the root.
template <int Limbs>
class NearRoot {
 public:
  using Short = FixedInt<2 * Limbs>;
  using Long = FixedInt<3 * Limbs>;
  using Quadratic = Polynomial<Short, 2>;
  using SmallQuadratic = Polynomial<SmallInt, 2>;
  using Cubic = Polynomial<Long, 3>;
  using List = NearRoots<Limbs>;

  /// The double `time` in [0, 1], as a root of this multiplicity.
  static NearRoot at_double(double time, int multiplicity, Doubt& doubt);

  int multiplicity() const noexcept { return multiplicity_; }

  /// The neighbouring doubles around the root: the largest double <= it and the smallest >= it.
  double lower() const noexcept { return lower_; }
  double upper() const noexcept { return upper_; }

  static constexpr int kMostSmallBits = 44;

  /// The sign of q at the root.
  template <class R, int D>
  int sign_at(const Polynomial<R, D>& q) const {
    static_assert(D <= 2);
    if (const Fraction* fraction = std::get_if<Fraction>(&exact_)) return sign_at_fraction(q, *fraction);
    std::array<double, D + 1> c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = to_double(q.c[i]);
    const ValueNear value = value_near(c.data(), D + 1, lower_);
    if (value.value > value.error) return 1;
    if (value.value < -value.error) return -1;
    return close_sign_at(as_quadratic(q));
  }

  /// The sign of q just after the root, or just before it. Zero only for q == 0.
  template <class R, int D>
  int sign_after(const Polynomial<R, D>& q) const {
    return sign_beside(q, 1);
  }
  template <class R, int D>
  int sign_before(const Polynomial<R, D>& q) const {
    return sign_beside(q, -1);
  }

  /// The sign of (this - other), of (this - value).
  int compare(const NearRoot& other) const;
  int compare(double value) const noexcept { return upper_ <= value ? (lower_ == value ? 0 : -1) : 1; }

  /// numerator(root) / denominator(root) within an absolute error of 2^-50.5, given that the quotient lies in [0, 1]
  /// where the denominator is not zero at the root. Nothing where it is zero, or too small.
  template <class R>
  std::optional<double> known_quotient(const Polynomial<R, 2>& numerator, const Polynomial<R, 2>& denominator) const {
    return close_quotient(as_quadratic(numerator), as_quadratic(denominator));
  }
  /// The same, with a doubt in place of nothing.
  template <class R>
  double quotient(const Polynomial<R, 2>& numerator, const Polynomial<R, 2>& denominator) const {
    const std::optional<double> quotient = known_quotient(numerator, denominator);
    return quotient ? *quotient : raise_doubt();
  }

 private:
  friend class NearRoots<Limbs>;

  /// numerator / denominator; the denominator is positive, both are below 2^61.
  struct Fraction {
    std::int64_t numerator, denominator;
  };
  /// The same in numbers of any size that a rational root of a cubic may need.
  struct Quotient {
    FixedInt<6 * Limbs> numerator, denominator;
  };
  /// The only root of a polynomial of degree 2 or 3 within `reach` of `near`, a simple one.
  struct Isolated {
    Cubic p;
    int degree;
    int sign_after;  ///< of p, just after the root
    double reach;
  };

  NearRoot() = default;

  template <class R, int D>
  static Quadratic widened(const Polynomial<R, D>& q) {
    Quadratic result;
    for (int i = 0; i <= D; ++i) result[i] = q[i].template widened<2 * Limbs>();
    return result;
  }

  template <int Q, int D>
  static int sign_at_fraction(const Polynomial<FixedInt<Q>, D>& q, const Fraction& at) {
    if (at.numerator == 0) return sign_of(q[0]);
    if (at.numerator == at.denominator) {
      if constexpr (D == 1) return sign_of(q[0] + q[1]);
      if constexpr (D == 2) return sign_of(q[0] + q[1] + q[2]);
    }
    return sign_at_quotient_of(q, FixedInt<1>::integer(at.numerator), FixedInt<1>::integer(at.denominator));
  }
  /// With denominators so small, the terms of a small polynomial's value at a fraction are below
  /// 2^(kMostSmallBits + 2 * 8), and there are three of them.
  static constexpr std::int64_t kLittle = std::int64_t{1} << 8;
  template <int D>
  static int sign_at_fraction(const Polynomial<SmallInt, D>& q, const Fraction& at) {
    if (at.denominator <= kLittle) {
      return sign_at_quotient_of(q, SmallInt::integer(at.numerator), SmallInt::integer(at.denominator));
    }
    Polynomial<FixedInt<1>, D> wide;
    for (int i = 0; i <= D; ++i) wide[i] = q[i].template widened<1>();
    return sign_at_fraction(wide, at);
  }
  /// q at n / d, times d to the power of its degree.
  template <class P, class N>
  static auto value_at_quotient(const P& q, const N& n, const N& d) {
    constexpr int D = static_cast<int>(std::tuple_size_v<decltype(q.c)>) - 1;
    const auto linear = q[0] * d + q[1] * n;
    if constexpr (D == 1) {
      return linear;
    } else {
      return linear * d + q[2] * n * n;
    }
  }
  template <class P, class N>
  static int sign_at_quotient_of(const P& q, const N& n, const N& d) {
    return sign_of(value_at_quotient(q, n, d));
  }

  template <class R, int D>
  int sign_beside(const Polynomial<R, D>& q, int side) const {
    const int sign = sign_at(q);
    if (sign != 0) return sign;
    if constexpr (D == 1) {
      return side * sign_of(q[1]);
    } else {
      return side * sign_beside(Polynomial<R, 1>{{q[1], q[2] + q[2]}}, side);
    }
  }

  template <int Q, int D>
  Quadratic as_quadratic(const Polynomial<FixedInt<Q>, D>& q) const {
    static_assert(Q <= 2 * Limbs);
    return widened(q);
  }
  template <int D>
  static SmallQuadratic as_quadratic(const Polynomial<SmallInt, D>& q) {
    SmallQuadratic result;
    for (int i = 0; i <= D; ++i) result[i] = q[i];
    return result;
  }

  /// A time n / 2^kFineBits near an isolated root, which is certainly less than kFineReach / 2^kFineBits away.
  using FineTime = FixedInt<2>;
  static constexpr int kFineBits = 126;
  static constexpr double kFineUnit = 0x1p-126;
  static constexpr int kFineReach = 16;
  struct Fine {
    FineTime n;
    double moved;  ///< at least its distance from near_
  };
  std::optional<Fine> fine(const Isolated& root) const;
  static BoundedPair as_pair(const Fine& fine);
  void sharpen();
  int fine_sign_at(const Quadratic& q, const Isolated& root) const;

  /// This root as a quotient, when it is held as one.
  std::optional<Quotient> rational() const;
  template <class P>
  BoundedPair value_of(const P& q, const BoundedPair& time) const;
  template <class P>
  int sign_of_close(const P& q) const;
  int close_sign_at(const Quadratic& q) const;
  int close_sign_at(const SmallQuadratic& q) const;
  template <class P>
  std::optional<double> quotient_of(const P& numerator, const P& denominator) const;
  std::optional<double> close_quotient(const Quadratic& numerator, const Quadratic& denominator) const;
  std::optional<double> close_quotient(const SmallQuadratic& numerator, const SmallQuadratic& denominator) const;
  /// The sign of q at this isolated root, exact however small the value is. Nothing where q has two roots close to it.
  /// @param value  of q at near_, within its bound
  template <class Q>
  std::optional<int> sign_by_remainder(const Q& q, const BoundedPair& value, const Isolated& root) const;
  /// Whether q certainly has this isolated root. Its value there is too small for doubles.
  bool certainly_vanishes(const Quadratic& q, const Isolated& root) const;
  /// Finds lower_ and upper_; a root that is a double becomes a Fraction.
  void settle();
  int sign_of_rest(double time) const;
  template <class N>
  int sign_of_rest(const N& numerator, const N& denominator) const;
  int raise_doubt() const {
    doubt_->raise();
    return 0;
  }

  std::variant<Fraction, Quotient, Isolated> exact_;
  BoundedPair near_;
  double lower_ = 0, upper_ = 0;
  int multiplicity_ = 1;
  Doubt* doubt_ = nullptr;
};

/// Whether a polynomial certainly has no root in [0, limit], 0 <= limit <= 1: in doubles, its Bernstein coefficients
/// over that range have one sign.
inline bool certainly_without_root(const Polynomial<SmallInt, 2>& p, double limit) noexcept {
  const auto exact = [](double x) { return Bounded{x, 0}; };
  const auto coefficient = [&p](int i) {  // its conversion may round
    const double c = to_double(p[i]);
    return Bounded{c, kRounding * std::fabs(c)};
  };
  const Bounded first = coefficient(0), slope = coefficient(1) * exact(limit);
  const int sign = first.sign();
  return sign != 0 && (exact(2) * first + slope).sign() == sign &&
         (first + slope + coefficient(2) * exact(limit) * exact(limit)).sign() == sign;
}
template <int Q>
bool certainly_without_root(const Polynomial<FixedInt<Q>, 2>&, double) noexcept {
  return false;
}

/// The distinct roots, ascending, in [0, limit], 0 <= limit <= 1, each with its multiplicity.
template <int Limbs>
class NearRoots {
 public:
  using Root = NearRoot<Limbs>;

  /// Of p, which is not identically zero. Sums of 6 of its coefficients are below the limit of NearRoot, too.
  template <int Q, int D>
  NearRoots(const Polynomial<FixedInt<Q>, D>& p, double limit, Doubt& doubt) : limit_(limit), doubt_(doubt) {
    static_assert(Q <= (D <= 2 ? 2 : 3) * Limbs);  // those of a quadratic may be those of another's root
    if (has_no_root(p)) return;
    Cubic cubic;
    for (int i = 0; i <= D; ++i) cubic[i] = p[i].template widened<3 * Limbs>();
    isolate(cubic);
  }
  template <int D>
  NearRoots(const Polynomial<SmallInt, D>& p, double limit, Doubt& doubt) : limit_(limit), doubt_(doubt) {
    if (has_no_root(p)) return;
    SmallCubic cubic;
    for (int i = 0; i <= D; ++i) cubic[i] = p[i];
    isolate(cubic);
  }
  NearRoots(const NearRoots&) = delete;
  NearRoots& operator=(const NearRoots&) = delete;

  int size() const noexcept { return size_; }
  const Root& operator[](int i) const noexcept { return *roots_[static_cast<std::size_t>(i)]; }

 private:
  using Cubic = typename Root::Cubic;
  using SmallCubic = Polynomial<SmallInt, 3>;
  using Pairs = std::array<BoundedPair, 4>;

  void isolate(const Cubic& p);
  void isolate(const SmallCubic& p);
  template <class P>
  void isolate_all(P p);
  template <class P>
  void isolate_inside(const P& p, int size);
  template <class P>
  void isolate_quadratic(const P& p);
  template <class P>
  void push_close(const P& p, const BoundedPair& middle, double apart);
  bool isolate_rational_quadratic(const SmallCubic& p);
  bool isolate_rational_cubic(const SmallCubic& p);
  template <class P>
  void isolate_cubic(const P& p);
  template <class P>
  bool isolate_beside_double(const P& p);
  void push_repeated(const Cubic& p);
  void push_double(double time, int multiplicity);
  void push_fraction(std::int64_t n, std::int64_t d, int multiplicity);
  template <class N>
  void push_quotient(const N& numerator, const N& denominator, int multiplicity);
  template <class P>
  void push_simple(const P& p, int size, double low, double high, int sign_low);
  void push(Root&& root);
  void sort_last();

  double limit_;
  Doubt& doubt_;
  int size_ = 0;
  std::array<std::optional<Root>, 3> roots_;
};

extern template class NearRoot<1>;
extern template class NearRoot<2>;
extern template class NearRoots<1>;
extern template class NearRoots<2>;

}  // namespace touchstone::numbers
