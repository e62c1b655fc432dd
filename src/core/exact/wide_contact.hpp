// Contact in doubles of any exponent: the quick look before sparse numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>

namespace touchstone::exact {

/// What doubles of any exponent tell about two elements over [0, 1].
struct WideLook {
  enum class Verdict {
    apart,     ///< they never touch
    touching,  ///< they touch in the part below, at the only root of V in it, which is a simple one, and not earlier
    open
  };

  /// From a part of [0, 1] to one of its two parts, before or after the point that is distance 2^-exponent of the
  /// part's length from its start, or from its end. As it stands here, that is the middle.
  struct Step {
    double distance = 1;
    long exponent = 1;
    bool from_end = false, after = false;
  };
  static constexpr std::size_t kMostSteps = 6;

  Verdict verdict = Verdict::open;

  // While they touch:
  std::array<Step, kMostSteps> steps{};  ///< from [0, 1] to the part; the contact is inside it
  std::size_t steps_taken = 0;
  int axis = -1;          ///< along which n and all side conditions have certain signs: the contact is no border's
  int sign_at_start = 0;  ///< V's, at the start of the part, with the sign that geometry/frame.hpp gives to V
};

/// A point and an edge are apart or open, two points always open.
WideLook look_widely(const Query& query) noexcept;

}  // namespace touchstone::exact
