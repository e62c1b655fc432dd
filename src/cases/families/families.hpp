// Seeded queries, straight and curved, that are hard for solvers. Each family is degenerate, nearly degenerate or
// extreme in one way.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "seeded/rng.hpp"

namespace touchstone::families {

using seeded::Rng;

enum class Family : std::uint8_t {
  // Small integers, where coincidences of every sort happen by chance.
  lattice1,
  lattice2,
  lattice4,
  signed_zero,
  static_step,
  few_moving,
  // V vanishes identically, or an element is degenerate.
  planar_axis,
  planar_general,
  moving_plane,
  collinear,
  moving_line,
  shared_corner,
  parallel,
  sliding,
  flat,
  // A contact at a known dyadic time with dyadic weights, and its neighbours.
  prescribed,
  at_start,
  at_end,
  chain_joint,
  near_hit,
  grazing_merged,
  grazing_apart,
  grazing_gone,
  triple_root,
  irrational_joint,
  layers,
  extreme_time,
  // Hard for doubles.
  sliver,
  near_rigid,
  ulp_lattice,
  far_offset,
  random_doubles,
  simulation,
  // Magnitudes.
  uniform_scale,
  axis_scale,
  subnormal,
  huge,
  corner_scale,
  mixed_scale,
  // A new family goes to the end, so that the seeded queries of the others do not change.
  beside_ends,
  // With distances of their own.
  gap_crossing,
  gap_tangent,
  gap_constant,
  gap_border,
  gap_parallel,
  gap_turning,
  gap_irrational,
  gap_start,
  gap_ulp,
  gap_lattice,
  gap_scale,
  gap_extreme,
  // Of curved queries.
  curved_lattice,
  gears,
  rod_tip,
  screw,
  coin,
  turn_meets_start,
  turn_meets_half,
  turn_meets_end,
  pythagorean,
  near_meeting,
  tangent_turn,
  turn_in_plane,
  turn_alike,
  straight_curves,
  ballistic,
  spline,
  large_turn,
  tiny_turn,
  long_quaternion,
  curved_scale,
  curved_random,
  turning_bodies
};

/// The properties of a family.
enum class Group : std::uint8_t { lattice, coplanar, contact, perturbed, scale, separation, curved };

struct FamilyInfo {
  Family family;
  Group group;
  std::string_view name;
  std::string_view about;  ///< one line, for a person
  bool dyadic;             ///< coordinates are multiples of 2^-30 below 2^10: much arithmetic on them is exact
};

/// Every family of straight queries, in the order of the enumeration.
const std::vector<FamilyInfo>& all_families();

/// Those of curved queries, in the order of the enumeration, which has them after all others.
const std::vector<FamilyInfo>& curved_families();

const FamilyInfo& info(Family family);
inline bool is_curved(Family family) { return info(family).group == Group::curved; }

/// The family of that name, straight or curved; null when there is none.
const FamilyInfo* find_family(std::string_view name);

struct Sample {
  Query query;
  std::optional<double> touches_at;  ///< by construction the elements touch at this time, perhaps earlier too
};

/// The next query of a family of straight queries. The caller's floating-point environment must be the default one.
Sample make_sample(Family family, Kind kind, Rng& rng);
Query make(Family family, Kind kind, Rng& rng);

/// A query and a separation's distance to ask it with.
struct Separated {
  Query query;
  double distance = 0;              ///< finite and above 0
  std::optional<double> within_at;  ///< by construction the elements are at most that far apart at this time
};

/// The next query of a family with a distance of its own. For the families of Group::separation it is the one that
/// makes the query special. For others it is drawn after the query: of the query's own size, most often.
/// @param metric  that of the separation
Separated make_separated(Family family, Kind kind, Metric metric, Rng& rng);

/// A curved query, and how much of the step it is asked about.
struct CurvedSample {
  CurvedQuery query;                 ///< valid
  double t_max = 1;                  ///< in [0, 1]; most often 1
  std::optional<double> touches_at;  ///< by construction the elements touch at this time <= t_max, perhaps earlier too
};

/// The next query of a family of curved queries. The caller's floating-point environment must be the default one.
CurvedSample make_curved(Family family, Kind kind, Rng& rng);

/// A curved query and a separation's distance to ask it with.
struct CurvedSeparated {
  CurvedSample sample;
  double distance = 0;  ///< finite and above 0; of the query's own size, most often
};

/// The next query of a family of curved queries, and a distance that is drawn after it.
/// @param metric  that of the separation
CurvedSeparated make_curved_separated(Family family, Kind kind, Metric metric, Rng& rng);

/// One seeded query that can be made again without the ones before it.
struct CaseId {
  Family family;
  Kind kind;
  std::uint64_t seed;
  std::uint64_t index;
};
Sample make_sample(const CaseId& id);
Query make(const CaseId& id);
Separated make_separated(const CaseId& id, Metric metric);
CurvedSample make_curved(const CaseId& id);

/// The generator of a case, for a caller that needs more random numbers than the query has used.
Rng rng_of(const CaseId& id);

/// "grazing_apart edge-edge 7 1234", and back; nothing when the text is no case.
std::string case_name(const CaseId& id);
std::optional<CaseId> parse_case(std::string_view text);

}  // namespace touchstone::families
