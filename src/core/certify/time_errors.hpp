// How far claimed times lie before or after the exact ones. Exact counts in bounded memory.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace touchstone::certify {

/// The number of doubles in [from, to): 0 when they are equal, 1 for neighbours. 0 and -0 are one double.
/// Both are finite and from <= to.
std::uint64_t ulps_between(double from, double to) noexcept;

/// How far a claimed time may lie from the exact one; without either member, any distance.
struct TimeLimit {
  std::optional<std::uint64_t> ulps;  ///< as ulps_between
  std::optional<double> fraction;     ///< of the step

  /// @param from, to  as for ulps_between
  bool allows(double from, double to) const noexcept {
    return !(ulps && ulps_between(from, to) > *ulps) && !(fraction && to - from > *fraction);
  }
};

/// A late time for `allows` from the answer's toi on. One that was written with more digits may round to that toi: it
/// is late by a double at most, and counts as late by one.
inline double late_until(double claimed, double toi) noexcept {
  const double next = std::nextafter(toi, std::numeric_limits<double>::infinity());
  return claimed > toi ? claimed : next;
}

/// Which wrong claims count. @tparam Class  the ways in which a claim is wrong
template <class Class>
struct Counting {
  std::optional<TimeLimit> late;  ///< how far after the exact time a late one must be; nothing: any late one counts
  std::vector<Class> classes;     ///< those that count; empty: all

  bool has(Class one) const noexcept {
    return classes.empty() || std::find(classes.begin(), classes.end(), one) != classes.end();
  }
  /// Whether a time that is late does not count. @param toi  the answer's
  bool allows(double claimed, double toi) const noexcept { return late && late->allows(toi, late_until(claimed, toi)); }
};

/// Claims whose distance lies in [from, below).
template <class Distance>
struct ErrorBucket {
  Distance from{};
  std::optional<Distance> below;  ///< nothing: no upper end
  std::uint64_t claims = 0;
};

/// Counts the distances of claimed times from exact ones in buckets that double in width, so that any number of claims
/// takes the same memory, partial counts from several threads add up to the same, and the bucket of the median is exact.
class TimeErrors {
 public:
  /// @param from, to  the claimed time and the answer's toi, or the other way round: finite, from <= to
  void add(double from, double to) noexcept;
  void merge(const TimeErrors& other) noexcept;

  std::uint64_t claims() const noexcept { return claims_; }

  // Of at least one claim:
  std::uint64_t least_ulps() const noexcept { return least_ulps_; }
  std::uint64_t most_ulps() const noexcept { return most_ulps_; }
  double least_time() const noexcept { return least_time_; }  ///< to - from, rounded to nearest
  double most_time() const noexcept { return most_time_; }
  ErrorBucket<std::uint64_t> median_ulps() const;  ///< where the lower median lies
  ErrorBucket<double> median_time() const;

  /// The buckets that are not empty, ascending: {0}, [1, 2), [2, 4), [4, 8), ...
  std::vector<ErrorBucket<std::uint64_t>> ulps() const;
  /// The buckets that are not empty, ascending: {0}, and [2^k, 2^(k+1)).
  std::vector<ErrorBucket<double>> times() const;

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
