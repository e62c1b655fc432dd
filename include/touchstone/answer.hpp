// Touchstone: the answers.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>

#include <touchstone/names.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// How the two elements meet at the first contact. V(t) is the coplanarity cubic of edge-edge and vertex-face queries:
/// a polynomial of degree at most 3 that is zero exactly when the four corners lie in one plane. The other two kinds
/// have no V. V is a polynomial on the whole real line, so it may change its sign at t = 0 and t = 1 too.
///
/// With a separation d > 0, let D(t) be the distance of the elements, for all real t. The nature is `entering` when
/// D = d at the time of impact and D < d just after it. It is `grazing` when D = d there and D > d just before and just
/// after it. It is `isolated` when D = d there, D > d just after it and D <= d just before it, which happens at t = 0
/// only. It is `sustained` when D stays d, or when the elements start with D < d.
enum class Nature : std::uint8_t {
  none,       ///< there is no contact
  crossing,   ///< V is not identically zero and changes sign at the time of impact
  grazing,    ///< V is not identically zero and does not change sign at the time of impact
  sustained,  ///< the elements touch during an interval of positive length that starts at the time of impact
  isolated,   ///< the contact is a single instant, and V is identically zero or the kind has no V
  entering    ///< with a separation d > 0: the distance is d at the time of impact and less than d just after it
};

/// What the distance of the two elements does just after the time of impact. Only an answer with a separation d > 0
/// has one.
enum class Trend : std::uint8_t {
  none,         ///< there is no contact, or no separation
  approaching,  ///< the distance falls
  constant,     ///< the distance stays as it is
  leaving       ///< the distance rises
};

/// The part of an element that is touched. If several features fit the touching point, the answer is the first of them
/// in this order. So a zero-length edge is touched at its first corner.
enum class Feature : std::uint8_t {
  none,    ///< there is no contact
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
  p,       ///< the point of a point-edge query, or the first point of a point-point query
  e0,      ///< first corner of the edge of a point-edge query
  e1,      ///< second corner of the edge of a point-edge query
  e,       ///< interior of the edge of a point-edge query
  q,       ///< the second point of a point-point query
  overlap  ///< both edges, along a segment of positive length
};

/// The level of the solver that decided an answer.
enum class Level : std::uint8_t {
  filter,   ///< a test in error-bounded doubles that needs no root of V
  bracket,  ///< roots of V isolated and refined in error-bounded doubles
  exact,    ///< the library's own exact arithmetic
  oracle    ///< CGAL's number types and algebraic kernel
};

/// What a caller wants to know of a contact. Each value leaves out more than the one before, and costs less.
enum class Wanted : std::uint8_t {
  all,       ///< everything
  features,  ///< all but the weights
  time,      ///< toi, toi_upper and starts_within
  contact    ///< whether there is one
};

/// "", "crossing", "grazing", "sustained", "isolated", "entering".
template <>
Names names_of<Nature>() noexcept;

/// "", "a0", "a1", "a", and so on to "overlap": as the enumerators.
template <>
Names names_of<Feature>() noexcept;

/// "filter", "bracket", "exact", "oracle".
template <>
Names names_of<Level>() noexcept;

/// "", "approaching", "constant", "leaving".
template <>
Names names_of<Trend>() noexcept;

/// "all", "features", "time", "contact".
template <>
Names names_of<Wanted>() noexcept;

/// The answer to one query. With a separation d > 0, `touch` below means to be within d. The touched features then hold
/// the closest points, and the weights are those of the closest points. Without contact only `contact` and `level` have
/// a meaning, and both times are +infinity. SolveOptions::wanted may leave members of a contact out: these are as
/// without contact, but times are NaN.
struct Answer {
  bool contact = false;               ///< Whether the elements touch at any time in [0, t_max].
  Level level = Level::exact;         ///< Which level decided.
  Nature nature = Nature::none;       ///< How the elements meet at the first contact.
  Feature feature_a = Feature::none;  ///< The touched part of the first element: edge a, vertex v or point p.
  Feature feature_b = Feature::none;  ///< The touched part of the second element: edge b, face f, edge e or point q.
  bool starts_within = false;         ///< Whether the contact exists at t = 0 already. `toi` may be 0 without it.
  Trend trend = Trend::none;          ///< What the distance does next, with a separation d > 0.

  /// The largest double <= the exact first time of contact, in [0, t_max]. A step of this length is safe, and no larger
  /// double is.
  double toi;

  /// The smallest double >= the exact first time of contact, in [0, t_max]. It equals `toi` when the exact time is a
  /// double; otherwise it is the next double after `toi`.
  double toi_upper;

  /// Barycentric coordinates of the touching point on the first element at the exact time: (a0, a1, 0) for an edge,
  /// (1, 0, 0) for a vertex or point. Each is in [0, 1] and within 2^-50 of its true value. A corner that does not
  /// belong to the touched feature has weight 0. An overlap has many touching points. The answer gives the one with the
  /// lexicographically smallest (a0, a1, b0, b1).
  ///
  /// With a separation in the largest-axis metric there may be many pairs of closest points. The answer gives the one
  /// with the lexicographically smallest weights, of the first element and then of the second. A zero-length edge is
  /// its first corner. A flat triangle is the first of f0, f1, f2, f01, f12, f20 that holds closest points.
  std::array<double, 3> weights_a{};

  /// The same on the second element: (b0, b1, 0) or (e0, e1, 0) for an edge, (f0, f1, f2) for a face, (1, 0, 0) for a
  /// point.
  std::array<double, 3> weights_b{};

  /// An answer without contact.
  Answer() noexcept;
};

/// For a person: "contact at t in [0.3333333333333333, 0.33333333333333337], crossing, a against b", "no contact". A time
/// is the shortest decimal that reads back as the same double.
std::string to_string(const Answer& answer);

/// Writes the text of to_string.
template <class Traits>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, const Answer& answer) {
  return out << to_string(answer);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
