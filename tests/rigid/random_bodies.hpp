// Bodies of all sorts in motion.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <touchstone/bodies.hpp>

#include "families/body_scenes.hpp"

namespace touchstone::tests {

using families::every_pair;
using families::some_motion;
using families::some_point;

inline Body body_of(const families::BodyShape& shape) { return Body(Mesh(shape.elements), Positions(shape.points)); }
inline Body box(double x, double y, double z) { return body_of(families::box_shape(x, y, z)); }
inline Body random_body(seeded::Rng& random, bool coarse, bool radii) {
  return body_of(families::random_shape(random, coarse, radii));
}

struct RandomBodies {
  Bodies bodies;
  std::vector<RigidMotion> motions;
};

inline RandomBodies random_bodies(seeded::Rng& random) {
  const families::BodyScene scene = families::random_body_scene(random);
  return {scene.bodies(), scene.motions};
}

}  // namespace touchstone::tests
