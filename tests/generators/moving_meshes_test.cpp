// Moving meshes are well-formed and of the chosen size. Their motion is smooth, and the same on every machine.
// SPDX-License-Identifier: MIT
#include "generators/moving_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <touchstone/error.hpp>

#include "generators/step.hpp"
#include "generators/vectors.hpp"
#include "generators/waves.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::generators;

namespace {

void check_mesh(const Mesh& mesh) {
  std::set<std::array<Index, 2>> edges;
  for (const auto& edge : mesh.edges) {
    CHECK(edge[0] != edge[1]);
    CHECK(std::max(edge[0], edge[1]) < mesh.corner_count);
    CHECK(edges.insert({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}).second);
  }
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i], b = face[(i + 1) % 3];
      CHECK(edges.count({std::min(a, b), std::max(a, b)}) == 1);
    }
  }
}

}  // namespace

TEST_CASE("the sine of a turn is sin(2 pi x)") {
  double worst = 0;
  for (int i = -4000; i <= 4000; ++i) {
    const double x = i / 1000.0;
    worst = std::max(worst, std::fabs(sine(x) - std::sin(6.283185307179586 * x)));
    worst = std::max(worst, std::fabs(cosine(x) - std::cos(6.283185307179586 * x)));
    CHECK(std::fabs(crease(x)) <= 1);
  }
  CHECK(worst < 0x1p-23);
  CHECK(sine(0) == 0);
}

TEST_CASE("meshes have the corners, edges and faces that they say") {
  const std::size_t n = GENERATE(1, 2, 5);
  const auto euler = [](const Mesh& mesh) {
    return static_cast<int>(mesh.corner_count) - static_cast<int>(mesh.edges.size()) +
           static_cast<int>(mesh.faces.size());
  };
  const Mesh sheet = sheet_mesh(n);
  check_mesh(sheet);
  CHECK(sheet.faces.size() == 2 * n * n);
  CHECK(euler(sheet) == 1);
  const Sphere sphere = sphere_mesh(n);
  check_mesh(sphere.mesh);
  CHECK(sphere.mesh.edges.size() == 12 * n * n);
  CHECK(euler(sphere.mesh) == 2);
  for (const Vec3& direction : sphere.directions) CHECK(std::fabs(length(direction) - 1) < 1e-15);
  const Mesh chain = chain_mesh(n);
  check_mesh(chain);
  CHECK(euler(chain) == 1);
}

TEST_CASE("scenes are of the size that was asked for and stay near the origin") {
  const SceneName name = GENERATE(SceneName::cloth, SceneName::sheets, SceneName::cables, SceneName::drape);
  const std::size_t edges = GENERATE(100, 1000, 10000);
  CAPTURE(scene_name(name), edges);
  CHECK(scene_from_name(scene_name(name)) == name);
  const auto moving = make_moving_mesh(name, 3, edges);
  check_mesh(moving->mesh());
  const auto count = static_cast<double>(moving->mesh().edges.size());
  CHECK(std::fabs(count / static_cast<double>(edges) - 1) < 0.2);
  CHECK(moving->mesh().faces.empty() == !has_faces(name));
  std::vector<Vec3> corners;
  for (const double time : {0.0, 1.0, 50.5, 1e6}) {
    moving->set_corners(time, corners);
    REQUIRE(corners.size() == moving->mesh().corner_count);
    double furthest = 0;
    for (const Vec3& corner : corners) furthest = std::max(furthest, length(corner));
    CHECK(furthest < 2);
  }
}

TEST_CASE("steps follow each other, and a corner moves about a tenth of an edge in each") {
  const SceneName name = GENERATE(SceneName::cloth, SceneName::sheets, SceneName::cables, SceneName::drape);
  CAPTURE(scene_name(name));
  Step step(name, 1, 4000, 1);
  const double edge = make_moving_mesh(name, 1, 4000)->edge_length();
  for (int i = 0; i < 3; ++i) {
    const std::vector<Vec3> before = step.end();
    step.advance();
    const bool follows =
        std::equal(before.begin(), before.end(), step.start().begin(), step.start().end(),
                   [](const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; });
    CHECK(follows);
    double sum = 0;
    for (std::size_t k = 0; k < before.size(); ++k) sum += length(step.end()[k] - step.start()[k]);
    const double mean = sum / static_cast<double>(before.size()) / edge;
    CHECK(mean > 0.01);
    CHECK(mean < 0.5);
  }
}

TEST_CASE("names that are no scene") {
  CHECK_FALSE(scene_from_name("").has_value());
  CHECK_FALSE(scene_from_name("Cloth").has_value());
}
