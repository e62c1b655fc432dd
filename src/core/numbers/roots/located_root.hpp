// A simple root of a polynomial of degree at most 3: hints in doubles, and the proof that a root is near them.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "numbers/doubles/bounded.hpp"
#include "numbers/integers/small_int.hpp"
#include "numbers/roots/polynomial.hpp"

namespace touchstone::numbers {

/// A double near one of a cubic's roots, if all are real the first one after 0; only a hint.
double hint_of_first(const Polynomial<SmallInt, 3>& p) noexcept;

/// A double near the one root in (low, high), where the polynomial has the sign `sign_low` at low and the other one at
/// high; only a hint.
double hint_between(const BoundedPair* c, int size, double low, double high, int sign_low) noexcept;

/// A root, and how far it is from others at least.
struct Located {
  BoundedPair near;
  double reach;  ///< the polynomial has no other root so close to `near`
};

/// The one root of a polynomial in (low, high) inside [0, 1], a simple one; `sign_low` is the polynomial's sign at low,
/// and the other one is its sign at high. Nothing where the bounds are not good enough.
/// @param near  its hint
std::optional<Located> locate(const BoundedPair* c, int size, double low, double high, int sign_low,
                              double near) noexcept;

}  // namespace touchstone::numbers
