// SPDX-License-Identifier: MIT
#include "sim/memory.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace touchstone::sim {

void give_memory_back() noexcept {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

}  // namespace touchstone::sim
