// A small seeded generator of random numbers that are the same with every compiler and library.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace touchstone::seeded {

/// The next state and output of splitmix64 (Steele, Lea and Flood 2014): mixes seeds.
constexpr std::uint64_t splitmix64(std::uint64_t& state) noexcept {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// A seed for stream `index` of the sequence of `seed`. So no stream depends on how many numbers another one drew.
constexpr std::uint64_t seed_of_stream(std::uint64_t seed, std::uint64_t index) noexcept {
  std::uint64_t state = splitmix64(seed) ^ (index * 0xD1342543DE82EF95u);
  return splitmix64(state);
}

/// xoshiro256** (Blackman and Vigna 2018), seeded by splitmix64.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) noexcept {
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

  /// An integer in [low, high]. The modulo's bias of at most 2^-40 for the small ranges used here does not matter.
  int between(int low, int high) noexcept {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }

  /// In [0, n), n > 0. The modulo's bias of n / 2^64 does not matter.
  std::uint64_t below(std::uint64_t n) noexcept { return bits() % n; }

  bool one_in(int n) noexcept { return between(1, n) == 1; }

  /// A multiple of 2^-53 in [0, 1).
  double unit() noexcept { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// A multiple of 2^-52 in [-1, 1).
  double symmetric() noexcept { return 2 * unit() - 1; }

  double uniform(double low, double high) noexcept { return low + (high - low) * unit(); }

  template <typename T, std::size_t N>
  const T& pick(const std::array<T, N>& items) noexcept {
    return items[static_cast<std::size_t>(bits() % N)];
  }

 private:
  static constexpr std::uint64_t rotated(std::uint64_t x, int k) noexcept { return (x << k) | (x >> (64 - k)); }
  std::array<std::uint64_t, 4> state_;
};

}  // namespace touchstone::seeded
