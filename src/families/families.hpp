// Seeded queries, built to hurt: each family is one way to be degenerate, or nearly so, or extreme.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

#include "seeded/rng.hpp"

namespace touchstone::families {

using seeded::Rng;

enum class Family : std::uint8_t {
  // Small integers, where coincidences of every sort happen by themselves.
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
  // Later ones go to the end: the seeded queries of the others stay the same.
  beside_ends
};

/// The groups of families, to choose by.
enum class Group : std::uint8_t { lattice, coplanar, contact, perturbed, scale };

struct FamilyInfo {
  Family family;
  Group group;
  std::string_view name;
  std::string_view about;  ///< one line, for a person
  bool dyadic;             ///< coordinates are multiples of 2^-30 below 2^10: much arithmetic on them is exact
};

/// Every family, in the order of the enumeration.
const std::vector<FamilyInfo>& all_families();
const FamilyInfo& info(Family family);

/// The kinds of query, in the order of the enumeration.
constexpr std::array<Kind, 4> kKinds{Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point};

struct Sample {
  Query query;
  std::optional<double> touches_at;  ///< by construction the elements touch then, perhaps earlier too
};

/// The next query of a family. The caller's floating-point environment must be the default one.
Sample make_sample(Family family, Kind kind, Rng& rng);
Query make(Family family, Kind kind, Rng& rng);

/// One seeded query that can be made again without the ones before it.
struct CaseId {
  Family family;
  Kind kind;
  std::uint64_t seed;
  std::uint64_t index;
};
Sample make_sample(const CaseId& id);
Query make(const CaseId& id);

/// The generator behind a case, for who needs more random numbers than its query.
Rng rng_of(const CaseId& id);

/// "grazing_apart edge-edge 7 1234", and back; nothing when the text is no case.
std::string case_name(const CaseId& id);
std::optional<CaseId> parse_case(std::string_view text);

}  // namespace touchstone::families
