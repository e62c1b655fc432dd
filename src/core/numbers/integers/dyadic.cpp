// SPDX-License-Identifier: MIT
#include "numbers/integers/dyadic.hpp"

#include <gmp.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>

#include "numbers/integers/limb_scratch.hpp"

#ifndef __SIZEOF_INT128__
#error "a compiler with 128-bit integers is needed (64-bit GCC or clang): products of limbs are of that type"
#endif

namespace touchstone::numbers {
namespace {

static_assert(GMP_NUMB_BITS == 64 && sizeof(Dyadic::Limb) == 8, "limbs must have 64 bits");
static_assert(std::is_same_v<Dyadic::Limb, mp_limb_t>, "limbs must be GMP's");

using Limb = Dyadic::Limb;
__extension__ using Wide = unsigned __int128;

constexpr int kLimbBits = 64;

inline Limb add_with_carry(Limb a, Limb b, Limb& carry) noexcept {
  const Wide total = static_cast<Wide>(a) + b + carry;
  carry = static_cast<Limb>(total >> kLimbBits);
  return static_cast<Limb>(total);
}

inline Limb subtract_with_borrow(Limb a, Limb b, Limb& borrow) noexcept {
  const Wide total = static_cast<Wide>(a) - b - borrow;
  borrow = static_cast<Limb>(total >> kLimbBits) & 1;
  return static_cast<Limb>(total);
}

}  // namespace

thread_local LimbScratch* LimbScratch::current_ = nullptr;

LimbScratch::Limb* LimbScratch::take_block() noexcept {
  if (free_ == 0) return nullptr;
  const int block = std::countr_zero(free_);
  free_ &= free_ - 1;
  return blocks_[block];
}

Dyadic::Dyadic(int value) noexcept : size_(value > 0 ? 1 : value < 0 ? -1 : 0), exponent_(0), capacity_(kInline) {
  inline_[0] = value < 0 ? -static_cast<Limb>(value) : static_cast<Limb>(value);
}

Dyadic::Dyadic(double value) noexcept : size_(0), exponent_(0), capacity_(kInline) {
  const Limb bits = std::bit_cast<Limb>(value);
  Limb significand = bits & 0x000FFFFFFFFFFFFF;
  int exponent = static_cast<int>(bits >> 52) & 0x7FF;
  if (exponent == 0) {
    if (significand == 0) return;
    exponent = 1;
  } else {
    significand |= 0x0010000000000000;
  }
  // value = significand 2^(exponent - 1075); 1088 = 17 * 64.
  const int shifted = exponent - 1075 + 1088;
  const int offset = shifted % kLimbBits;
  exponent_ = shifted / kLimbBits - 17;
  inline_[0] = significand << offset;
  inline_[1] = offset > 11 ? significand >> (kLimbBits - offset) : 0;
  if (inline_[0] == 0) {
    inline_[0] = inline_[1];
    inline_[1] = 0;
    ++exponent_;
  }
  size_ = inline_[1] == 0 ? 1 : 2;
  if ((bits >> 63) != 0) size_ = -size_;
}

Dyadic Dyadic::power_of_two(long exponent) noexcept {
  Dyadic power(1);
  const long limb = exponent >= 0 ? exponent / kLimbBits : -((-exponent + kLimbBits - 1) / kLimbBits);
  power.exponent_ = static_cast<int>(limb);
  power.inline_[0] = Limb{1} << (exponent - limb * kLimbBits);
  return power;
}

Dyadic Dyadic::from_limbs(const Limb* limbs, int count, bool negative) {
  Dyadic result;
  result.reserve(count);
  std::copy(limbs, limbs + count, result.data());
  result.trim(count, negative);
  return result;
}

Dyadic::Dyadic(const Dyadic& other) : size_(other.size_), exponent_(other.exponent_), capacity_(kInline) {
  reserve(other.limb_count());
  copy_limbs(other);
}

Dyadic::Dyadic(Dyadic&& other) noexcept : size_(other.size_), exponent_(other.exponent_), capacity_(other.capacity_) {
  if (capacity_ == kInline) {
    copy_limbs(other);
  } else {
    heap_ = std::exchange(other.heap_, nullptr);
    other.capacity_ = kInline;
    other.size_ = 0;
  }
}

Dyadic& Dyadic::operator=(const Dyadic& other) {
  if (this == &other) return *this;
  if (capacity_ < other.limb_count()) {
    Dyadic copy(other);
    return *this = std::move(copy);
  }
  size_ = other.size_;
  exponent_ = other.exponent_;
  copy_limbs(other);
  return *this;
}

Dyadic& Dyadic::operator=(Dyadic&& other) noexcept {
  if (this == &other) return *this;
  if (other.capacity_ == kInline) {  // no longer than any number's capacity
    size_ = other.size_;
    exponent_ = other.exponent_;
    copy_limbs(other);
    return *this;
  }
  if (capacity_ != kInline) release();
  size_ = std::exchange(other.size_, 0);
  exponent_ = other.exponent_;
  heap_ = std::exchange(other.heap_, nullptr);
  capacity_ = std::exchange(other.capacity_, kInline);
  return *this;
}

void Dyadic::reserve(int limbs) {
  if (limbs <= kInline) return;
  heap_ = LimbScratch::take(limbs);
  if (heap_ == nullptr) heap_ = new Limb[static_cast<std::size_t>(limbs)];
  capacity_ = limbs;
}

void Dyadic::release() noexcept {
  if (!LimbScratch::give_back(heap_)) delete[] heap_;
  capacity_ = kInline;
}

void Dyadic::copy_limbs(const Dyadic& other) noexcept {
  // Four limbs whatever the size: less work than a loop, and most numbers have no more.
  const int count = other.limb_count();
  const Limb* from = other.data();
  Limb* to = data();
  std::memcpy(to, from, 4 * sizeof(Limb));
  if (count > 4) std::memcpy(to + 4, from + 4, static_cast<std::size_t>(count - 4) * sizeof(Limb));
}

/// Drops zero limbs at either end of the `count` limbs written, and sets size and sign.
void Dyadic::trim(int count, bool negative) noexcept {
  Limb* limbs = data();
  if (count > 0 && limbs[count - 1] != 0 && limbs[0] != 0) {
    size_ = negative ? -count : count;
    return;
  }
  while (count > 0 && limbs[count - 1] == 0) --count;
  if (count > 0 && limbs[0] == 0) {
    int zeros = 1;
    while (limbs[zeros] == 0) ++zeros;
    count -= zeros;
    exponent_ += zeros;
    std::memmove(limbs, limbs + zeros, static_cast<std::size_t>(count) * sizeof(Limb));
  }
  size_ = negative ? -count : count;
}

int Dyadic::compare_magnitudes(const Dyadic& a, const Dyadic& b) noexcept {
  const int a_count = a.limb_count();
  const int b_count = b.limb_count();
  if (a_count == 0 || b_count == 0) return (a_count != 0) - (b_count != 0);
  const int a_top = a_count + a.exponent_;
  const int b_top = b_count + b.exponent_;
  if (a_top != b_top) return a_top < b_top ? -1 : 1;
  const Limb* a_limbs = a.data() + a_count;
  const Limb* b_limbs = b.data() + b_count;
  for (int i = std::min(a_count, b_count); i > 0; --i) {
    --a_limbs;
    --b_limbs;
    if (*a_limbs != *b_limbs) return *a_limbs < *b_limbs ? -1 : 1;
  }
  return (a_count > b_count) - (a_count < b_count);  // the first limb of the longer one is not zero
}

/// a + b with b's sign taken from b_size.
Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, int b_size) {
  if (b_size == 0) return a;
  if (a.size_ == 0) {
    Dyadic result = b;
    result.size_ = b_size;
    return result;
  }
  // The larger magnitude first when the signs differ, so that the difference is not negative.
  const bool subtract = (a.size_ < 0) != (b_size < 0);
  const Dyadic* first = &a;
  const Dyadic* second = &b;
  bool negative = a.size_ < 0;
  if (subtract) {
    const int order = compare_magnitudes(a, b);
    if (order == 0) return Dyadic();
    if (order < 0) {
      std::swap(first, second);
      negative = b_size < 0;
    }
  }
  // Limbs of the result, from low to high: those below the higher of the two starts come from one operand (or neither),
  // then both overlap, then one operand or the carry goes on.
  const int low = std::min(first->exponent_, second->exponent_);
  const int first_begin = first->exponent_ - low;
  const int second_begin = second->exponent_ - low;
  const int first_end = first_begin + first->limb_count();
  const int second_end = second_begin + second->limb_count();
  Dyadic result;
  result.exponent_ = low;
  result.reserve(std::max(first_end, second_end) + 1);
  Limb* limbs = result.data();
  const Limb* x = first->data() - first_begin;
  const Limb* y = second->data() - second_begin;
  const auto combine = [subtract](Limb p, Limb q, Limb& carry) {
    return subtract ? subtract_with_borrow(p, q, carry) : add_with_carry(p, q, carry);
  };
  Limb carry = 0;
  int i = 0;
  for (; i < second_begin && i < first_end; ++i) limbs[i] = x[i];
  for (; i < second_begin; ++i) limbs[i] = 0;
  for (; i < first_begin && i < second_end; ++i) limbs[i] = combine(0, y[i], carry);
  for (; i < first_begin; ++i) limbs[i] = combine(0, 0, carry);
  for (; i < first_end && i < second_end; ++i) limbs[i] = combine(x[i], y[i], carry);
  for (; i < first_end; ++i) limbs[i] = combine(x[i], 0, carry);
  for (; i < second_end; ++i) limbs[i] = combine(0, y[i], carry);
  if (carry != 0) limbs[i++] = carry;  // of a sum only: a difference of magnitudes is not negative
  result.trim(i, negative);
  return result;
}

Dyadic Dyadic::product(const Dyadic& a, const Dyadic& b) {
  Dyadic result;
  if (a.size_ == 0 || b.size_ == 0) return result;
  const bool negative = (a.size_ < 0) != (b.size_ < 0);
  const bool a_longer = a.limb_count() >= b.limb_count();
  const Dyadic& longer = a_longer ? a : b;
  const Dyadic& shorter = a_longer ? b : a;
  const int m = longer.limb_count();
  const int n = shorter.limb_count();
  result.exponent_ = a.exponent_ + b.exponent_;
  result.reserve(m + n);
  Limb* limbs = result.data();
  const Limb* x = longer.data();
  const Limb* y = shorter.data();
  if (n == 1) {
    Limb carry = 0;
    for (int i = 0; i < m; ++i) {
      const Wide total = static_cast<Wide>(x[i]) * y[0] + carry;
      limbs[i] = static_cast<Limb>(total);
      carry = static_cast<Limb>(total >> kLimbBits);
    }
    limbs[m] = carry;
  } else if (n == 2) {
    // Both limbs of the shorter operand in one pass, column by column.
    Limb column = 0;  // of the result, and what it carries on
    Wide carried = 0;
    Limb previous = 0;
    for (int i = 0; i <= m; ++i) {
      const Limb current = i < m ? x[i] : 0;
      const Wide low_product = static_cast<Wide>(current) * y[0];
      const Wide high_product = static_cast<Wide>(previous) * y[1];
      Wide total = carried + static_cast<Limb>(low_product);
      const Wide low_sum = static_cast<Wide>(static_cast<Limb>(high_product)) + static_cast<Limb>(total);
      column = static_cast<Limb>(low_sum);
      carried =
          (total >> kLimbBits) + (low_sum >> kLimbBits) + (low_product >> kLimbBits) + (high_product >> kLimbBits);
      limbs[i] = column;
      previous = current;
    }
    limbs[m + 1] = static_cast<Limb>(carried);
  } else {
    mpn_mul(limbs, x, m, y, n);
  }
  result.trim(m + n, negative);
  return result;
}

}  // namespace touchstone::numbers
