// A caller's floating-point environment changes no answer about meshes, and is left as it was.
// SPDX-License-Identifier: MIT
#include <touchstone/touchstone.hpp>

#include "environment/float_mode.hpp"
#include "mesh/scenes.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

struct Outcome {
  FirstContact first;
  FreeStep step, keeping;
  std::vector<Intersection> intersections;
  bool intersects = false;
  std::vector<MeshPair> candidates;
  std::size_t contacts = 0;
};

Outcome outcome_of(const Scene& scene, int threads) {
  Outcome outcome;
  const Mesh mesh(scene.elements);
  FirstContactOptions options;
  options.threads = threads;
  FreeStepOptions step;
  step.threads = threads;
  outcome.first = first_contact(mesh, scene.start(), scene.end(), options);
  outcome.step = free_step(mesh, scene.start(), scene.end(), step);
  step.kept_fraction = 0.25;
  outcome.keeping = free_step(mesh, scene.start(), scene.end(), step);
  outcome.intersections = intersections(mesh, scene.start(), options);
  outcome.intersects = intersects(mesh, scene.start(), options);
  outcome.candidates = candidates(mesh, scene.start(), scene.end(), options);
  outcome.contacts = all_contacts(mesh, scene.start(), scene.end(), options).size();
  return outcome;
}

bool equal(const Outcome& a, const Outcome& b) {
  const auto same_step = [](const FreeStep& x, const FreeStep& y) {
    return x.outcome == y.outcome && x.length == y.length && x.positions == y.positions;
  };
  return a.first.toi == b.first.toi && a.first.toi_upper == b.first.toi_upper &&
         a.first.earliest.size() == b.first.earliest.size() && a.first.at_start.size() == b.first.at_start.size() &&
         same_step(a.step, b.step) && same_step(a.keeping, b.keeping) &&
         a.intersections.size() == b.intersections.size() && a.intersects == b.intersects &&
         a.candidates == b.candidates && a.contacts == b.contacts;
}

}  // namespace

TEST_CASE("answers about meshes are the same in every floating-point mode, and the mode is restored") {
  seeded::Rng random(401);
  int contacts = 0, tiny_contacts = 0;
  for (std::size_t round = 0; round < effort(10); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 12);
      const bool tiny = random.one_in(3);
      if (tiny) {  // subnormal
        for (double& x : scene.x0) x = std::ldexp(x, -1060);
        for (double& x : scene.x1) x = std::ldexp(x, -1060);
      }
      if (random.one_in(2)) add_separation(random, scene);
      const Outcome expected = outcome_of(scene, 1);
      contacts += expected.first.contact ? 1 : 0;
      tiny_contacts += tiny && expected.first.contact ? 1 : 0;
      for (const FloatMode& mode : float_modes()) {
        if (mode.traps && !random.one_in(3)) continue;
        Outcome found;
        ControlBits before, after;
        {
          const WithFloatMode with(mode);
          before = control_bits();
          found = outcome_of(scene, 2);
          after = control_bits();
        }
        CAPTURE(round, scene.name, mode.name());
        REQUIRE(equal(found, expected));
        REQUIRE(before == after);
      }
    }
  }
  CHECK(contacts > 0);
  CHECK((tiny_contacts > 0 || !whole_effort("a contact among subnormals is seen")));
}
