// A value that is made when it is first asked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <new>
#include <utility>

namespace touchstone::exact {

/// Like std::optional, but its constructor does not clear the storage: these values are large, many, and mostly unused.
template <class T>
class Lazy {
 public:
  Lazy() noexcept {}  // NOLINT(modernize-use-equals-default): the value is not made yet
  ~Lazy() {
    if (made_) std::destroy_at(get());
  }
  Lazy(const Lazy&) = delete;
  Lazy& operator=(const Lazy&) = delete;

  template <class Make>
  const T& value_or_make(Make&& make) {
    if (!made_) {
      ::new (static_cast<void*>(storage_)) T(make());
      made_ = true;
    }
    return *get();
  }

 private:
  T* get() noexcept { return std::launder(reinterpret_cast<T*>(storage_)); }

  alignas(T) unsigned char storage_[sizeof(T)];
  bool made_ = false;
};

}  // namespace touchstone::exact
