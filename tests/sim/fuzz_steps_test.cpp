// The simulator's broad phase under the fuzzer of whole steps.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <touchstone/fuzz.hpp>

#include "contact/colliders.hpp"
#include "scene/parts.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using touchstone::tests::effort;

namespace {

Vector3 vertex_of(const Positions& x, std::size_t v) {
  const double* const at = x.data + static_cast<std::ptrdiff_t>(v) * x.vertex_stride;
  return {at[0], at[x.coordinate_stride], at[2 * x.coordinate_stride]};
}

VectorX vector_of(const Positions& x, Eigen::Index size) {
  VectorX all = VectorX::Zero(size);
  for (std::size_t v = 0; v < x.count; ++v) all.segment<3>(3 * static_cast<Eigen::Index>(v)) = vertex_of(x, v);
  return all;
}

/// The numbers of a mesh's edges or faces, by their vertices.
template <class Elements>
auto numbered(const Elements& elements) {
  std::map<typename Elements::value_type, MeshIndex> numbers;
  for (MeshIndex i = 0; i < elements.size(); ++i) {
    auto vertices = elements[i];
    std::sort(vertices.begin(), vertices.end());
    numbers[vertices] = i;
  }
  return numbers;
}
template <class Element, class Numbers>
MeshIndex number_of(Element element, const Numbers& numbers) {
  std::sort(element.begin(), element.end());
  return numbers.at(element);
}

/// The pairs that the simulator asks about in a step to x1.
StepReply simulator_reply(const Mesh& mesh, const Positions& x0, const Positions& x1) {
  Scene scene;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    add_particle(scene, vertex_of(x0, v), 1);
    scene.particles.back().collides = false;
  }
  const auto collide = [&scene](const auto& vertices) {
    for (const MeshIndex v : vertices) scene.particles[v].collides = true;
  };
  collide(mesh.points());
  for (const auto& edge : mesh.edges()) scene.wires.push_back({edge}), collide(edge);
  for (const auto& face : mesh.faces()) scene.faces.push_back({face}), collide(face);
  const System system(scene);
  const Colliders colliders(scene, system);
  const auto edges = numbered(mesh.edges());
  const auto faces = numbered(mesh.faces());
  StepReply reply;
  reply.candidates.emplace();
  const Eigen::Index size = system.initial_position.size();
  for (const Pair& pair : colliders.candidates(vector_of(x0, size), vector_of(x1, size), 0)) {
    const auto edge = [&](Index i) { return number_of(colliders.edges()[i], edges); };
    switch (pair.kind) {
      case Kind::edge_edge: reply.candidates->push_back({pair.kind, edge(pair.i), edge(pair.j)}); break;
      case Kind::vertex_face:
        reply.candidates->push_back({pair.kind, pair.i, number_of(colliders.faces()[pair.j], faces)});
        break;
      case Kind::point_edge: reply.candidates->push_back({pair.kind, pair.i, edge(pair.j)}); break;
      case Kind::point_point: reply.candidates->push_back({pair.kind, pair.i, pair.j}); break;
    }
  }
  return reply;
}

StepFuzzOptions touching(std::uint64_t cases) {
  StepFuzzOptions options;
  options.cases = cases;
  options.separations = options.groups = false;
  options.threads = 2;
  return options;
}

}  // namespace

TEST_CASE("the simulator's broad phase leaves out no pair that touches") {
  const StepFuzzReport report = fuzz_steps(simulator_reply, touching(effort(2600)));
  for (const StepFuzzFinding& finding : report.findings) UNSCOPED_INFO(to_string(finding));
  CHECK(report.findings.empty());
}

TEST_CASE("a pair that the simulator's broad phase would drop is found") {
  const StepFuzzReport report = fuzz_steps(
      [](const Mesh& mesh, const Positions& x0, const Positions& x1) {
        StepReply reply = simulator_reply(mesh, x0, x1);
        if (!reply.candidates->empty()) reply.candidates->erase(reply.candidates->begin());
        return reply;
      },
      touching(650));
  REQUIRE(report.findings.size() == 1);
  CHECK(report.findings[0].failure == FuzzFailure::missed);
  CHECK(report.findings[0].question == "candidates");
}
