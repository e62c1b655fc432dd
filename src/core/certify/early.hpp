// For claims that hold: how far before the exact time the claimed time lies. Exact counts in bounded memory.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace touchstone::certify {

/// The number of doubles in [from, to): 0 when they are equal, 1 for neighbours. 0 and -0 are one double.
/// Both are finite and from <= to.
std::uint64_t ulps_between(double from, double to) noexcept;

/// Claims whose distance lies in [from, below).
template <class Distance>
struct EarlyBucket {
  Distance from{};
  std::optional<Distance> below;  ///< nothing: no upper end
  std::uint64_t claims = 0;
};

/// Counts distances to the answer's toi in buckets that double in width, so that any number of claims takes the same
/// memory, partial counts from several threads add up to the same, and the bucket of the median is exact.
class EarlyTally {
 public:
  /// @param claimed, toi  finite, claimed <= toi
  void add(double claimed, double toi) noexcept;
  void merge(const EarlyTally& other) noexcept;

  std::uint64_t claims() const noexcept { return claims_; }

  // Of at least one claim:
  std::uint64_t least_ulps() const noexcept { return least_ulps_; }
  std::uint64_t most_ulps() const noexcept { return most_ulps_; }
  double least_time() const noexcept { return least_time_; }  ///< toi - claimed, rounded to nearest
  double most_time() const noexcept { return most_time_; }
  EarlyBucket<std::uint64_t> median_ulps() const;  ///< where the lower median lies
  EarlyBucket<double> median_time() const;

  /// The buckets that are not empty, ascending: {0}, [1, 2), [2, 4), [4, 8), ...
  std::vector<EarlyBucket<std::uint64_t>> ulps() const;
  /// The buckets that are not empty, ascending: {0}, and [2^k, 2^(k+1)).
  std::vector<EarlyBucket<double>> times() const;

 private:
  static constexpr int kLeastExponent = -1074;
  static constexpr int kGreatestExponent = 1023;

  std::uint64_t claims_ = 0;
  std::uint64_t least_ulps_ = 0;
  std::uint64_t most_ulps_ = 0;
  double least_time_ = 0;
  double most_time_ = 0;
  std::array<std::uint64_t, 65> ulps_{};  ///< by the number of bits of the distance
  std::array<std::uint64_t, kGreatestExponent - kLeastExponent + 2> times_{};  ///< zero, then by exponent
};

}  // namespace touchstone::certify
