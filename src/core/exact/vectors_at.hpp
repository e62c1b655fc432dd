// Moving vectors at an exact time.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "exact/elements.hpp"

namespace touchstone::exact {

/// The sign of a polynomial at the root, tried in doubles first.
template <class Root, class R, int D>
int sign_at(const Root& root, const numbers::Polynomial<R, D>& p) {
  return root.sign_at(p);
}
inline int sign_at(const RealRoot& root, const Form& p) { return root.quick_sign_at(p); }

/// Whether a moving vector is zero at the root.
template <class P, class Root>
bool vanishes(const geometry::Vector<P>& v, const Root& root) {
  return sign_at(root, v[0]) == 0 && sign_at(root, v[1]) == 0 && sign_at(root, v[2]) == 0;
}

/// An axis along which v is not zero at the moment, with the sign of that component; axis -1 when v is zero.
struct NonzeroAxis {
  int axis = -1;
  int sign = 0;
};
template <class P, class Root>
NonzeroAxis nonzero_axis(const geometry::Vector<P>& v, const MomentOf<Root>& moment, const char* name) {
  for (int k = 0; k < 3; ++k) {
    const int sign = moment.sign(v[static_cast<std::size_t>(k)], name, k);
    if (sign != 0) return {k, sign};
  }
  return {};
}

/// A quotient of two components along an axis, numerator / denominator at the root, in [0, 1]. The denominator is not
/// zero there. along(other axis) is the quotient of the same value from those along another axis, as a std::pair.
template <class Root, class P, class D, class Along>
double quotient_along(const Root& root, const P& numerator, const D& denominator, std::size_t, const Along&) {
  return root.quotient(numerator, denominator);
}
/// A near root may know the quotient along another axis only. That is rare: a function of its own keeps it out of the
/// way.
template <int Limbs, class Along>
[[gnu::noinline]] double quotient_elsewhere(const numbers::NearRoot<Limbs>& root, std::size_t axis,
                                            const Along& along) {
  const auto [n, d] = along((axis + 1) % 3);
  if (const auto quotient = root.known_quotient(n, d)) return *quotient;
  const auto [n2, d2] = along((axis + 2) % 3);
  return root.quotient(n2, d2);
}
template <int Limbs, class P, class D, class Along>
double quotient_along(const numbers::NearRoot<Limbs>& root, const P& numerator, const D& denominator, std::size_t axis,
                      const Along& along) {
  const auto quotient = root.known_quotient(numerator, denominator);
  return quotient ? *quotient : quotient_elsewhere(root, axis, along);
}

/// Appends a polynomial whose roots contain the isolated times at which a moving difference vanishes.
template <class N>
void append_coincidence(const typename Forms<N>::Point& difference, Events<N>& events) {
  for (const auto& component : difference.c) {
    if (is_zero(component)) continue;
    if constexpr (std::is_same_v<N, AnyDegree>) {
      events.add(component);
    } else {
      const typename Forms<N>::Number one(1);
      events.add(typename Forms<N>::Quadratic{{component[0] * one, component[1] * one, typename Forms<N>::Square(0)}});
    }
    return;
  }
}

}  // namespace touchstone::exact
