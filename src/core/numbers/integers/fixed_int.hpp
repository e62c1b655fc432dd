// Integers of a fixed number of 64-bit limbs, in two's complement: exact arithmetic without a branch or an allocation,
// for numbers whose size is known beforehand. Products are as wide as both factors together. Sums are as wide as their
// operands: the user must leave room for the carry.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "numbers/integers/exact_number.hpp"
#include "numbers/roots/polynomial.hpp"

#ifndef __SIZEOF_INT128__
#error "a compiler with 128-bit integers is needed (64-bit GCC or clang): products of limbs are of that type"
#endif

namespace touchstone::numbers {

template <int Limbs>
class FixedInt {
 public:
  using Limb = std::uint64_t;

  FixedInt() noexcept = default;  ///< 0
  explicit FixedInt(int value) noexcept : FixedInt(integer(value)) {}

  static FixedInt integer(std::int64_t value) noexcept {
    FixedInt result;
    result.limbs_[0] = static_cast<Limb>(value);
    for (int i = 1; i < Limbs; ++i) result.limbs_[i] = value < 0 ? ~Limb{0} : 0;
    return result;
  }

  /// x * 2^-exponent, which must be an integer below 2^(64 Limbs - 1) in absolute value.
  static FixedInt scaled(double x, int exponent) noexcept {
    const Limb bits = std::bit_cast<Limb>(x);
    const int biased = static_cast<int>(bits >> 52) & 0x7FF;
    const Limb fraction = bits & 0x000FFFFFFFFFFFFF;
    Limb significand = biased == 0 ? fraction : fraction | 0x0010000000000000;
    FixedInt result;
    if (significand == 0) return result;
    int shift = (biased == 0 ? 1 : biased) - 1075 - exponent;
    if (shift < 0) {  // the bits shifted out are zero
      significand >>= -shift;
      shift = 0;
    }
    const int limb = shift / 64;
    const int offset = shift % 64;
    for (int i = 0; i < Limbs; ++i) {
      if (i == limb) result.limbs_[i] = significand << offset;
      if (i == limb + 1 && offset != 0) result.limbs_[i] = significand >> (64 - offset);
    }
    return (bits >> 63) != 0 ? -result : result;
  }

  int sign() const noexcept {
    if (static_cast<std::int64_t>(limbs_[Limbs - 1]) < 0) return -1;
    Limb any = 0;
    for (int i = 0; i < Limbs; ++i) any |= limbs_[i];
    return any != 0 ? 1 : 0;
  }
  bool is_zero() const noexcept {
    Limb any = 0;
    for (int i = 0; i < Limbs; ++i) any |= limbs_[i];
    return any == 0;
  }

  friend FixedInt operator+(const FixedInt& a, const FixedInt& b) noexcept {
    FixedInt sum;
    Wide carry = 0;
    for (int i = 0; i < Limbs; ++i) {
      carry += static_cast<Wide>(a.limbs_[i]) + b.limbs_[i];
      sum.limbs_[i] = static_cast<Limb>(carry);
      carry >>= 64;
    }
    return sum;
  }
  friend FixedInt operator-(const FixedInt& a, const FixedInt& b) noexcept {
    FixedInt difference;
    Limb borrow = 0;
    for (int i = 0; i < Limbs; ++i) {
      const Wide total = static_cast<Wide>(a.limbs_[i]) - b.limbs_[i] - borrow;
      difference.limbs_[i] = static_cast<Limb>(total);
      borrow = static_cast<Limb>(total >> 64) & 1;
    }
    return difference;
  }
  friend FixedInt operator-(const FixedInt& a) noexcept { return FixedInt() - a; }

  template <int Others>
  friend FixedInt<Limbs + Others> operator*(const FixedInt& a, const FixedInt<Others>& b) noexcept {
    FixedInt<Limbs + Others> product;
    if constexpr (Limbs <= 2 && Others == 1) {
      // The highest limb alone has a sign; the totals are in (-2^127, 2^127). As one loop over any number of limbs,
      // GCC 12.2 made wrong products of this in near_root_test.cpp at -O3, though not with -fno-tree-loop-vectorize.
      const auto signed_limb = [](Limb limb) { return SignedWide{static_cast<std::int64_t>(limb)}; };
      const SignedWide factor = signed_limb(b.limb(0));
      SignedWide total = factor * (Limbs == 1 ? signed_limb(a.limb(0)) : SignedWide{a.limb(0)});
      product.set_limb(0, static_cast<Limb>(total));
      if constexpr (Limbs == 2) {
        total = factor * signed_limb(a.limb(1)) + (total >> 64);
        product.set_limb(1, static_cast<Limb>(total));
      }
      product.set_limb(Limbs, static_cast<Limb>(total >> 64));
      return product;
    }
    for (int i = 0; i < Limbs; ++i) {
      Limb carry = 0;
      for (int j = 0; j < Others; ++j) {
        const Wide total = static_cast<Wide>(a.limb(i)) * b.limb(j) + product.limb(i + j) + carry;
        product.set_limb(i + j, static_cast<Limb>(total));
        carry = static_cast<Limb>(total >> 64);
      }
      product.set_limb(i + Others, carry);
    }
    // The limbs of a negative x stand for x + 2^(64 size). Subtract from the product's upper part what this adds to it.
    subtract_above(product, b, Limbs, a.sign_mask());
    subtract_above(product, a, Others, b.sign_mask());
    return product;
  }

  /// The same number with more limbs.
  template <int Others>
  FixedInt<Others> widened() const noexcept {
    static_assert(Others >= Limbs);
    FixedInt<Others> result;
    for (int i = 0; i < Others; ++i) result.set_limb(i, i < Limbs ? limbs_[i] : sign_mask());
    return result;
  }

  Limb limb(int i) const noexcept { return limbs_[i]; }
  void set_limb(int i, Limb value) noexcept { limbs_[i] = value; }
  Limb sign_mask() const noexcept { return static_cast<Limb>(static_cast<std::int64_t>(limbs_[Limbs - 1]) >> 63); }

 private:
  __extension__ using Wide = unsigned __int128;
  __extension__ using SignedWide = __int128;

  template <int Size, int Others>
  static void subtract_above(FixedInt<Size>& from, const FixedInt<Others>& x, int first, Limb mask) noexcept {
    Limb borrow = 0;
    for (int i = 0; i < Others; ++i) {
      const Wide total = static_cast<Wide>(from.limb(first + i)) - (x.limb(i) & mask) - borrow;
      from.set_limb(first + i, static_cast<Limb>(total));
      borrow = static_cast<Limb>(total >> 64) & 1;
    }
  }

  Limb limbs_[Limbs] = {};
};

template <int Limbs>
int sign_of(const FixedInt<Limbs>& x) noexcept {
  return x.sign();
}
template <int Limbs>
bool is_zero(const FixedInt<Limbs>& x) noexcept {
  return x.is_zero();
}

/// x itself.
template <int Limbs>
Exact to_exact(const FixedInt<Limbs>& x) {
  const bool negative = x.sign() < 0;
  const FixedInt<Limbs> magnitude = negative ? -x : x;
  Exact::Limb limbs[Limbs];
  for (int i = 0; i < Limbs; ++i) limbs[i] = magnitude.limb(i);
  return Exact::from_limbs(limbs, Limbs, negative);
}

template <int Limbs, int D>
Polynomial<Exact, D> to_exact(const Polynomial<FixedInt<Limbs>, D>& p) {
  Polynomial<Exact, D> exact;
  for (int i = 0; i <= D; ++i) exact[i] = to_exact(p[i]);
  return exact;
}
template <int D>
const Polynomial<Exact, D>& to_exact(const Polynomial<Exact, D>& p) noexcept {
  return p;
}

/// The double near x within a relative error of 2^-51; |x| < 2^1000.
template <int Limbs>
double to_double(const FixedInt<Limbs>& x) noexcept {
  static_assert(Limbs <= 15, "the result must be finite");
  const bool negative = x.sign() < 0;
  const FixedInt<Limbs> magnitude = negative ? -x : x;
  int top = Limbs - 1;
  while (top > 0 && magnitude.limb(top) == 0) --top;
  double result = static_cast<double>(magnitude.limb(top));
  double unit = 0x1p-64;
  if (top > 0) result += static_cast<double>(magnitude.limb(top - 1)) * unit;
  for (int i = 0; i < top; ++i) result *= 0x1p64;
  return negative ? -result : result;
}

}  // namespace touchstone::numbers
