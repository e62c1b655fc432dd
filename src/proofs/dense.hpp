// Polynomials in t of any degree with exact coefficients.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "geometry/vector.hpp"
#include "numbers/integers/exact_number.hpp"
#include "numbers/roots/coefficients.hpp"

namespace touchstone::proofs {

using numbers::Exact;

/// Coefficient i belongs to t^i. Leading coefficients may be zero; no coefficients are the zero polynomial.
struct Dense : std::vector<Exact> {
  using std::vector<Exact>::vector;
  Dense(std::vector<Exact>&& coefficients) : std::vector<Exact>(std::move(coefficients)) {}
};

Dense operator+(const Dense& p, const Dense& q);
Dense operator-(const Dense& p, const Dense& q);
Dense operator-(const Dense& p);
Dense operator*(const Dense& p, const Dense& q);
Dense operator*(const Exact& factor, const Dense& p);
bool is_zero(const Dense& p);

/// scale p; the scale is often 1.
Dense scaled_by(const Dense& scale, const Dense& p);

Exact value(const Dense& p, const Exact& t);

/// Whether g divides p, over the rational numbers. g's leading coefficient is not zero.
bool divides(const Dense& g, Dense p);

/// Multiplies the polynomials by the power of two that makes all their coefficients integers, not all of them even.
void make_short_integers(std::initializer_list<Dense*> polynomials);

/// The same with any positive number: integers without a common factor.
void remove_common_factor(std::initializer_list<Dense*> polynomials);

inline numbers::Coefficients coefficients(const Dense& p) { return {p.data(), static_cast<int>(p.size())}; }

/// What the Bernstein coefficients after the first one may be, for `sign_over`.
enum class Inner {
  not_zero,  ///< as the first one
  any_zero,  ///< zero too
};

/// The sign that the Bernstein coefficients of p over [from, to] have: 1 or -1 when all of them have it, 0 when they
/// differ or one is zero that must not be. The first one must not be zero.
int sign_over(const Dense& p, const Exact& from, const Exact& to, Inner inner);

/// Whether no Bernstein coefficient of p over [from, to] is negative.
bool nowhere_negative(const Dense& p, const Exact& from, const Exact& to);

using DenseVector = geometry::Vector<Dense>;

}  // namespace touchstone::proofs
