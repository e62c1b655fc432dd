// Packs of doubles that are computed side by side. Each operator is one IEEE operation in every lane.
//
// A file may be compiled for wider vectors than every processor has. No function that it instantiates may then be
// shared with other files. So packs are in an unnamed namespace: every file that includes this one has types of its
// own.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#ifdef __FMA__
#include <immintrin.h>
#endif

namespace touchstone::numbers {
namespace {

/// The compiler's vector types for so many doubles.
template <int Width>
struct VectorTypes {
  typedef double Doubles __attribute__((vector_size(8 * Width)));
  typedef std::int64_t Integers __attribute__((vector_size(8 * Width)));
};

/// So many doubles.
template <int Width>
struct Pack {
  typename VectorTypes<Width>::Doubles v;

  friend Pack operator+(Pack a, Pack b) { return {a.v + b.v}; }
  friend Pack operator-(Pack a, Pack b) { return {a.v - b.v}; }
  friend Pack operator-(Pack a) { return {-a.v}; }
  friend Pack operator*(Pack a, Pack b) { return {a.v * b.v}; }
  friend Pack operator*(double a, Pack b) { return {a * b.v}; }
  friend auto operator>(Pack a, Pack b) { return a.v > b.v; }
  friend auto operator<(Pack a, Pack b) { return a.v < b.v; }
  friend auto operator>=(Pack a, double b) { return a.v >= b; }
  friend auto operator<=(Pack a, double b) { return a.v <= b; }

  friend Pack larger(Pack a, Pack b) { return {a.v > b.v ? a.v : b.v}; }
  friend Pack magnitude(Pack a) { return from_bits(a.bits() & INT64_MAX); }
  /// a, or -a where s is negative.
  friend Pack flipped(Pack a, Pack s) { return from_bits(a.bits() ^ (s.bits() & INT64_MIN)); }

  friend Pack square_root(Pack a) {
    for (int i = 0; i < Width; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
    return a;
  }

  typename VectorTypes<Width>::Integers bits() const {
    return reinterpret_cast<typename VectorTypes<Width>::Integers>(v);
  }
  static Pack from_bits(typename VectorTypes<Width>::Integers b) {
    return {reinterpret_cast<typename VectorTypes<Width>::Doubles>(b)};
  }
};

inline Pack<4> pack(double a, double b, double c, double d) {
  const VectorTypes<4>::Doubles v = {a, b, c, d};
  return {v};
}

inline Pack<2> pack(double a, double b) {
  const VectorTypes<2>::Doubles v = {a, b};
  return {v};
}

/// The two lanes of a in the other order.
inline Pack<2> swapped(Pack<2> a) { return pack(a.v[1], a.v[0]); }

/// Width I, J, K, L of a.
template <int I, int J, int K, int L>
Pack<4> shuffled(Pack<4> a) {
#ifdef __clang__
  return {__builtin_shufflevector(a.v, a.v, I, J, K, L)};
#else
  const VectorTypes<4>::Integers order = {I, J, K, L};
  return {__builtin_shuffle(a.v, order)};
#endif
}

#ifdef __FMA__
/// a b - c with one rounding.
inline Pack<4> multiply_subtract(Pack<4> a, Pack<4> b, Pack<4> c) { return {_mm256_fmsub_pd(a.v, b.v, c.v)}; }
#endif

}  // namespace
}  // namespace touchstone::numbers
