// Same side all along: the coplanarity cubic has no root in the step. SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "filters/coplanarity_form.hpp"

namespace touchstone::filters {

using Vector = geometry::Vector<double>;
using Frame = FrameOf<double>;

/// Whether queries of this kind have a coplanarity cubic.
constexpr bool has_cubic(Kind kind) noexcept { return kind == Kind::edge_edge || kind == Kind::vertex_face; }

/// The frame of a query that has a cubic.
inline Frame frame_of(const Query& query) noexcept {
  const auto corner = [&query](int side, std::size_t i) {
    const Vec3& x = (side == 0 ? query.start : query.end)[i];
    return Vector{{x.x, x.y, x.z}};
  };
  return query.kind == Kind::edge_edge ? edge_edge_frame<double>(corner) : vertex_face_frame<double>(corner);
}

}  // namespace touchstone::filters
