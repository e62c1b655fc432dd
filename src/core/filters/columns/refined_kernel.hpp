// The text of the refinement kernels. It is compiled for several widths: see same_side_kernel.hpp for what that
// forbids.
// SPDX-License-Identifier: MIT
#pragma once

#include "filters/columns/refined_columns.hpp"
#include "filters/contact_values_steps.hpp"
#include "filters/gathered_corners.hpp"
#include "filters/refined_root_steps.hpp"
#include "numbers/doubles/pack.hpp"

namespace touchstone::filters {
namespace {

template <int Width>
TOUCHSTONE_INLINE SimpleRootOf<numbers::Pack<Width>> gathered_roots(const BracketedRoots& from,
                                                                    const std::size_t* which) noexcept {
  using Lanes = numbers::Lanes<numbers::Pack<Width>>;
  const auto gathered = [which](const auto* x) { return Lanes::gathered(x, which); };
  const auto axis = gathered(from.axis);
  return {gathered(from.t),
          gathered(from.radius),
          gathered(from.slope),
          gathered(from.slope_error),
          gathered(from.curvature),
          {gathered(from.u), gathered(from.w), gathered(from.r)},
          {(axis & 1) != 0, (axis & 2) != 0},
          (gathered(from.facts) & kInsideElements) != 0};
}

/// refine_root for the roots which[0], which[1] ... of one pack, as far as it goes without exact values.
template <int Width, Kind K>
void refine_pack(const Columns& columns, const RootsToRefine& from, const std::size_t* which, double t_max,
                 bool with_weights, std::size_t first, RefinedRoots& result) {
  using N = numbers::Pack<Width>;
  using Lanes = numbers::Lanes<N>;
  using Mask = typename Lanes::Mask;
  std::size_t queries[Width];
  for (std::size_t lane = 0; lane < Width; ++lane) queries[lane] = from.queries[which[lane]];
  const GatheredCorners<Width> corners(columns, queries);
  const auto corner = [&corners](int side, std::size_t i) {
    const auto& [x, y, z] = corners.at(side, i).c;
    return CoordinatesOfSeveral<Width>{x, y, z};
  };
  const SimpleRootOf<N> root = gathered_roots<Width>(from.roots, which);
  const MagnitudesOf<N>& m = root.magnitudes;
  const auto frame = moving_frame(K, corner, root.t);
  const N value = numbers::rounded(precise_coplanarity(frame));
  const OffsetOf<N> offset = offset_of(root, root.t, value, kCoplanarityError * (m.u * m.w * m.r));
  const NearestDouble<N> at = nearest_double(root.t, offset);
  const N toi = chosen(at.earlier, before(at.nearest), at.nearest);
  const N toi_upper = chosen(at.earlier, at.nearest, after(at.nearest));
  const Mask late = is_late(toi, toi_upper, Lanes::all(t_max));
  Mask outside = Mask{};
  Mask touches = at.near & (at.earlier | at.later);  // or is late
  if (with_weights || Lanes::any(root.inside == 0)) {
    const ComponentsAt<N> components = rounded(precise_components(K, frame, root.axis));
    const N spread = component_spread(offset);
    const SidesAtRoot<N> sides = sides_at_root(K, components, m, offset, spread);
    outside = (root.inside == 0) & sides.outside;
    touches = touches & (root.inside | sides.inside);
    if (with_weights) {
      const WeightsAtRoot<N> found = weights_at_root(K, components, m, offset, spread);
      touches = touches & (late | found.certain);
      for (std::size_t k = 0; k < 3; ++k) Lanes::store(found.weights[k], result.weights[k] + first);
    }
  }
  constexpr auto kContact = static_cast<std::int64_t>(Outcome::contact);
  constexpr auto kNoContact = static_cast<std::int64_t>(Outcome::no_contact);
  static_assert(static_cast<std::int64_t>(Outcome::uncertain) == 0);
  Lanes::store(((outside | (touches & late)) & kNoContact) | (touches & (late == 0) & kContact),
               result.finding + first);
  Lanes::store(toi, result.toi + first);
  Lanes::store(toi_upper, result.toi_upper + first);
}

/// Whole packs. The last one has its last root in every lane that is left over.
template <int Width, Kind K>
void refine(const Columns& columns, const RootsToRefine& roots, double t_max, bool with_weights, RefinedRoots& result) {
  std::size_t i = 0;
  for (; i + Width <= roots.count; i += Width) {
    refine_pack<Width, K>(columns, roots, roots.which + i, t_max, with_weights, i, result);
  }
  if (i == roots.count) return;
  std::size_t rest[Width];
  for (std::size_t lane = 0; lane < Width; ++lane) {
    rest[lane] = roots.which[i + lane < roots.count ? i + lane : roots.count - 1];
  }
  refine_pack<Width, K>(columns, roots, rest, t_max, with_weights, i, result);
}

template <int Width>
RefineKernel refine_kernel_for(Kind kind) {
  return kind == Kind::edge_edge ? refine<Width, Kind::edge_edge> : refine<Width, Kind::vertex_face>;
}

}  // namespace
}  // namespace touchstone::filters
