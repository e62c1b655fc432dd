// Touchstone: the direction between two elements at their first contact.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The unit normal at the first contact for t in [0, t_max], at its exact time. Its distance from the true unit vector
/// is less than 2^-49. Exact arithmetic computes it, in tens of microseconds for touching elements and in hundreds with
/// a separation, for coordinates of ordinary size.
///
/// With a separation d > 0 the normal points from the closest point of the first element to that of the second.
///
/// With d = 0 the normal is parallel to n. Two edges have n = (a1 - a0) x (b1 - b0), and a face has n = (f1 - f0) x
/// (f2 - f0). The normal points from the first element to the second, at their positions just before the time: its
/// product with b0 - a0, or with f0 - v, is positive then. If the corners are coplanar at all times, there is no such
/// side, and the normal points as n does.
/// @param query       the two elements and their motion
/// @param separation  the distance that they are to keep; the metric of a distance > 0 is Euclidean
/// @param t_max       the end of the time range, 0 <= t_max <= 1
/// @return the normal. It is empty in four cases: there is no contact; d = 0 and n = 0; d = 0 and the kind has no n;
///         d > 0 and the elements touch at t = 0, where the closest points are one point
/// @throws InvalidQuery  for a NaN or infinite coordinate, a t_max outside [0, 1], a distance that is negative or not
///                       finite, or a distance > 0 in a metric that is not Euclidean, because the closest points are
///                       then not unique
std::optional<std::array<double, 3>> contact_normal(const Query& query, const Separation& separation = {},
                                                    double t_max = 1.0);

/// The same for rational coordinates.
std::optional<std::array<double, 3>> contact_normal(const RationalQuery& query, const Separation& separation = {},
                                                    double t_max = 1.0);

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
