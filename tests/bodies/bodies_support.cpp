// SPDX-License-Identifier: MIT
#include "bodies_support.hpp"

#include <Eigen/Geometry>

#include <touchstone/curved.hpp>

#include "scene/body_shapes.hpp"

using namespace touchstone::sim;

namespace touchstone::tests {

Body box_at(const Vector3& size, const Vector3& at, double density) {
  Body body = box(size, density);
  body.pose.p = at;
  return body;
}

Scene empty_scene(double time_step) {
  Scene scene;
  scene.settings.time_step = time_step;
  scene.settings.gravity.setZero();
  scene.settings.contact.thickness = 2e-3;
  return scene;
}

Momentum momentum_of(const BodySystem& system, const BodyStates& states) {
  Momentum sum;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const RigidBody& body = system.bodies()[i];
    if (!body.is_free()) continue;
    sum.linear += body.mass * states[i].velocity;
    sum.angular += states[i].momentum + body.mass * states[i].pose.p.cross(states[i].velocity);
  }
  return sum;
}

Momentum momentum_of(const Simulation& simulation) {
  Momentum sum = momentum_of(simulation.bodies()->system(), simulation.bodies()->state().bodies);
  for (Index p = 0; p < simulation.scene().particles.size(); ++p) {
    const double m = simulation.system().mass[3 * p];
    const Vector3 v = position(simulation.state().v, p);
    sum.linear += m * v;
    sum.angular += m * position(simulation.state().q, p).cross(v);
  }
  return sum;
}

bool any_touch(const Colliders& colliders, const BodyStates& from, const BodyStates& to) {
  const VectorX none;
  const SceneMotion motion{&none, &none, &from, &to};
  const auto touch = [&](const Pair& pair) { return solve(colliders.query(pair, motion)).contact; };
  const auto &first = colliders.before(1), &all = colliders.before(colliders.group_count());
  for (Index i = first.edges; i < all.edges; ++i) {
    for (Index j = colliders.before(colliders.group_of(MeshElement::edge, i) + 1).edges; j < all.edges; ++j) {
      if (touch({Kind::edge_edge, i, j})) return true;
    }
  }
  for (Index v = first.vertices; v < all.vertices; ++v) {
    for (Index f = first.faces; f < all.faces; ++f) {
      if (colliders.group_of(v) == colliders.group_of(MeshElement::face, f)) continue;
      if (touch({Kind::vertex_face, v, f})) return true;
    }
  }
  return false;
}

}  // namespace touchstone::tests
