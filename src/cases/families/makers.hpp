// The generators behind families.hpp, one per family or per few that share a construction.
// SPDX-License-Identifier: MIT
#pragma once

#include "families/curved_parts.hpp"
#include "families/families.hpp"
#include "families/linear_motion.hpp"
#include "seeded/rng.hpp"

namespace touchstone::families::makers {

/// A whole number from -reach to reach.
inline double small(Rng& rng, int reach) { return rng.between(-reach, reach); }
Vec3 lattice_point(Rng& rng, int reach);
Moving lattice_motion(Rng& rng, int reach);

// lattice.cpp
Query lattice(Kind kind, Rng& rng, int reach);
Query signed_zero(Kind kind, Rng& rng);
Query static_step(Kind kind, Rng& rng);
Query few_moving(Kind kind, Rng& rng);

// coplanar.cpp
Query planar_axis(Kind kind, Rng& rng);
Query planar_general(Kind kind, Rng& rng);
Query moving_plane(Kind kind, Rng& rng);
Query collinear(Kind kind, Rng& rng);
Query moving_line(Kind kind, Rng& rng);
Query shared_corner(Kind kind, Rng& rng);
Query parallel(Kind kind, Rng& rng);
Query sliding(Kind kind, Rng& rng);
Query flat(Kind kind, Rng& rng);

// contact.cpp
enum class Where { anywhere, joint };
Sample prescribed(Kind kind, Rng& rng, double time, Where where);
double dyadic_time(Rng& rng);  ///< a multiple of 1/64 strictly inside (0, 1)
Sample chain_joint(Kind kind, Rng& rng);
Query near_hit(Kind kind, Rng& rng);

// roots.cpp
enum class Graze { merged, apart, gone, triple };
Sample grazing(Kind kind, Rng& rng, Graze graze);
Query irrational_joint(Kind kind, Rng& rng);
Query layers(Kind kind, Rng& rng);
Query extreme_time(Kind kind, Rng& rng);
Query beside_ends(Kind kind, Rng& rng);

// perturbed.cpp
Query sliver(Kind kind, Rng& rng);
Query near_rigid(Kind kind, Rng& rng);
Query ulp_lattice(Kind kind, Rng& rng);
Sample far_offset(Kind kind, Rng& rng);
Query random_doubles(Kind kind, Rng& rng);
Query simulation(Kind kind, Rng& rng);

// scale.cpp
Sample uniform_scale(Kind kind, Rng& rng);
Sample axis_scale(Kind kind, Rng& rng);
Query subnormal(Kind kind, Rng& rng);
Query huge(Kind kind, Rng& rng);
Query corner_scale(Kind kind, Rng& rng);
Query mixed_scale(Kind kind, Rng& rng);

// separations.cpp
Separated gap_crossing(Kind kind, Metric metric, Rng& rng);
Separated gap_tangent(Kind kind, Metric metric, Rng& rng);
Separated gap_constant(Kind kind, Metric metric, Rng& rng);
Separated gap_border(Kind kind, Metric metric, Rng& rng);
Separated gap_parallel(Kind kind, Metric metric, Rng& rng);
Separated gap_turning(Kind kind, Metric metric, Rng& rng);
Separated gap_irrational(Kind kind, Metric metric, Rng& rng);
Separated gap_start(Kind kind, Metric metric, Rng& rng);
Separated gap_ulp(Kind kind, Metric metric, Rng& rng);
Separated gap_lattice(Kind kind, Metric metric, Rng& rng);
Separated gap_scale(Kind kind, Metric metric, Rng& rng);
Separated gap_extreme(Kind kind, Metric metric, Rng& rng);
double drawn_distance(const Query& query, Metric metric, Rng& rng);        ///< for a query that has none of its own
double drawn_distance(const CurvedQuery& query, Metric metric, Rng& rng);  ///< the same

// curved_meetings.cpp
CornerWeights dyadic_weights(std::size_t corners, Rng& rng, Where where);
void meet_at_random(CurvedQuery& query, Rng& rng, double time, Where where);  ///< with random weights
CurvedSample turn_meets(Kind kind, Rng& rng, double time, Where where);  ///< time: 0, 1 or a multiple of 1/8 between
CurvedSample pythagorean(Kind kind, Rng& rng);
CurvedSample near_meeting(Kind kind, Rng& rng);
CurvedSample ballistic(Kind kind, Rng& rng);
CurvedSample spline(Kind kind, Rng& rng);

// curved_machines.cpp
CurvedSample gears(Kind kind, Rng& rng);
CurvedSample rod_tip(Kind kind, Rng& rng);
CurvedSample screw(Kind kind, Rng& rng);
CurvedSample coin(Kind kind, Rng& rng);
CurvedSample tangent_turn(Kind kind, Rng& rng);
CurvedSample turn_in_plane(Kind kind, Rng& rng);
CurvedSample turning_bodies(Kind kind, Rng& rng);

// curved_motions.cpp
CurvedSample curved_lattice(Kind kind, Rng& rng);
CurvedSample turn_alike(Kind kind, Rng& rng);
CurvedSample straight_curves(Kind kind, Rng& rng);
CurvedSample large_turn(Kind kind, Rng& rng);
CurvedSample tiny_turn(Kind kind, Rng& rng);
CurvedSample long_quaternion(Kind kind, Rng& rng);
CurvedSample curved_scale(Kind kind, Rng& rng);
CurvedSample curved_random(Kind kind, Rng& rng);

}  // namespace touchstone::families::makers
