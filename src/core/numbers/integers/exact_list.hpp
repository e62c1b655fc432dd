// A few exact numbers in a row, in storage of its own as long as they are few.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

#include "numbers/integers/exact_number.hpp"

namespace touchstone::numbers {

/// Like std::vector<Exact> of a size that is known when it is made. Up to kInline numbers need no allocation.
class ExactList {
 public:
  ExactList() noexcept : ExactList(0) {}
  explicit ExactList(int size) : data_(storage_for(size)), size_(size), capacity_(size) {
    std::uninitialized_default_construct_n(data_, static_cast<std::size_t>(size));
  }
  ExactList(const Exact* first, int size) : ExactList(size) { std::copy_n(first, size, data_); }
  ExactList(const ExactList& other) : ExactList(other.data_, other.size_) {}
  ExactList(ExactList&& other) noexcept { take(other); }
  ExactList& operator=(const ExactList& other) {
    if (this != &other) *this = ExactList(other);
    return *this;
  }
  ExactList& operator=(ExactList&& other) noexcept {
    if (this == &other) return *this;
    release();
    take(other);
    return *this;
  }
  ~ExactList() { release(); }

  int size() const noexcept { return size_; }
  Exact* begin() noexcept { return data_; }
  Exact* end() noexcept { return data_ + size_; }
  const Exact* begin() const noexcept { return data_; }
  const Exact* end() const noexcept { return data_ + size_; }
  Exact& operator[](std::size_t i) noexcept { return data_[i]; }
  const Exact& operator[](std::size_t i) const noexcept { return data_[i]; }

  /// Forgets all numbers after the first `size` of them.
  void shorten(int size) noexcept {
    std::destroy(data_ + size, data_ + size_);
    size_ = size;
  }

 private:
  static constexpr int kInline = 3;  // a product of two differences; with more, the polynomials of a question are so
                                     // large that the heap gives their pages back after each

  Exact* own() noexcept { return std::launder(reinterpret_cast<Exact*>(storage_)); }
  Exact* storage_for(int size) {
    return size <= kInline ? reinterpret_cast<Exact*>(storage_) : std::allocator<Exact>().allocate(capacity_of(size));
  }
  static std::size_t capacity_of(int size) noexcept { return static_cast<std::size_t>(size); }

  void take(ExactList& other) noexcept {
    size_ = other.size_;
    capacity_ = other.capacity_;
    if (capacity_ > kInline) {
      data_ = std::exchange(other.data_, other.own());
      other.size_ = other.capacity_ = 0;
    } else {
      data_ = reinterpret_cast<Exact*>(storage_);
      std::uninitialized_move_n(other.data_, size_, data_);
    }
  }
  void release() noexcept {
    std::destroy_n(data_, static_cast<std::size_t>(size_));
    if (capacity_ > kInline) std::allocator<Exact>().deallocate(data_, capacity_of(capacity_));
  }

  Exact* data_;
  int size_;
  int capacity_;
  alignas(Exact) unsigned char storage_[kInline * sizeof(Exact)];
};

}  // namespace touchstone::numbers
