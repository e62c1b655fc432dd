// SPDX-License-Identifier: MIT
#include "fuzz/steps/judge_step.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "fuzz/scenes/judge_reply.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::fuzz {
namespace {

using families::StepScene;

/// The least and the greatest coordinates of an element in the step, along each axis.
using StepBox = std::array<std::array<double, 2>, 3>;

template <std::size_t N>
StepBox box_in_step(const std::array<MeshIndex, N>& corners, const StepScene& scene) {
  StepBox box;
  box.fill({std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
  for (const MeshIndex v : corners) {
    for (const Vec3& at : {scene.x0[v], scene.x1[v]}) {
      const std::array<double, 3> coordinates = {at.x, at.y, at.z};
      for (std::size_t k = 0; k < 3; ++k) {
        box[k] = {std::min(box[k][0], coordinates[k]), std::max(box[k][1], coordinates[k])};
      }
    }
  }
  return box;
}

struct StepBoxes {
  std::vector<StepBox> vertices, edges, faces;

  StepBoxes(const Mesh& mesh, const StepScene& scene) {
    for (MeshIndex v = 0; v < mesh.vertex_count(); ++v) vertices.push_back(box_in_step(std::array{v}, scene));
    for (const auto& edge : mesh.edges()) edges.push_back(box_in_step(edge, scene));
    for (const auto& face : mesh.faces()) faces.push_back(box_in_step(face, scene));
  }

  const StepBox& of(MeshElement sort, MeshIndex number) const {
    return (sort == MeshElement::face ? faces : sort == MeshElement::edge ? edges : vertices)[number];
  }
};

/// Whether two boxes are farther apart than this along an axis. If the difference of two doubles is rounded, it is so
/// by 2^-53 of itself, and the factor leaves more room than that.
bool are_apart(const StepBox& a, const StepBox& b, double distance) {
  const double room = distance * (1 + 0x1p-40);
  for (std::size_t k = 0; k < 3; ++k) {
    if (b[k][0] - a[k][1] > room || a[k][0] - b[k][1] > room) return true;
  }
  return false;
}

/// The contacts of all pairs.
std::vector<MeshContact> exact_contacts(const Mesh& mesh, const StepScene& scene) {
  const Positions x0(scene.x0), x1(scene.x1);
  const StepBoxes boxes(mesh, scene);
  const double distance = scene.elements.separation.distance;
  const auto may_meet = [&](const MeshPair& pair) {
    const auto& [first, second] = geometry::traits_of(pair.kind);
    return !are_apart(boxes.of(first.sort, pair.first), boxes.of(second.sort, pair.second), distance);
  };
  std::vector<MeshContact> contacts;
  SolveOptions options;
  options.method = Method::exact;
  for (const MeshPair& pair : families::every_pair(mesh, may_meet)) {
    options.separation = mesh.separation(pair);
    const Answer answer = solve(query_of(mesh, pair, x0, x1), options);
    if (answer.contact) contacts.push_back({pair, options.separation, answer});
  }
  return contacts;
}

}  // namespace

std::optional<SceneFailure> judge_step(const StepScene& scene, const StepSolver& solver,
                                       const StepFuzzOptions& options) {
  const Mesh mesh = scene.mesh();
  const Positions x0(scene.x0), x1(scene.x1);
  const auto fault = [&mesh](const MeshPair& pair) {
    const auto& [first, second] = geometry::traits_of(pair.kind);
    if (has_element(mesh, first.sort, pair.first) && has_element(mesh, second.sort, pair.second)) return std::string();
    return std::string(name_of(pair.kind)) + " " + std::to_string(pair.first) + " " + std::to_string(pair.second) +
           " names an element that the mesh has not";
  };
  const auto describe = [&mesh](const MeshPair& pair) { return mesh.describe(pair); };
  const auto intersects_at_start = [&] { return !intersections(mesh, x0).empty(); };
  const ReplyJudge<MeshContact> judge(exact_contacts(mesh, scene), fault, describe, intersects_at_start, options);
  return judge.judge([&] { return solver(mesh, x0, x1); });
}

}  // namespace touchstone::fuzz
