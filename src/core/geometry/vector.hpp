// Vectors over any number type, polynomials in t included.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace touchstone::geometry {

template <class N>
struct Vector {
  std::array<N, 3> c;

  const N& operator[](std::size_t k) const { return c[k]; }
  N& operator[](std::size_t k) { return c[k]; }
};

template <class N>
Vector<N> operator-(const Vector<N>& a) {
  return {{-a[0], -a[1], -a[2]}};
}
template <class N>
Vector<N> operator+(const Vector<N>& a, const Vector<N>& b) {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
template <class N>
Vector<N> operator-(const Vector<N>& a, const Vector<N>& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

template <class N>
Vector<N> operator*(const N& factor, const Vector<N>& v) {
  return {{factor * v[0], factor * v[1], factor * v[2]}};
}

/// Component k of a x b.
template <class A, class B>
auto cross_component(const Vector<A>& a, const Vector<B>& b, std::size_t k) {
  const std::size_t i = (k + 1) % 3;
  const std::size_t j = (k + 2) % 3;
  return a[i] * b[j] - a[j] * b[i];
}

template <class A, class B>
auto cross(const Vector<A>& a, const Vector<B>& b) -> Vector<decltype(cross_component(a, b, 0))> {
  return {{cross_component(a, b, 0), cross_component(a, b, 1), cross_component(a, b, 2)}};
}

template <class A, class B>
auto dot(const Vector<A>& a, const Vector<B>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace touchstone::geometry
