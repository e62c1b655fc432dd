// SPDX-License-Identifier: MIT
#include "certify/time_errors.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace touchstone::certify {
namespace {

/// The index of a finite double among all finite doubles in order; both zeros have one index.
std::uint64_t index_of(double value) noexcept {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSign) != 0 ? kSign - (bits & ~kSign) : kSign + bits;
}

template <class Distance>
ErrorBucket<Distance> bucket_of_median(const std::vector<ErrorBucket<Distance>>& buckets, std::uint64_t claims) {
  std::uint64_t before = 0;
  for (const auto& bucket : buckets) {
    before += bucket.claims;
    if (2 * before >= claims) return bucket;
  }
  return {};
}

}  // namespace

std::uint64_t ulps_between(double from, double to) noexcept { return index_of(to) - index_of(from); }

void TimeErrors::add(double from, double to) noexcept {
  const std::uint64_t ulps = ulps_between(from, to);
  const double time = to - from;  // zero only when they are equal: doubles have gradual underflow
  least_ulps_ = claims_ == 0 ? ulps : std::min(least_ulps_, ulps);
  most_ulps_ = std::max(most_ulps_, ulps);
  least_time_ = claims_ == 0 ? time : std::min(least_time_, time);
  most_time_ = std::max(most_time_, time);
  ++claims_;
  ++ulps_[static_cast<std::size_t>(std::bit_width(ulps))];
  ++times_[time == 0 ? 0 : static_cast<std::size_t>(std::ilogb(time) - kLeastExponent + 1)];
}

void TimeErrors::merge(const TimeErrors& other) noexcept {
  if (other.claims_ == 0) return;
  least_ulps_ = claims_ == 0 ? other.least_ulps_ : std::min(least_ulps_, other.least_ulps_);
  most_ulps_ = std::max(most_ulps_, other.most_ulps_);
  least_time_ = claims_ == 0 ? other.least_time_ : std::min(least_time_, other.least_time_);
  most_time_ = std::max(most_time_, other.most_time_);
  claims_ += other.claims_;
  for (std::size_t i = 0; i < ulps_.size(); ++i) ulps_[i] += other.ulps_[i];
  for (std::size_t i = 0; i < times_.size(); ++i) times_[i] += other.times_[i];
}

ErrorBucket<std::uint64_t> TimeErrors::median_ulps() const { return bucket_of_median(ulps(), claims_); }

ErrorBucket<double> TimeErrors::median_time() const { return bucket_of_median(times(), claims_); }

std::vector<ErrorBucket<std::uint64_t>> TimeErrors::ulps() const {
  std::vector<ErrorBucket<std::uint64_t>> buckets;
  for (std::size_t bits = 0; bits < ulps_.size(); ++bits) {
    if (ulps_[bits] == 0) continue;
    ErrorBucket<std::uint64_t> bucket;
    bucket.from = bits == 0 ? 0 : std::uint64_t{1} << (bits - 1);
    if (bits < 64) bucket.below = std::uint64_t{1} << bits;
    bucket.claims = ulps_[bits];
    buckets.push_back(bucket);
  }
  return buckets;
}

std::vector<ErrorBucket<double>> TimeErrors::times() const {
  std::vector<ErrorBucket<double>> buckets;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (times_[i] == 0) continue;
    const int exponent = static_cast<int>(i) - 1 + kLeastExponent;
    ErrorBucket<double> bucket;
    bucket.from = i == 0 ? 0.0 : std::ldexp(1.0, exponent);
    if (exponent < kGreatestExponent) bucket.below = std::ldexp(1.0, i == 0 ? kLeastExponent : exponent + 1);
    bucket.claims = times_[i];
    buckets.push_back(bucket);
  }
  return buckets;
}

}  // namespace touchstone::certify
