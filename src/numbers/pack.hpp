// Doubles that are worked on side by side: lane by lane, each operator is one IEEE operation.
//
// A file may be compiled for wider vectors than every processor has. Nothing that it instantiates may then be shared
// with other files, so packs are in an unnamed namespace: every file that includes this has a type of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#ifdef __FMA__
#include <immintrin.h>
#endif

namespace touchstone::numbers {
namespace {

template <int Lanes>
struct Lane {
  typedef double Doubles __attribute__((vector_size(8 * Lanes)));
  typedef std::int64_t Integers __attribute__((vector_size(8 * Lanes)));
};

template <int Lanes>
struct Pack {
  typename Lane<Lanes>::Doubles v;

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

  typename Lane<Lanes>::Integers bits() const { return reinterpret_cast<typename Lane<Lanes>::Integers>(v); }
  static Pack from_bits(typename Lane<Lanes>::Integers b) {
    return {reinterpret_cast<typename Lane<Lanes>::Doubles>(b)};
  }
};

inline Pack<4> pack(double a, double b, double c, double d) {
  const Lane<4>::Doubles v = {a, b, c, d};
  return {v};
}

inline Pack<2> pack(double a, double b) {
  const Lane<2>::Doubles v = {a, b};
  return {v};
}

/// The two lanes of a in the other order.
inline Pack<2> swapped(Pack<2> a) { return pack(a.v[1], a.v[0]); }

/// Lanes I, J, K, L of a.
template <int I, int J, int K, int L>
Pack<4> shuffled(Pack<4> a) {
#ifdef __clang__
  return {__builtin_shufflevector(a.v, a.v, I, J, K, L)};
#else
  const Lane<4>::Integers order = {I, J, K, L};
  return {__builtin_shuffle(a.v, order)};
#endif
}

#ifdef __FMA__
/// a b - c with one rounding.
inline Pack<4> multiply_subtract(Pack<4> a, Pack<4> b, Pack<4> c) { return {_mm256_fmsub_pd(a.v, b.v, c.v)}; }
#endif

}  // namespace
}  // namespace touchstone::numbers
