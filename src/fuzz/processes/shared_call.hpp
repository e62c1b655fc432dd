// A call between two processes over memory that both see: one asks, the other answers.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace touchstone::fuzz {

/// The stage of the child's work. After the child's death, this is the stage in which it died.
enum class CallStage : std::uint32_t { loading, initialising, ready, solving, ending };

/// Lives in shared memory. The child runs hostile code that may write anything here, so the parent reads plain numbers
/// only, once each, and checks them.
struct SharedCall {
  std::atomic<std::uint32_t> asked{0};     ///< raised by the parent when a query is ready
  std::atomic<std::uint32_t> answered{0};  ///< raised by the child when it is ready, and for each answer
  std::atomic<std::uint32_t> asleep[2]{};  ///< not 0: the parent, or the child, may sleep and must be woken
  std::atomic<CallStage> stage{CallStage::loading};

  // The separation, from the beginning; 0: touching. The parent may set another one together with a query.
  double separation = 0;
  std::int32_t metric = 0;  ///< as in plugin.h

  // The query.
  std::uint32_t ends = 0;  ///< not 0: there is no further query
  std::uint32_t kind = 0;  ///< as in plugin.h
  std::array<double, 12> start{};
  std::array<double, 12> end{};

  // The answer.
  std::uint32_t refused = 0;  ///< not 0: the plugin does not take the separation
  std::int32_t status = 0;
  double toi = 0;

  // The plugin, as it describes itself.
  std::uint32_t kinds = 0;
  std::array<char, 512> failure{};  ///< why it cannot run, or ""
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<CallStage>::is_always_lock_free);

enum class Side : std::uint8_t { parent, child };

/// Waits until `word` is no longer `old` or the time is over: awake for a few microseconds, then asleep.
/// `self` is the side that waits. @returns whether it has changed
bool wait_for_change(SharedCall& call, Side self, const std::atomic<std::uint32_t>& word, std::uint32_t old,
                     std::chrono::nanoseconds time);

/// Raises `word` by one, and wakes the other side when it sleeps.
void raise(SharedCall& call, Side self, std::atomic<std::uint32_t>& word);

}  // namespace touchstone::fuzz
