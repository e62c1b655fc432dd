// Bodies in scene files: they are written and read to the last bit, and each fault is named by its path.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include "scene/scene_file.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

const std::string kCorners = R"("vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])";
const std::string kTetrahedron = R"("faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])";
const std::string kSolid = kCorners + ", " + kTetrahedron + ", \"density\": 1000, \"position\": [0, 0, 5]";

std::string scene_of(const std::string& body) { return R"({"touchstone_scene": 1, "bodies": [{)" + body + "}]}"; }

void check_refused(const std::string& body, const std::string& message) {
  CAPTURE(body);
  try {
    scene_from_json(scene_of(body));
  } catch (const touchstone::Error& error) {
    CHECK_THAT(error.what(), Catch::Contains(message));
    return;
  }
  FAIL_CHECK("it was accepted");
}

}  // namespace

TEST_CASE("bodies are the same after a round trip through JSON") {
  const std::string text =
      R"({"touchstone_scene": 1, "bodies": [{)" + kSolid +
      R"(, "orientation": [0.1, 0.2, 0.3, 0.7], "velocity": [1, 2, 3], "angular_velocity": [0.1, 0, 0]}, {)" +
      kCorners +
      R"(, "edges": [[0, 1], [1, 2], [2, 3], [3, 0]], "mass": 0.3, "inertia": [1, 2, 2.5, 0.1, 0, -0.1],
          "centre": [0.1, 0.2, 0.3], "radius": 0.05}, {)" +
      kCorners + ", " + kTetrahedron + R"(, "motion": "fixed", "position": [9, 9, 9]}, {)" + kCorners + ", " +
      kTetrahedron +
      R"(, "motion": "driven", "path": [{"time": 0, "position": [4, 0, 0]},
          {"time": 1.5, "position": [4, 1, 0], "orientation": [0, 1, 0, 0]}]}]})";
  const Scene scene = scene_from_json(text);
  REQUIRE(scene.bodies.size() == 4);
  CHECK(scene.bodies[0].pose.q == Quaternion{0.1, 0.2, 0.3, 0.7});
  CHECK(scene.bodies[1].inertia[3] == 0.1);
  CHECK(scene.bodies[2].motion == BodyMotion::fixed);
  REQUIRE(scene.bodies[3].path.size() == 2);
  CHECK(scene.bodies[3].path[0].pose.q == Quaternion{1, 0, 0, 0});
  const std::string written = scene_to_json(scene);
  const Scene again = scene_from_json(written);
  CHECK(scene_to_json(again) == written);
  for (std::size_t i = 0; i < 4; ++i) {
    const Body &a = scene.bodies[i], &b = again.bodies[i];
    CHECK((a.vertices == b.vertices && a.edges == b.edges && a.faces == b.faces && a.density == b.density));
    CHECK((a.mass == b.mass && a.inertia == b.inertia && a.centre == b.centre && a.pose == b.pose));
    CHECK((a.radius == b.radius && a.velocity == b.velocity && a.angular_velocity == b.angular_velocity &&
           a.path == b.path));
  }
}

TEST_CASE("wrong bodies are refused, and the path of the fault is named") {
  check_refused("\"wings\": 2", "wings");
  check_refused(kTetrahedron, "bodies[0]: lacks the key 'vertices'");
  check_refused("\"vertices\": [], " + kTetrahedron + ", \"density\": 1", "bodies[0].vertices: a body must have some");
  check_refused(kCorners + ", \"density\": 1", "bodies[0]: a body has either faces");
  check_refused(kSolid + R"(, "edges": [[0, 1]])", "bodies[0]: a body has either faces");
  check_refused(kCorners + ", \"density\": 1, \"faces\": [[0, 2, 4]]", "bodies[0].faces[0]: there is no vertex 4");
  check_refused(kCorners + ", \"density\": 1, \"faces\": [[0, 2, 2]]", "bodies[0].faces[0]: vertex 2 is there twice");
  check_refused(kCorners + ", \"density\": 1, \"faces\": [[0, 2]]", "bodies[0].faces[0]: must be a list of 3");
  check_refused(kCorners + ", \"density\": 1, \"faces\": [[0, 2, 1], [0, 1, 2]]", "bodies[0].vertices[3]: is in no");
  check_refused(kCorners + ", \"density\": 1, \"faces\": [[0, 2, 1], [0, 1, 3], [0, 3, 2]]",
                "bodies[0].faces: the mesh is open at edge 1-");
  check_refused(kCorners + ", \"density\": 1, \"faces\": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], [1, 2, 3]]",
                "bodies[0].faces: two faces run from vertex");
  check_refused(kCorners + ", \"density\": 1, \"faces\": [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]",
                "bodies[0].faces: they turn clockwise");
  check_refused(kCorners + ", " + kTetrahedron + ", \"density\": 0", "bodies[0].density: must be positive");
  check_refused(kCorners + ", " + kTetrahedron, "bodies[0].density: a free body needs one");
  check_refused(kCorners + ", " + kTetrahedron + ", \"mass\": 0, \"inertia\": [1, 1, 1, 0, 0, 0]",
                "bodies[0].mass: must be positive");
  check_refused(kCorners + ", " + kTetrahedron + ", \"mass\": 1", "bodies[0]: lacks the key 'inertia'");
  check_refused(kCorners + ", " + kTetrahedron + ", \"inertia\": [1, 1, 1, 0, 0, 0]",
                "bodies[0].inertia: goes with mass");
  check_refused(kCorners + ", " + kTetrahedron + ", \"mass\": 1, \"inertia\": [1, 1, 2.1, 0, 0, 0]",
                "bodies[0].inertia: the principal moments of inertia");
  check_refused(kCorners + ", " + kTetrahedron + ", \"mass\": 1, \"inertia\": [1, 1, 0, 0, 0, 0]",
                "bodies[0].inertia: the principal moments of inertia");
  check_refused(kSolid + ", \"mass\": 1, \"inertia\": [1, 1, 1, 0, 0, 0]", "bodies[0].mass: follows from the density");
  check_refused(R"("vertices": [[0, 0, 0], [1, 0, 0]], "edges": [[0, 1]], "density": 1)",
                "bodies[0].density: the principal moments of inertia");
  check_refused(R"("vertices": [[0, 0, 0], [0, 0, 0]], "edges": [[0, 1]], "density": 1)", "are in one place");
  check_refused(R"("vertices": [[0, 0, 1e10], [0, 0, 0]], "edges": [[0, 1]], "density": 1)",
                "bodies[0].vertices[0]: must be three finite numbers");
  check_refused(kSolid + ", \"orientation\": [0, 0, 0, 0]", "bodies[0].orientation: must be a quaternion");
  check_refused(kSolid + ", \"orientation\": [0, 0, 1]", "bodies[0].orientation: must be a list of 4");
  check_refused(kSolid + ", \"motion\": \"fixed\"", "bodies[0].density: goes with a body that is free");
  check_refused(kSolid + ", \"motion\": \"flying\"", "bodies[0].motion: must be free, fixed or driven");
  check_refused(kSolid + ", \"radius\": -0.1", "bodies[0].radius: ");
  check_refused(kSolid + R"(, "path": [{"time": 0, "position": [0, 0, 0]}])", "bodies[0].path: goes with a driven");
  check_refused(kCorners + ", " + kTetrahedron +
                    R"(, "motion": "driven", "path": [{"time": 1, "position": [0, 0, 0]},
                       {"time": 1, "position": [0, 0, 1]}])",
                "bodies[0].path[1].time: must be later");
  check_refused(kCorners + ", " + kTetrahedron + R"(, "motion": "fixed", "velocity": [1, 0, 0])",
                "bodies[0].velocity: a fixed body has none");
}
