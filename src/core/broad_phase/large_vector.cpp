// SPDX-License-Identifier: MIT
#include "broad_phase/large_vector.hpp"

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace touchstone::broad_phase {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

/// Of an array of so many bytes.
std::align_val_t alignment_of(std::size_t bytes, std::align_val_t least) {
  return bytes < kHugePage ? least : std::align_val_t(kHugePage);
}

}  // namespace

void* allocate_array(std::size_t bytes, std::align_val_t alignment) {
  void* const memory = ::operator new(bytes, alignment_of(bytes, alignment));
#ifdef MADV_HUGEPAGE
  // The pages that the array fills, which may be none. A system that refuses this gives small pages.
  if (bytes >= kHugePage) ::madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_array(void* memory, std::size_t bytes, std::align_val_t alignment) noexcept {
  ::operator delete(memory, alignment_of(bytes, alignment));
}

}  // namespace touchstone::broad_phase
