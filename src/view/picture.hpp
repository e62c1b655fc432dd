// What the page draws of a query: motions relative to the place and the time where the elements meet or come closest.
//
// Everything is computed in exact arithmetic, and becomes a double at the end. So each number of the picture has a
// relative error of about 2^-50 by itself, and differences that are far smaller than the rounding of the coordinates
// stay visible. docs/view.md says what is drawn.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <touchstone/answer.hpp>
#include <touchstone/separation.hpp>

#include "io/queries/query_parser.hpp"
#include "view/moving_corners.hpp"

namespace touchstone::view {

/// The time that the picture's times are relative to, and the points that its positions are relative to.
struct Origin {
  Exact t;                       ///< the first contact within 2^-260 where that is known, or the closest approach
  std::array<Exact, 4> weights;  ///< of the closest points at t
};
Origin origin_of(const io::FileQuery& query, const MovingCorners& corners, const Answer& answer, double t_max,
                 const Separation& separation);

/// The picture of a valid query and its answer over [0, t_max]:
///
///     kind, names, first, planar  the kind, the corners' names, how many belong to the first element, whether z = 0
///     contact, t, tMax            t is a double near the origin's time
///     exponent                    lengths are multiples of 2^exponent
///     deepest                     the zoom, a power of two, at which the gap fills the view
///     basis                       right, up and towards the reader, for a first view
///     denominator                 a polynomial in s = (time - origin's time), constant first, as all below
///     carrier                     x, y, z of the first element's closest point relative to its place at s = 0
///     gap                         the second element's closest point relative to the first one's
///     corners                     relative to the closest point of its own element; weights: of the corners there
///     planes                      of the proof, over [0, 1]: until (t), untilS, normal, and offsets,
///                                 the normal times each corner relative to the first element's closest point
///     marks                       t, s, sort (start, root, contact, closest, end), text
///
/// All vectors but `normal` are to be divided by the denominator.
nlohmann::json picture_of(const io::FileQuery& query, const Answer& answer, double t_max,
                          const Separation& separation = {});

}  // namespace touchstone::view
