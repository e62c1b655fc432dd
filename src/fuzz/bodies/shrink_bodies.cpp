// SPDX-License-Identifier: MIT
#include "fuzz/bodies/shrink_bodies.hpp"

#include <algorithm>
#include <cstddef>

#include "fuzz/scenes/scene_shrinking.hpp"
#include "fuzz/shrinking/simplicity.hpp"

namespace touchstone::fuzz {
namespace {

using families::BodyScene;
using families::BodyShape;

template <class F>
void for_each_scene_number(BodyScene& scene, const F& f) {
  const auto of_point = [&](Vec3& p) { f(p.x), f(p.y), f(p.z); };
  for (BodyShape& shape : scene.shapes) {
    for (Vec3& point : shape.points) of_point(point);
    for (double& radius : shape.elements.radii) f(radius);
  }
  for (RigidMotion& motion : scene.motions) {
    for (auto* q : {&motion.q0, &motion.q1}) std::for_each(q->begin(), q->end(), f);
    of_point(motion.p0), of_point(motion.p1);
  }
  f(scene.separation.distance);
}

void drop_bodies(SceneShrinking<BodyScene>& shrinking) {
  shrinking.change([](BodyScene& scene) { scene.rules = {}; });
  for (std::size_t b = shrinking.best().shapes.size(); b-- > 0 && shrinking.best().shapes.size() > 2;) {
    shrinking.change([b](BodyScene& scene) {
      scene.shapes.erase(scene.shapes.begin() + static_cast<std::ptrdiff_t>(b));
      scene.motions.erase(scene.motions.begin() + static_cast<std::ptrdiff_t>(b));
    });
  }
}

/// Bodies that do not turn or move.
void rest(SceneShrinking<BodyScene>& shrinking) {
  for (std::size_t b = 0; b < shrinking.best().motions.size(); ++b) {
    const auto change = [&](const auto& move) { shrinking.change([&](BodyScene& scene) { move(scene.motions[b]); }); };
    change([](RigidMotion& motion) { motion = {}; });
    change([](RigidMotion& motion) { motion.q0 = motion.q1 = {1, 0, 0, 0}; });
    change([](RigidMotion& motion) { motion.q1 = motion.q0; });
    change([](RigidMotion& motion) { motion.q0 = motion.q1; });
    change([](RigidMotion& motion) { motion.p0 = motion.p1; });
    change([](RigidMotion& motion) { motion.p1 = motion.p0; });
  }
  shrinking.change([](BodyScene& scene) { scene.separation = {}; });
}

}  // namespace

std::int64_t difficulty(const BodyScene& scene) {
  std::int64_t sum = 0;
  BodyScene read = scene;
  for_each_scene_number(read, [&](double& x) { sum += std::min(difficulty(x), kElementDifficulty / 1000); });
  for (const BodyShape& shape : scene.shapes) sum += difficulty_of_elements(shape.elements);
  for (const RigidMotion& motion : scene.motions) sum += motion.q0 == motion.q1 ? 0 : 100;
  return sum + (scene.rules.body_pairs.empty() ? 0 : kElementDifficulty);
}

BodyScene shrink_bodies(const BodyScene& scene, const std::function<bool(const BodyScene&)>& still_fails,
                        const std::function<bool()>& stop) {
  // A function that fails always would end with bodies of nothing.
  const std::function<bool(const BodyScene&)> fails_with_a_pair = [&](const BodyScene& candidate) {
    return !families::every_pair(candidate.bodies()).empty() && still_fails(candidate);
  };
  SceneShrinking<BodyScene> shrinking(scene, difficulty, fails_with_a_pair, stop);
  std::int64_t before = 0;
  do {
    before = shrinking.difficulty();
    drop_bodies(shrinking);
    for (std::size_t b = 0; b < shrinking.best().shapes.size(); ++b) {
      shrinking.drop_elements(
          [b](auto& of) -> auto& { return of.shapes[b].elements; },
          [b](BodyScene& of, MeshIndex vertex) {
            BodyShape& shape = of.shapes[b];
            shape.points.erase(shape.points.begin() + vertex);
            drop_vertex(shape.elements, vertex);
          });
    }
    rest(shrinking);
    shrinking.simplify_numbers([](BodyScene& of, const auto& f) { for_each_scene_number(of, f); });
  } while (shrinking.difficulty() < before && !shrinking.over());
  return shrinking.best();
}

}  // namespace touchstone::fuzz
