// The separations of pairs: sums of radii rounded up, neighbours, and the candidates that need them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "contact/contact_finder.hpp"
#include "contact/impact_zones.hpp"
#include "numbers/doubles/rounded_sum.hpp"
#include "scene/parts.hpp"
#include "sim/all_pairs.hpp"
#include "sim/thick_elements.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using touchstone::seeded::Rng;

namespace {

struct Model {
  Scene scene;
  System system;
  Colliders colliders;

  explicit Model(const Scene& of) : scene(of), system(scene), colliders(scene, system) {}
};

Index edge_of(const Colliders& colliders, Index a, Index b) {
  const auto& edges = colliders.edges();
  const auto found = std::find(edges.begin(), edges.end(), Edge{std::min(a, b), std::max(a, b)});
  REQUIRE(found != edges.end());
  return static_cast<Index>(found - edges.begin());
}

Pair two_edges(const Colliders& colliders, Index a, Index c) {
  return {Kind::edge_edge, edge_of(colliders, a, a + 1), edge_of(colliders, c, c + 1)};
}

/// Random radii, of which every third is 0.
void give_radii(Rng& random, Scene& scene) {
  const auto radius = [&] { return random.one_in(3) ? 0 : 0.2 * random.unit() + 1e-3; };
  for (Wire& wire : scene.wires) wire.radius = radius();
  for (Facet& face : scene.faces) face.radius = radius();
  std::vector<char> lone(scene.particles.size(), 1);
  for (const Wire& wire : scene.wires) {
    for (const Index p : wire.particles) lone[p] = 0;
  }
  for (const Facet& face : scene.faces) {
    for (const Index p : face.particles) lone[p] = 0;
  }
  for (Index p = 0; p < scene.particles.size(); ++p) {
    if (lone[p]) scene.particles[p].radius = radius();
  }
  check_scene(scene);
}

}  // namespace

TEST_CASE("a sum is rounded up: not below the exact one, and no double lies between") {
  Rng random(5);
  int exact = 0, rounded = 0;
  for (int i = 0; i < 20000; ++i) {
    const double a = random.unit() * std::exp2(random.between(-8, 2));
    const double b = i % 5 == 0 ? a * random.between(0, 3) : random.unit() * std::exp2(random.between(-8, 2));
    // Sums of two such doubles take at most 64 bits.
    const long double truth = static_cast<long double>(a) + b;
    static_assert(std::numeric_limits<long double>::digits >= 64);
    const double up = touchstone::numbers::sum_rounded_up(a, b);
    CHECK(static_cast<long double>(up) >= truth);
    CHECK(static_cast<long double>(std::nextafter(up, -1)) < truth);
    CHECK(touchstone::numbers::sum_rounded_up(b, a) == up);
    ++(static_cast<long double>(up) == truth ? exact : rounded);
  }
  CHECK(exact > 1000);
  CHECK(rounded > 1000);
  CHECK(touchstone::numbers::sum_rounded_up(0, 0) == 0);
}

TEST_CASE("on a straight cable, segments with less than pi r between them are neighbours") {
  constexpr double kRadius = 0.01, kSegment = 0.003;
  constexpr Index kSegments = 40;
  Scene scene;
  Cable cable = straight_cable(scene, {0, 0, 0}, {kSegments * kSegment, 0, 0}, kSegments);
  set_material(cable, 1e7, 0.4, kRadius, 1000);
  cable.solid = true;
  scene.cables.push_back(cable);
  const Model model(scene);
  int kept = 0, neighbours = 0;
  for (Index i = 0; i + 1 < kSegments; ++i) {
    for (Index j = i + 2; j < kSegments; ++j) {
      const double between = (j - i - 1) * kSegment;
      const bool near = between < std::numbers::pi * kRadius;
      CAPTURE(i, j, between);
      CHECK(model.colliders.separation(two_edges(model.colliders, i, j)) == (near ? 0 : 2 * kRadius));
      ++(near ? neighbours : kept);
    }
  }
  CHECK(kept > 300);
  CHECK(neighbours > 300);

  // A closed cable: the way around counts.
  Scene ring;
  Cable closed;
  for (Index i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    closed.particles.push_back(add_particle(ring, {0.03 * std::cos(angle), 0.03 * std::sin(angle), 0}, 0));
  }
  set_material(closed, 1e7, 0.4, kRadius, 1000);
  closed.closed = closed.solid = true;
  ring.cables.push_back(closed);
  const Model around(ring);
  CHECK(around.colliders.separation(two_edges(around.colliders, 0, 38)) == 0);
  CHECK(around.colliders.separation(two_edges(around.colliders, 0, 20)) == 2 * kRadius);
  // By its centreline a cable keeps no distance.
  ring.cables[0].solid = false;
  const Model thin(ring);
  CHECK_FALSE(thin.colliders.has_separations());
  CHECK(thin.colliders.separation(two_edges(thin.colliders, 0, 20)) == 0);
}

TEST_CASE("elements that a short spring joins are neighbours, colliding or not, those of a long one are not") {
  for (const double length : {0.1, 0.2}) {
    Scene scene;
    add_particle(scene, {-1, 0, 0}, 1), add_particle(scene, {0, 0, 0}, 1);
    add_particle(scene, {0, length, 0}, 1), add_particle(scene, {1, length, 0}, 1);
    scene.wires = {{{0, 1}, 0.02}, {{2, 3}, 0.06}};
    add_spring(scene, 1, 2, 1, 0, false);
    const Model model(scene);
    // pi/2 * 0.08 is 0.126.
    CHECK(model.colliders.separation(two_edges(model.colliders, 0, 2)) == (length < 0.12 ? 0 : 0.02 + 0.06));
    scene.springs.clear();
    const Model free(scene);
    CHECK(free.colliders.separation(two_edges(free.colliders, 0, 2)) == 0.02 + 0.06);
  }
}

TEST_CASE("radii of elements that share edges: the largest counts, and folds keep none") {
  Scene scene;
  for (const Vector3& at : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(1, 0, 1)})
    add_particle(scene, at, 1);
  add_spring(scene, 0, 1, 1, 0, true);
  scene.springs.back().radius = 0.05;
  scene.faces.push_back({{0, 1, 2}, 0.03});
  scene.wires.push_back({{3, 4}, 0});
  const Model model(scene);
  const Colliders& colliders = model.colliders;
  const auto of_edges = [&](Index a, Index b) {
    const Index first = edge_of(colliders, a, b), second = edge_of(colliders, 3, 4);
    return colliders.separation({Kind::edge_edge, std::min(first, second), std::max(first, second)});
  };
  CHECK(of_edges(0, 1) == 0.05);
  CHECK(of_edges(1, 2) == 0.03);
  CHECK(colliders.separation({Kind::vertex_face, 3, 0}) == 0.03);
  CHECK(colliders.separation({Kind::point_edge, 2, edge_of(colliders, 0, 1)}) == 0);
  CHECK(colliders.with_radius() == 4);
  CHECK(colliders.largest_radius() == 0.05);
  // To a face without a thickness, the thickest element at a corner counts.
  scene.faces[0].radius = 0;
  scene.wires[0].radius = 0.07;
  const Model other(scene);
  CHECK(other.colliders.separation({Kind::vertex_face, 4, 0}) == 0.07);
  CHECK(Colliders(scene, other.system, Keep::contact).separation({Kind::vertex_face, 4, 0}) == 0);
}

TEST_CASE("separations of random scenes are those of a plain search over all ways") {
  Rng random(71);
  std::uint64_t kept = 0, neighbours = 0;
  for (int round = 0; round < 30; ++round) {
    Scene scene = random_scene(random, false);
    for (Particle& p : scene.particles) p.position *= 0.1;  // so that many are neighbours
    give_radii(random, scene);
    const Model model(scene);
    const ThickElements elements(scene);
    std::map<std::pair<Kind, std::array<Index, 4>>, double> expected;
    for (const ThickPair& pair : elements.pairs()) {
      expected[{pair.kind, pair.particles}] =
          touchstone::numbers::sum_rounded_up(pair.first_radius, pair.second_radius);
    }
    std::size_t found = 0;
    for (const Pair& pair : all_pairs(scene, model.colliders)) {
      const auto corners = model.colliders.corners(pair);
      const auto same = expected.find({pair.kind, corners});
      const double d = model.colliders.separation(pair);
      CHECK(d == (same == expected.end() ? 0 : same->second));
      ++(d > 0 ? kept : neighbours);
      found += same != expected.end();
    }
    CHECK(found == expected.size());
  }
  CHECK(kept > 2000);
  CHECK(neighbours > 2000);
}

TEST_CASE("whatever comes within its separation is a candidate, and the finder finds all of it and no more") {
  Rng random(72);
  std::uint64_t contacts = 0, entering = 0, all_asked = 0, candidates = 0;
  for (int round = 0; round < 100; ++round) {
    Scene scene = random_scene(random, false);
    give_radii(random, scene);
    const Model model(scene);
    const std::vector<Pair> all = all_pairs(scene, model.colliders);
    const VectorX x0 = model.system.initial_position;
    VectorX x1 = x0;
    for (double& x : x1) x += 0.7 * random.symmetric();
    std::set<PairKey> expected, keys, collected;
    for (const Pair& pair : model.colliders.candidates(x0, x1, 0)) collected.insert(key(pair));
    candidates += collected.size();
    all_asked += all.size();
    for (const Pair& pair : all) {
      const Separation separation{model.colliders.separation(pair)};
      if (!solve(model.colliders.query(pair, x0, x1), {.separation = separation}).contact) continue;
      expected.insert(key(pair));
      CHECK(collected.count(key(pair)) == 1);
    }
    ContactFinder finder(model.colliders, NarrowPhase::exact, 1);
    finder.begin(x0, x1, 0.05);
    std::vector<Contact> found;
    ResponseCounts counts;
    finder.find(x1, found, counts);
    for (const Contact& contact : found) {
      CHECK(keys.insert(key(contact.pair)).second);
      const Separation separation{model.colliders.separation(contact.pair)};
      const Query query = model.colliders.query(contact.pair, x0, x1);
      CHECK(contact.time == solve(query, {.separation = separation}).toi);
      CHECK(contact.normal.norm() == Approx(1));
      if (separation.distance == 0) continue;
      // The normal is along the closest points, which are the separation apart at the contact, and nearer within it.
      Vector3 before = Vector3::Zero(), then = Vector3::Zero();
      for (std::size_t c = 0; c < contact.corners; ++c) {
        const Vector3 start = position(x0, contact.particles[c]), end = position(x1, contact.particles[c]);
        before += contact.omega[c] * start;
        then += contact.omega[c] * (start + contact.time * (end - start));
      }
      CHECK(contact.gap == Approx(std::max(contact.normal.dot(before) - separation.distance, 0.0)).margin(1e-12));
      CHECK((then - then.norm() * contact.normal).norm() < 1e-9);
      CHECK(then.norm() < separation.distance + 1e-9);
      if (contact.time > 0) CHECK(then.norm() > separation.distance - 1e-9);
    }
    CHECK(keys == expected);
    contacts += found.size();
    entering += counts.natures[static_cast<std::size_t>(Nature::entering)];
    // Elements that are close at the start, beyond their separation.
    Contact contact;
    for (const Pair& pair : all) {
      const double d = model.colliders.separation(pair);
      if (!proximity(model.colliders, pair, x0, 0.05, contact)) continue;
      const double distance = touchstone::distance(model.colliders.query(pair, x0, x0)).value;
      CHECK(distance < d + 0.05);
      CHECK(contact.gap == Approx(std::max(distance - d, 0.0)).margin(1e-12));
    }
  }
  CHECK(contacts > 1000);
  CHECK(entering > 100);
  CHECK(candidates < all_asked / 2);
}

TEST_CASE("a separation that the rounded sum of the radii decides is not lost by the boxes") {
  // Edges across each other, at the sum rounded up along z: the boxes are as far apart as the separation.
  Rng random(73);
  int rounded = 0;
  for (int i = 0; i < 2000; ++i) {
    Scene scene;
    const double a = 0.01 + random.unit(), b = 0.01 + random.unit(), d = touchstone::numbers::sum_rounded_up(a, b);
    add_particle(scene, {-1, 0, 0}, 1), add_particle(scene, {1, 0, 0}, 1);
    add_particle(scene, {0, -1, d}, 1), add_particle(scene, {0, 1, d}, 1);
    scene.wires = {{{0, 1}, a}, {{2, 3}, b}};
    const Model model(scene);
    const VectorX& x = model.system.initial_position;
    CHECK(model.colliders.candidates(x, x, 0).size() == 1);
    rounded += static_cast<long double>(d) > static_cast<long double>(a) + b;
  }
  CHECK(rounded > 100);
}

TEST_CASE("a zone that may not turn keeps its momentum and all distances") {
  Scene scene;
  for (const Vector3& at : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 2, 0), Vector3(0, 0, 1)})
    add_particle(scene, at, 1 + at.y());
  const System system(scene);
  VectorX inverse(12);
  for (Eigen::Index i = 0; i < 12; ++i) inverse[i] = 1 / system.mass[i];
  Rng random(3);
  const VectorX x0 = system.initial_position;
  VectorX x1 = x0;
  for (double& x : x1) x += 0.3 * random.symmetric();
  VectorX turned = x1, shifted = x1;
  const std::vector<Index> zone{0, 1, 2, 3};
  REQUIRE(move_rigidly(zone, system, inverse, x0, turned));
  REQUIRE(move_rigidly(zone, system, inverse, x0, shifted, Turning::none));
  const auto momentum = [&](const VectorX& x) {
    Vector3 sum = Vector3::Zero();
    for (const Index p : zone) sum += system.mass[3 * p] * (position(x, p) - position(x0, p));
    return sum;
  };
  CHECK((momentum(shifted) - momentum(x1)).norm() < 1e-14);
  CHECK((momentum(turned) - momentum(x1)).norm() < 1e-14);
  double shrunk = 0;
  for (const Index p : zone) {
    for (Index other = 0; other < p; ++other) {
      const double at_first = (position(x0, p) - position(x0, other)).norm();
      CHECK((position(shifted, p) - position(shifted, other)).norm() == Approx(at_first).epsilon(1e-14));
      const VectorX half = 0.5 * (x0 + turned);
      shrunk = std::max(shrunk, at_first - (position(half, p) - position(half, other)).norm());
    }
  }
  CHECK(shrunk > 1e-4);  // which is why it may not turn
}

TEST_CASE("radii far longer than the elements are refused before they take all memory") {
  Scene scene;
  Cable cable = straight_cable(scene, {0, 0, 0}, {1, 0, 0}, 8000);
  set_material(cable, 1e7, 0.4, 100, 1);
  cable.solid = true;
  scene.cables.push_back(cable);
  CHECK_THROWS_WITH(Model(scene), Catch::Contains("radii of up to 100 m are too long for elements so small"));
}
