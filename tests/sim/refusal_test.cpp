// Steps that are refused or cannot be completed: nothing has moved then, and the error names the obstacle.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "scene/parts.hpp"
#include "sim/checkpoint.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

std::string error_of(Simulation& simulation, int steps) {
  try {
    for (int i = 0; i < steps; ++i) simulation.step();
  } catch (const touchstone::Error& error) {
    return error.what();
  }
  return "";
}

/// A wire across the three pinned rays of a star, which is driven from one sector to the next round the end of the ray
/// between them, in `legs` straight lines in a step of one second. A part that is longer than one of these would take
/// it through a ray: three sectors are never as many as a power of two, so it never ends where it began.
Scene round_a_star(int legs) {
  Scene scene;
  scene.settings.time_step = 1;
  scene.settings.gravity.setZero();
  for (const double z : {-1.0, 1.0}) {
    Particle end;
    for (int i = 0; i <= legs; ++i) {
      const double angle = i * std::numbers::pi / 3, radius = i % 2 == 0 ? 0.5 : 10;
      end.path.push_back({static_cast<double>(i) / legs, {radius * std::cos(angle), radius * std::sin(angle), z}});
    }
    scene.particles.push_back(end);
  }
  scene.wires.push_back({0, 1});
  const Index centre = add_pinned(scene, {0, 0, 0});
  for (int i = 1; i < 6; i += 2) {
    const double angle = i * std::numbers::pi / 3;
    scene.wires.push_back({centre, add_pinned(scene, {2 * std::cos(angle), 2 * std::sin(angle), 0})});
  }
  return scene;
}

}  // namespace

TEST_CASE("a step is taken in so many parts as it needs, and in 20,000 tries at most") {
  Simulation few(round_a_star(16), {});
  CHECK(few.step().size() == 16);
  CHECK(few.steps() == 1);
  CHECK(few.state().time == 1);
  CHECK(few.refused(Cause::not_resolved) == 15);  // a whole one, two halves, ...: all that is longer than a sixteenth

  Simulation many(round_a_star(1 << 14), {});
  const std::string before = checkpoint_to_json(many);
  const std::string error = error_of(many, 1);
  CHECK_THAT(error, Catch::StartsWith("step 1 cannot be taken: after 20000 tries of its parts it has come to 0.6"));
  CHECK_THAT(error, Catch::Contains(" found no response): edge 0-1 and edge 2-"));
  CHECK((checkpoint_to_json(many) == before));
  CHECK(many.refused(Cause::not_resolved) > 9000);
}

TEST_CASE("what ends a run between the parts of a step takes back the parts that were made") {
  Scene blocked = round_a_star(16);
  const Index loose = add_particle(blocked, {7, 7, 7}, 1);
  blocked.particles[loose].velocity = {1, 2, 3};

  // The paper's narrow phase sees edges, so this step still needs substeps. It sees no faces, so a particle crosses one
  // in the first substep.
  Scene crossed = blocked;
  const auto first = static_cast<Index>(crossed.particles.size());
  for (const Vector3& corner : {Vector3(20, 0, 0), Vector3(21, 0, 0), Vector3(20, 1, 0)}) add_pinned(crossed, corner);
  crossed.faces.push_back({first, first + 1, first + 2});
  const Index through = add_particle(crossed, {20.2, 0.2, 1}, 0);
  crossed.particles[through].path = {{0, {20.2, 0.2, 1}}, {1.0 / 16, {20.3, 0.2, -1}}};

  constexpr int kNever = 1'000'000'000;
  for (const bool paper : {false, true}) {
    CAPTURE(paper);
    const Scene& scene = paper ? crossed : blocked;
    SimulationOptions options;
    options.narrow_phase = paper ? NarrowPhase::paper : NarrowPhase::exact;
    Simulation twin(scene, options);
    const std::size_t parts = twin.step().size();
    REQUIRE(parts == 16);
    REQUIRE(twin.crossings().size() == (paper ? 1 : 0));

    int checks = 0, last = kNever;  // the last check that lets the run go on
    options.check_cancelled = [&] {
      if (++checks > last) throw std::runtime_error("enough");
    };
    Simulation simulation(scene, options);
    const std::string before = checkpoint_to_json(simulation);
    for (last = 0; last < 24; last += 3) {
      CAPTURE(last);
      checks = 0;
      CHECK_THROWS_WITH(simulation.step(), "enough");
      CHECK((checkpoint_to_json(simulation) == before));
      CHECK(simulation.steps() == 0);
      CHECK(simulation.crossings().empty());
    }
    // A sink of queries that can take no more, in the middle of a proof.
    last = kNever;
    int queries = 0;
    simulation.watch([&](const touchstone::Query&, double, const touchstone::Answer&) {
      if (++queries == 5) throw std::runtime_error("full");
    });
    CHECK_THROWS_WITH(simulation.step(), "full");
    CHECK((checkpoint_to_json(simulation) == before));
    CHECK(simulation.crossings().empty());
    simulation.watch({});
    checks = 0;
    CHECK(simulation.step().size() == parts);
    CHECK((checkpoint_to_json(simulation) == checkpoint_to_json(twin)));
    REQUIRE(simulation.crossings().size() == twin.crossings().size());
    CHECK(checks > 24);
  }
}

TEST_CASE("who is in the way of a step, where, and what would be right") {
  Scene scene;
  scene.particles.resize(1);
  scene.particles[0].path = {{0, {0, 0, 1}}};
  for (const Vector3& corner : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)}) add_pinned(scene, corner);
  scene.faces.push_back({1, 2, 3});
  const Index free = add_particle(scene, {0.25, 0.5, 2}, 1);
  scene.cables.push_back(straight_cable(scene, {5, 0, 0}, {8, 0, 0}, 3));
  set_material(scene.cables.back(), 1e5, 0.3, 0.01, 1000);
  const System system(scene);
  const Colliders colliders(scene, system);
  const auto words = [&](const Refusal& refusal) {
    return refusal_for_person(refusal, scene, system, colliders, system.initial_position);
  };
  Refusal refusal;
  refusal.cause = Cause::not_resolved;
  refusal.pair = Pair{touchstone::Kind::vertex_face, 0, 0};
  refusal.point = {0.25, 0.5, -1};
  CHECK(words(refusal) ==
        "particle 0 and face 1-2-3 would touch at (0.25, 0.5, -1), and nothing of them is free to give way; other "
        "paths or pins would be right");
  refusal.pair->i = free;
  CHECK(words(refusal) ==
        "particle 4 and face 1-2-3 would touch at (0.25, 0.5, -1), and have no room between what is held or driven; "
        "paths that leave them room would be right");
  refusal.cause = Cause::not_certified;
  CHECK(words(refusal) ==
        "particle 4 and face 1-2-3 would cross at (0.25, 0.5, -1); a smaller settings.time_step or a larger "
        "settings.contact.thickness would be right");

  refusal = {};
  CHECK(words(refusal) ==
        "its equations cannot be solved in doubles; a smaller settings.time_step or softer springs and cables would be "
        "right");
  refusal.largest_change = {3 * free + 1, 0.25};
  CHECK(words(refusal) ==
        "Newton's method does not settle particle 4 at (0.25, 0.5, 2), which it still changes by 0.25 m/s; a smaller "
        "settings.time_step or softer springs and cables would be right");
  refusal.largest_change = {system.angle(1), 3};
  refusal.with_contacts = true;
  scene.settings.contact.friction = 0.5;
  CHECK(words(refusal) ==
        "Newton's method with its contacts does not settle the twist of segment 6-7 at (6, 0, 0), which it still "
        "changes by 3 rad/s; a smaller settings.time_step, less settings.contact.friction or softer springs and cables "
        "would be right");
}

TEST_CASE("the place of a contact is the touched point of its first element") {
  Scene scene;
  scene.wires = {{add_particle(scene, {0, 0, 0}, 1), add_particle(scene, {4, 0, 0}, 1)},
                 {add_particle(scene, {1, -1, 1}, 1), add_particle(scene, {1, 3, 1}, 1)}};
  const Index a = add_particle(scene, {0, 9, 9}, 1), b = add_particle(scene, {2, 9, 9}, 1);
  const System system(scene);
  const Colliders colliders(scene, system);
  VectorX end = system.initial_position;
  for (Eigen::Index k = 2; k < 6; k += 3) end[k] = 2;
  const auto contact = [&](const Pair& pair) {
    return contact_of(colliders, pair, system.initial_position, end,
                      touchstone::solve(colliders.query(pair, system.initial_position, end)), true);
  };
  const Vector3 place = contact_point(contact({touchstone::Kind::edge_edge, 0, 1}), system.initial_position);
  CHECK((place - Vector3(1, 0, 0)).norm() < 1e-14);
  end[3 * a] = 3;
  CHECK(contact_point(contact({touchstone::Kind::point_point, a, b}), system.initial_position) == Vector3(0, 9, 9));
}

TEST_CASE("an explicit step that explodes says which step it would have needed") {
  Scene scene;
  scene.settings.integrator = Integrator::symplectic_euler;
  scene.settings.gravity.setZero();
  scene.settings.time_step = 0.1;
  add_particle(scene, {0, 0, 0}, 1);
  add_particle(scene, {1.5, 0, 0}, 1);
  scene.springs.push_back({0, 1, 1e6, 0, 1, true});
  Simulation simulation(scene, {});
  const std::string error = error_of(simulation, 1000);
  CHECK_THAT(error, Catch::Contains(" (25 did not converge): its numbers grow out of range; settings.time_step below "
                                    "the stiffest period / pi"));
  CHECK(simulation.state().q.allFinite());
}

TEST_CASE(
    "a cable that is thrown at the greatest speed there is: its steps are taken or refused, no search gets lost") {
  // Newton's method leaves the range of doubles here, in the middle of steps uphill.
  Scene scene;
  scene.settings.integrator = Integrator::tr_bdf2;
  Cable& cable = add_cable(scene, {0, 0, 0}, {1, 0, 0}, 5);
  cable.radius = 0.01;
  cable.density = 1000;
  cable.stretch = 3141.6;
  cable.bend = 0.07854;
  cable.twist = 0.06042;
  for (const Index i : {1u, 3u, 5u}) scene.particles[cable.particles[i]].position.z() = 0.01;
  scene.particles[cable.particles[3]].velocity.x() = 1e9;
  Simulation simulation(scene, {});
  error_of(simulation, 5);
  CHECK(simulation.state().q.allFinite());
  CHECK(simulation.crossings().empty());
}
