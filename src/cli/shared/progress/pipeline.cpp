// SPDX-License-Identifier: MIT
#include "cli/shared/progress/pipeline.hpp"

#if TOUCHSTONE_WITH_TBB
#include <oneapi/tbb/info.h>
#endif

namespace touchstone::cli {

int default_threads() noexcept {
#if TOUCHSTONE_WITH_TBB
  return tbb::info::default_concurrency();  // those that this process may use; the machine may have more
#else
  return 1;
#endif
}

int thread_count(int threads) noexcept { return threads > 0 ? threads : default_threads(); }

}  // namespace touchstone::cli
