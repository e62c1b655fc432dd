// Moving vectors at an exact time. SPDX-License-Identifier: MIT
#pragma once

#include "exact/elements.hpp"

namespace touchstone::exact {

/// Whether a moving vector is zero at the root.
template <class R, int D>
bool vanishes(const geometry::Vector<numbers::Polynomial<R, D>>& v, const RealRoot& root) {
  return root.sign_at(v[0]) == 0 && root.sign_at(v[1]) == 0 && root.sign_at(v[2]) == 0;
}

/// An axis along which v is not zero at the moment, with the sign of that component; axis -1 when v is zero.
struct NonzeroAxis {
  int axis = -1;
  int sign = 0;
};
template <class R, int D>
NonzeroAxis nonzero_axis(const geometry::Vector<numbers::Polynomial<R, D>>& v, const Moment& moment, const char* name) {
  for (int k = 0; k < 3; ++k) {
    const int sign = moment.sign(v[static_cast<std::size_t>(k)], name, k);
    if (sign != 0) return {k, sign};
  }
  return {};
}

/// Appends a polynomial whose roots contain the isolated times at which a moving difference vanishes.
template <class N>
void append_coincidence(const geometry::Vector<numbers::Polynomial<N, 1>>& difference, Events<N>& events) {
  for (const auto& component : difference.c) {
    if (!numbers::is_zero(component)) {
      const N one(1);
      events.add(typename Forms<N>::Quadratic{{component[0] * one, component[1] * one, typename Forms<N>::Square(0)}});
      return;
    }
  }
}

}  // namespace touchstone::exact
