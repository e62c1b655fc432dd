// The contacts of small meshes are those that the oracle finds pair by pair, and a verdict changes where the oracle's
// does: from a double to the next one.
// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>

#include <touchstone/touchstone.hpp>

#include "mesh/scenes.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// Every pair in contact within [0, t_max], by the oracle alone.
std::map<MeshPair, Answer> oracle_contacts(const Scene& scene, double t_max = 1) {
  std::map<MeshPair, Answer> contacts;
  const Parts parts = parts_of(scene.elements);
  for (const MeshPair& pair : all_pairs(scene.elements)) {
    const Separation separation{separation_between(scene, parts, pair), scene.elements.separation.metric};
    const Query query = query_between(scene, parts, pair, scene.x0, scene.x1);
    const Answer answer = solve(query, {.t_max = t_max, .separation = separation, .method = Method::oracle});
    if (answer.contact) contacts[pair] = answer;
  }
  return contacts;
}

/// Doubles as integers in the same order.
std::int64_t ordered(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits < 0 ? std::int64_t{INT64_MIN} - bits : bits;
}
double of_ordered(std::int64_t i) { return std::bit_cast<double>(i < 0 ? std::int64_t{INT64_MIN} - i : i); }

/// An integer between two that are not neighbours; the distance of the two may exceed the greatest integer.
std::int64_t between(std::int64_t a, std::int64_t b) { return (a & b) + ((a ^ b) >> 1); }

}  // namespace

TEST_CASE("the contacts of a small mesh are those that the oracle finds") {
  seeded::Rng random(111);
  std::size_t contacts = 0, at_start = 0, free = 0, separated = 0;
  for (std::size_t round = 0; round < effort(12); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 10);
      const bool apart = random.one_in(2);
      if (apart) add_separation(random, scene);
      const Mesh mesh(scene.elements);
      FirstContactOptions options;
      options.t_max = random.one_in(3) ? random.unit() : 1;
      const std::map<MeshPair, Answer> expected = oracle_contacts(scene, options.t_max);
      const std::vector<MeshContact> all = all_contacts(mesh, scene.start(), scene.end(), options);
      CAPTURE(round, scene.name, apart, options.t_max);
      REQUIRE(all.size() == expected.size());
      double toi = INFINITY, toi_upper = INFINITY;
      std::size_t starts = 0;
      for (const MeshContact& contact : all) {
        CAPTURE(mesh.describe(contact.pair));
        REQUIRE(expected.count(contact.pair) == 1);
        const Answer& answer = expected.at(contact.pair);
        REQUIRE(contact.answer.toi == answer.toi);
        REQUIRE(contact.answer.toi_upper == answer.toi_upper);
        REQUIRE(contact.answer.starts_within == answer.starts_within);
        if (answer.starts_within) {
          ++starts;
        } else if (answer.toi < toi || (answer.toi == toi && answer.toi_upper < toi_upper)) {
          toi = answer.toi;
          toi_upper = answer.toi_upper;
        }
      }
      const FirstContact first = first_contact(mesh, scene.start(), scene.end(), options);
      REQUIRE(first.at_start.size() == starts);
      REQUIRE(first.contact == (toi < INFINITY));
      REQUIRE(first.toi == toi);
      REQUIRE(first.toi_upper == toi_upper);
      REQUIRE(first.free() == expected.empty());
      contacts += first.contact ? 1 : 0;
      at_start += starts > 0 ? 1 : 0;
      free += first.free() ? 1 : 0;
      separated += apart && first.contact ? 1 : 0;
    }
  }
  CHECK((contacts > 0 || !whole_effort("a first contact is seen")));
  CHECK((at_start > 0 || !whole_effort("a contact at the start is seen")));
  CHECK((free > 0 || !whole_effort("a free step is seen")));
  CHECK((separated > 0 || !whole_effort("a contact within a separation is seen")));
}

TEST_CASE("a verdict changes from one double to the next where the oracle's does") {
  seeded::Rng random(112);
  std::map<std::string, int> flips;
  for (std::size_t round = 0; round < effort(300); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 8);
      if (random.one_in(3)) add_separation(random, scene);
      const Mesh mesh(scene.elements);
      const std::size_t moved = random.below(scene.x1.size());
      const double far = scene.x0[moved] + (random.one_in(2) ? 3 : -3) * (scene.x1[moved] - scene.x0[moved]);
      // Short ways for the rest, or there would seldom be a free step.
      for (std::size_t i = 0; i < scene.x1.size(); ++i) scene.x1[i] = scene.x0[i] + (scene.x1[i] - scene.x0[i]) / 16;
      const auto is_free = [&](std::int64_t at) {
        scene.x1[moved] = of_ordered(at);
        return first_contact(mesh, scene.start(), scene.end()).free();
      };
      // The end of one coordinate of one vertex: near its start, and far away.
      std::int64_t free = ordered(scene.x0[moved]);
      std::int64_t met = ordered(far);
      if (is_free(met)) std::swap(free, met);
      if (!is_free(free) || is_free(met)) continue;
      while (free - 1 > met || free + 1 < met) {
        const std::int64_t middle = between(free, met);
        (is_free(middle) ? free : met) = middle;
      }
      CAPTURE(round, scene.name, moved, of_ordered(free), of_ordered(met));
      scene.x1[moved] = of_ordered(free);
      REQUIRE(oracle_contacts(scene).empty());
      scene.x1[moved] = of_ordered(met);
      const auto contacts = oracle_contacts(scene);
      REQUIRE_FALSE(contacts.empty());
      const FirstContact found = first_contact(mesh, scene.start(), scene.end());
      for (const MeshContact& contact : found.earliest) {
        REQUIRE(contacts.count(contact.pair) == 1);
        REQUIRE(contacts.at(contact.pair).toi == found.toi);
      }
      ++flips[scene.name];
    }
  }
  for (const auto& [name, count] : flips) std::printf("%s: %d verdicts change\n", name.c_str(), count);
  CHECK((flips.size() == kLayouts.size() || !whole_effort("a verdict of each sort of scene changes")));
}
