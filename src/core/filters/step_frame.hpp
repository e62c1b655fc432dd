// The frame of one query in doubles, at both ends of the step.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "filters/coplanarity_form.hpp"

namespace touchstone::filters {

using Vector = geometry::Vector<double>;

/// Whether queries of this kind have a coplanarity cubic.
constexpr bool has_cubic(Kind kind) noexcept { return kind == Kind::edge_edge || kind == Kind::vertex_face; }

/// The frame of a query that has a cubic.
inline StepFrame<double> frame_of(const Query& query) noexcept {
  return step_frame<double>(query.kind, [&query](int side, std::size_t i) {
    const Vec3& x = (side == 0 ? query.start : query.end)[i];
    return Vector{{x.x, x.y, x.z}};
  });
}

}  // namespace touchstone::filters
