// Polynomials in t whose coefficients know how much was added up to make them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "baselines/frame.hpp"

namespace touchstone::baselines {

/// Constant first. `size[i]` is the sum of the absolute values of all terms of c[i], so that c[i] can be told from the
/// rounding noise of its own computation.
template <std::size_t Degree>
struct Polynomial {
  std::array<double, Degree + 1> c{};
  std::array<double, Degree + 1> size{};
};

using Linear = Polynomial<1>;
using Cubic = Polynomial<3>;

template <std::size_t A, std::size_t B>
Polynomial<A + B> operator*(const Polynomial<A>& a, const Polynomial<B>& b) {
  Polynomial<A + B> product;
  for (std::size_t i = 0; i <= A; ++i) {
    for (std::size_t j = 0; j <= B; ++j) {
      product.c[i + j] += a.c[i] * b.c[j];
      product.size[i + j] += a.size[i] * b.size[j];
    }
  }
  return product;
}

template <std::size_t D>
Polynomial<D> operator+(Polynomial<D> a, const Polynomial<D>& b) {
  for (std::size_t i = 0; i <= D; ++i) {
    a.c[i] += b.c[i];
    a.size[i] += b.size[i];
  }
  return a;
}

template <std::size_t D>
Polynomial<D> operator-(Polynomial<D> a, const Polynomial<D>& b) {
  for (std::size_t i = 0; i <= D; ++i) {
    a.c[i] -= b.c[i];
    a.size[i] += b.size[i];
  }
  return a;
}

/// Each component of the motion as a polynomial.
inline geometry::Vector<Linear> linear(const Motion& m) {
  geometry::Vector<Linear> v;
  for (std::size_t k = 0; k < 3; ++k) {
    v[k].c = {m.start[k], m.end[k] - m.start[k]};
    v[k].size = {std::fabs(m.start[k]), std::fabs(m.start[k]) + std::fabs(m.end[k])};
  }
  return v;
}

template <std::size_t D>
Cubic as_cubic(const Polynomial<D>& p) {
  static_assert(D <= 3);
  Cubic cubic;
  for (std::size_t i = 0; i <= D; ++i) {
    cubic.c[i] = p.c[i];
    cubic.size[i] = p.size[i];
  }
  return cubic;
}

/// A coefficient within this share of its size is taken for zero: a determinant of differences has seven roundings.
constexpr double kNoise = 0x1p-50;

inline bool is_noise(const Cubic& p, std::size_t i) { return std::fabs(p.c[i]) <= kNoise * p.size[i]; }
inline bool is_noise(const Cubic& p) { return is_noise(p, 0) && is_noise(p, 1) && is_noise(p, 2) && is_noise(p, 3); }

inline double value(const Cubic& p, double t) { return ((p.c[3] * t + p.c[2]) * t + p.c[1]) * t + p.c[0]; }
inline double slope(const Cubic& p, double t) { return (3 * p.c[3] * t + 2 * p.c[2]) * t + p.c[1]; }

/// The real roots of a t^2 + b t + c, the degree decided by a != 0 and b != 0; at most two, in no order. The root with
/// the larger absolute value comes from the sum without cancellation, the other one from the product of both.
struct QuadraticRoots {
  std::array<double, 2> t{};
  std::size_t count = 0;
};

inline QuadraticRoots quadratic_roots(double a, double b, double c) {
  QuadraticRoots roots;
  if (a == 0) {
    if (b != 0) roots.t[roots.count++] = -c / b;
    return roots;
  }
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return roots;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  roots.t[roots.count++] = q / a;
  if (q != 0) roots.t[roots.count++] = c / q;
  return roots;
}

}  // namespace touchstone::baselines
