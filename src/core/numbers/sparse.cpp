// SPDX-License-Identifier: MIT
#include "numbers/sparse.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>

#include "numbers/near_root.hpp"

namespace touchstone::numbers {
namespace {

__extension__ using Wide = __int128;
constexpr int kBits = Sparse::kDigitBits;
constexpr std::int64_t kHalf = std::int64_t{1} << (kBits - 1);
constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;

/// x's lowest digit, in [-2^59, 2^59); x becomes the rest, in units of the next digit.
template <class Integer>
std::int64_t take_digit(Integer& x) noexcept {
  x += kHalf;
  const std::int64_t digit = static_cast<std::int64_t>(static_cast<std::uint64_t>(x) & kMask) - kHalf;
  x >>= kBits;
  return digit;
}

}  // namespace

constinit thread_local SparseScratch* SparseScratch::current_ = nullptr;

void SparseScratch::raise() noexcept { doubt_.raise(); }

/// Places from kDigits on are those of more_digits_.
Sparse::Digit* SparseScratch::room(int digits) noexcept {
  if (used_ + digits <= kDigits) return digits_ + used_;
  used_ = std::max(used_, kDigits);
  if (more_digits_ == nullptr) {
    more_digits_.reset(static_cast<Sparse::Digit*>(::operator new(kMoreDigits * sizeof(Sparse::Digit), std::nothrow)));
  }
  if (used_ + digits <= kDigits + kMoreDigits && more_digits_ != nullptr) return more_digits_.get() + (used_ - kDigits);
  raise();
  return nullptr;
}

bool SparseScratch::spend(int products) noexcept {
  products_ += products;
  if (products_ <= kMostProducts) return true;
  raise();
  return false;
}

Sparse::Sparse(int value) noexcept {
  if (value == 0) return;
  SparseScratch& scratch = *SparseScratch::current_;
  Digit* const digits = scratch.room(1);
  if (digits == nullptr) return;
  digits[0] = {value, 0};
  digits_ = digits;
  size_ = 1;
  scratch.keep(1);
}

Sparse Sparse::scaled(double x, long exponent) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52) & 0x7FF;
  const std::uint64_t fraction = bits & 0x000FFFFFFFFFFFFF;
  std::int64_t significand = static_cast<std::int64_t>(biased == 0 ? fraction : fraction | 0x0010000000000000);
  Sparse result;
  if (significand == 0) return result;
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(significand));
  significand >>= zeros;
  const long power = (biased == 0 ? 1 : biased) - 1075 + zeros - exponent;
  int index = static_cast<int>(power / kBits), offset = static_cast<int>(power % kBits);
  if (offset < 0) {
    offset += kBits;
    --index;
  }
  constexpr int kMost = 2;  // 53 + 59 bits are less than 119
  SparseScratch& scratch = *SparseScratch::current_;
  Digit* const digits = scratch.room(kMost);
  if (digits == nullptr) return result;
  Wide rest = Wide{(bits >> 63) != 0 ? -significand : significand} << offset;
  for (; rest != 0; ++index) {
    const std::int64_t digit = take_digit(rest);
    if (digit != 0) digits[result.size_++] = {digit, index};
  }
  result.digits_ = digits;
  scratch.keep(result.size_);
  return result;
}

long Sparse::bits() const noexcept {
  if (size_ == 0) return kNoError;
  const Digit& top = digits_[size_ - 1];
  return long{kDigitBits} * top.index +
         std::bit_width(static_cast<std::uint64_t>(top.value < 0 ? -top.value : top.value));
}

Sparse::Part Sparse::leading(int digits) const noexcept {
  if (size_ <= digits) return {*this, kNoError};
  Sparse part;
  part.digits_ = digits_ + (size_ - digits);
  part.size_ = digits;
  return {part, long{kDigitBits} * part.digits_[0].index};
}

/// Each sum is below 2^60 + 1, and the carry is -1, 0 or 1. Two digits make at most one and a carry, and so does one
/// that becomes 2^59, the negative of a digit of b, or with a carry.
Sparse Sparse::sum(const Sparse& a, const Sparse& b, int sign) noexcept {
  if (b.size_ == 0) return a;
  if (a.size_ == 0 && sign > 0) return b;
  Sparse result;
  SparseScratch& scratch = *SparseScratch::current_;
  Digit* const digits = scratch.room(a.size_ + (sign > 0 ? 1 : 2) * b.size_);
  if (digits == nullptr) return result;
  const Digit *x = a.digits_, *const x_end = x + a.size_, *y = b.digits_, *const y_end = y + b.size_;
  std::int64_t carry = 0;
  int index = 0;
  const auto emit = [&](std::int64_t total) {
    const std::int64_t digit = take_digit(total);
    digits[result.size_] = {digit, index};
    result.size_ += digit != 0;
    carry = total;
  };
  while (x != x_end && y != y_end) {
    const int next = std::min(x->index, y->index);
    if (carry != 0 && next != index + 1) {  // seldom
      ++index;
      emit(carry);
      continue;
    }
    index = next;
    const bool from_x = x->index == next, from_y = y->index == next;
    emit(carry + (from_x ? x->value : 0) + (from_y ? sign * y->value : 0));
    x += from_x;
    y += from_y;
  }
  const bool a_is_done = x == x_end;
  const Digit* const end = a_is_done ? y_end : x_end;
  for (const Digit* rest = a_is_done ? y : x; rest != end; ++rest) {
    while (carry != 0 && rest->index != index + 1) {
      ++index;
      emit(carry);
    }
    index = rest->index;
    emit(carry + (a_is_done ? sign : 1) * rest->value);
  }
  while (carry != 0) {
    ++index;
    emit(carry);
  }
  result.digits_ = digits;
  scratch.keep(result.size_);
  return result;
}

/// A product is at most 2^118, and the carry at most 2^58 + 1.
Sparse Sparse::times_digit(const Sparse& a, const Digit& factor) noexcept {
  Sparse result;
  SparseScratch& scratch = *SparseScratch::current_;
  Digit* const digits = scratch.room(2 * a.size_ + 1);
  if (digits == nullptr) return result;
  const auto emit = [&](std::int64_t digit, int index) {
    digits[result.size_] = {digit, index};
    result.size_ += digit != 0;
  };
  Wide carry = 0;
  int index = a.digits_[0].index;
  for (int i = 0; i < a.size_; ++i) {
    const Digit& x = a.digits_[i];
    if (x.index != index) {
      emit(static_cast<std::int64_t>(carry), index + factor.index);
      carry = 0;
      index = x.index;
    }
    carry += Wide{x.value} * factor.value;
    const std::int64_t digit = take_digit(carry);
    emit(digit, index + factor.index);
    ++index;
  }
  emit(static_cast<std::int64_t>(carry), index + factor.index);
  result.digits_ = digits;
  scratch.keep(result.size_);
  return result;
}

Sparse operator*(const Sparse& a, const Sparse& b) noexcept {
  if (a.size_ == 0 || b.size_ == 0) return Sparse();
  if (b.size_ == 1) return Sparse::times_digit(a, b.digits_[0]);
  if (a.size_ == 1) return Sparse::times_digit(b, a.digits_[0]);
  return multiply_add(a, b, Sparse());
}

/// Sums of the products for each index: at most kMost of them, each at most 2^118, a digit of c and a carry below 2^68.
/// A bit of marks_ stands for an index that has a sum; the next one takes its carry. All sums and marks are 0 again in
/// the end.
Sparse multiply_add(const Sparse& a, const Sparse& b, const Sparse& c) noexcept {
  using Digit = Sparse::Digit;
  if (a.size_ == 0 || b.size_ == 0) return c;
  Sparse result;
  SparseScratch& scratch = *SparseScratch::current_;
  constexpr int kSpan = SparseScratch::kSpan, kMost = 256;
  int low = a.digits_[0].index + b.digits_[0].index;
  int high = a.digits_[a.size_ - 1].index + b.digits_[b.size_ - 1].index;
  if (c.size_ > 0) {
    low = std::min(low, c.digits_[0].index);
    high = std::max(high, c.digits_[c.size_ - 1].index);
  }
  const int span = high - low + 3;
  if (span > kSpan || std::min(a.size_, b.size_) > kMost) {
    scratch.raise();
    return result;
  }
  Digit* const digits = scratch.room(1 + std::min(3 * (a.size_ * b.size_ + c.size_), span));
  if (digits == nullptr || !scratch.spend(a.size_ * b.size_)) return result;
  auto& sums = scratch.sums_;
  auto& marks = scratch.marks_;
  const auto add = [&](int index, Wide x) {
    const auto at = static_cast<unsigned>(index - low);
    sums[at] += x;
    marks[at / 64] |= std::uint64_t{1} << (at % 64);
  };
  for (int i = 0; i < a.size_; ++i) {
    const Digit& x = a.digits_[i];
    for (int j = 0; j < b.size_; ++j) add(x.index + b.digits_[j].index, Wide{x.value} * b.digits_[j].value);
  }
  for (int i = 0; i < c.size_; ++i) add(c.digits_[i].index, c.digits_[i].value);
  Wide carry = 0;
  const auto emit = [&](Wide total, int at) {
    const std::int64_t digit = take_digit(total);
    digits[result.size_] = {digit, low + at};
    result.size_ += digit != 0;
    carry = total;
  };
  int at = 0;
  std::uint64_t previous = 0;
  for (int word = 0; 64 * word < span; ++word) {
    const std::uint64_t here = marks[word];
    marks[word] = 0;
    std::uint64_t bits = here | here << 1 | previous >> 63;
    previous = here;
    for (; bits != 0; bits &= bits - 1) {
      const int next = 64 * word + std::countr_zero(bits);
      while (carry != 0 && at < next) emit(carry, at++);  // seldom
      emit(carry + sums[next], next);
      sums[next] = 0;
      at = next + 1;
    }
  }
  while (carry != 0) emit(carry, at++);
  result.digits_ = digits;
  scratch.keep(result.size_);
  return result;
}

/// Two adjacent digits make an integer of at least 2^59, and what follows is at most 1/2 + 2^-60 of its units: the
/// relative error is below 2^-59, and the conversion's at most 2^-53.
Approximation approximate(const Sparse& x) noexcept {
  if (x.size_ == 0) return {0, 0};
  const Sparse::Digit& top = x.digits_[x.size_ - 1];
  Wide both = Wide{top.value} << kBits;
  if (x.size_ > 1 && x.digits_[x.size_ - 2].index == top.index - 1) both += x.digits_[x.size_ - 2].value;
  int exponent = 0;
  const double significand = std::frexp(static_cast<double>(both), &exponent);
  return {significand, exponent + long{kBits} * (top.index - 1)};
}

}  // namespace touchstone::numbers
