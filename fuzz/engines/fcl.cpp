// FCL, the Flexible Collision Library.
// SPDX-License-Identifier: MIT
#include <fcl/config.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include <cmath>
#include <memory>

#include "engine.hpp"

namespace {

using engine::Answer;
using engine::Query;
using Vector = fcl::Vector3d;

Vector vector(const engine::Point& p) { return {p[0], p[1], p[2]}; }

/// The test of two moving primitives of meshes that deform, as fcl's mesh traversal calls it. @see intersect-inl.h
Answer linear(const Query& q) {
  using Intersect = fcl::detail::Intersect<double>;
  Vector s[4], e[4], where;
  for (std::size_t i = 0; i < 4; ++i) s[i] = vector(q.start[i]), e[i] = vector(q.end[i]);
  double time = 2;
  const bool contact = q.kind == "edge-edge"
                           ? Intersect::intersect_EE(s[0], s[1], s[2], s[3], e[0], e[1], e[2], e[3], &time, &where)
                           : Intersect::intersect_VF(s[1], s[2], s[3], s[0], e[1], e[2], e[3], e[0], &time, &where);
  return contact ? engine::contact_at(time) : engine::no_contact();
}

constexpr double kRadius = 0.125;  // two of them are the separation

/// A ball at a point, or a capsule around an edge, which FCL has along its z axis; and its poses.
struct Posed {
  std::shared_ptr<fcl::CollisionGeometryd> shape;
  fcl::Transform3d start = fcl::Transform3d::Identity(), end = fcl::Transform3d::Identity();

  Posed(const Query& q, std::size_t corner, bool edge) {
    const Vector from = vector(q.start[corner]);
    if (edge) {
      const Vector along = vector(q.start[corner + 1]) - from;
      shape = std::make_shared<fcl::Capsuled>(kRadius, along.norm());
      start.linear() = Eigen::Quaterniond::FromTwoVectors(Vector::UnitZ(), along).toRotationMatrix();
      start.translation() = from + along / 2;
    } else {
      shape = std::make_shared<fcl::Sphered>(kRadius);
      start.translation() = from;
    }
    end = start;
    end.translation() += vector(q.motion(corner));
  }
};

/// Conservative advancement of two shapes that translate, with the request's default tolerance and iterations.
Answer advance(const Query& q) {
  const bool edges = q.kind == "edge-edge";
  const Posed a(q, 0, edges), b(q, q.first(), edges);
  fcl::ContinuousCollisionRequestd request;
  request.ccd_motion_type = fcl::CCDM_TRANS;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResultd result;
  fcl::continuousCollide(a.shape.get(), a.start, a.end, b.shape.get(), b.start, b.end, request, result);
  return result.is_collide ? engine::contact_at(result.time_of_contact) : engine::no_contact();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string version = std::string("engine FCL ") + FCL_VERSION + "\n";
  return engine::serve(
      argc, argv,
      {{"linear",
        version +
            "asks detail::Intersect<double>::intersect_EE and intersect_VF, the continuous test of deforming meshes\n"
            "kinds edge-edge vertex-face\n"
            "motion straight\n"
            "elements 0.001\n"
            "sizes 0.5 8\n"
            "tolerance-length 1e-5\n"
            "tolerance-time 1e-7\n"
            "note its constants are absolute, epsilon 1e-5 and resolution of time 1e-7: it is asked about sizes near "
            "1\n"
            "note it answers no contact, by its code, where all coefficients of the cubic vanish\n",
        linear},
       {"advance",
        version +
            "asks continuousCollide of balls and capsules of radius 0.125, CCDM_TRANS, CCDC_CONSERVATIVE_ADVANCEMENT\n"
            "kinds edge-edge point-point\n"
            "motion translations\n"
            "elements 0.001\n"
            "sizes 0.5 8\n"
            "separation 0.25\n"
            "tolerance-length 1e-4\n"
            "tolerance-time 1e-4\n"
            "note the default request: toc_err 1e-4, at most 10 iterations\n",
        advance}});
}
