// Packs of doubles that are computed side by side. Each operator is one IEEE operation in every lane.
//
// A file may be compiled for wider vectors than every processor has. No function that it instantiates may then be
// shared with other files. So packs are in an unnamed namespace: every file that includes this one has types of its
// own.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "numbers/doubles/lanes.hpp"

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
  // The same in an array. Copies by memcpy go through narrower registers, and wait for memory.
  typedef double DoublesInArray __attribute__((vector_size(8 * Width), aligned(8), may_alias));
  typedef std::int64_t IntegersInArray __attribute__((vector_size(8 * Width), aligned(8), may_alias));
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
  friend Pack operator/(Pack a, Pack b) { return {a.v / b.v}; }
  friend Pack operator/(double a, Pack b) { return {a / b.v}; }
  friend Pack operator+(double a, Pack b) { return {a + b.v}; }
  friend Pack operator-(double a, Pack b) { return {a - b.v}; }
  friend auto operator>(Pack a, Pack b) { return a.v > b.v; }
  friend auto operator<(Pack a, Pack b) { return a.v < b.v; }
  friend auto operator<=(Pack a, Pack b) { return a.v <= b.v; }
  friend auto operator>=(Pack a, Pack b) { return a.v >= b.v; }
  friend auto operator>(Pack a, double b) { return a.v > b; }
  friend auto operator<(Pack a, double b) { return a.v < b; }
  friend auto operator>=(Pack a, double b) { return a.v >= b; }
  friend auto operator<=(Pack a, double b) { return a.v <= b; }

  friend Pack larger(Pack a, Pack b) { return {a.v > b.v ? a.v : b.v}; }
  friend Pack smaller(Pack a, Pack b) { return {a.v < b.v ? a.v : b.v}; }
  /// a where the mask is set, b elsewhere.
  friend Pack chosen(typename VectorTypes<Width>::Integers mask, Pack a, Pack b) { return {mask ? a.v : b.v}; }
  friend Pack magnitude(Pack a) { return from_bits(a.bits() & INT64_MAX); }
  /// a, or -a where s is negative.
  friend Pack flipped(Pack a, Pack s) { return from_bits(a.bits() ^ (s.bits() & INT64_MIN)); }

  /// The doubles beside a > 0.
  friend Pack after(Pack a) { return from_bits(a.bits() + 1); }
  friend Pack before(Pack a) { return from_bits(a.bits() - 1); }

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

/// Several doubles as the lanes of one text.
template <int Width>
struct PackLanes {
  using Mask = typename VectorTypes<Width>::Integers;  // of a comparison: all bits of a lane or none
  /// The doubles from `from` on, and those at from[which[0]], from[which[1]] and so on.
  static Pack<Width> loaded(const double* from) {
    return {*reinterpret_cast<const typename VectorTypes<Width>::DoublesInArray*>(from)};
  }
  static Pack<Width> gathered(const double* from, const std::size_t* which) {
    return gathered(from, which, std::make_index_sequence<Width>());
  }
  static Mask gathered(const std::int64_t* from, const std::size_t* which) {
    Mask a;
    for (int i = 0; i < Width; ++i) a[i] = from[which[i]];
    return a;
  }
  static void store(Pack<Width> a, double* to) {
    *reinterpret_cast<typename VectorTypes<Width>::DoublesInArray*>(to) = a.v;
  }
  static void store(const Mask& mask, std::int64_t* to) {
    *reinterpret_cast<typename VectorTypes<Width>::IntegersInArray*>(to) = mask;
  }
  static Pack<Width> all(double x) {
    Pack<Width> a;
    for (int i = 0; i < Width; ++i) a.v[i] = x;
    return a;
  }
  static Mask every() { return Mask{} == 0; }
  static bool any(const Mask& mask) {
    bool set = false;
    for (int i = 0; i < Width; ++i) set |= mask[i] != 0;
    return set;
  }

  struct Axis {
    Mask is_y, is_z;  // where neither is set, it is x
  };
  static Axis greatest(Pack<Width> x, Pack<Width> y, Pack<Width> z) {
    const Mask is_x = x > y;
    const Mask is_z = z > chosen(is_x, x, y);
    return {Mask((is_x | is_z) == 0), is_z};
  }
  template <class Vector>
  static Vector turned(const Vector& a, const Axis& axis) {
    return {{chosen(axis.is_z, a[2], chosen(axis.is_y, a[1], a[0])),
             chosen(axis.is_z, a[0], chosen(axis.is_y, a[2], a[1])),
             chosen(axis.is_z, a[1], chosen(axis.is_y, a[0], a[2]))}};
  }

 private:
  template <std::size_t... Lane>
  static Pack<Width> gathered(const double* from, const std::size_t* which, std::index_sequence<Lane...>) {
    const typename VectorTypes<Width>::Doubles v = {from[which[Lane]]...};
    return {v};
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
inline Pack<2> multiply_subtract(Pack<2> a, Pack<2> b, Pack<2> c) { return {_mm_fmsub_pd(a.v, b.v, c.v)}; }
inline Pack<4> multiply_subtract(Pack<4> a, Pack<4> b, Pack<4> c) { return {_mm256_fmsub_pd(a.v, b.v, c.v)}; }
#ifdef __AVX512F__
inline Pack<8> multiply_subtract(Pack<8> a, Pack<8> b, Pack<8> c) { return {_mm512_fmsub_pd(a.v, b.v, c.v)}; }
#endif
#endif

}  // namespace

template <int Width>
struct Lanes<Pack<Width>> : PackLanes<Width> {};

}  // namespace touchstone::numbers
