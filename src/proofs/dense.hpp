// Polynomials in t of any degree with exact coefficients. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "numbers/coefficients.hpp"
#include "numbers/exact_number.hpp"

namespace touchstone::proofs {

using numbers::Exact;

/// Coefficient i belongs to t^i. Leading coefficients may be zero; no coefficients are the zero polynomial.
using Dense = std::vector<Exact>;

Dense operator+(const Dense& p, const Dense& q);
Dense operator-(const Dense& p, const Dense& q);
Dense operator*(const Dense& p, const Dense& q);
bool is_zero(const Dense& p);
Exact value(const Dense& p, const Exact& t);

inline numbers::Coefficients coefficients(const Dense& p) { return {p.data(), static_cast<int>(p.size())}; }

/// The sign that the Bernstein coefficients of p over [from, to] have: 1 or -1 when all of them have it, 0 when they
/// differ or one is zero. With `open`, which leaves out `to`, only the first one must not be zero.
int sign_over(const Dense& p, const Exact& from, const Exact& to, bool open);

using DenseVector = std::array<Dense, 3>;
DenseVector operator-(const DenseVector& a, const DenseVector& b);
Dense dot(const DenseVector& a, const DenseVector& b);
DenseVector cross(const DenseVector& a, const DenseVector& b);

}  // namespace touchstone::proofs
