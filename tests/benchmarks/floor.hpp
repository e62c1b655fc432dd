// The least that anyone could do with a query: read it and compute V's Bernstein coefficients in doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <touchstone/query.hpp>

namespace touchstone::benchmarks {

/// b0, 3 b1, 3 b2 and b3 of V over [0, 1], without any bound on their error. Kinds without a V get that of their
/// corners and zeros, which costs the same.
std::array<double, 4> bernstein_coefficients(const Query& query) noexcept;

}  // namespace touchstone::benchmarks
