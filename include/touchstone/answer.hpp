// Touchstone: the answers.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace touchstone {

/// How the two elements meet at the first contact. V(t) is the coplanarity cubic of edge-edge and vertex-face queries.
enum class Nature : std::uint8_t {
  none,       ///< no contact
  crossing,   ///< V is not identically zero and changes sign at the time of impact
  grazing,    ///< V is not identically zero and does not change sign
  sustained,  ///< the elements touch during an interval of positive length that starts here
  isolated    ///< V is identically zero or the kind has none, and the contact is a single instant
};

/// The part of an element that is touched. Of several names for one place, the first in this order is given
/// (a zero-length edge is touched at its first corner).
enum class Feature : std::uint8_t {
  none,    ///< no contact
  a0,      ///< first corner of the first edge
  a1,      ///< second corner of the first edge
  a,       ///< interior of the first edge
  b0,      ///< first corner of the second edge
  b1,      ///< second corner of the second edge
  b,       ///< interior of the second edge
  v,       ///< the vertex of a vertex-face query
  f0,      ///< first corner of the face
  f1,      ///< second corner of the face
  f2,      ///< third corner of the face
  f01,     ///< interior of the face's edge f0 f1
  f12,     ///< interior of the face's edge f1 f2
  f20,     ///< interior of the face's edge f2 f0
  f,       ///< interior of the face
  p,       ///< the point of a point-edge query, the first point of a point-point query
  e0,      ///< first corner of the edge of a point-edge query
  e1,      ///< second corner of the edge of a point-edge query
  e,       ///< interior of the edge of a point-edge query
  q,       ///< the second point of a point-point query
  overlap  ///< both edges, along a segment of positive length
};

/// Which level of the cascade decided.
enum class Level : std::uint8_t { filter, bracket, exact, oracle };

std::string_view nature_name(Nature nature) noexcept;     ///< "crossing", ...; empty for none
std::string_view feature_name(Feature feature) noexcept;  ///< "a0", ..., "overlap"; empty for none
std::string_view level_name(Level level) noexcept;        ///< "filter", "bracket", "exact", "oracle"

/// The answer to one query. Without contact only `contact` and `level` mean anything; the times are then +infinity.
struct Answer {
  bool contact = false;
  Level level = Level::exact;
  Nature nature = Nature::none;
  Feature feature_a = Feature::none;
  Feature feature_b = Feature::none;

  /// The largest double <= the exact first time of contact, and the smallest double >= it, in [0, t_max].
  /// Equal when the exact time is a double. Stepping to `toi` is safe: no better double exists.
  double toi;
  double toi_upper;

  /// Barycentric coordinates of the touching point on each element at the exact time, each within 2^-50 of its
  /// true value and in [0, 1]: (a0, a1, 0) for an edge, (1, 0, 0) for a point, (f0, f1, f2) for a face. They are
  /// supported on the feature. For an overlap: the lexicographically smallest valid (a0, a1, b0, b1).
  std::array<double, 3> weights_a{};
  std::array<double, 3> weights_b{};

  Answer() noexcept;
};

}  // namespace touchstone
