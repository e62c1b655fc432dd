// SPDX-License-Identifier: MIT
#include "scene/body_shapes.hpp"

namespace touchstone::sim {

Body box(const Vector3& size, double density) {
  Body body;
  for (int i = 0; i < 8; ++i) {
    body.vertices.emplace_back((i & 1 ? 0.5 : -0.5) * size.x(), (i & 2 ? 0.5 : -0.5) * size.y(),
                               (i & 4 ? 0.5 : -0.5) * size.z());
  }
  body.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  body.density = density;
  return body;
}

Body fixed(Body body, const Vector3& position) {
  body.motion = BodyMotion::fixed;
  body.density = 0;
  body.pose.p = position;
  return body;
}

}  // namespace touchstone::sim
