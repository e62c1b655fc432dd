// Cloth in scene files: what is read, what is written, and what is refused.
// SPDX-License-Identifier: MIT
#include <string>

#include <touchstone/error.hpp>

#include "cloth/cloth_scenes.hpp"
#include "scene/scene_file.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;

namespace {

/// Six particles, and surfaces with this text. 3 and 0, 1 are on a line; 4 does not collide.
std::string with_surface(const std::string& surface) {
  return R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0]}, {"position": [1, 0, 0]},
      {"position": [0, 1, 0]}, {"position": [2, 0, 0], "mass": 1},
      {"position": [0, 0, 1], "mass": 1, "collides": false}, {"position": [1, 1, 1], "mass": 1}],
      "surfaces": [)" +
         surface + "]}";
}

void check_refused(const std::string& surface, const std::string& reason) {
  CAPTURE(surface);
  CHECK_THROWS_WITH(scene_from_json(with_surface(surface)), Catch::Contains(reason));
}

}  // namespace

TEST_CASE("a surface of cloth: its material or its stiffnesses, and the same from its own text") {
  const Scene scene = scene_from_json(with_surface(
      R"({"faces": [[0, 1, 2], [1, 2, 5]], "young": 1e6, "poisson": 0.25, "sheet_thickness": 1e-3, "density": 300,
          "damping": 0.01, "strain_limit": true, "radius": 0.002, "rest_is_bent": true})"));
  REQUIRE(scene.surfaces.size() == 1);
  const Surface& cloth = scene.surfaces[0];
  CHECK(cloth.faces == std::vector<Face>{{0, 1, 2}, {1, 2, 5}});
  CHECK(cloth.stretch == Approx(1e3));
  CHECK(cloth.bend == Approx(1e6 * 1e-9 / (12 * (1 - 0.0625))));
  CHECK(cloth.areal_density == Approx(0.3));
  CHECK(cloth.strain_limit == 0.1);
  const Scene again = scene_from_json(scene_to_json(scene));
  CHECK(scene_to_json(again) == scene_to_json(scene));
  CHECK(again.surfaces[0].bend == cloth.bend);
  CHECK(again.surfaces[0].radius == 0.002);
  CHECK(again.surfaces[0].rest_is_bent);

  const Scene given = scene_from_json(with_surface(
      R"({"faces": [[0, 1, 2]], "stretch": 50, "bend": 1e-4, "areal_density": 0.1, "strain_limit": 0.2})"));
  CHECK(given.surfaces[0].stretch == 50);
  CHECK(given.surfaces[0].strain_limit == 0.2);
  // A third of the triangle's mass for each corner.
  CHECK(System(given).mass[0] == Approx(0.1 * 0.5 / 3));

  // Springs stay springs.
  const std::string springs = R"({"faces": [[0, 1, 2]], "stiffness": 3})";
  const std::string text = with_surface(springs);
  std::string massive = text;
  for (std::size_t at; (at = massive.find("0]},")) != std::string::npos;) massive.replace(at, 4, R"(0], "mass": 1},)");
  const Scene net = scene_from_json(massive);
  CHECK(net.surfaces.empty());
  CHECK(net.springs.size() == 3);
  CHECK(net.faces.size() == 1);
  CHECK(scene_to_json(net).find("surfaces") == std::string::npos);
}

TEST_CASE("a surface of cloth that makes no sense is refused, by its key") {
  const std::string good = R"(, "stretch": 50, "areal_density": 0.1)";
  CHECK_NOTHROW(scene_from_json(with_surface(R"({"faces": [[0, 1, 2]])" + good + "}")));
  const auto refused = [&](const std::string& faces, const std::string& more, const std::string& reason) {
    check_refused("{\"faces\": " + faces + good + more + "}", reason);
  };
  refused("[[0, 1, 9]]", "", "surfaces[0].faces[0]: there is no particle 9: there are 6");
  refused("[[0, 1, 1]]", "", "surfaces[0].faces[0]: particle 1 is there twice");
  refused("[[0, 1]]", "", "surfaces[0].faces[0]: must be a list of 3 particle numbers");
  refused("[]", "", "surfaces[0].faces: must be at least one");
  refused("[[0, 1, 3]]", "", "surfaces[0].faces[0]: the particles 0, 1 and 3 are on a line");
  refused("[[0, 1, 4]]", "", "surfaces[0].faces[0]: particle 4 does not collide");
  refused("[[0, 1, 2], [2, 1, 0]]", "", "surfaces[0].faces[1]: is the same triangle as faces[0]");
  refused("[[0, 1, 2], [1, 2, 5], [1, 2, 3]]", "", "surfaces[0].faces[2]: is the third face at the edge 1-2");
  refused("[[0, 1, 2]]", R"(, "stiffness": 3)", "surfaces[0].stiffness: goes with a surface of springs");
  refused("[[0, 1, 2]]", R"(, "poisson": 0.6)", "surfaces[0].poisson: 0.6 is not in [-0.99, 0.5]");
  refused("[[0, 1, 2]]", R"(, "bend": -1)", "surfaces[0].bend: -1 is not in");
  refused("[[0, 1, 2]]", R"(, "bend": 1e300)", "surfaces[0].bend: 1e+300 is not in");
  refused("[[0, 1, 2]]", R"(, "damping": -1)", "surfaces[0].damping: -1 is not in");
  refused("[[0, 1, 2]]", R"(, "strain_limit": 0)", "surfaces[0].strain_limit: must be true, false or a positive");
  refused("[[0, 1, 2]]", R"(, "strain_limit": "yes")", "surfaces[0].strain_limit: ");
  refused("[[0, 1, 2]]", R"(, "strain_limit": 1e-9)", "surfaces[0].strain_limit: 1e-09 is not in");
  refused("[[0, 1, 2]]", R"(, "rest_is_bent": true)", "surfaces[0].rest_is_bent: goes with a surface that resists");
  refused("[[0, 1, 2]]", R"(, "radius": -1)", "surfaces[0].radius: -1 is neither");
  refused("[[0, 1, 2]]", R"(, "colour": 1)", "surfaces[0]: has no key 'colour'");
  refused("[[0, 1, 2]]", R"(, "density": 1)", "surfaces[0].density: goes with young");
  refused("[[0, 1, 2]]", R"(, "young": 1)", "surfaces[0].stretch: follows from young");
  check_refused(R"({"faces": [[0, 1, 2]], "young": 1e6, "density": 3})",
                "surfaces[0]: lacks the key 'sheet_thickness'");
  check_refused(R"({"faces": [[0, 1, 2]], "young": -1, "sheet_thickness": 1e-3, "density": 3})",
                "surfaces[0].young: must be positive");
  check_refused(R"({"faces": [[0, 1, 2]], "bend": 1})", "surfaces[0]: lacks the key 'young', or 'stretch'");
  check_refused(R"({"faces": [[0, 1, 2]], "stretch": 0, "areal_density": 1})", "surfaces[0].stretch: 0 N/m is not in");
  check_refused(R"({"faces": [[0, 1, 2]], "stretch": 1})", "particles[0].mass: 0 is not allowed");
  SheetScene sheet = sheet_scene(1, 1, 2);
  sheet.surface().stretch = std::nan("");
  CHECK_THROWS_WITH(check_scene(sheet.scene), Catch::Contains("surfaces[0].stretch: nan"));
}

TEST_CASE("a sheet's mesh covers it with nearly equilateral triangles that all face one way") {
  for (const Index columns : {1u, 2u, 5u, 8u}) {
    Scene scene;
    const SheetMesh mesh = add_sheet(scene, {{1, 2, 3}, {2, 0, 0}, {0, 3, 0}, columns});
    double area = 0;
    for (const Face& face : mesh.faces) {
      const Vector3 a = scene.particles[face[0]].position;
      const Vector3 u = scene.particles[face[1]].position - a, w = scene.particles[face[2]].position - a;
      const double twice = u.x() * w.y() - u.y() * w.x();
      CHECK(twice > 0);
      area += twice / 2;
    }
    CAPTURE(columns);
    CHECK(area == Approx(6));
    // Mirrored along x, the mesh is the same.
    for (const auto& row : mesh.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        CHECK(scene.particles[row[i]].position.x() + scene.particles[row[row.size() - 1 - i]].position.x() ==
              Approx(4));
      }
    }
    CHECK_NOTHROW(columns_for(2, 3, 100));
  }
  Scene scene;
  const double many =
      static_cast<double>(add_sheet(scene, {{}, {2, 0, 0}, {0, 3, 0}, columns_for(2, 3, 5000)}).faces.size());
  CHECK(many == Approx(5000).epsilon(0.05));
}
