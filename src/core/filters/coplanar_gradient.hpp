// How the time of an ordinary contact changes with the corners, in double-doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "geometry/end_gradients.hpp"

namespace touchstone::filters {

/// Writes the gradient of the time of a contact inside both edges, or inside the face, as touchstone/toi_gradient.hpp
/// defines it. False where double-doubles do not tell it, or whether it exists; the gradient is then undefined.
/// @param toi, toi_upper  the neighbouring doubles around the time; the second is not 0
using CoplanarGradient = bool (*)(const Query& query, double toi, double toi_upper,
                                  geometry::EndGradients& gradient) noexcept;

bool coplanar_gradient(const Query& query, double toi, double toi_upper, geometry::EndGradients& gradient) noexcept;

/// The functions that it chooses from: their results are the same bit for bit. `fused`: for processors with AVX2 and
/// fused multiply-add, null on others. Not `fused`: for every one.
CoplanarGradient coplanar_gradient_function(bool fused) noexcept;

}  // namespace touchstone::filters
