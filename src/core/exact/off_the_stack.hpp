// Large values in memory of their own: a call of the library needs little of its thread's stack (docs/guide.md says how
// much at most).
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

namespace touchstone::exact {

/// What make() returns, made where it stays. Polynomials hold their coefficients themselves, so that a few corners of
/// them are tens of kilobytes.
template <class Make>
auto off_the_stack(const Make& make) {
  using T = decltype(make());
  return std::unique_ptr<const T>(new T(make()));
}

}  // namespace touchstone::exact
