// Touchstone: how the time of the first contact changes with the corners.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The gradient of the time of a first contact.
struct ToiGradient {
  /// Whether there is a contact, and its exact time has a derivative by every coordinate. It has none
  /// - where the elements are in contact at t = 0, or only touch and leave again: the velocity towards each other is 0;
  /// - with d = 0, unless the contact is inside both edges, or inside the face: elsewhere a small change ends it, or
  ///   gives it to other features;
  /// - with d > 0, where two edges have more than one pair of closest points, and where an edge has no length or a face
  ///   no area at that time.
  bool exists = false;

  /// The derivatives of the time by the coordinates of each corner at t = 0, in units of 1 / length; zeros where there
  /// is no gradient. Each is the true one, or one of the two doubles beside it, and exactly 0 only where that is.
  std::array<Vec3, 4> start{};
  std::array<Vec3, 4> end{};  ///< the same at t = 1
};

/// The gradient of the first contact's time in [0, t_max]. For coordinates of ordinary size it mostly takes less than
/// twice as long as `solve`, in double-doubles with proven bounds. Where they do not tell each derivative, exact
/// arithmetic does, in some tenths of a millisecond: near a border or a grazing contact, very near to t = 0, and for
/// extreme sizes.
///
/// At the time T let n be the contact's normal, w_i the weight of corner i in the contact, negative on the first
/// element, and v_i = x1_i - x0_i. Then dT/dx0_i = -(1 - T) w_i n / s and dT/dx1_i = -T w_i n / s, for s the sum of
/// w_i n . v_i: the implicit function theorem for V(T) = 0 or, with a separation, for the squared distance, whose
/// gradient by the corners is that for fixed weights.
/// @param query       the two elements and their motion
/// @param separation  the distance that they are to keep; the metric of a distance > 0 is Euclidean
/// @param t_max       the end of the time range, 0 <= t_max <= 1
/// @return the gradient; a derivative beyond the greatest double is infinite
/// @throws InvalidQuery  for a NaN or infinite coordinate, a t_max outside [0, 1], a distance that is negative or not
///                       finite, or a distance > 0 in a metric that is not Euclidean
ToiGradient toi_gradient(const Query& query, const Separation& separation = {}, double t_max = 1.0);

/// The same for rational coordinates.
ToiGradient toi_gradient(const RationalQuery& query, const Separation& separation = {}, double t_max = 1.0);

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
