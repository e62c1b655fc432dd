// The shipped scenes of cloth, small: the folds of `flag`, and the friction that holds `drape`.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <touchstone/distance.hpp>

#include "cloth/cloth_scenes.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::sim;

namespace {

/// How many particles of the cloth are within `reach` of a triangle that is far from them on the flat sheet: of another
/// layer. All pairs, by the library's exact distance and not by the simulator's candidates.
std::size_t on_another_layer(const Simulation& simulation, double reach) {
  const Scene& scene = simulation.scene();
  const Surface& surface = scene.surfaces[0];
  const VectorX& q = simulation.state().q;
  const auto at = [&](Index p) { return Vec3{q[3 * p], q[3 * p + 1], q[3 * p + 2]}; };
  const auto rest = [&](Index p) -> const Vector3& { return scene.particles[p].position; };
  Index count = 0;
  for (const Face& face : surface.faces) count = std::max({count, face[0] + 1, face[1] + 1, face[2] + 1});
  std::size_t found = 0;
  for (Index p = 0; p < count; ++p) {
    for (const Face& face : surface.faces) {
      const double side = (rest(face[1]) - rest(face[0])).norm();
      const Vector3 centre = (rest(face[0]) + rest(face[1]) + rest(face[2])) / 3;
      if ((rest(p) - centre).norm() < 2.2 * side) continue;
      Query query;
      query.kind = Kind::vertex_face;
      query.start = query.end = {at(p), at(face[0]), at(face[1]), at(face[2])};
      if (touchstone::distance(query).value > reach) continue;
      ++found;
      break;
    }
  }
  return found;
}

/// Makes steps up to the time of `seconds`. @returns the crossings
std::size_t run_until(Simulation& simulation, double seconds) {
  while (simulation.state().time < seconds - 1e-9) simulation.step();
  return simulation.crossings().size();
}

}  // namespace

TEST_CASE("flag falls into folds, lies on itself and stays so") {
  Scene scene = make_shipped_scene("flag", tests::whole_effort("the folds of flag") ? 300 : 60);
  scene.settings.time_step = 1.0 / 240;
  Simulation simulation(scene, {});
  CHECK(on_another_layer(simulation, 4e-3) == 0);
  CHECK(run_until(simulation, tests::whole_effort("flag to its end") ? 1.6 : 0.5) == 0);
  if (!tests::whole_effort("flag lies on itself")) return;
  const std::size_t before = on_another_layer(simulation, 4e-3);
  const double fallen = simulation.energies().load;
  CHECK(run_until(simulation, 1.9) == 0);
  const std::size_t after = on_another_layer(simulation, 4e-3);
  CAPTURE(before, after);
  CHECK(before >= 12);
  CHECK(after >= 12);
  CHECK(simulation.energies().kinetic < 1e-3);
  CHECK(std::abs(simulation.energies().load - fallen) < 0.02);  // of 0.5 J at the start
}

TEST_CASE("friction holds drape on its ball, and without friction it slides") {
  for (const double friction : {0.5, 0.0}) {
    Scene scene = make_shipped_scene("drape", 120);
    scene.settings.contact.friction = friction;
    Simulation simulation(scene, {});
    // The particle nearest to the ball's top.
    Index middle = 0;
    for (const Face& face : scene.surfaces[0].faces) {
      for (const Index p : face) {
        if (scene.particles[p].position.head<2>().norm() < scene.particles[middle].position.head<2>().norm())
          middle = p;
      }
    }
    CHECK(run_until(simulation, tests::whole_effort("drape comes to rest") ? 1.5 : 0.5) == 0);
    if (!tests::whole_effort("how far drape slides")) continue;
    const Vector3 moved = position(simulation.state().q, middle) - scene.particles[middle].position;
    CAPTURE(friction, moved.transpose());
    if (friction > 0) {
      CHECK(moved.head<2>().norm() < 5e-3);
      CHECK(simulation.energies().kinetic < 1e-3);
    } else {
      CHECK(moved.head<2>().norm() > 2e-2);
    }
    CHECK(position(simulation.state().q, middle).z() > 0.33);  // on the ball
  }
}
