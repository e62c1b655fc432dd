// Whether two elements touch at one moment, and where.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "oracle/place.hpp"

namespace touchstone::oracle {

struct Touch {
  Place a;
  Place b;
};

/// The touching point at a moment at which the contact equations hold, or nothing.
std::optional<Touch> touch(Kind kind, const Corners& corners, const Moment& at);

}  // namespace touchstone::oracle
