// Work on many items, on one thread or several.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace touchstone::threads {

inline constexpr int kMostThreads = 1024;

/// @throws InvalidQuery  naming the number of threads, unless it is in [0, kMostThreads]
void validate_threads(int threads);

/// Covers [0, count) by calls of work(first, last) with last - first <= about `block` items, on `threads` threads (0:
/// as many as the machine has). Each call runs in the default floating-point environment. With one thread there may be
/// one call for all, and it runs on the calling thread. An exception of `work` ends the others, and is thrown.
void for_each_range(std::size_t count, std::size_t block, int threads,
                    const std::function<void(std::size_t first, std::size_t last)>& work);

}  // namespace touchstone::threads
