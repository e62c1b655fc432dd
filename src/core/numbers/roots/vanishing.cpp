// SPDX-License-Identifier: MIT
#include "numbers/roots/vanishing.hpp"

#include <cmath>
#include <cstddef>

#include "numbers/integers/exact_number.hpp"

namespace touchstone::numbers {
namespace {

/// Whether b = -c a for some c > 0, both not zero: exactly then (1 - t) a + t b is zero for some t in [0, 1].
bool opposite(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] < 0 ? !(b[i] > 0) : a[i] > 0 ? !(b[i] < 0) : b[i] != 0) return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = i + 1; j < a.size(); ++j) {
      if (Exact(a[i]) * Exact(b[j]) != Exact(a[j]) * Exact(b[i])) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<double> zero_between(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  if (!opposite(a, b)) return std::nullopt;
  std::size_t i = 0;
  while (a[i] == 0) ++i;
  const double from = std::fabs(a[i]) / 4, to = std::fabs(b[i]) / 4;  // their sum does not overflow
  return from + to > 0 ? from / (from + to) : 0.5;
}

int sign_of_dot(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  Exact dot(0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return 1;
    dot = dot + Exact(a[i]) * Exact(b[i]);
  }
  return sign_of(dot);
}

}  // namespace touchstone::numbers
