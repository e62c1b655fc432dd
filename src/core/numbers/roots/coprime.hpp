// A quick proof that two polynomials have no common root.
// SPDX-License-Identifier: MIT
#pragma once

#include "numbers/roots/coefficients.hpp"

namespace touchstone::numbers {

/// True proves that p and q have no common root, over the complex numbers. False proves nothing.
/// @param p  its leading coefficient is not zero
bool certainly_coprime(Coefficients p, Coefficients q) noexcept;

}  // namespace touchstone::numbers
