// A small seeded generator whose numbers are the same with every compiler and library.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace touchstone::generators {

/// The next state and output of splitmix64 (Steele, Lea and Flood 2014): mixes seeds.
constexpr std::uint64_t splitmix64(std::uint64_t& state) noexcept {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// A seed for part `index` of what `seed` makes, so that no part depends on how many numbers another one drew.
constexpr std::uint64_t seed_of_part(std::uint64_t seed, std::uint64_t index) noexcept {
  std::uint64_t state = splitmix64(seed) ^ (index * 0xD1342543DE82EF95u);
  return splitmix64(state);
}

/// xoshiro256** (Blackman and Vigna 2018), seeded by splitmix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept {
    for (auto& word : state_) word = splitmix64(seed);
  }

  std::uint64_t bits() noexcept {
    const std::uint64_t result = rotated(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotated(state_[3], 45);
    return result;
  }

  /// In [0, n), n > 0. The modulo's bias of n / 2^64 does not matter.
  std::uint64_t below(std::uint64_t n) noexcept { return bits() % n; }

  /// A multiple of 2^-53 in [0, 1).
  double unit() noexcept { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  double between(double low, double high) noexcept { return low + (high - low) * unit(); }

 private:
  static constexpr std::uint64_t rotated(std::uint64_t x, int k) noexcept { return (x << k) | (x >> (64 - k)); }
  std::array<std::uint64_t, 4> state_;
};

}  // namespace touchstone::generators
