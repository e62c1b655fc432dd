// The distance of claimed times from the exact ones, in units in the last place.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace touchstone::report {

/// The number of doubles from `exact` up to `claimed`: negative when the claim is earlier (safe to step to), positive
/// when it is later, 0 when they are equal. Both are finite and of magnitude at most 1.
std::int64_t signed_ulps(double claimed, double exact) noexcept;

/// The errors of the true claims of contact. Negative: early; positive: late.
struct TimeError {
  std::size_t claims = 0;
  std::int64_t earliest = 0;       ///< the least of the signed errors
  std::int64_t median = 0;         ///< the lower median of them
  std::int64_t latest = 0;         ///< the greatest
  std::int64_t median_size = 0;    ///< the lower median of their magnitudes
  std::int64_t greatest_size = 0;  ///< the greatest magnitude
};

/// Nothing for no error at all.
std::optional<TimeError> time_error(std::vector<std::int64_t> signed_errors);

}  // namespace touchstone::report
