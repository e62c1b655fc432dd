// SPDX-License-Identifier: MIT
#include "broad_phase/large_vector.hpp"

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace touchstone::broad_phase {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

}  // namespace

void* allocate_array(std::size_t bytes) {
  if (bytes < kHugePage) return ::operator new(bytes);
  void* const memory = ::operator new(bytes, std::align_val_t(kHugePage));
#ifdef MADV_HUGEPAGE
  // The pages that the array fills. A system that refuses this gives small pages.
  ::madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_array(void* memory, std::size_t bytes) noexcept {
  if (bytes < kHugePage) {
    ::operator delete(memory);
  } else {
    ::operator delete(memory, std::align_val_t(kHugePage));
  }
}

}  // namespace touchstone::broad_phase
