// The number types of the oracle: integers and rationals without limit, and integer polynomials in the time t.
// SPDX-License-Identifier: MIT
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Polynomial.h>

#ifndef CGAL_HAS_THREADS
#error "CGAL without thread support keeps plain static variables: the oracle would not be safe to call from two threads"
#endif

namespace touchstone::oracle {

using Integer = CGAL::Gmpz;
using Rational = CGAL::Gmpq;
using Polynomial = CGAL::Polynomial<Integer>;

}  // namespace touchstone::oracle
