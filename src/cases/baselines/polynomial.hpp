// Polynomials in t, with the sizes of the terms that were added up to their coefficients.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "baselines/scaled_frame.hpp"

namespace touchstone::baselines {

/// The sum of the absolute values of a formula's terms. A formula that is computed in this type gives the size with
/// which its result in doubles is compared: a far smaller result may be rounding noise.
struct Magnitude {
  double m = 0;
};
inline Magnitude operator+(Magnitude a, Magnitude b) { return {a.m + b.m}; }
inline Magnitude operator-(Magnitude a, Magnitude b) { return {a.m + b.m}; }
inline Magnitude operator*(Magnitude a, Magnitude b) { return {a.m * b.m}; }

/// Constant first.
template <std::size_t Degree, class N = double>
struct Polynomial {
  std::array<N, Degree + 1> c{};
};

template <std::size_t A, std::size_t B, class N>
Polynomial<A + B, N> operator*(const Polynomial<A, N>& a, const Polynomial<B, N>& b) {
  Polynomial<A + B, N> product;
  for (std::size_t i = 0; i <= A; ++i) {
    for (std::size_t j = 0; j <= B; ++j) product.c[i + j] = product.c[i + j] + a.c[i] * b.c[j];
  }
  return product;
}

template <std::size_t D, class N>
Polynomial<D, N> operator+(Polynomial<D, N> a, const Polynomial<D, N>& b) {
  for (std::size_t i = 0; i <= D; ++i) a.c[i] = a.c[i] + b.c[i];
  return a;
}

template <std::size_t D, class N>
Polynomial<D, N> operator-(Polynomial<D, N> a, const Polynomial<D, N>& b) {
  for (std::size_t i = 0; i <= D; ++i) a.c[i] = a.c[i] - b.c[i];
  return a;
}

/// Each component of the motion as a polynomial.
template <class N>
geometry::Vector<Polynomial<1, N>> linear(const Motion& m) {
  geometry::Vector<Polynomial<1, N>> v;
  for (std::size_t k = 0; k < 3; ++k) {
    if constexpr (std::is_same_v<N, Magnitude>) {
      v[k].c = {Magnitude{std::fabs(m.start[k])}, Magnitude{std::fabs(m.start[k]) + std::fabs(m.end[k])}};
    } else {
      v[k].c = {m.start[k], m.end[k] - m.start[k]};
    }
  }
  return v;
}

/// A polynomial of degree at most 3, with the size of the terms of each coefficient.
struct Cubic {
  std::array<double, 4> c{};
  std::array<double, 4> size{};
};

template <std::size_t D>
Cubic cubic_of(const Polynomial<D>& p, const Polynomial<D, Magnitude>& sizes) {
  static_assert(D <= 3);
  Cubic cubic;
  for (std::size_t i = 0; i <= D; ++i) {
    cubic.c[i] = p.c[i];
    cubic.size[i] = sizes.c[i].m;
  }
  return cubic;
}

/// Every Bernstein coefficient over [0, 1] farther from zero than `noise`, all on one side: no root.
inline bool one_sided(const std::array<double, 4>& c, double noise) {
  const double third = c[1] / 3;
  const double b1 = c[0] + third;
  const double b2 = b1 + third + c[2] / 3;
  const double b3 = ((c[0] + c[1]) + c[2]) + c[3];
  return std::min({c[0], b1, b2, b3}) > noise || std::max({c[0], b1, b2, b3}) < -noise;
}

/// A value within this fraction of the sizes of all terms may be zero.
constexpr double kZero = 0x1p-46;

/// A coefficient within this fraction of its size counts as zero: a determinant of differences has seven roundings.
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
