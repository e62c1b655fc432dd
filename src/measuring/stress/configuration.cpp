// SPDX-License-Identifier: MIT
#include "stress/configuration.hpp"

namespace touchstone::stress {
namespace {

using seeded::Rng;

Vec3 combined(const Vec3& a, double factor, const Vec3& b) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

Vec3 integers(Rng& rng) {
  Vec3 v;
  v.x = rng.between(-4, 4);
  v.y = rng.between(-4, 4);
  v.z = rng.between(-4, 4);
  return v;
}

Vec3 direction(Rng& rng) {
  Vec3 v = integers(rng);
  if (v.x == 0 && v.y == 0 && v.z == 0) v.x = 1;
  return v;
}

/// Whether the meeting point lies in the interior of an element, on its border, or 1/64 outside of it.
enum class Containment : std::uint8_t { inside, border, outside };

/// Inside half of the time, on a border a quarter of the time, just outside a quarter of the time.
Containment random_containment(Rng& rng) {
  using enum Containment;
  static constexpr std::array<Containment, 4> kChoices{inside, inside, border, outside};
  return rng.pick(kChoices);
}

/// A weight of an edge's second corner.
double weight(Containment containment, Rng& rng) {
  const bool high = rng.one_in(2);
  switch (containment) {
    case Containment::inside: return rng.between(1, 7) / 8.0;
    case Containment::border: return high ? 1 : 0;
    case Containment::outside: break;
  }
  return high ? 65.0 / 64 : -1.0 / 64;
}

struct FaceWeights {
  double first, second;
};

/// Weights of a face's second and third corner.
FaceWeights face_weights(Containment containment, Rng& rng) {
  static constexpr std::array<FaceWeights, 3> kInside{{{0.25, 0.25}, {0.5, 0.25}, {0.125, 0.5}}};
  static constexpr std::array<FaceWeights, 6> kBorder{{{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0, 0.25}, {0.5, 0.5}}};
  static constexpr std::array<FaceWeights, 3> kOutside{{{-1.0 / 64, 0.5}, {0.5, -1.0 / 64}, {0.5, 33.0 / 64}}};
  switch (containment) {
    case Containment::inside: return rng.pick(kInside);
    case Containment::border: return rng.pick(kBorder);
    case Containment::outside: break;
  }
  return rng.pick(kOutside);
}

template <class Function>
Corners each(const Corners& corners, const Function& function) {
  Corners result;
  for (std::size_t i = 0; i < corners.size(); ++i) result[i] = function(corners[i]);
  return result;
}

}  // namespace

Configuration random_configuration(Kind kind, Rng& rng) {
  Configuration made;
  made.kind = kind;
  made.time = rng.between(0, 8) / 8.0;
  const Vec3 meeting = made.meeting = integers(rng);
  const Vec3 one = direction(rng), other = direction(rng);
  if (kind == Kind::edge_edge) {
    const Containment a = random_containment(rng);
    const Containment b = a == Containment::outside ? Containment::inside : random_containment(rng);
    const double s = weight(a, rng), t = weight(b, rng);
    made.at = {combined(meeting, -s, one), combined(meeting, 1 - s, one), combined(meeting, -t, other),
               combined(meeting, 1 - t, other)};
  } else {
    const FaceWeights w = face_weights(random_containment(rng), rng);
    const Vec3 origin = combined(combined(meeting, -w.first, one), -w.second, other);
    made.at = {meeting, origin, combined(origin, 1, one), combined(origin, 1, other)};
  }
  for (Vec3& velocity : made.velocity) velocity = integers(rng);
  return made;
}

Corners scaled(const Corners& corners, const Vec3& factors) {
  return each(corners, [&](const Vec3& c) { return Vec3{c.x * factors.x, c.y * factors.y, c.z * factors.z}; });
}

Corners sheared(const Corners& corners) {
  return each(corners, [](const Vec3& c) { return Vec3{c.x + 2 * c.y - c.z, c.y + 3 * c.z, c.x + 2 * c.y}; });
}

Corners turned(const Corners& corners, int times) {
  Corners result = corners;
  for (int i = 0; i < times; ++i) result = each(result, [](const Vec3& c) { return Vec3{c.y, c.z, c.x}; });
  return result;
}

Query query_of(const Configuration& configuration) {
  Query query;
  query.kind = configuration.kind;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    query.start[i] = combined(configuration.at[i], -configuration.time, configuration.velocity[i]);
    query.end[i] = combined(configuration.at[i], 1 - configuration.time, configuration.velocity[i]);
  }
  return query;
}

}  // namespace touchstone::stress
