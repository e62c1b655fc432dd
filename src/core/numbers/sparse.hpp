// Dyadic numbers of wide span and few bits, n 2^k: sums of few digits that stand far apart. A number such as
// 3 2^900 - 2^-900 has two digits here, where an integer has a limb for each 64 bits between them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

#include "numbers/exact_number.hpp"

namespace touchstone::numbers {

class Doubt;

/// A sum of digits d 2^(60 i), each with its own i, |d| <= 2^59 and d not 0. Digits have signs, so that a difference
/// of two numbers that are far apart has no more digits than both together. What follows the leading digit is less
/// than one of its units: below 2^(60 i) (1/2 + 2^-60). So the leading digit has the number's sign.
///
/// The digits lie in the SparseScratch of this thread. They never change, so that copies share them. Exact, as long as
/// that scratch raises no doubt.
class Sparse {
 public:
  static constexpr int kDigitBits = 60;
  struct Digit {
    std::int64_t value;
    int index;
  };

  Sparse() noexcept = default;          ///< 0
  explicit Sparse(int value) noexcept;  ///< |value| < 2^31
  /// x 2^-exponent.
  static Sparse scaled(double x, long exponent) noexcept;

  int sign() const noexcept { return size_ == 0 ? 0 : digits_[size_ - 1].value > 0 ? 1 : -1; }
  bool is_zero() const noexcept { return size_ == 0; }
  bool is_one() const noexcept { return size_ == 1 && digits_->value == 1 && digits_->index == 0; }

  /// 2^(bits - 3) < |x| < 2^bits for x != 0: with d the leading digit, |x| is within 1/2 + 2^-60 of |d|, in its units.
  /// Below the exponent of any number for 0.
  long bits() const noexcept;

  /// The sum of at most so many leading digits, and the binary exponent of a bound on the rest.
  struct Part;
  Part leading(int digits) const noexcept;

  friend Sparse operator+(const Sparse& a, const Sparse& b) noexcept { return sum(a, b, 1); }
  friend Sparse operator-(const Sparse& a, const Sparse& b) noexcept { return sum(a, b, -1); }
  friend Sparse operator-(const Sparse& a) noexcept { return sum(Sparse(), a, -1); }
  friend Sparse operator*(const Sparse& a, const Sparse& b) noexcept;
  /// a b + c.
  friend Sparse multiply_add(const Sparse& a, const Sparse& b, const Sparse& c) noexcept;
  friend Approximation approximate(const Sparse& x) noexcept;

 private:
  static Sparse sum(const Sparse& a, const Sparse& b, int sign) noexcept;
  static Sparse times_digit(const Sparse& a, const Digit& factor) noexcept;

  const Digit* digits_ = nullptr;  // the leading one last
  int size_ = 0;
};

/// The true number is within 2^error of value.
struct Sparse::Part {
  Sparse value;
  long error;
};
/// The exponent of a bound on nothing.
constexpr long kNoError = std::numeric_limits<long>::min() / 8;

inline int sign_of(const Sparse& x) noexcept { return x.sign(); }
inline bool is_zero(const Sparse& x) noexcept { return x.is_zero(); }

/// A sparse number from the leading digits of sums and products alone: the true one is within 2^error of value.
template <int Digits>
struct Leading : Sparse::Part {
  Leading() noexcept : Sparse::Part{Sparse(), kNoError} {}
  explicit operator Sparse() const noexcept { return value; }
  explicit Leading(const Sparse& x) noexcept : Sparse::Part(x.leading(Digits)) {}

  /// 0 when uncertain, and for an exact 0.
  int sign() const noexcept { return value.bits() - 3 >= error ? value.sign() : 0; }

  /// The true number is below 2^most_bits().
  long most_bits() const noexcept { return std::max(value.bits(), error) + 1; }

  friend Leading operator+(const Leading& a, const Leading& b) noexcept { return {a.value + b.value, more(a, b)}; }
  friend Leading operator-(const Leading& a, const Leading& b) noexcept { return {a.value - b.value, more(a, b)}; }
  friend Leading operator-(const Leading& a) noexcept { return {-a.value, a.error}; }
  /// (A + e) (B + f) = A B + A f + e B + e f.
  friend Leading operator*(const Leading& a, const Leading& b) noexcept { return {a.value * b.value, error_of(a, b)}; }
  friend Leading multiply_add(const Leading& a, const Leading& b, const Leading& c) noexcept {
    return {multiply_add(a.value, b.value, c.value), std::max(error_of(a, b), c.error) + 1};
  }

 private:
  Leading(const Sparse& x, long error_of_x) noexcept : Leading(x) { error = std::max(error, error_of_x) + 1; }
  static long error_of(const Leading& a, const Leading& b) noexcept {
    const long left = a.value.bits() + b.error, right = b.value.bits() + a.error;
    return std::max({left, right, a.error + b.error, kNoError}) + 2;
  }
  static long more(const Leading& a, const Leading& b) noexcept { return std::max(a.error, b.error) + 1; }
};

/// The memory of this thread's sparse numbers while it lives. Its size and the number of products of digits bound the
/// time that they may take: where these do not suffice, it raises the doubt, and numbers are 0.
class SparseScratch {
 public:
  explicit SparseScratch(Doubt& doubt) noexcept : previous_(current_), doubt_(doubt) { current_ = this; }
  ~SparseScratch() { current_ = previous_; }
  SparseScratch(const SparseScratch&) = delete;
  SparseScratch& operator=(const SparseScratch&) = delete;

  /// Gives the memory of all numbers back that are made while it lives.
  class Rewind {
   public:
    Rewind() noexcept : used_(current_->used_) {}
    ~Rewind() { current_->used_ = used_; }
    Rewind(const Rewind&) = delete;
    Rewind& operator=(const Rewind&) = delete;

   private:
    int used_;
  };

 private:
  friend class Sparse;
  friend Sparse multiply_add(const Sparse& a, const Sparse& b, const Sparse& c) noexcept;
  static constexpr int kDigits = 1536, kMoreDigits = 5464;
  static constexpr int kMostProducts = 40000;

  /// Room for so many digits, of which `keep` takes those that are used; null without room.
  Sparse::Digit* room(int digits) noexcept;
  void keep(int digits) noexcept { used_ += digits; }
  bool spend(int products) noexcept;
  void raise() noexcept;

  static constinit thread_local SparseScratch* current_;  // NOLINT(readability-identifier-naming)

  SparseScratch* previous_;
  Doubt& doubt_;
  int used_ = 0;
  int products_ = 0;
  struct Delete {
    void operator()(Sparse::Digit* digits) const noexcept { ::operator delete(digits); }
  };
  Sparse::Digit digits_[kDigits];                       // 24 KiB, not initialised
  std::unique_ptr<Sparse::Digit, Delete> more_digits_;  // 86 KiB, for the few that need them

  // For products: see multiply_add.
  static constexpr int kSpan = 512;
  __extension__ using Wide = __int128;
  std::array<Wide, kSpan> sums_{};
  std::array<std::uint64_t, kSpan / 64> marks_{};
};

}  // namespace touchstone::numbers
