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
  const std::size_t whole_pages = (bytes + kHugePage - 1) / kHugePage * kHugePage;
  void* const memory = ::operator new(whole_pages, std::align_val_t(kHugePage));
#ifdef MADV_HUGEPAGE
  ::madvise(memory, whole_pages, MADV_HUGEPAGE);  // a system that refuses it gives small pages
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
