// An interval around one root of a polynomial, as small as it takes. SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "numbers/coefficients.hpp"
#include "numbers/exact_number.hpp"

namespace touchstone::numbers {

/// An open dyadic interval in which a polynomial p of degree 2 or 3 has exactly one root, a simple one, and changes its
/// sign; or the root itself, where that turned out to be dyadic: then low() == high(). Functions that take p want the
/// one it was made for.
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

  /// Uses what `compare` says of the value; true when the root is the value itself.
  bool keep_side(Coefficients p, const Exact& value);

  /// Uses that the root lies between two values.
  void keep_between(const Exact& low, const Exact& high) {
    if (low > low_) low_ = low;
    if (high < high_) high_ = high;
  }

  /// q's sign at the root, if q has one strict sign all over the bracket, as its Bernstein coefficients there show, or
  /// if the bracket is the root. q's formal degree is at most 3.
  std::optional<int> sign_over(Coefficients q) const;

  /// Makes the bracket smaller: by a factor of at least 2, and as a rule of 2^40 and more, the more the oftener it is
  /// called.
  void narrow(Coefficients p);

 private:
  bool narrow_by_model(Coefficients p);
  bool narrow_by_formula(Coefficients cubic);
  bool keep_within(Coefficients p, const Exact& middle, const Exact& radius);

  Exact low_, high_;
  int sign_low_ = 0;
  int corrections_ = 0;      // that the next call makes
  bool by_formula_ = false;  // was done
};

/// p(t).
Exact evaluate(Coefficients p, const Exact& t);

}  // namespace touchstone::numbers
