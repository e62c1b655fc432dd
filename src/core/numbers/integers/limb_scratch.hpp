// Memory for long numbers that live no longer than one decision: on the stack, without the heap.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace touchstone::numbers {

/// While a scratch lives, numbers of its thread that are too long to hold their own limbs take its blocks. Where no
/// block is free or large enough, they use the heap. A number in a block must not outlive the scratch, nor go to
/// another thread.
class LimbScratch {
 public:
  /// GMP's, of 64 bits: where a long has fewer, as on WebAssembly, GMP must be built for limbs of the longer type.
  using Limb = std::conditional_t<sizeof(unsigned long) == 8, unsigned long, unsigned long long>;
  static constexpr int kBlockLimbs = 48;  ///< 3,072 bits
  static constexpr int kBlocks = 64;

  LimbScratch() noexcept : previous_(current_) { current_ = this; }
  ~LimbScratch() { current_ = previous_; }
  LimbScratch(const LimbScratch&) = delete;
  LimbScratch& operator=(const LimbScratch&) = delete;

  /// A block for so many limbs, or null.
  static Limb* take(int limbs) noexcept {
    LimbScratch* const scratch = current_;
    return scratch != nullptr && limbs <= kBlockLimbs ? scratch->take_block() : nullptr;
  }

  /// Frees the block if it belongs to a scratch of this thread; returns whether it does.
  static bool give_back(const Limb* block) noexcept {
    for (LimbScratch* scratch = current_; scratch != nullptr; scratch = scratch->previous_) {
      const std::ptrdiff_t offset =
          reinterpret_cast<std::intptr_t>(block) - reinterpret_cast<std::intptr_t>(scratch->blocks_);
      if (offset < 0 || offset >= static_cast<std::ptrdiff_t>(sizeof blocks_)) continue;
      scratch->free_ |= std::uint64_t{1} << (offset / static_cast<std::ptrdiff_t>(sizeof blocks_[0]));
      return true;
    }
    return false;
  }

 private:
  Limb* take_block() noexcept;

  static thread_local LimbScratch* current_;  // NOLINT(readability-identifier-naming)

  LimbScratch* previous_;
  std::uint64_t free_ = ~std::uint64_t{0};  // bit i: block i
  Limb blocks_[kBlocks][kBlockLimbs];       // 24 KiB, not initialised
};

}  // namespace touchstone::numbers
