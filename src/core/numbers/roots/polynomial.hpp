// Polynomials in t of small, fixed formal degree over any ring: the coefficient of t^i is c[i]. The formal degree is
// an upper bound; leading coefficients may be zero.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace touchstone::numbers {

template <class R, int Degree>
struct Polynomial {
  std::array<R, Degree + 1> c;

  const R& operator[](int i) const { return c[static_cast<std::size_t>(i)]; }
  R& operator[](int i) { return c[static_cast<std::size_t>(i)]; }
};

template <class R, int D>
Polynomial<R, D> operator+(const Polynomial<R, D>& p, const Polynomial<R, D>& q) {
  Polynomial<R, D> sum;
  for (int i = 0; i <= D; ++i) sum[i] = p[i] + q[i];
  return sum;
}

template <class R, int D>
Polynomial<R, D> operator-(const Polynomial<R, D>& p, const Polynomial<R, D>& q) {
  Polynomial<R, D> difference;
  for (int i = 0; i <= D; ++i) difference[i] = p[i] - q[i];
  return difference;
}

/// a b + c; a number type may have a better one.
template <class A, class B, class C>
C multiply_add(const A& a, const B& b, const C& c) {
  return c + a * b;
}

template <class R, class S, int D, int E>
auto operator*(const Polynomial<R, D>& p, const Polynomial<S, E>& q) {
  Polynomial<decltype(p[0] * q[0]), D + E> product;
  for (int k = 0; k <= D + E; ++k) {
    const int first = k > E ? k - E : 0;
    const int last = k < D ? k : D;
    product[k] = p[first] * q[k - first];
    for (int i = first + 1; i <= last; ++i) product[k] = multiply_add(p[i], q[k - i], product[k]);
  }
  return product;
}

template <class R, int D>
bool is_zero(const Polynomial<R, D>& p) {
  for (const R& c : p.c) {
    if (!is_zero(c)) return false;
  }
  return true;
}

}  // namespace touchstone::numbers
