// The start of a run: whatever is pierced is refused, of all sorts of elements, and what is left out is said.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <array>
#include <string>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "scene/body_shapes.hpp"
#include "scene/shipped_scenes.hpp"
#include "seeded/rng.hpp"
#include "sim/all_pairs.hpp"
#include "sim/left_out.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::sim;

namespace {

/// Particles 0, 1 and 2 of a triangle in the plane z = 0, that can move; then 3 and 4, below and above it.
Scene triangle_and_ends() {
  Scene scene;
  for (const Vector3& x : {Vector3(-1, -1, 0), Vector3(1, -1, 0), Vector3(0, 1, 0)}) add_particle(scene, x, 1);
  add_particle(scene, {0, -0.25, -1}, 1);
  add_particle(scene, {0, -0.25, 1}, 1);
  return scene;
}

Surface cloth(std::vector<Face> faces) {
  Surface surface;
  surface.faces = std::move(faces);
  surface.stretch = 100;
  surface.areal_density = 0.1;
  return surface;
}

void check_start_refused(const Scene& scene, const std::string& what) {
  CHECK_THROWS_WITH(Simulation(scene, {}), Catch::Contains("the scene begins with elements that pierce each other: ") &&
                                               Catch::Contains(what) &&
                                               Catch::Contains("positions at which all elements are apart"));
}

double determinant(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  return (b - a).dot((c - a).cross(d - a));
}

/// Of integer coordinates, so that doubles are exact.
bool pierces(const Scene& scene, const Edge& edge, const Face& face) {
  const auto at = [&](Index p) -> const Vector3& { return scene.particles[p].position; };
  if (determinant(at(edge[0]), at(face[0]), at(face[1]), at(face[2])) *
          determinant(at(edge[1]), at(face[0]), at(face[1]), at(face[2])) >=
      0) {
    return false;
  }
  std::array<double, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = determinant(at(edge[0]), at(edge[1]), at(face[k]), at(face[(k + 1) % 3]));
  }
  return (sides[0] > 0 && sides[1] > 0 && sides[2] > 0) || (sides[0] < 0 && sides[1] < 0 && sides[2] < 0);
}

/// Adds a face around the middle of an edge of the scene: far wider than radii are, so that its border is nowhere near.
void pierce(Scene& scene) {
  const System system(scene);
  const Colliders colliders(scene, system);
  Vector3 middle, along;
  double length = 0;
  const auto plant_face = [&](const Vector3& a, const Vector3& b) {
    middle = (a + b) / 2;
    along = (b - a).normalized();
    length = (b - a).norm();
    const Vector3 side = along.unitOrthogonal(), other = along.cross(side);
    const auto first = static_cast<Index>(scene.particles.size());
    for (const Vector3& x : {Vector3(2 * side), Vector3(-side + other), Vector3(-side - other)}) {
      add_particle(scene, middle + length * x, 1);
    }
    scene.faces.push_back({{first, first + 1, first + 2}});
  };
  if (const auto edges = colliders.edges_of(kParticles); !edges.empty()) {
    const Edge& edge = edges.back();
    plant_face(position(system.initial_position, edge[0]), position(system.initial_position, edge[1]));
    return;
  }
  const Body& body = scene.bodies.back();
  const Pose pose{normalised(body.pose.q), body.pose.p};
  const Edge edge = body.edges.empty() ? Edge{body.faces[0][0], body.faces[0][1]} : body.edges[0];
  plant_face(placed(pose, body.vertices[edge[0]]), placed(pose, body.vertices[edge[1]]));
}

}  // namespace

TEST_CASE("a spring, a wire or a cable through a face is refused, with its place") {
  Scene scene = triangle_and_ends();
  scene.faces = {{{0, 1, 2}}};
  SECTION("a spring") { add_spring(scene, 3, 4, 10, 0, true); }
  SECTION("a wire") { scene.wires = {{{3, 4}}}; }
  SECTION("a wire with a radius, which reaches far on both sides") { scene.wires = {{{3, 4}, 0.01}}; }
  SECTION("a cable, as thick as it is or as its centreline") {
    for (const bool solid : {false, true}) {
      Scene with_cable = scene;
      add_cable(with_cable, {0.1, -0.25, -1}, {0.1, -0.25, 1}, 1);
      Cable& cable = with_cable.cables.back();
      set_material(cable, 1e6, 0.3, 0.01, 1000);
      cable.solid = solid;
      check_start_refused(with_cable, "edge 5-6 and face 0-1-2 at (0.1, -0.25, 0)");
    }
    return;
  }
  check_start_refused(scene, "edge 3-4 and face 0-1-2 at (0, -0.25, 0)");
}

TEST_CASE("triangles of cloth, of springs and of faces through each other are refused") {
  Scene scene = triangle_and_ends();
  add_particle(scene, {0.5, 2, 0.5}, 1);
  SECTION("cloth") {
    scene.surfaces = {cloth({{0, 1, 2}}), cloth({{3, 4, 5}})};
    check_start_refused(scene, "edge 1-2 and face 3-4-5 at (0.192308, 0.615385, 0), and 1 more pair;");
  }
  SECTION("one sheet that passes through itself") {
    scene.surfaces = {cloth({{0, 1, 2}, {3, 4, 5}})};
    check_start_refused(scene, "edge 1-2 and face 3-4-5");
  }
  SECTION("a face and cloth, and a face that is given twice") {
    scene.surfaces = {cloth({{0, 1, 2}})};
    scene.faces = {{{3, 4, 5}}, {{5, 4, 3}}};
    check_start_refused(scene, "edge 1-2 and face 3-4-5");
  }
}

TEST_CASE("what is driven or pinned is refused when something pierces it that can move") {
  Scene scene = triangle_and_ends();
  for (const Index p : {0U, 1U, 2U}) scene.particles[p].fixed = {true, true, true};
  scene.faces = {{{0, 1, 2}}};
  scene.wires = {{{3, 4}}};
  check_start_refused(scene, "edge 3-4 and face 0-1-2");
  for (const Index p : {3U, 4U}) scene.particles[p].path = {{0, scene.particles[p].position}};
  check_start_refused(scene, "edge 3-4 and face 0-1-2");
}

TEST_CASE("elements that cannot move may intersect, and the verdict counts them") {
  Scene scene = triangle_and_ends();
  for (Particle& p : scene.particles) p.fixed = {true, true, true};
  scene.faces = {{{0, 1, 2}}};
  scene.wires = {{{3, 4}}};
  add_particle(scene, {9, 9, 9}, 1);
  Simulation simulation(scene, {});
  CHECK(simulation.start().held == 1);
  simulation.step();
  CHECK(left_out_for_person(simulation, 1) ==
        "; left out: pairs among 5 elements that cannot move (1 of which intersects)");
  CHECK_THAT(checked_for_person(simulation, 1),
             Catch::StartsWith("checked: no intersection of anything that can move at 0 s, and each step to "
                               "0.0166666667 s, of 4 edges, 1 face, 1 loose particle"));
}

TEST_CASE("a verdict names what does not collide, and runs in which nothing is asked") {
  const auto verdict = [](const Scene& scene, int steps) {
    Simulation simulation(scene, {});
    for (int i = 0; i < steps; ++i) simulation.step();
    return left_out_for_person(simulation, static_cast<std::uint64_t>(steps));
  };
  Scene scene = triangle_and_ends();
  scene.faces = {{{0, 1, 2}}};
  CHECK(verdict(scene, 1).empty());
  CHECK(verdict(scene, 0) == "; warning: only the start was asked about");
  add_spring(scene, 3, 4, 10, 0, false);
  add_spring(scene, 0, 1, 10, 0, false);  // an edge of the face collides all the same
  CHECK(verdict(scene, 1) == "; left out: 1 spring that does not collide");
  scene.particles[3].collides = scene.particles[4].collides = false;
  CHECK(verdict(scene, 1) == "; left out: 2 particles and 1 spring that do not collide");

  Scene nothing = triangle_and_ends();
  for (Particle& p : nothing.particles) p.collides = false;
  CHECK(verdict(nothing, 1) ==
        "; warning: nothing collides, so no pair was asked about; left out: 5 particles that do not collide");
  Scene still = triangle_and_ends();
  for (Particle& p : still.particles) p.fixed = {true, true, true};
  still.faces = {{{0, 1, 2}}};
  CHECK_THAT(
      verdict(still, 1),
      Catch::StartsWith("; warning: nothing that collides can move, so no pair was asked about; left out: pairs"));
  Scene alone;
  add_particle(alone, {0, 0, 0}, 1);
  CHECK(verdict(alone, 1) == "; warning: only one element or body collides, so no pair was asked about");
}

TEST_CASE("a verdict counts the waypoints that a step passes by, and cables without their radius") {
  // A particle goes down through a face and up again within one step, and is not asked about on its way.
  Scene scene;
  add_particle(scene, {0, 0, 0}, 1);
  add_particle(scene, {4, 0, 0}, 1);
  add_particle(scene, {0, 4, 0}, 1);
  add_particle(scene, {1, 1, 1}, 1);
  for (const Index p : {0U, 1U, 2U}) scene.particles[p].fixed = {true, true, true};
  scene.faces = {{{0, 1, 2}}};
  scene.settings.time_step = 0.1;
  scene.particles[3].path = {{0, {1, 1, 1}}, {0.05, {1, 1, -1}}, {0.1, {1, 1, 1}}, {0.3, {1, 1, 2}}};
  {
    Simulation simulation(scene, {});
    for (int i = 0; i < 4; ++i) simulation.step();
    CHECK(simulation.passed_waypoints() == 1);
    CHECK(left_out_for_person(simulation, 4) == "; left out: 1 waypoint of paths between the ends of steps");
  }
  scene.settings.time_step = 0.05;
  Simulation shorter(scene, {});
  CHECK_THROWS_WITH(shorter.step(), Catch::Contains("would touch"));
  CHECK(shorter.passed_waypoints() == 0);

  Scene cable;
  for (const double x : {0.0, 1.0, 2.0}) add_particle(cable, {x, 0, 0}, 1);
  cable.cables.resize(1);
  cable.cables[0].particles = {0, 1, 2};
  cable.cables[0].radius = 0.1;
  cable.cables[0].density = cable.cables[0].stretch = 100;
  CHECK(left_out_for_person(Simulation(cable, {}), 1) == "; left out: the radius of 1 cable that is not solid");
  cable.cables[0].solid = true;
  CHECK_THAT(left_out_for_person(Simulation(cable, {}), 1), !Catch::Contains("not solid"));
}

TEST_CASE("a verdict says where nobody knows what is inside") {
  // Two tetrahedra over one triangle, without that triangle: a closed surface with a particle in it.
  Scene scene;
  for (const Vector3& x :
       {Vector3(0, 0, 2), Vector3(0, 0, -2), Vector3(2, 0, 0), Vector3(-1, 2, 0), Vector3(-1, -2, 0)}) {
    add_particle(scene, x, 1);
  }
  add_particle(scene, {0.1, 0.1, 0.5}, 1);
  scene.faces = {{{0, 2, 3}}, {{0, 3, 4}}, {{0, 4, 2}}, {{1, 3, 2}}, {{1, 4, 3}}, {{1, 2, 4}}};
  const auto verdict = [&] { return left_out_for_person(Simulation(scene, {}), 1); };
  CHECK_THAT(verdict(), Catch::StartsWith("; 1 part wholly inside a closed surface"));
  scene.faces.push_back({{2, 3, 4}});  // a wall
  CHECK(verdict() == "; what is inside what is not known of 1 surface with an edge of three faces or more");
  scene.faces.erase(scene.faces.begin() + 3, scene.faces.end());
  CHECK(verdict() == "; 1 part in the box around an open surface at the start, which has no inside");
}

TEST_CASE("a body that intersects itself does so for ever, and the verdict counts its pairs") {
  Body two = box({1, 1, 1}, 1000);
  const Body other = box({1, 1, 1}, 1000);
  const auto first = static_cast<Index>(two.vertices.size());
  for (const Vector3& x : other.vertices) two.vertices.push_back(x + Vector3(0.5, 0.25, 0.125));
  for (const Face& face : other.faces) two.faces.push_back({first + face[0], first + face[1], first + face[2]});
  Scene scene;
  scene.bodies = {two, box({1, 1, 1}, 1000)};
  scene.bodies[1].pose.p.x() = 9;
  Simulation simulation(scene, {});
  simulation.step();
  const std::size_t within = simulation.start().within_bodies;
  CHECK(within > 1);
  CHECK(simulation.start().held == 0);
  CHECK(left_out_for_person(simulation, 1) ==
        "; left out: " + std::to_string(within) + " pairs within bodies, which intersect");
  CHECK_THAT(checked_for_person(simulation, 1),
             Catch::StartsWith("checked: no intersection but within bodies at 0 s, and each step to "));

  // A body of two shells, one in the other, is no part inside another.
  scene.bodies[0] = box({1, 1, 1}, 1000);
  for (const Vector3& x : other.vertices) scene.bodies[0].vertices.push_back(0.5 * x);
  for (const Face& face : other.faces) scene.bodies[0].faces.push_back({8 + face[0], 8 + face[2], 8 + face[1]});
  CHECK(left_out_for_person(Simulation(scene, {}), 1).empty());
  CHECK(Simulation(scene, {}).start().within_bodies == 0);
  // Wholly inside another body, both shells are, whichever body is named first.
  for (const bool outer_first : {false, true}) {
    const Body hollow = scene.bodies[0], around = box({9, 9, 9}, 1000);
    Scene nested;
    nested.bodies = outer_first ? std::vector{around, hollow} : std::vector{hollow, around};
    CHECK(Simulation(nested, {}).start().enclosed == 2);
    CHECK(Simulation(nested, {}).start().enclosed_in_bodies == 2);
  }
}

TEST_CASE("a checkpoint whose elements are pierced is refused, and the run stays where it is") {
  Scene scene = triangle_and_ends();
  scene.faces = {{{0, 1, 2}}};
  scene.wires = {{{3, 4}}};
  scene.settings.gravity.setZero();
  for (const Index p : {3U, 4U}) scene.particles[p].position.x() = 9;
  Simulation simulation(scene, {});
  simulation.step();
  State state = simulation.state();
  state.q[9] = state.q[12] = 0;
  const VectorX before = simulation.state().q;
  CHECK_THROWS_WITH(
      simulation.resume(state, 1),
      Catch::Contains("q: the checkpoint begins with elements that pierce each other: edge 3-4 and face"));
  CHECK(simulation.state().q == before);
}

TEST_CASE("random starts on a lattice are refused exactly when elements touch or pierce each other") {
  seeded::Rng random(1);
  const int rounds = static_cast<int>(tests::effort(4000));
  int refused = 0, refused_as_pierced = 0;
  for (int round = 0; round < rounds; ++round) {
    Scene scene;
    for (int i = 0; i < 11; ++i) {
      const double x = random.between(-3, 3), y = random.between(-3, 3);
      add_particle(scene, {x, y, static_cast<double>(random.between(-3, 3))}, 1);
    }
    scene.faces = {{{0, 1, 2}}, {{2, 1, 3}}, {{4, 5, 6}}};
    scene.wires = {{{7, 8}}, {{8, 9}}};
    try {
      check_scene(scene);
    } catch (const Error&) {
      continue;  // corners in one place
    }
    const System system(scene);
    const Colliders colliders(scene, system);
    bool touches = false, is_pierced = false;
    for (const Pair& pair : all_pairs(scene, colliders)) {
      touches |= solve(colliders.query(pair, system.initial_position, system.initial_position)).contact;
    }
    for (const Edge& edge : colliders.edges()) {
      for (const Face& face : colliders.faces()) is_pierced |= pierces(scene, edge, face);
    }
    bool was_refused = false;
    try {
      const Simulation simulation(scene, {});
    } catch (const Error&) {
      was_refused = true;
    }
    CAPTURE(round, touches, is_pierced);
    REQUIRE(was_refused == (touches || is_pierced));
    refused += was_refused ? 1 : 0;
    refused_as_pierced += is_pierced && !touches ? 1 : 0;
  }
  CHECK(refused_as_pierced > rounds / 20);
  CHECK(rounds - refused > rounds / 20);
}

TEST_CASE("every shipped scene starts, and none of them starts pierced") {
  for (const ShippedScene& shipped : shipped_scenes()) {
    CAPTURE(shipped.name);
    Scene scene = make_shipped_scene(shipped.name, shipped.least);
    CHECK_NOTHROW(Simulation(scene, {}));
    pierce(scene);
    CHECK_THROWS_WITH(Simulation(scene, {}), Catch::Contains("the scene begins with elements that "));
  }
}

TEST_CASE("parts wholly inside a closed surface of particles are counted at the start") {
  Scene scene;
  const auto tetrahedron = [&](double size) {
    const auto first = static_cast<Index>(scene.particles.size());
    for (const Vector3& x : {Vector3(-1, -1, -1), Vector3(3, -1, -1), Vector3(-1, 3, -1), Vector3(-1, -1, 3)}) {
      add_particle(scene, size * x, 1);
    }
    scene.surfaces.push_back(cloth({{first, first + 2, first + 1},
                                    {first, first + 1, first + 3},
                                    {first + 1, first + 2, first + 3},
                                    {first, first + 3, first + 2}}));
  };
  const auto verdict = [&] {
    Simulation simulation(scene, {});
    simulation.step();
    return left_out_for_person(simulation, 1);
  };
  tetrahedron(1);
  CHECK(verdict().find("inside") == std::string::npos);
  tetrahedron(0.25);
  CHECK(verdict() ==
        "; 1 part wholly inside a closed surface at the start, without contact of surfaces (particle 4 in the surface "
        "of face 0-2-1)");
  add_particle(scene, {-0.5, -0.5, -0.5}, 1);
  CHECK(verdict() ==
        "; 2 parts wholly inside a closed surface at the start, without contact of surfaces (particle 4 in the surface "
        "of face 0-2-1, ...)");
  scene.surfaces[0].faces.pop_back();
  CHECK(verdict() == "; 2 parts in the box around an open surface at the start, which has no inside");
}
