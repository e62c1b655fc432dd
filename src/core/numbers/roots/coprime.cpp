// The greatest common divisor in the field of P = 2^61 - 1 elements, in which all numbers are words.
//
// Coefficients are dyadic rationals. P is odd, so taking them modulo P is a homomorphism of rings. If p and q have a
// common root, they have a common divisor g of degree 1 or more with dyadic coefficients (Gauss's lemma, in which the
// powers of 2 are units), and p = g h with such an h. So g's leading coefficient divides p's. Where p's is not zero
// modulo P, neither is g's: g keeps its degree modulo P, and divides both polynomials there. So a constant divisor
// modulo P proves that there is no common root.
// SPDX-License-Identifier: MIT
#include "numbers/roots/coprime.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "numbers/integers/exact_number.hpp"

namespace touchstone::numbers {
namespace {

using Word = std::uint64_t;
__extension__ using Wide = unsigned __int128;

constexpr int kBits = 61;
constexpr Word kPrime = (Word{1} << kBits) - 1;

/// For x < 2^64, as 2^61 is 1.
Word reduced(Word x) noexcept {
  x = (x & kPrime) + (x >> kBits);
  return x >= kPrime ? x - kPrime : x;
}
Word product(Word a, Word b) noexcept {
  const Wide wide = static_cast<Wide>(a) * b;
  return reduced((static_cast<Word>(wide) & kPrime) + static_cast<Word>(wide >> kBits));
}
Word difference(Word a, Word b) noexcept { return a >= b ? a - b : a + (kPrime - b); }

/// The number modulo P. 2^64 is 2^3.
Word residue(const Exact& x) noexcept {
  Word sum = 0;
  int shift = static_cast<int>((3L * x.limb_exponent() % kBits + kBits) % kBits);
  for (int i = 0; i < x.limb_count(); ++i) {
    sum = reduced(sum + product(reduced(x.limb(i)), Word{1} << shift));
    shift = (shift + 3) % kBits;
  }
  return x.sign() < 0 && sum != 0 ? kPrime - sum : sum;
}

struct Residues {
  std::array<Word, kMostDegree + 1> c;
  std::size_t size = 0;

  explicit Residues(Coefficients p) noexcept : size(static_cast<std::size_t>(p.size)) {
    for (std::size_t i = 0; i < size; ++i) c[i] = residue(p.c[i]);
    trim();
  }
  void trim() noexcept {
    while (size > 0 && c[size - 1] == 0) --size;
  }
};

/// Leaves a multiple of the remainder by b, which is not zero, in a.
void divide(Residues& a, const Residues& b) noexcept {
  const Word leading = b.c[b.size - 1];
  while (a.size >= b.size) {
    const Word factor = a.c[a.size - 1];
    const std::size_t shift = a.size - b.size;
    for (std::size_t i = 0; i + 1 < a.size; ++i) {
      a.c[i] = product(a.c[i], leading);
      if (i >= shift) a.c[i] = difference(a.c[i], product(factor, b.c[i - shift]));
    }
    --a.size;
    a.trim();
  }
}

}  // namespace

bool certainly_coprime(Coefficients p, Coefficients q) noexcept {
  Residues a(p), b(q);
  if (a.size != static_cast<std::size_t>(p.size) || a.size == 0) return false;
  while (b.size > 0) {
    divide(a, b);
    std::swap(a, b);
  }
  return a.size == 1;
}

}  // namespace touchstone::numbers
