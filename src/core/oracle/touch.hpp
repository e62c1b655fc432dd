// Whether two elements touch at one moment, and where.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "oracle/feature_point.hpp"

namespace touchstone::oracle {

struct Touch {
  FeaturePoint a;
  FeaturePoint b;
};

/// The touching point at a moment at which the contact equations hold, or nothing.
std::optional<Touch> touch(Kind kind, const Corners& corners, const Moment& at);

}  // namespace touchstone::oracle
