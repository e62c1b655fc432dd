// Vectors that may hold hundreds of megabytes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace touchstone::broad_phase {

/// Memory for an array. From 2 MB on, huge pages are asked for, where the system has them: the first touch of a page
/// costs a fault, and one fault for 2 MB costs much less than 512 of them. @throws std::bad_alloc
void* allocate_array(std::size_t bytes, std::align_val_t alignment);
void free_array(void* memory, std::size_t bytes, std::align_val_t alignment) noexcept;

template <class T>
struct ArrayAllocator {
  using value_type = T;
  static constexpr auto kAlignment = std::align_val_t(alignof(T));

  ArrayAllocator() = default;
  template <class U>
  ArrayAllocator(const ArrayAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_array(count * sizeof(T), kAlignment));
  }
  void deallocate(T* memory, std::size_t count) noexcept { free_array(memory, count * sizeof(T), kAlignment); }

  /// Elements of plain types are not set to zero: they are written before they are read.
  template <class U>
  void construct(U* at) noexcept(std::is_nothrow_default_constructible_v<U>) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }

  bool operator==(const ArrayAllocator&) const = default;
};

template <class T>
using LargeVector = std::vector<T, ArrayAllocator<T>>;

}  // namespace touchstone::broad_phase
