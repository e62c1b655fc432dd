// Touchstone: bodies that turn at a constant rate, as slerp and screw motions do. No finite polynomial is such a
// motion: it is cut into arcs that are rational, with a proved bound on their deviation.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/curved_query.hpp>
#include <touchstone/names.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// What is proved about the motion.
enum class ScrewVerdict : std::uint8_t {
  free,         ///< there is certainly no contact in [0, t_max]
  contact,      ///< there certainly is one
  within_bound  ///< the elements come so near that the bound on the deviation leaves it open
};

/// "free", "contact", "within the bound".
template <>
Names names_of<ScrewVerdict>() noexcept;

/// How a motion of constant rate is decided.
struct ScrewOptions {
  double t_max = 1.0;          ///< the end of the time range, 0 <= t_max <= 1
  Separation separation = {};  ///< contact is to be within this of each other; with distance 0, to touch

  /// Into how many arcs of equal duration the step is cut first: a power of two from 4 to 2^20. Twice as many arcs have
  /// an eighth of the deviation, or a quarter with a position on a curve, down to the rounding errors of doubles.
  int arcs = 8;

  /// While the verdict is `within_bound`, the number of arcs is doubled up to this: a power of two from 4 to 2^20. It
  /// has no effect when it is less than `arcs`.
  int most_arcs = 256;
};

/// The answer. Whatever the verdict is, the elements certainly have no contact before `free_until`.
struct ScrewAnswer {
  ScrewVerdict verdict = ScrewVerdict::within_bound;  ///< what is proved
  double free_until = 0;                              ///< no contact is at a time less than this; t_max for `free`
  double contact_by = 0;  ///< for `contact`: there is a contact at this time or before it; t_max otherwise
  double deviation = 0;   ///< no corner was ever farther than this from where it should be, in the unit of length
  int arcs = 0;           ///< the number of arcs that gave the verdict
};

/// Whether two elements whose bodies turn at a constant rate come into contact.
///
/// The query's rigid motions are read in another way than `solve` reads them: the orientation goes from q0 / |q0| to
/// q1 / |q1| by slerp,
///
///     q(t) = sin((1 - t) h) / sin(h) q0 / |q0| + sin(t h) / sin(h) q1 / |q1|,   cos(h) = q0 . q1 / (|q0| |q1|),
///
/// so that the body turns about one axis at a constant rate, by the angle 2 h. The position is linear in t, or on the
/// Bezier curve of RigidMotion::control_points. If it moves straight along this axis, the motion is a screw. See
/// Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985. Corners on curves are as in `solve`.
///
/// For two edges, or a vertex and a face, a contact is proved if the elements pass through each other. A small change
/// of the motion undoes some touches: a graze, and every touch of two points or of a point and an edge. Such a touch is
/// proved only at t = 0 or t = 1. But a point and an edge that stay in one plane z = c, of bodies that turn about z,
/// are a matter of the plane: a contact is proved if the point passes through the edge. With a separation, a contact is
/// proved if the distance falls below it by more than the bound.
/// @param query    the two elements and their motion
/// @param options  the time range, the separation and the number of arcs
/// @return the verdict, with the times and the bound that it rests on
/// @throws InvalidQuery  as solve, and for a number of arcs that is not a power of two in range
ScrewAnswer solve_screw(const CurvedQuery& query, const ScrewOptions& options = {});

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
