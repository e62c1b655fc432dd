// Dyadic rationals m 2^e of any size, exact under +, - and *: the ring that decisions are made in.
//
// CGAL's Mpzf has the same representation. The reason for a class of our own: on the exact level's queries most numbers
// have one to six limbs, and Mpzf spends most of its time around the arithmetic (calls into GMP for single limbs,
// copies, heap blocks above eight limbs). Here short operands are computed in line; long ones go to GMP's mpn level.
// SPDX-License-Identifier: MIT
#pragma once

#include "numbers/integers/limb_scratch.hpp"

namespace touchstone::numbers {

class Dyadic {
 public:
  using Limb = LimbScratch::Limb;

  Dyadic() noexcept : size_(0), exponent_(0), capacity_(kInline) {}
  explicit Dyadic(int value) noexcept;
  explicit Dyadic(double value) noexcept;  ///< the value must be finite
  static Dyadic power_of_two(long exponent) noexcept;

  /// sign * (limbs[0] + limbs[1] 2^64 + ...); `count` may be 0 and limbs may be zero.
  static Dyadic from_limbs(const Limb* limbs, int count, bool negative);

  Dyadic(const Dyadic& other);
  Dyadic(Dyadic&& other) noexcept;
  Dyadic& operator=(const Dyadic& other);
  Dyadic& operator=(Dyadic&& other) noexcept;
  ~Dyadic() {
    if (capacity_ != kInline) release();
  }

  int sign() const noexcept { return (size_ > 0) - (size_ < 0); }
  bool is_zero() const noexcept { return size_ == 0; }

  /// The value is sign() * (limb(0) + limb(1) 2^64 + ...) * 2^(64 limb_exponent()); the first and the last limb are not
  /// 0.
  int limb_count() const noexcept { return size_ < 0 ? -size_ : size_; }
  Limb limb(int i) const noexcept { return data()[i]; }
  int limb_exponent() const noexcept { return exponent_; }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, b.size_); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, -b.size_); }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) { return product(a, b); }
  friend Dyadic operator-(const Dyadic& a) {
    Dyadic negative = a;
    negative.size_ = -negative.size_;
    return negative;
  }

  friend int compare(const Dyadic& a, const Dyadic& b) noexcept {
    if (a.sign() != b.sign()) return a.sign() < b.sign() ? -1 : 1;
    const int magnitudes = compare_magnitudes(a, b);
    return a.size_ < 0 ? -magnitudes : magnitudes;
  }
  friend bool operator==(const Dyadic& a, const Dyadic& b) noexcept { return compare(a, b) == 0; }
  friend bool operator!=(const Dyadic& a, const Dyadic& b) noexcept { return compare(a, b) != 0; }
  friend bool operator<(const Dyadic& a, const Dyadic& b) noexcept { return compare(a, b) < 0; }
  friend bool operator>(const Dyadic& a, const Dyadic& b) noexcept { return compare(a, b) > 0; }
  friend bool operator<=(const Dyadic& a, const Dyadic& b) noexcept { return compare(a, b) <= 0; }
  friend bool operator>=(const Dyadic& a, const Dyadic& b) noexcept { return compare(a, b) >= 0; }

 private:
  static constexpr int kInline = 14;  // 896 bits: a coplanarity cubic of doubles of similar size, and its values

  static Dyadic sum(const Dyadic& a, const Dyadic& b, int b_size);
  static Dyadic product(const Dyadic& a, const Dyadic& b);
  static int compare_magnitudes(const Dyadic& a, const Dyadic& b) noexcept;

  Limb* data() noexcept { return capacity_ == kInline ? inline_ : heap_; }
  const Limb* data() const noexcept { return capacity_ == kInline ? inline_ : heap_; }
  void reserve(int limbs);  // only for a number that holds nothing yet
  void release() noexcept;
  void copy_limbs(const Dyadic& other) noexcept;
  void trim(int count, bool negative) noexcept;

  int size_;      // number of limbs, negative for a negative value
  int exponent_;  // in limbs
  int capacity_;
  union {
    // Private, though clang-tidy takes the members of an unnamed union for public ones.
    Limb inline_[kInline];  // NOLINT(readability-identifier-naming)
    Limb* heap_;            // NOLINT(readability-identifier-naming)
  };
};

}  // namespace touchstone::numbers
