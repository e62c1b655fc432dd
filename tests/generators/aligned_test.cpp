// The scenes along the axes: what they promise, and the cascade on them against the exact level.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "generators/candidates.hpp"
#include "generators/step.hpp"
#include "generators/vectors.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::generators;

namespace {

constexpr double kFinest = 0x1p-14;  // every coordinate of the scenes with few bits is a multiple of it

bool is_multiple(double x) { return x / kFinest == std::floor(x / kFinest); }

SceneName any_aligned_scene() { return kAlignedScenes[GENERATE(range(std::size_t{0}, kAlignedScenes.size()))]; }

}  // namespace

TEST_CASE("scenes along the axes have the size that was asked for, their planes, and names") {
  const SceneName name = any_aligned_scene();
  const std::size_t edges = GENERATE(100, 1000, 10000);
  CAPTURE(scene_name(name), edges);
  CHECK(scene_from_name(scene_name(name)) == name);
  const auto scene = make_moving_mesh(name, 3, edges);
  const auto turned = make_moving_mesh(name, 3, edges, Placement::turned);
  const Mesh& mesh = scene->mesh();
  const double size = static_cast<double>(mesh.edges.size()) / static_cast<double>(edges);
  CHECK(size > 0.5);
  CHECK(size < 1.6);
  CHECK(mesh.faces.empty() == !has_faces(name));
  CHECK(turned->mesh().edges == mesh.edges);
  CHECK(turned->mesh().faces == mesh.faces);
  for (const auto& face : mesh.faces) CHECK(*std::max_element(face.begin(), face.end()) < mesh.corner_count);
  std::vector<Vec3> corners, elsewhere;
  for (const double time : {0.0, 1.0, 50.5, 1e6}) {
    scene->set_corners(time, corners);
    turned->set_corners(time, elsewhere);
    REQUIRE(corners.size() == mesh.corner_count);
    REQUIRE(elsewhere.size() == mesh.corner_count);
    std::set<double> heights;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3& x = corners[i];
      CHECK(length(x) < 2);
      CHECK(std::fabs(length(x) - length(elsewhere[i])) < 1e-14);
      heights.insert(x.z);
      const bool few_bits = name == SceneName::boxes || name == SceneName::bricks || name == SceneName::grid;
      if (few_bits) CHECK((is_multiple(x.x) && is_multiple(x.y) && is_multiple(x.z)));
    }
    if (name == SceneName::plane || name == SceneName::grid) CHECK(heights == std::set<double>{0});
    if (name == SceneName::boxes || name == SceneName::bricks) CHECK(heights.size() * 4 < corners.size());
  }
}

TEST_CASE("scenes along the axes rest, or slide by a fraction of an edge in each step") {
  const SceneName name = any_aligned_scene();
  CAPTURE(scene_name(name));
  Step step(name, 1, 4000, 1);
  const double edge = make_moving_mesh(name, 1, 4000)->edge_length();
  double sum = 0;
  for (int i = 0; i < 5; ++i) {
    step.advance();
    for (std::size_t k = 0; k < step.end().size(); ++k) sum += length(step.end()[k] - step.start()[k]);
  }
  const double mean = sum / (5 * static_cast<double>(step.end().size())) / edge;
  if (name == SceneName::bricks || name == SceneName::lying) {
    CHECK(mean == 0);
  } else {
    CHECK(mean > 0.01);
    CHECK(mean < 0.5);
  }
}

TEST_CASE("a box has twelve faces that look outwards") {
  const Mesh box = box_mesh();
  CHECK(box.edges.size() == 18);
  CHECK(box.faces.size() == 12);
  double six_volumes = 0;
  const auto at = [](Index i) { return Vec3{i & 1U ? 1.0 : 0.0, i & 2U ? 1.0 : 0.0, i & 4U ? 1.0 : 0.0}; };
  for (const auto& f : box.faces) six_volumes += dot(at(f[0]), cross(at(f[1]), at(f[2])));
  CHECK(six_volumes == 6);
}

TEST_CASE("scenes along the axes, in each placement: fast and exact agree, and much of it touches") {
  const SceneName name = any_aligned_scene();
  const Placement placement = kAllPlacements[GENERATE(range(std::size_t{0}, kAllPlacements.size()))];
  CHECK(placement_from_name(placement_name(placement)) == placement);
  CandidateOptions options;
  options.scene = name;
  options.placement = placement;
  options.edges = 1000;
  options.steps = 4;
  options.count = tests::effort(500);
  options.vertex_face = has_faces(name);
  std::size_t contacts = 0, queries = 0;
  for (const Query& query : candidates(options)) {
    ++queries;
    const Answer fast = solve(query), exact = solve(query, {.method = Method::exact});
    contacts += exact.contact;
    INFO(scene_name(name) << ", " << placement_name(placement) << "  " << tests::cpp_initializer(query));
    REQUIRE(tests::decision_difference(fast, exact) == "");
    REQUIRE(tests::weight_difference(fast, exact) == "");
  }
  CAPTURE(scene_name(name), placement_name(placement), queries, contacts);
  CHECK(queries > 0);
  if (placement == Placement::as_built) CHECK(50 * contacts > queries);
}
