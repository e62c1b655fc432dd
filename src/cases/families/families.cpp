// The registry of query families and the dispatch to their makers.
// SPDX-License-Identifier: MIT
#include "families/families.hpp"

#include <sstream>

#include <touchstone/error.hpp>

#include "families/makers.hpp"

namespace touchstone::families {

const std::vector<FamilyInfo>& all_families() {
  static const std::vector<FamilyInfo> all{
      {Family::lattice1, Group::lattice, "lattice1", "integers from -1 to 1", true},
      {Family::lattice2, Group::lattice, "lattice2", "integers from -2 to 2", true},
      {Family::lattice4, Group::lattice, "lattice4", "integers from -4 to 4", true},
      {Family::signed_zero, Group::lattice, "signed_zero", "integers from -1 to 1, zeros of both signs", true},
      {Family::static_step, Group::lattice, "static_step", "one element or both stand still", true},
      {Family::few_moving, Group::lattice, "few_moving", "translation of all, of one element or of one corner", true},

      {Family::planar_axis, Group::coplanar, "planar_axis", "motion in a plane across an axis", true},
      {Family::planar_general, Group::coplanar, "planar_general", "motion in a plane in general position", true},
      {Family::moving_plane, Group::coplanar, "moving_plane", "coplanar all the time in a plane that turns", true},
      {Family::collinear, Group::coplanar, "collinear", "all corners on a line that may translate", true},
      {Family::moving_line, Group::coplanar, "moving_line", "all corners on a line that turns", true},
      {Family::shared_corner, Group::coplanar, "shared_corner", "one particle is a corner of both elements", true},
      {Family::parallel, Group::coplanar, "parallel", "parallel edges, motion parallel to a face", true},
      {Family::sliding, Group::coplanar, "sliding", "a corner slides along the other element", true},
      {Family::flat, Group::coplanar, "flat", "zero-length edges and flat faces, always or for an instant", true},

      {Family::prescribed, Group::contact, "prescribed", "contact at a dyadic time inside the step", true},
      {Family::at_start, Group::contact, "at_start", "contact at t = 0", true},
      {Family::at_end, Group::contact, "at_end", "contact at t = 1", true},
      {Family::chain_joint, Group::contact, "chain_joint", "a corner is hit exactly, or one ulp beside it", false},
      {Family::near_hit, Group::contact, "near_hit", "a contact with one coordinate moved by one ulp or by less",
       false},
      {Family::grazing_merged, Group::contact, "grazing_merged", "V has a double root, a contact", true},
      {Family::grazing_apart, Group::contact, "grazing_apart", "V's two roots are just apart", false},
      {Family::grazing_gone, Group::contact, "grazing_gone", "V's two roots are just gone", false},
      {Family::triple_root, Group::contact, "triple_root", "V has a triple root, or three close ones", false},
      {Family::irrational_joint, Group::contact, "irrational_joint", "a corner on an edge at an irrational time", true},
      {Family::layers, Group::contact, "layers", "motion in parallel planes; parallel or flat at V's roots", true},
      {Family::extreme_time, Group::contact, "extreme_time", "contact just after 0 or just before 1", false},

      {Family::sliver, Group::perturbed, "sliver", "a degenerate query, a few coordinates off by a little", false},
      {Family::near_rigid, Group::perturbed, "near_rigid", "one displacement for all but rounding noise", false},
      {Family::ulp_lattice, Group::perturbed, "ulp_lattice", "a lattice of spacing one ulp far from the origin", false},
      {Family::far_offset, Group::perturbed, "far_offset", "a small query around 1e8 or farther", false},
      {Family::random_doubles, Group::perturbed, "random_doubles", "full significands, one scale a query", false},
      {Family::simulation, Group::perturbed, "simulation", "what a broad phase hands over", false},

      {Family::uniform_scale, Group::scale, "uniform_scale", "any query times a power of two", false},
      {Family::axis_scale, Group::scale, "axis_scale", "any query, each axis times a power of two", false},
      {Family::subnormal, Group::scale, "subnormal", "subnormal coordinates", false},
      {Family::huge, Group::scale, "huge", "coordinates up to the greatest double", false},
      {Family::corner_scale, Group::scale, "corner_scale", "each corner times a power of two", false},
      {Family::mixed_scale, Group::scale, "mixed_scale", "each coordinate times a power of two", false},

      {Family::beside_ends, Group::contact, "beside_ends", "V's root is 0, 1 or the double just beside one of them",
       false},

      {Family::gap_crossing, Group::separation, "gap_crossing", "as far apart as the distance at a dyadic time", true},
      {Family::gap_tangent, Group::separation, "gap_tangent", "the same, and tangent there", true},
      {Family::gap_constant, Group::separation, "gap_constant", "exactly as far apart for a while", true},
      {Family::gap_border, Group::separation, "gap_border", "the closest point enters exactly at a border", true},
      {Family::gap_parallel, Group::separation, "gap_parallel", "parallel edges, or flat faces, slide or approach",
       true},
      {Family::gap_turning, Group::separation, "gap_turning", "parallel or flat at the instant only", true},
      {Family::gap_irrational, Group::separation, "gap_irrational", "the double nearest to an irrational distance",
       true},
      {Family::gap_start, Group::separation, "gap_start", "within the distance at t = 0", true},
      {Family::gap_ulp, Group::separation, "gap_ulp", "distance or coordinate off by an ulp or two", false},
      {Family::gap_lattice, Group::separation, "gap_lattice", "small integers, and the root of an integer", true},
      {Family::gap_scale, Group::separation, "gap_scale", "query and distance times a power of two", false},
      {Family::gap_extreme, Group::separation, "gap_extreme", "a huge, tiny or subnormal distance", false},
  };
  return all;
}

const std::vector<FamilyInfo>& curved_families() {
  constexpr Group kGroup = Group::curved;
  static const std::vector<FamilyInfo> all{
      {Family::curved_lattice, kGroup, "curved_lattice", "small integers: points, poses and control points", true},
      {Family::gears, kGroup, "gears", "two bodies turn in a plane, or as prisms", true},
      {Family::rod_tip, kGroup, "rod_tip", "the tip of a rod that turns grazes a wall, or just does not", false},
      {Family::screw, kGroup, "screw", "bodies that turn about one axis and move along it", true},
      {Family::coin, kGroup, "coin", "a coin that rolls on its rim", false},
      {Family::turn_meets_start, kGroup, "turn_meets_start", "bodies that turn touch at t = 0", true},
      {Family::turn_meets_half, kGroup, "turn_meets_half", "bodies that turn touch at t = 1/2", true},
      {Family::turn_meets_end, kGroup, "turn_meets_end", "bodies that turn touch at t = 1", true},
      {Family::pythagorean, kGroup, "pythagorean", "rational rotations at a dyadic time: corner on corner", true},
      {Family::near_meeting, kGroup, "near_meeting", "contact at a dyadic time, a number off by an ulp", false},
      {Family::tangent_turn, kGroup, "tangent_turn", "two tips that turn touch where their paths do", false},
      {Family::turn_in_plane, kGroup, "turn_in_plane", "turns in a plane: a face's own, or one parallel", false},
      {Family::turn_alike, kGroup, "turn_alike", "both elements on the same motion, or nearly", false},
      {Family::straight_curves, kGroup, "straight_curves", "any straight query, written as curves", false},
      {Family::ballistic, kGroup, "ballistic", "parabolas: a flight, and its apex against something", true},
      {Family::spline, kGroup, "spline", "cubic curves that meet at a dyadic time", true},
      {Family::large_turn, kGroup, "large_turn", "turns by nearly 180 or 360 degrees", false},
      {Family::tiny_turn, kGroup, "tiny_turn", "turns by 1e-6 to 1e-24 radians", false},
      {Family::long_quaternion, kGroup, "long_quaternion", "quaternions of extreme or unequal lengths", false},
      {Family::curved_scale, kGroup, "curved_scale", "extreme lengths, uniform or mixed", false},
      {Family::curved_random, kGroup, "curved_random", "full significands", false},
      {Family::turning_bodies, kGroup, "turning_bodies", "bodies turn a few degrees near each other", false},
  };
  return all;
}

const FamilyInfo& info(Family family) {
  const auto index = static_cast<std::size_t>(family);
  const auto& straight = all_families();
  return index < straight.size() ? straight[index] : curved_families()[index - straight.size()];
}

const FamilyInfo* find_family(std::string_view name) {
  for (const auto* families : {&all_families(), &curved_families()}) {
    for (const FamilyInfo& family : *families) {
      if (family.name == name) return &family;
    }
  }
  return nullptr;
}

Sample make_sample(Family family, Kind kind, Rng& rng) {
  using namespace makers;
  if (is_curved(family)) throw InvalidQuery(std::string(info(family).name) + " has curved queries only");
  switch (family) {
    case Family::lattice1: return {lattice(kind, rng, 1), {}};
    case Family::lattice2: return {lattice(kind, rng, 2), {}};
    case Family::lattice4: return {lattice(kind, rng, 4), {}};
    case Family::signed_zero: return {signed_zero(kind, rng), {}};
    case Family::static_step: return {static_step(kind, rng), {}};
    case Family::few_moving: return {few_moving(kind, rng), {}};
    case Family::planar_axis: return {planar_axis(kind, rng), {}};
    case Family::planar_general: return {planar_general(kind, rng), {}};
    case Family::moving_plane: return {moving_plane(kind, rng), {}};
    case Family::collinear: return {collinear(kind, rng), {}};
    case Family::moving_line: return {moving_line(kind, rng), {}};
    case Family::shared_corner: return {shared_corner(kind, rng), 0.0};
    case Family::parallel: return {parallel(kind, rng), {}};
    case Family::sliding: return {sliding(kind, rng), {}};
    case Family::flat: return {flat(kind, rng), {}};
    case Family::prescribed: return prescribed(kind, rng, dyadic_time(rng), Where::anywhere);
    case Family::at_start: return prescribed(kind, rng, 0, rng.one_in(3) ? Where::joint : Where::anywhere);
    case Family::at_end: return prescribed(kind, rng, 1, rng.one_in(3) ? Where::joint : Where::anywhere);
    case Family::chain_joint: return chain_joint(kind, rng);
    case Family::near_hit: return {near_hit(kind, rng), {}};
    case Family::grazing_merged: return grazing(kind, rng, Graze::merged);
    case Family::grazing_apart: return grazing(kind, rng, Graze::apart);
    case Family::grazing_gone: return grazing(kind, rng, Graze::gone);
    case Family::triple_root: return grazing(kind, rng, Graze::triple);
    case Family::irrational_joint: return {irrational_joint(kind, rng), {}};
    case Family::layers: return {layers(kind, rng), {}};
    case Family::extreme_time: return {extreme_time(kind, rng), {}};
    case Family::sliver: return {sliver(kind, rng), {}};
    case Family::near_rigid: return {near_rigid(kind, rng), {}};
    case Family::ulp_lattice: return {ulp_lattice(kind, rng), {}};
    case Family::far_offset: return far_offset(kind, rng);
    case Family::random_doubles: return {random_doubles(kind, rng), {}};
    case Family::simulation: return {simulation(kind, rng), {}};
    case Family::uniform_scale: return uniform_scale(kind, rng);
    case Family::axis_scale: return axis_scale(kind, rng);
    case Family::subnormal: return {subnormal(kind, rng), {}};
    case Family::huge: return {huge(kind, rng), {}};
    case Family::corner_scale: return {corner_scale(kind, rng), {}};
    case Family::mixed_scale: return {mixed_scale(kind, rng), {}};
    case Family::beside_ends: return {beside_ends(kind, rng), {}};
    default: return {make_separated(family, kind, Metric::euclidean, rng).query, {}};
  }
}

Separated make_separated(Family family, Kind kind, Metric metric, Rng& rng) {
  using namespace makers;
  switch (family) {
    case Family::gap_crossing: return gap_crossing(kind, metric, rng);
    case Family::gap_tangent: return gap_tangent(kind, metric, rng);
    case Family::gap_constant: return gap_constant(kind, metric, rng);
    case Family::gap_border: return gap_border(kind, metric, rng);
    case Family::gap_parallel: return gap_parallel(kind, metric, rng);
    case Family::gap_turning: return gap_turning(kind, metric, rng);
    case Family::gap_irrational: return gap_irrational(kind, metric, rng);
    case Family::gap_start: return gap_start(kind, metric, rng);
    case Family::gap_ulp: return gap_ulp(kind, metric, rng);
    case Family::gap_lattice: return gap_lattice(kind, metric, rng);
    case Family::gap_scale: return gap_scale(kind, metric, rng);
    case Family::gap_extreme: return gap_extreme(kind, metric, rng);
    default: break;
  }
  const Query query = make(family, kind, rng);
  return {query, drawn_distance(query, metric, rng), {}};
}

Query make(Family family, Kind kind, Rng& rng) { return make_sample(family, kind, rng).query; }

Rng rng_of(const CaseId& id) {
  std::uint64_t state = id.seed;
  std::uint64_t mixed = seeded::splitmix64(state) ^ id.index;
  mixed =
      seeded::splitmix64(mixed) ^ (static_cast<std::uint64_t>(id.family) << 8 | static_cast<std::uint64_t>(id.kind));
  return Rng(seeded::splitmix64(mixed));
}

Sample make_sample(const CaseId& id) {
  Rng rng = rng_of(id);
  return make_sample(id.family, id.kind, rng);
}

CurvedSample make_curved(const CaseId& id) {
  Rng rng = rng_of(id);
  return make_curved(id.family, id.kind, rng);
}

Query make(const CaseId& id) { return make_sample(id).query; }

Separated make_separated(const CaseId& id, Metric metric) {
  Rng rng = rng_of(id);
  return make_separated(id.family, id.kind, metric, rng);
}

std::string case_name(const CaseId& id) {
  return std::string(info(id.family).name) + " " + std::string(name_of(id.kind)) + " " + std::to_string(id.seed) + " " +
         std::to_string(id.index);
}

std::optional<CaseId> parse_case(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::string family, kind;
  std::uint64_t seed = 0, index = 0;
  if (!(in >> family >> kind >> seed >> index)) return std::nullopt;
  const FamilyInfo* const found = find_family(family);
  if (found == nullptr) return std::nullopt;
  for (const Kind k : kKinds) {
    if (name_of(k) == kind) return CaseId{found->family, k, seed, index};
  }
  return std::nullopt;
}

}  // namespace touchstone::families
