// SPDX-License-Identifier: MIT
#include "fuzz/steps/shrink_steps.hpp"

#include <algorithm>
#include <cstddef>

#include "fuzz/scenes/scene_shrinking.hpp"
#include "fuzz/shrinking/simplicity.hpp"

namespace touchstone::fuzz {
namespace {

using families::StepScene;

template <class F>
void for_each_step_number(StepScene& scene, const F& f) {
  for (auto* const positions : {&scene.x0, &scene.x1}) {
    for (Vec3& at : *positions) f(at.x), f(at.y), f(at.z);
  }
  f(scene.elements.separation.distance);
}

bool is_still(const StepScene& scene, std::size_t v) {
  const Vec3 &a = scene.x0[v], &b = scene.x1[v];
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Vertices that do not move, all together and one by one, and the origin at one of them.
void rest(SceneShrinking<StepScene>& shrinking) {
  const std::size_t count = shrinking.best().x0.size();
  shrinking.change([](StepScene& scene) { scene.elements.rules = {}; });
  shrinking.change([](StepScene& scene) { scene.elements.separation = {}; });
  for (std::size_t v = 0; v < count; ++v) {
    shrinking.change([v](StepScene& scene) { scene.x1[v] = scene.x0[v]; });
    shrinking.change([v](StepScene& scene) { scene.x0[v] = scene.x1[v]; });
    shrinking.change([v](StepScene& scene) {
      const Vec3 origin = scene.x0[v];
      for (auto* const positions : {&scene.x0, &scene.x1}) {
        for (Vec3& at : *positions) at = {at.x - origin.x, at.y - origin.y, at.z - origin.z};
      }
    });
  }
}

}  // namespace

std::int64_t difficulty(const StepScene& scene) {
  std::int64_t sum = difficulty_of_elements(scene.elements);
  StepScene read = scene;
  for_each_step_number(read, [&](double& x) { sum += std::min(difficulty(x), kElementDifficulty / 1000); });
  for (std::size_t v = 0; v < scene.x0.size(); ++v) sum += is_still(scene, v) ? 0 : 100;
  return sum + (scene.elements.rules.groups.empty() ? 0 : kElementDifficulty);
}

StepScene shrink_steps(const StepScene& scene, const std::function<bool(const StepScene&)>& still_fails,
                       const std::function<bool()>& stop) {
  // A function that fails always would end with a mesh of nothing.
  const std::function<bool(const StepScene&)> fails_with_a_pair = [&](const StepScene& candidate) {
    return Mesh(candidate.elements).has_pairs() && still_fails(candidate);
  };
  SceneShrinking<StepScene> shrinking(scene, difficulty, fails_with_a_pair, stop);
  std::int64_t before = 0;
  do {
    before = shrinking.difficulty();
    shrinking.drop_elements(
        [](auto& of) -> auto& { return of.elements; },
        [](StepScene& of, MeshIndex vertex) {
          of.x0.erase(of.x0.begin() + vertex);
          of.x1.erase(of.x1.begin() + vertex);
          drop_vertex(of.elements, vertex);
        });
    rest(shrinking);
    shrinking.simplify_numbers([](StepScene& of, const auto& f) { for_each_step_number(of, f); });
  } while (shrinking.difficulty() < before && !shrinking.over());
  return shrinking.best();
}

}  // namespace touchstone::fuzz
