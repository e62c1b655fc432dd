// The contacts while the end of a step changes, against a new search over every pair.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include <touchstone/solve.hpp>

#include "contact/contact_finder.hpp"
#include "sim/all_pairs.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using touchstone::seeded::Rng;

TEST_CASE("contacts are found in the order of time, and again after ends have moved, however far") {
  Rng random(99);
  std::uint64_t contacts = 0, gone = 0, asked = 0, could_ask = 0;
  for (int round = 0; round < 60; ++round) {
    const Scene scene = random_scene(random, false);
    const System system(scene);
    const Colliders colliders(scene, system);
    const std::vector<Pair> all = all_pairs(scene, colliders);
    const VectorX x0 = system.initial_position;
    VectorX x1 = x0;
    for (double& x : x1) x += 0.7 * random.symmetric();
    ContactFinder finder(colliders, NarrowPhase::exact, 1);
    const double margin = 0.05;
    finder.begin(x0, x1, margin);
    std::vector<Contact> found;
    std::set<PairKey> before;
    for (int change = 0; change < 6; ++change) {
      ResponseCounts counts;
      finder.find(x1, found, counts);
      std::set<PairKey> expected, keys;
      for (const Pair& pair : all) {
        if (solve(colliders.query(pair, x0, x1)).contact) expected.insert(key(pair));
      }
      double last = 0;
      for (const Contact& contact : found) {
        CHECK(keys.insert(key(contact.pair)).second);
        CHECK(contact.time == solve(colliders.query(contact.pair, x0, x1)).toi);
        CHECK(contact.time >= last);
        last = contact.time;
      }
      CAPTURE(round, change);
      CHECK(keys == expected);
      CHECK(counts.contacts == found.size());
      contacts += found.size();
      asked += counts.queries;
      could_ask += all.size();
      gone += static_cast<std::uint64_t>(
          std::count_if(before.begin(), before.end(), [&](const PairKey& k) { return keys.count(k) == 0; }));
      before = keys;
      // A few particles end elsewhere, most of them within the margin.
      std::vector<char> moved(scene.particles.size(), 0);
      for (int k = 0; k < 4; ++k) {
        const auto p = static_cast<Index>(random.between(0, static_cast<int>(moved.size()) - 1));
        moved[p] = 1;
        const double far = random.one_in(5) ? 3.0 : 0.9 * margin;
        x1.segment<3>(3 * static_cast<Eigen::Index>(p)) +=
            far * Vector3(random.symmetric(), random.symmetric(), random.symmetric());
      }
      finder.moved(x1, moved);
    }
  }
  CHECK(contacts > 500);
  CHECK(gone > 50);
  CHECK(asked < could_ask / 4);
}

TEST_CASE("what is nearer than the thickness at the start is found, each once, with its distance") {
  Rng random(7);
  std::uint64_t near = 0, inner = 0;
  for (int round = 0; round < 60; ++round) {
    const Scene scene = random_scene(random, false);
    const System system(scene);
    const Colliders colliders(scene, system);
    const VectorX x0 = system.initial_position;
    VectorX x1 = x0;
    for (double& x : x1) x += 0.1 * random.symmetric();
    const double thickness = 0.1;
    ContactFinder finder(colliders, NarrowPhase::exact, 1);
    finder.begin(x0, x1, thickness);
    std::set<PairKey> expected, keys;
    for (const Pair& pair : all_pairs(scene, colliders)) {
      Contact contact;
      if (proximity(colliders, pair, x0, thickness, contact)) expected.insert(key(pair));
    }
    for (const Contact& contact : finder.close(thickness)) {
      CHECK(keys.insert(key(contact.pair)).second);
      CHECK(contact.gap < thickness);
      CHECK(contact.normal.norm() == Approx(1));
      // Moved along the normal by a little less than their distance, they do not touch; by a little more they do, but
      // corners, which pass beside.
      const bool edges = contact.pair.kind == Kind::edge_edge;
      const bool inside = std::all_of(contact.omega.begin() + (edges ? 0 : 1), contact.omega.begin() + contact.corners,
                                      [](double omega) { return std::abs(omega) > 0.01; });
      inner += inside && contact.corners == 4;
      for (const double share : {0.999, 1.001}) {
        if (share > 1 && (!inside || contact.corners < 4)) continue;
        VectorX there = x0;
        for (std::size_t c = 0; c < (edges ? 2 : 1); ++c) {
          there.segment<3>(3 * static_cast<Eigen::Index>(contact.particles[c])) +=
              (edges ? share : -share) * contact.gap * contact.normal;
        }
        CHECK(solve(colliders.query(contact.pair, x0, there)).contact == (share > 1));
      }
      ++near;
    }
    CHECK(keys == expected);
  }
  CHECK(near > 150);
  CHECK(inner > 30);
}
