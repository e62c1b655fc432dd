// A list of at most so many, without allocation.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace touchstone::exact {

/// Like std::vector, in storage of its own; elements are made where they are added.
template <class T, std::size_t Capacity>
class BoundedList {
 public:
  BoundedList() noexcept {}  // NOLINT(modernize-use-equals-default): the elements are not made yet
  BoundedList(const BoundedList&) = delete;
  BoundedList& operator=(const BoundedList&) = delete;
  ~BoundedList() { std::destroy_n(begin(), size_); }

  /// There must be room.
  template <class... Arguments>
  void add(Arguments&&... arguments) {
    ::new (static_cast<void*>(storage_ + size_ * sizeof(T))) T{std::forward<Arguments>(arguments)...};
    ++size_;
  }

  std::size_t size() const noexcept { return size_; }
  T* begin() noexcept { return std::launder(reinterpret_cast<T*>(storage_)); }
  T* end() noexcept { return begin() + size_; }
  const T* begin() const noexcept { return std::launder(reinterpret_cast<const T*>(storage_)); }
  const T* end() const noexcept { return begin() + size_; }
  T& operator[](std::size_t i) noexcept { return begin()[i]; }
  const T& operator[](std::size_t i) const noexcept { return begin()[i]; }

 private:
  alignas(T) unsigned char storage_[Capacity * sizeof(T)];
  std::size_t size_ = 0;
};

}  // namespace touchstone::exact
