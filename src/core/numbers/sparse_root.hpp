// Real roots in [0, 1] of polynomials with sparse coefficients, each known by a bracket that is as narrow as the sizes
// of the numbers ask for, and the signs of other polynomials there. Every sign is that of a sparse number, and so
// exact; doubles only tell where to look. What stays open raises a doubt, as in near_root.hpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "numbers/near_root.hpp"
#include "numbers/polynomial.hpp"
#include "numbers/sparse.hpp"
#include "numbers/wide_polynomial.hpp"

namespace touchstone::numbers {

class SparseRoots;

/// A root of a polynomial of degree at most 3. The doubt outlives it, and so does the scratch of the numbers.
class SparseRoot {
 public:
  using List = SparseRoots;

  /// The double `time` in [0, 1], as a root of this multiplicity.
  static SparseRoot at_double(double time, int multiplicity, Doubt& doubt);

  /// The root of p between low and high, where p has one, a simple one, and the sign `sign_low` next to low. Nothing,
  /// and a doubt, where it is not found.
  static std::optional<SparseRoot> between(const Sparse& low, const Sparse& high, const Polynomial<Sparse, 3>& p,
                                           int sign_low, Doubt& doubt);

  int multiplicity() const noexcept { return multiplicity_; }
  double lower() const {
    settle();
    return lower_;
  }
  double upper() const {
    settle();
    return upper_;
  }

  /// The sign of q at the root.
  template <int D>
  int sign_at(const Polynomial<Sparse, D>& q) const {
    static_assert(D <= 2);
    return sign_at(q.c.data(), D + 1);
  }

  /// The same where it takes little; else 0.
  int quick_sign_at(const Polynomial<Sparse, 2>& q) const;

  /// The sign of q just after the root, or just before it. Zero only for q == 0.
  template <int D>
  int sign_after(const Polynomial<Sparse, D>& q) const {
    return sign_beside(q, 1);
  }
  template <int D>
  int sign_before(const Polynomial<Sparse, D>& q) const {
    return sign_beside(q, -1);
  }

  /// The sign of (this - other), of (this - value).
  int compare(const SparseRoot& other) const;
  int compare(double value) const { return upper() <= value ? (lower_ == value ? 0 : -1) : 1; }

  /// As NearRoot's.
  double quotient(const Polynomial<Sparse, 2>& numerator, const Polynomial<Sparse, 2>& denominator) const;

 private:
  friend class SparseRoots;
  using Coefficients = std::array<Sparse, 4>;

  SparseRoot() = default;

  int sign_at(const Sparse* q, int size) const;
  /// At a root that is not exact, from leading digits; 0 where these do not tell.
  int quick_sign(const Sparse* q, int size) const;
  template <class N>
  N value_near(const Sparse* q, int size, int bits) const;
  bool is_monotone(const Sparse* q, int size) const;
  std::optional<int> close_sign_at(const Sparse* q, int size, int sign_low, bool at_any_cost) const;
  template <int D>
  int sign_beside(const Polynomial<Sparse, D>& q, int side) const {
    const int sign = sign_at(q);
    if (sign != 0) return sign;
    if constexpr (D == 1) {
      return side * sign_of(q[1]);
    } else {
      return side * sign_beside(Polynomial<Sparse, 1>{{q[1], q[2] + q[2]}}, side);
    }
  }

  static std::optional<SparseRoot> simple(const Coefficients& p, int size, const Sparse& low, const Sparse& high,
                                          const Sparse& divisor, int sign_low, Doubt& doubt);
  void become_exact(const Sparse& numerator, const Sparse& divisor) const;
  bool locate();

  // sparse_root_near.cpp
  std::optional<WidePoint> point_at(const Sparse& x) const;
  bool locate_widely();
  bool is_near_zero() const noexcept { return near_ && near_->base.is_zero(); }
  void take(Sparse base, int side, const WideBracket& bracket) const;
  bool rebase() const;
  bool rebase_at(Sparse base) const;
  int sign_near(const Sparse* q, int size) const;

  bool narrow_around(const Sparse& x) const;
  /// How often a bracket is narrowed at most where it is too wide. Each time adds some 90 bits.
  static constexpr int kRounds = 8;
  bool narrow() const;
  bool narrow_until(const Coefficients& q, int sign, bool at_low) const;
  bool keep_side(const Sparse& x) const;
  void settle() const;
  int raise_doubt() const {
    doubt_->raise();
    return 0;
  }

  // While it is not exact: p has one root, a simple one, in the open interval between low_ / divisor_ and
  // high_ / divisor_, and the sign sign_low_ at low_. Else it is low_ / divisor_ = high_ / divisor_. The divisor is
  // positive.
  Coefficients p_;
  int size_ = 0;
  mutable Sparse low_, high_, divisor_;
  mutable bool exact_ = false;
  int sign_low_ = 0;

  /// The root, not an exact one, is (base + side x) / divisor_, with x within the slack of the distance.
  struct Near {
    Sparse base;
    int side;
    WidePoint distance;
  };
  mutable std::optional<Near> near_;

  mutable bool settled_ = false;
  mutable double lower_ = 0, upper_ = 0;
  int multiplicity_ = 1;
  Doubt* doubt_ = nullptr;
};

/// As that of NearRoot's coefficients, but left to the roots.
inline bool certainly_without_root(const Polynomial<Sparse, 2>&, double) noexcept { return false; }

/// The distinct roots, ascending, in [0, limit], 0 <= limit <= 1, each with its multiplicity.
class SparseRoots {
 public:
  /// Of p, which is not identically zero.
  template <int D>
  SparseRoots(const Polynomial<Sparse, D>& p, double limit, Doubt& doubt) : limit_(limit), doubt_(doubt) {
    SparseRoot::Coefficients c;
    for (int i = 0; i <= D; ++i) c[static_cast<std::size_t>(i)] = p[i];
    isolate(c, D + 1);
  }
  SparseRoots(const SparseRoots&) = delete;
  SparseRoots& operator=(const SparseRoots&) = delete;

  int size() const noexcept { return size_; }
  const SparseRoot& operator[](int i) const noexcept { return *roots_[static_cast<std::size_t>(i)]; }

 private:
  using Coefficients = SparseRoot::Coefficients;

  void isolate(Coefficients p, int size);
  static std::array<int, 4> exact_bernstein_signs(const Coefficients& p, int size);
  void isolate_inside(const Coefficients& p, int size, const std::array<int, 4>& signs);
  void isolate_quadratic(const Coefficients& p);
  void isolate_cubic(const Coefficients& p);
  void isolate_between_critical_points(const Coefficients& p);
  void push_double(double time, int multiplicity);
  void push_quotient(const Sparse& numerator, const Sparse& denominator, int multiplicity);
  void push_simple(const Coefficients& p, int size, const Sparse& low, const Sparse& high, const Sparse& divisor,
                   int sign_low);
  void push(SparseRoot&& root);

  double limit_;
  Doubt& doubt_;
  int size_ = 0;
  std::array<std::optional<SparseRoot>, 3> roots_;
};

}  // namespace touchstone::numbers
