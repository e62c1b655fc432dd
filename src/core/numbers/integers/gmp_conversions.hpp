// Exact numbers to and from GMP's.
// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include "numbers/integers/exact_number.hpp"

namespace touchstone::numbers {

Exact exact_from_integer(const mpz_class& integer);
mpq_class to_rational(const Exact& x);

}  // namespace touchstone::numbers
