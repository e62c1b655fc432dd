// Bullet, in single precision, as bullet.pc has it.
// SPDX-License-Identifier: MIT
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <btBulletCollisionCommon.h>

#include "engine.hpp"

namespace {

using engine::Answer;
using engine::Query;

btVector3 vector(const engine::Point& p) { return {btScalar(p[0]), btScalar(p[1]), btScalar(p[2])}; }

/// The nearest hit of one triangle.
struct NearestHit : btTriangleRaycastCallback {
  using btTriangleRaycastCallback::btTriangleRaycastCallback;
  bool hit = false;
  btScalar reportHit(const btVector3&, btScalar fraction, int, int) override {
    hit = true;
    return fraction;
  }
};

/// A ray against a triangle, as btBvhTriangleMeshShape has its rays answered.
Answer ray(const Query& q) {
  NearestHit nearest(vector(q.start[0]), vector(q.end[0]));
  btVector3 triangle[3] = {vector(q.start[1]), vector(q.start[2]), vector(q.start[3])};
  nearest.processTriangle(triangle, 0, 0);
  return nearest.hit ? engine::contact_at(static_cast<double>(nearest.m_hitFraction)) : engine::no_contact();
}

btTransform moved(const btVector3& by) { return btTransform(btQuaternion::getIdentity(), by); }

/// The corners [from, to) as a hull with Bullet's default margin, about its first corner.
void add_corners(btConvexHullShape& hull, const Query& q, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) hull.addPoint(vector(q.start[i]) - vector(q.start[from]), i + 1 == to);
}

/// The cast of btCollisionWorld::convexSweepTest: btContinuousConvexCollision of two convex shapes that translate.
Answer cast(const Query& q) {
  btConvexHullShape a, b;
  add_corners(a, q, 0, q.first());
  add_corners(b, q, q.first(), q.start.size());
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btContinuousConvexCollision caster(&a, &b, &simplex, &depth);
  btConvexCast::CastResult result;
  result.m_fraction = 1;
  const std::size_t second = q.first();
  const bool hit = caster.calcTimeOfImpact(moved(vector(q.start[0])), moved(vector(q.end[0])),
                                           moved(vector(q.start[second])), moved(vector(q.end[second])), result);
  return hit ? engine::contact_at(static_cast<double>(result.m_fraction)) : engine::no_contact();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string version =
      "engine Bullet " + std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100) + "\n";
  return engine::serve(argc, argv,
                       {{"ray",
                         version + "asks btTriangleRaycastCallback, the ray against a triangle of a mesh\n"
                                   "kinds vertex-face\n"
                                   "motion cast\n"
                                   "numbers float\n"
                                   "elements 0.001\n"
                                   "sizes 0.05 10\n"
                                   "tolerance-relative 1e-4\n"
                                   "note a ray that starts or ends in the triangle's plane hits nothing, by its code\n"
                                   "note by its code a triangle is wider by about 1e-4 of its size\n",
                         ray},
                        {"cast",
                         version + "asks btContinuousConvexCollision, which convexSweepTest uses, of convex hulls with "
                                   "the default margin 0.04\n"
                                   "kinds edge-edge vertex-face point-edge point-point\n"
                                   "motion translations\n"
                                   "numbers float\n"
                                   "elements 0.001\n"
                                   "sizes 0.05 10\n"
                                   "starts apart\n"
                                   "separation 0.08\n"
                                   "tolerance-length 1e-3\n"
                                   "tolerance-relative 1e-5\n"
                                   "note by its code it advances until the shapes are 0.001 apart, 64 times at most, "
                                   "and reports no contact of\n"
                                   "note shapes that overlap at the start and move apart\n",
                         cast}});
}
