// The text of the bracket kernels. It is compiled for several widths: see same_side_kernel.hpp for what that forbids.
// SPDX-License-Identifier: MIT
#pragma once

#include "filters/apart/boxes.hpp"
#include "filters/columns/bracket_columns.hpp"
#include "filters/gathered_corners.hpp"
#include "filters/root_sides.hpp"
#include "filters/step_cubic.hpp"
#include "numbers/doubles/pack.hpp"

namespace touchstone::filters {
namespace {

/// The tests of one pack, in the order of decide_by_filters.
template <int Width, Kind K>
void bracket_pack(const Columns& columns, const std::size_t* which, double t_max, std::size_t first,
                  BracketedRoots& result) {
  using N = numbers::Pack<Width>;
  using Lanes = numbers::Lanes<N>;
  using Mask = typename Lanes::Mask;
  const GatheredCorners<Width> corners(columns, which);
  const StepFrame<N> frame = step_frame<N>(K, [&corners](int side, std::size_t i) { return corners.at(side, i); });
  const MagnitudesOf<N> m = magnitudes_of(frame);
  const StepCubic<N> cubic(coplanarity_coefficients(frame), m.u * m.w * m.r);
  // A coordinate that is not finite makes b0 or b3 NaN or a magnitude infinite, and a shared corner makes V zero: then
  // no sign is certain.
  const Mask one = within_range(m) & cubic.step_variations().one;
  if (!Lanes::any(one)) {
    Lanes::store(Mask{}, result.facts + first);
    return;
  }
  Mask disjoint = Mask{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto corner = [&corners, k](int side, std::size_t i) { return corners.at(side, i)[k]; };
    disjoint = disjoint | ranges_apart<N>(K == Kind::edge_edge ? 2 : 1, 4, Lanes::all(0), corner);
  }
  const typename StepCubic<N>::Root root = cubic.root_between(Lanes::all(0), Lanes::all(1), one & (disjoint == 0));
  const RootTime<N> time = time_of<N>(root, Lanes::all(t_max));
  const SideValues<N> values = side_values(K, frame, m, root.t, root.radius);
  const Sides<N> sides = sides_of(K, values);
  const Mask misses = root.certain & (time.outside | sides.outside);
  const Mask refines = root.certain & ((time.outside | sides.outside | sides.unknown) == 0);
  Lanes::store((one & disjoint & kBoxesDisjoint) | (misses & kNoContactAtRoot) | (refines & kOneRoot) |
                   (refines & sides.inside & kInsideElements) | (refines & time.inside & kInsideStep),
               result.facts + first);
  Lanes::store(root.t, result.t + first);
  Lanes::store(root.radius, result.radius + first);
  Lanes::store(root.slope, result.slope + first);
  Lanes::store(cubic.slope_error(), result.slope_error + first);
  Lanes::store(cubic.curvature(), result.curvature + first);
  Lanes::store(m.u, result.u + first);
  Lanes::store(m.w, result.w + first);
  Lanes::store(m.r, result.r + first);
  Lanes::store((values.axis.is_z & 2) | (values.axis.is_y & 1), result.axis + first);
}

/// Whole packs. The last one has its last query in every lane that is left over.
template <int Width, Kind K>
void bracket(const Columns& columns, const std::size_t* which, std::size_t count, double t_max,
             BracketedRoots& result) {
  std::size_t i = 0;
  for (; i + Width <= count; i += Width) bracket_pack<Width, K>(columns, which + i, t_max, i, result);
  if (i == count) return;
  std::size_t rest[Width];
  for (std::size_t lane = 0; lane < Width; ++lane) rest[lane] = which[i + lane < count ? i + lane : count - 1];
  bracket_pack<Width, K>(columns, rest, t_max, i, result);
}

template <int Width>
BracketKernel bracket_kernel_for(Kind kind) {
  return kind == Kind::edge_edge ? bracket<Width, Kind::edge_edge> : bracket<Width, Kind::vertex_face>;
}

}  // namespace
}  // namespace touchstone::filters
