// Touchstone: the distance of two elements at one instant.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The distance of the two elements of a query at the time t: double-doubles tell it where they can prove which double is
/// nearest, and exact arithmetic elsewhere.
/// @param query   the two elements and their motion; for elements at rest give the same corners at both ends
/// @param t       the time, 0 <= t <= 1
/// @param metric  how a distance is measured
/// @return the distance
/// @throws InvalidQuery  for a NaN or infinite coordinate, a t outside [0, 1] or an unknown metric
Distance distance(const Query& query, double t = 0, Metric metric = Metric::euclidean);
Distance distance(const RationalQuery& query, double t = 0, Metric metric = Metric::euclidean);  ///< the same
Distance distance(const CurvedQuery& query, double t = 0, Metric metric = Metric::euclidean);    ///< the same

/// A number that is at least the Euclidean distance of the two elements at the time t, and at most 1 + 2^-20 times it,
/// or the next double but one. It is much sooner found than the distance, unless the elements are very near each other,
/// or nearly parallel.
/// @param query  the two elements and their motion
/// @param t      the time, 0 <= t <= 1
/// @return the number, 0 for elements that touch; infinity where no double is great enough
/// @throws InvalidQuery  for a NaN or infinite coordinate, or a t outside [0, 1]
double distance_upper_bound(const Query& query, double t = 0);

/// The distance of the two elements at the time t, compared exactly.
/// @param query       the two elements and their motion
/// @param t           the time, 0 <= t <= 1
/// @param separation  the distance to compare with
/// @return negative when the elements are nearer to each other than the separation, zero when their distance equals it,
///         positive when they are farther apart
/// @throws InvalidQuery  for a NaN or infinite coordinate, a t outside [0, 1], or a separation without meaning
int compare_distance(const Query& query, double t, const Separation& separation);
int compare_distance(const RationalQuery& query, double t, const Separation& separation);  ///< the same
int compare_distance(const CurvedQuery& query, double t, const Separation& separation);    ///< the same

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
