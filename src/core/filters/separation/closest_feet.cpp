// SPDX-License-Identifier: MIT
#include "filters/separation/closest_feet.hpp"

#include <cmath>
#include <cstddef>

namespace touchstone::filters {
namespace {

/// The facet with its signs: from u and w, in doubles.
SignedFacet with_signs(const Facet& facet, const Vector& u, const Vector& w) noexcept {
  SignedFacet found;
  found.facet = facet;
  const Vector n = normal_of(facet, u, w, 0.0, 1.0);
  // An edge is measured along the two axes that count, and a plane's normal, without its sign, along all.
  const Vector along = facet.sort == Sort::edge ? edge_of(facet.free, u, w) : n;
  double largest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool counts = facet.sort == Sort::plane || (facet.sort == Sort::face) == (k == facet.axis);
    found.sigma[k] = !counts ? 0 : n[k] < 0 ? -1 : 1;
    if (!counts || std::fabs(along[k]) <= largest) continue;
    largest = std::fabs(along[k]);
    found.axis = k;
    found.sign = (along[k] < 0) == (facet.sort == Sort::plane && facet.sign < 0) ? 1 : -1;
  }
  return found;
}

}  // namespace

Hint ClosestFeet::hint_at(const StepAt& iterate) const noexcept {
  Hint hint;
  if (metric_ == Metric::euclidean) {
    hint.p = closest(domain_, iterate.r, iterate.u, iterate.w);
    hint.free = free_parameters(domain_, hint.p);
    const Vector c = combined(iterate.r, iterate.u, iterate.w, hint.p.s, hint.p.q);
    hint.distance = std::sqrt(dot(c, c));
    return hint;
  }
  const auto [facet, distance] = FacetSearch(domain_, iterate).best();
  hint.facet = with_signs(facet, iterate.u, iterate.w);
  hint.distance = distance;
  hint.free = facet.free;
  hint.p = {facet.s, facet.q};
  return hint;
}

bool ClosestFeet::name(const Hint& hint, const Feet<BoundedPair>& feet, Answer& answer) const noexcept {
  const auto weight = [&feet](std::size_t i) { return quotient(feet.weights[i], feet.units[i]); };
  double s = hint.p.s, q = hint.p.q, rest = 0;
  switch (hint.free) {
    case Free::none: break;
    case Free::s: s = weight(0); break;
    case Free::q: q = weight(0); break;
    case Free::sum:
      q = weight(0);
      s = 1 - q;
      break;
    case Free::both:
      s = weight(0);
      q = weight(1);
      if (domain_ == Domain::triangle) rest = weight(2);
      break;
  }
  if (!(s + q + rest >= 0)) return false;  // NaN
  name_closest(kind_, s, q, hint.free, answer);
  if (hint.free == Free::both && domain_ == Domain::triangle) answer.weights_b[0] = rest;
  answer.contact = true;
  return true;
}

}  // namespace touchstone::filters
