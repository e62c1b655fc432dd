// Threads that work while the caller's thread watches them.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace touchstone::fuzz {

/// Runs `work(i)` on a thread of its own for every i below `count`, each in the default floating-point environment.
/// Meanwhile calls `watch` a few times a second on the caller's thread, until it returns false. `stop` becomes true
/// when `watch` returns false, when a thread throws, and at the end; `work` is to look at it.
/// @throws the first exception of a thread; Error when not all threads can be started, and then the others have ended
void run_on_threads(std::size_t count, std::atomic<bool>& stop, const std::function<void(std::size_t)>& work,
                    const std::function<bool()>& watch);

}  // namespace touchstone::fuzz
