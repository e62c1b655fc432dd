// The facets of the sum of the polygon of all differences of two elements and a cube, and the search for the one whose
// direction keeps the elements farthest apart.
//
// In the largest-axis metric, the elements are within d of each other when the polygon of all differences c = r - s u -
// q w meets the cube [-d, d]^3. The sum of the polygon and the cube has facets of three sorts. So these directions n
// are enough to tell (separating axes of two convex bodies):
//   face:  n is an axis: a face of the cube and a corner of the polygon;
//   edge:  n = axis x e: an edge of the cube and an edge e of the polygon;
//   plane: n = u x w: a corner of the cube and the polygon itself.
// D(t) is the largest value of n . c / |n|_1 over these n, each at the corner c at which n . c is least.
//
// Near the entry one facet decides. Let p be a corner of the polygon on it, sigma_k the sign of n_k, and
// a = p - d sigma. Then n . a = n . p - d |n|_1 is a polynomial of degree 1, 2 or 3, which falls to 0 at the entry.
// There c = d sigma along the axes with n_k != 0 is a linear system for the point on the facet. Its solution must lie
// inside the polygon's edge or plane, and within d along the other axes. As n . a falls, so does the level at which
// the system's solution lies, and with it D.
// The other corners have greater n . c, and every n_k of an edge or plane is not zero. So no other point is as near.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "filters/separation/entry_walk.hpp"

namespace touchstone::filters {

enum class Sort : std::uint8_t { face, edge, plane };

/// A facet by its normal, and the corner of the polygon on which it stands. An edge e runs from that corner: c = p - x
/// e for x in [0, 1].
struct Facet {
  Sort sort = Sort::face;
  std::size_t axis = 0;    ///< of a face or an edge of the cube
  Free free = Free::none;  ///< the parameters that are free on it
  double s = 0, q = 0;     ///< of the corner
  double sign = 1;         ///< n is the normal times this
};

/// axis x e.
template <class N>
geometry::Vector<N> axis_cross(std::size_t axis, const geometry::Vector<N>& e, const N& zero) noexcept {
  geometry::Vector<N> n = {{zero, zero, zero}};
  const std::size_t k = (axis + 1) % 3, l = (axis + 2) % 3;
  n[k] = zero - e[l];
  n[l] = e[k];
  return n;
}

/// The polygon's edge along which a parameter is free: the corner goes from p to p - e.
template <class V>
V edge_of(Free free, const V& u, const V& w) noexcept {
  return free == Free::s ? u : free == Free::q ? w : w - u;
}

/// The facet's normal from u and w, the same sort of numbers.
template <class N>
geometry::Vector<N> normal_of(const Facet& facet, const geometry::Vector<N>& u, const geometry::Vector<N>& w,
                              const N& zero, const N& one) noexcept {
  geometry::Vector<N> n = {{zero, zero, zero}};
  if (facet.sort == Sort::face) n[facet.axis] = one;
  if (facet.sort == Sort::edge) n = axis_cross(facet.axis, edge_of(facet.free, u, w), zero);
  if (facet.sort == Sort::plane) n = cross(u, w);
  for (N& x : n.c) x = facet.sign < 0 ? -x : x;
  return n;
}

/// The facet whose direction keeps the elements farthest apart, and its n . c / |n|_1.
struct BestFacet {
  Facet facet;
  double distance = 0;  ///< 0 when no direction keeps them apart
};

/// Searches the facets at one time, in doubles. Only a hint. With n = axis x e along an axis k, n . r is (e x r)_k, and
/// so on: a few cross products give the values of all edges.
class FacetSearch {
 public:
  FacetSearch(Domain domain, const StepAt& step) noexcept : domain_(domain) {
    const auto& [t, r, u, w, n, until] = step;
    for (std::size_t k = 0; k < 3; ++k) consider({Sort::face, k, Free::none, 0, 0, 1}, r[k], u[k], w[k], 1);
    if (domain_ == Domain::point) return;
    const Vector u_r = cross(u, r);
    if (domain_ == Domain::segment) {
      for (std::size_t k = 0; k < 3; ++k) consider({Sort::edge, k, Free::s, 0, 0, 1}, u_r[k], 0, 0, norm(u, k));
      return;
    }
    const Vector w_r = cross(w, r), u_w = cross(u, w);
    for (std::size_t k = 0; k < 3; ++k) {
      consider({Sort::edge, k, Free::s, 0, 0, 1}, u_r[k], 0, u_w[k], norm(u, k));
      consider({Sort::edge, k, Free::q, 0, 0, 1}, w_r[k], -u_w[k], 0, norm(w, k));
    }
    if (domain_ == Domain::triangle) {
      const Vector e = w - u;
      for (std::size_t k = 0; k < 3; ++k) {
        consider({Sort::edge, k, Free::sum, 0, 0, 1}, w_r[k] - u_r[k], -u_w[k], -u_w[k], norm(e, k));
      }
    }
    consider({Sort::plane, 0, Free::both, 0, 0, 1}, dot(u_w, r), 0, 0, dual_norm(u_w, Metric::max));
  }

  BestFacet best() const noexcept {
    if (!(value_ > 0)) return {};
    return {facet_, value_ / norm_};
  }

 private:
  /// |axis x e|_1.
  static double norm(const Vector& e, std::size_t axis) noexcept {
    return std::fabs(e[(axis + 1) % 3]) + std::fabs(e[(axis + 2) % 3]);
  }

  /// @param r, u, w  the products of the facet's normal with these
  void consider(const Facet& facet, double r, double u, double w, double norm) noexcept {
    const double low = r - greatest_at_corners(domain_, u, w);
    const double high = r + greatest_at_corners(domain_, -u, -w);
    const double value = std::max(low, -high);
    if (!(value * norm_ > value_ * norm)) return;
    value_ = value;
    norm_ = norm;
    facet_ = facet;
    facet_.sign = low > -high ? 1 : -1;
    stand(facet_.sign * u, facet_.sign * w);
  }

  /// The corner at which n . c is least, from n . u and n . w. On an edge, its first end.
  void stand(double u, double w) noexcept {
    Facet& facet = facet_;
    switch (facet.free) {
      case Free::both: return;
      case Free::sum: facet.s = 1; return;
      case Free::none:
        if (domain_ == Domain::point) return;
        if (domain_ == Domain::triangle) {
          facet.s = u > 0 && u >= w ? 1 : 0;
          facet.q = w > 0 && w > u ? 1 : 0;
          return;
        }
        break;
      case Free::s:
      case Free::q: break;
    }
    if (domain_ == Domain::triangle) return;  // the other parameter is 0 on its edges u and w
    if (facet.free != Free::s) facet.s = u > 0 ? 1 : 0;
    if (facet.free != Free::q && domain_ == Domain::square) facet.q = w > 0 ? 1 : 0;
  }

  Domain domain_;
  Facet facet_;
  double value_ = 0, norm_ = 1;  // of the best facet so far
};

/// A direction times a power of two, so that its largest coordinate is between 1 and 2: directions that turn into each
/// other must be of similar length.
inline Vector scaled_direction(const Vector& n) noexcept {
  const double factor = std::ldexp(1.0, -std::ilogb(largest_of(n)));
  return {{factor * n[0], factor * n[1], factor * n[2]}};
}

}  // namespace touchstone::filters
