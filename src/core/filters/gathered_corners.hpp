// The corners of several queries of columns as packs. See same_side_kernel.hpp for what this forbids.
// SPDX-License-Identifier: MIT
#pragma once

#include "filters/columns/same_side_columns.hpp"
#include "geometry/vector.hpp"
#include "numbers/doubles/pack.hpp"

namespace touchstone::filters {
namespace {

/// The corners of the queries of one pack.
template <int Width>
struct GatheredCorners {
  using Corner = geometry::Vector<numbers::Pack<Width>>;
  Corner start[4], end[4];

  GatheredCorners(const Columns& columns, const std::size_t* which) noexcept {
    const auto gathered = [which](const double* const(&x)[3]) {
      using Lanes = numbers::Lanes<numbers::Pack<Width>>;
      return Corner{{Lanes::gathered(x[0], which), Lanes::gathered(x[1], which), Lanes::gathered(x[2], which)}};
    };
    for (std::size_t i = 0; i < 4; ++i) {
      start[i] = gathered(columns.start[i]);
      end[i] = gathered(columns.end[i]);
    }
  }

  const Corner& at(int side, std::size_t i) const noexcept { return (side == 0 ? start : end)[i]; }
};

}  // namespace
}  // namespace touchstone::filters
