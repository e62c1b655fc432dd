// SPDX-License-Identifier: MIT
#include "stress/dials.hpp"

#include <algorithm>
#include <cmath>

#include "stress/configuration.hpp"
#include "stress/separation_dials.hpp"

namespace touchstone::stress {
namespace {

using seeded::Rng;

double power(int exponent) { return std::ldexp(1.0, exponent); }

Vec3 all_axes(double factor) { return {factor, factor, factor}; }

/// Half of the queries lie along the axes, where all is exact, half along general directions.
Configuration oriented(Configuration made, Rng& rng) {
  const int turns = rng.between(0, 2);
  made.at = turned(made.at, turns);
  made.velocity = turned(made.velocity, turns);
  if (rng.one_in(2)) return made;
  made.at = sheared(made.at);
  made.velocity = sheared(made.velocity);
  return made;
}

Query scale(Kind kind, int setting, Rng& rng) {
  Query query = query_of(random_configuration(kind, rng));
  // Products of three lengths leave the range of doubles long before the coordinates do.
  const double below_one = power(-6);  // so that the coordinates, of size 2^6, are of size 1
  for (auto* corners : {&query.start, &query.end}) {
    for (Vec3& c : *corners) {
      c = {std::ldexp(c.x * below_one, setting), std::ldexp(c.y * below_one, setting),
           std::ldexp(c.z * below_one, setting)};
    }
  }
  return query;
}

Query offset(Kind kind, int setting, Rng& rng) {
  Configuration made = random_configuration(kind, rng);
  Vec3 away;
  away.x = rng.between(1, 8) * power(setting - 3);
  away.y = rng.between(-8, 8) * power(setting - 3);
  away.z = -rng.between(1, 8) * power(setting - 3);
  for (Vec3& c : made.at) c = {c.x + away.x, c.y + away.y, c.z + away.z};
  return query_of(made);
}

Query sliver(Kind kind, int setting, Rng& rng) {
  Configuration made = random_configuration(kind, rng);
  const double thin = power(setting);
  if (kind == Kind::vertex_face) {  // the face is thin
    made.at = scaled(made.at, {1, thin, 1});
    made.velocity = scaled(made.velocity, {1, thin, 1});
    return query_of(oriented(made, rng));
  }
  // The second edge is short and contains the meeting point.
  for (Vec3& c : made.at) c = {c.x - made.meeting.x, c.y - made.meeting.y, c.z - made.meeting.z};
  const Corners shrunk = scaled(made.at, all_axes(thin));
  made.at[2] = shrunk[2];
  made.at[3] = shrunk[3];
  if (rng.one_in(2)) made.velocity = scaled(made.velocity, all_axes(thin));
  return query_of(oriented(made, rng));
}

Query parallel(Kind kind, int setting, Rng& rng) {
  Configuration made = random_configuration(kind, rng);
  const double small = power(setting);
  if (kind == Kind::edge_edge) {  // both edges nearly along x, each above the other
    made.at = scaled(made.at, {1, small, 0});
    made.velocity = scaled(made.velocity, {1, small, 1});
  } else {  // the vertex moves nearly in the face's plane
    for (std::size_t i = 1; i < 4; ++i) made.at[i].z = made.at[0].z;
    for (std::size_t i = 1; i < 4; ++i) made.velocity[i].z = 0;
    made.at = scaled(made.at, {1, 1, 0});
    made.velocity = scaled(made.velocity, {1, 1, small});
  }
  return query_of(oriented(made, rng));
}

Query separation(Kind kind, int setting, Rng& rng) { return separated_roots(kind, -setting, rng); }

Query speed(Kind kind, int setting, Rng& rng) {
  Configuration made = random_configuration(kind, rng);
  if (rng.one_in(2)) {  // everywhere: positions are rounded in the end
    made.velocity = scaled(made.velocity, all_axes(power(setting)));
    return query_of(made);
  }
  // Along one axis, with as little depth there as doubles hold beside it.
  made.velocity = scaled(made.velocity, {1, 1, power(setting)});
  made.at = scaled(made.at, {1, 1, power(std::max(0, setting - 40))});
  return query_of(oriented(made, rng));
}

}  // namespace

const std::vector<Dial>& dials() {
  static const std::vector<Dial> all{
      {"scale",
       "size of all coordinates",
       "Elements that meet at a prescribed time and place, at this scale; the smallest are subnormal and rounded",
       {-1070, -1040, -1000, -700, -360, -340, -100, 0, 100, 338, 342, 700, 1000, 1020},
       0,
       scale},
      {"offset",
       "distance from the origin / size",
       "Elements that meet at a prescribed time and place, far from the origin; from 2^44 on they are rounded",
       {0, 10, 20, 30, 40, 44, 48, 50, 52, 54, 56, 60},
       0,
       offset},
      {"sliver",
       "aspect",
       "Faces whose height, and edges whose length beside the other's, is this share; half of them in general "
       "directions, where they are rounded from 2^-44 on",
       {-60, -55, -50, -45, -40, -30, -20, -10, 0},
       0,
       sliver},
      {"parallel",
       "angle",
       "Edges at this angle to each other, and vertices that move at this angle to the face; half of them in general "
       "directions, where they are rounded from 2^-44 on",
       {-100, -80, -60, -55, -50, -40, -30, -20, -10, 0},
       0,
       parallel},
      {"separation",
       "distance of two roots",
       "The cubic has two roots so near to each other: at one the elements meet, most of them, at the other the edges "
       "are parallel or the face is flat",
       {-200, -160, -120, -104, -100, -90, -70, -54, -50, -40, -20, -10, -4},
       -4,
       separation},
      {"speed",
       "way in a step / size",
       "Elements of size 1 that meet at a prescribed time and go so far in the step, half of them along an axis only",
       {0, 10, 20, 30, 40, 44, 48, 50, 52, 56, 60},
       0,
       speed},
  };
  return all;
}

const Dial* find_dial(std::string_view name) noexcept {
  for (const Dial& dial : dials()) {
    if (dial.name == name) return &dial;
  }
  return nullptr;
}

report::QuerySet make_set(const Dial& dial, Kind kind, int setting, std::uint64_t seed, std::size_t count) {
  report::QuerySet set;
  set.name = std::string(dial.name) + "/" + std::string(name_of(kind));
  set.about = dial.about;
  set.kind = kind;
  // Every setting gets the same configurations, as far as possible, so that differences come from the dial.
  const auto stream =
      4 * static_cast<std::uint64_t>(find_dial(dial.name) - dials().data()) + static_cast<std::uint64_t>(kind);
  Rng rng(seeded::seed_of_stream(seed, 100 + stream));
  for (std::size_t i = 0; i < count; ++i) set.queries.push_back(dial.make(kind, setting, rng));
  return set;
}

}  // namespace touchstone::stress
