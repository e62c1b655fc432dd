// An interval around one root of a polynomial that narrows as far as a caller needs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "numbers/integers/exact_list.hpp"
#include "numbers/integers/exact_number.hpp"
#include "numbers/roots/coefficients.hpp"

namespace touchstone::numbers {

/// The coefficients of q(point + x) as a polynomial in x.
ExactList taylor_coefficients(Coefficients q, const Exact& point);

/// The Bernstein coefficients of a polynomial over an interval, all times one positive integer that depends on the
/// formal degree only. The polynomial's values there, times that integer, lie between the least and the greatest.
class BernsteinForm {
 public:
  BernsteinForm(Coefficients q, const Exact& low, const Exact& high);

  const Exact* begin() const { return c_.begin(); }
  const Exact* end() const { return c_.end(); }
  const Exact& operator[](int i) const { return c_[static_cast<std::size_t>(i)]; }

  /// The number of changes of sign in their order, zeros left out. It is at least the number of roots inside, with
  /// multiplicity, and differs from it by an even number (Descartes' rule).
  int variations() const;

  /// The forms over both halves of the interval, cut at low + position / 64 (high - low).
  std::pair<BernsteinForm, BernsteinForm> split(int position) const;

 private:
  explicit BernsteinForm(int size) : c_(size) {}

  ExactList c_;
};

/// An open dyadic interval in which a polynomial p of degree 2 or more has exactly one root, a simple one, and changes
/// its sign. Where the root is found to be dyadic, low() == high() is the root itself. The argument p of the functions
/// below must be the polynomial that the bracket was made for.
class RootBracket {
 public:
  RootBracket() = default;
  /// p(low) and p(high) have opposite signs, `sign_low` being p(low)'s.
  RootBracket(const Exact& low, const Exact& high, int sign_low) : low_(low), high_(high), sign_low_(sign_low) {}

  const Exact& low() const { return low_; }
  const Exact& high() const { return high_; }
  int sign_low() const { return sign_low_; }
  bool is_root() const { return low_ == high_; }

  /// The sign of (root - value); exact.
  int compare(Coefficients p, const Exact& value) const;

  /// Narrows to the side of the value on which the root lies; true when the root is the value itself.
  bool keep_side(Coefficients p, const Exact& value);

  /// Narrows to between two values, where the root is known to lie.
  void keep_between(const Exact& low, const Exact& high) {
    if (low > low_) low_ = low;
    if (high < high_) high_ = high;
  }

  /// q's sign at the root, if q has one strict sign all over the bracket, as its Bernstein coefficients there show, or
  /// if the bracket is the root.
  std::optional<int> sign_over(Coefficients q) const;

  /// Narrows the bracket by a factor of at least 2, and usually of 2^40 or more. The factor grows from call to call.
  void narrow(Coefficients p);

 private:
  bool narrow_by_model(Coefficients p);
  bool narrow_by_formula(Coefficients cubic);
  bool keep_within(Coefficients p, const Exact& middle, const Exact& radius);

  Exact low_, high_;
  int sign_low_ = 0;
  int corrections_ = 0;      // how many the next call of narrow makes
  bool by_formula_ = false;  // narrow_by_formula has been called
};

/// p(t).
Exact evaluate(Coefficients p, const Exact& t);

}  // namespace touchstone::numbers
