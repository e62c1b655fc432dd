// A facet at one time, in double-doubles: see max_entry.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "filters/separation/entry_step.hpp"
#include "filters/separation/facet.hpp"

namespace touchstone::filters {

// Errors in double-doubles, in units of e^2 = 2^-106. A coordinate of u(t) is off by 40 U (see entry_step.hpp), one of
// p by 80 S, one of a by 80 S + 4 (S + d). A coordinate of n is exact for a face; off by 80 S for an edge; for a plane,
// a difference of two products of 2 W U at most, by 2 (40 + 40 + 10) U W + 20 U W: less than 256 U W. h is a sum of
// three products, n_k a_k. With N the largest that |n_k| may be, 1, S or 2 U W: the products are off by (256 + 84 + 10)
// N (S + d) each at most, and the sums by 12 N (S + d): less than 1100 N (S + d) in all.
constexpr double kFacetError = 2048 * 0x1p-106;

struct PreciseFacet {
  PreciseVector n, p, a, e;  ///< e of an edge; for a plane n without its sign
  PreciseVector r, u, w;
  Vector sign;  ///< sigma: 1, -1 or, along axes that do not count, 0
  DoubleDouble h;
};

/// The largest that a coordinate of the facet's normal may be.
inline double normal_size(const Step& step, const Facet& facet) noexcept {
  return facet.sort == Sort::face ? 1 : facet.sort == Sort::edge ? step.size : step.size * step.size;
}

/// The facet at t, against a level. The signs of n are those of the doubles nearest to it.
inline PreciseFacet precise_facet(const PreciseStep& precise, const Facet& facet, double t,
                                  const DoubleDouble& level) noexcept {
  PreciseFacet at_t;
  at_t.r = at(precise.r, t);
  at_t.u = at(precise.u, t);
  at_t.w = at(precise.w, t);
  at_t.p = at_t.r;
  for (std::size_t k = 0; k < 3; ++k) {
    if (facet.s == 1) at_t.p[k] = numbers::normalised(at_t.p[k] - at_t.u[k]);
    if (facet.q == 1) at_t.p[k] = numbers::normalised(at_t.p[k] - at_t.w[k]);
  }
  at_t.n = normal_of<DoubleDouble>(facet, at_t.u, at_t.w, {0, 0}, {1, 0});
  for (DoubleDouble& x : at_t.n.c) x = numbers::normalised(x);
  at_t.e = edge_of(facet.free, at_t.u, at_t.w);
  at_t.h = {0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool counts = facet.sort == Sort::plane || (facet.sort == Sort::face) == (k == facet.axis);
    at_t.sign[k] = !counts ? 0 : rounded(at_t.n[k]) < 0 ? -1 : 1;
    at_t.a[k] = numbers::normalised(at_t.p[k] - at_t.sign[k] * level);
    if (counts) at_t.h = numbers::normalised(at_t.h + at_t.n[k] * at_t.a[k]);
  }
  return at_t;
}

}  // namespace touchstone::filters
