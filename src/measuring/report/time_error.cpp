// SPDX-License-Identifier: MIT
#include "report/time_error.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace touchstone::report {
namespace {

/// Neighbouring doubles have neighbouring numbers; zero and -0 are both 0.
std::int64_t number_of(double value) noexcept {
  std::int64_t bits = 0;
  const double magnitude = value < 0 ? -value : value;
  std::memcpy(&bits, &magnitude, sizeof bits);
  bits &= INT64_MAX;  // -0
  return value < 0 ? -bits : bits;
}

std::int64_t lower_median(std::vector<std::int64_t>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::int64_t signed_ulps(double claimed, double exact) noexcept { return number_of(claimed) - number_of(exact); }

std::optional<TimeError> time_error(std::vector<std::int64_t> signed_errors) {
  if (signed_errors.empty()) return std::nullopt;
  TimeError error;
  error.claims = signed_errors.size();
  const auto [least, greatest] = std::minmax_element(signed_errors.begin(), signed_errors.end());
  error.earliest = *least;
  error.latest = *greatest;
  error.median = lower_median(signed_errors);
  for (auto& value : signed_errors) value = std::llabs(value);
  error.median_size = lower_median(signed_errors);
  error.greatest_size = *std::max_element(signed_errors.begin(), signed_errors.end());
  return error;
}

}  // namespace touchstone::report
