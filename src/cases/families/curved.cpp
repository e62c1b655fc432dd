// The dispatch to the makers of curved queries, and the end of the time range.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <touchstone/error.hpp>

#include "families/curved_parts.hpp"
#include "families/makers.hpp"

namespace touchstone::families {
namespace {

CurvedSample made(Family family, Kind kind, Rng& rng) {
  using namespace makers;
  const auto where = [&] { return rng.one_in(3) ? Where::joint : Where::anywhere; };
  switch (family) {
    case Family::curved_lattice: return curved_lattice(kind, rng);
    case Family::gears: return gears(kind, rng);
    case Family::rod_tip: return rod_tip(kind, rng);
    case Family::screw: return screw(kind, rng);
    case Family::coin: return coin(kind, rng);
    case Family::turn_meets_start: return turn_meets(kind, rng, 0, where());
    case Family::turn_meets_half: return turn_meets(kind, rng, 0.5, where());
    case Family::turn_meets_end: return turn_meets(kind, rng, 1, where());
    case Family::pythagorean: return pythagorean(kind, rng);
    case Family::near_meeting: return near_meeting(kind, rng);
    case Family::tangent_turn: return tangent_turn(kind, rng);
    case Family::turn_in_plane: return turn_in_plane(kind, rng);
    case Family::turn_alike: return turn_alike(kind, rng);
    case Family::straight_curves: return straight_curves(kind, rng);
    case Family::ballistic: return ballistic(kind, rng);
    case Family::spline: return spline(kind, rng);
    case Family::large_turn: return large_turn(kind, rng);
    case Family::tiny_turn: return tiny_turn(kind, rng);
    case Family::long_quaternion: return long_quaternion(kind, rng);
    case Family::curved_scale: return curved_scale(kind, rng);
    case Family::curved_random: return curved_random(kind, rng);
    case Family::turning_bodies: return turning_bodies(kind, rng);
    default: break;
  }
  throw InvalidQuery(std::string(info(family).name) + " has no curved queries");
}

/// The whole step, most often; or up to a time of contact, the double just before it, or any other time.
double drawn_t_max(const std::optional<double>& touches_at, Rng& rng) {
  if (!rng.one_in(4)) return 1;
  static constexpr std::array<double, 4> round{0, 0.25, 0.5, 0.75};
  const double at = touches_at ? *touches_at : rng.pick(round);
  switch (rng.between(0, 3)) {
    case 0: return at;
    case 1: return at > 0 ? std::nextafter(at, 0) : at;
    case 2: return at < 1 ? std::nextafter(at, 1) : at;
    default: return rng.unit();
  }
}

}  // namespace

CurvedSample make_curved(Family family, Kind kind, Rng& rng) {
  CurvedSample sample = made(family, kind, rng);
  sample.query.kind = kind;
  make_valid(sample.query);
  sample.t_max = drawn_t_max(sample.touches_at, rng);
  if (sample.touches_at && *sample.touches_at > sample.t_max) sample.touches_at.reset();
  return sample;
}

CurvedSeparated make_curved_separated(Family family, Kind kind, Metric metric, Rng& rng) {
  const CurvedSample sample = make_curved(family, kind, rng);
  return {sample, makers::drawn_distance(sample.query, metric, rng)};
}

}  // namespace touchstone::families
