// The moves on one number that the shrinking of every sort of query makes.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

namespace touchstone::fuzz {

/// Offers simpler numbers in place of one: small ones, with fewer digits, nearer to 1, nearer to zero. `number` reads
/// it and `offer` puts another one in its place.
template <class Number, class Offer>
void simplify_number(Number&& number, Offer&& offer) {
  constexpr std::array<double, 14> kSmall{0.0, 1, -1, 2, -2, 3, -3, 4, -4, 0.5, -0.5, 8, -8, 1.5};
  for (const double value : kSmall) offer(value);
  const double x = number();
  for (const double value : {std::nearbyint(x), std::floor(x), std::ceil(x), -x}) offer(value);
  for (const int shift : {512, 256, 128, 64, 32, 16, 8, 4, 2, 1}) {
    offer(std::ldexp(number(), std::fabs(number()) < 1 ? shift : -shift));
  }
  while (offer(number() - std::copysign(1.0, number()))) {
  }
  for (const int digits : {1, 2, 3, 4, 5, 6, 8, 12, 20, 30, 40, 48}) {
    int exponent = 0;
    const double scaled = std::ldexp(std::frexp(number(), &exponent), digits);
    offer(std::ldexp(std::trunc(scaled), exponent - digits));
    offer(std::ldexp(std::nearbyint(scaled), exponent - digits));
  }
}

}  // namespace touchstone::fuzz
