// ODE, the Open Dynamics Engine: collision without a time, and rays.
// SPDX-License-Identifier: MIT
#include <ode/ode.h>

#include <cmath>

#include "engine.hpp"

namespace {

using engine::Answer;
using engine::Query;

constexpr double kRadius = 0.125;  // two of them are the separation

dReal real(double x) { return static_cast<dReal>(x); }

/// A capsule around the edge that starts with this corner, or a ball at the corner.
dGeomID shape(const Query& q, std::size_t corner, bool edge) {
  const engine::Point& a = q.start[corner];
  if (!edge) {
    const dGeomID ball = dCreateSphere(nullptr, real(kRadius));
    dGeomSetPosition(ball, real(a[0]), real(a[1]), real(a[2]));
    return ball;
  }
  const engine::Point& b = q.start[corner + 1];
  const double along[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const dGeomID capsule = dCreateCapsule(nullptr, real(kRadius), real(std::hypot(along[0], along[1], along[2])));
  dMatrix3 turn;
  dRFromZAxis(turn, real(along[0]), real(along[1]), real(along[2]));
  dGeomSetRotation(capsule, turn);
  dGeomSetPosition(capsule, real(a[0] + along[0] / 2), real(a[1] + along[1] / 2), real(a[2] + along[2] / 2));
  return capsule;
}

/// Whether two shapes that stand still touch.
Answer still(const Query& q) {
  const std::size_t second = q.first();
  const dGeomID a = shape(q, 0, q.kind == "edge-edge");
  const dGeomID b = shape(q, second, q.kind != "point-point");
  dContactGeom contact;
  const int contacts = dCollide(a, b, 1, &contact, sizeof contact);
  dGeomDestroy(a);
  dGeomDestroy(b);
  return contacts > 0 ? engine::contact_at(0) : engine::no_contact();
}

/// A ray against a mesh of one triangle.
Answer ray(const Query& q) {
  dReal corners[3 * 3];
  const dTriIndex indices[3] = {0, 1, 2};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) corners[3 * i + k] = real(q.start[1 + i][k]);
  }
  const engine::Point along = q.motion(0);
  const double length = std::hypot(along[0], along[1], along[2]);
  if (length == 0) return engine::failed();
  const dTriMeshDataID data = dGeomTriMeshDataCreate();
#ifdef dDOUBLE
  dGeomTriMeshDataBuildDouble(data, corners, 3 * sizeof(dReal), 3, indices, 3, 3 * sizeof(dTriIndex));
#else
  dGeomTriMeshDataBuildSingle(data, corners, 3 * sizeof(dReal), 3, indices, 3, 3 * sizeof(dTriIndex));
#endif
  const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
  const dGeomID line = dCreateRay(nullptr, real(length));
  dGeomRaySet(line, real(q.start[0][0]), real(q.start[0][1]), real(q.start[0][2]), real(along[0]), real(along[1]),
              real(along[2]));
  dGeomRaySetClosestHit(line, 1);
  dContactGeom contact;
  const int contacts = dCollide(line, mesh, 1, &contact, sizeof contact);
  dGeomDestroy(line);
  dGeomDestroy(mesh);
  dGeomTriMeshDataDestroy(data);
  return contacts > 0 ? engine::contact_at(static_cast<double>(contact.depth) / length) : engine::no_contact();
}

}  // namespace

int main(int argc, char** argv) {
  dInitODE2(0);
  const std::string version = "engine ODE " ENGINE_VERSION "\n";
  const std::string numbers = sizeof(dReal) == sizeof(double) ? "" : "numbers float\n";
  const int status = engine::serve(argc, argv,
                                   {{"ray",
                                     version + numbers +
                                         "asks dCollide of a ray and a triangle mesh of one triangle\n"
                                         "kinds vertex-face\n"
                                         "motion cast\n"
                                         "elements 0.001\n"
                                         "sizes 0.5 8\n"
                                         "tolerance-relative 1e-6\n"
                                         "note its meshes are of OPCODE, which computes in single precision\n",
                                     ray},
                                    {"still",
                                     version + numbers +
                                         "asks dCollide of balls and capsules of radius 0.125 that stand still\n"
                                         "kinds edge-edge point-edge point-point\n"
                                         "motion still\n"
                                         "elements 0.001\n"
                                         "sizes 0.5 8\n"
                                         "separation 0.25\n"
                                         "tolerance-relative 1e-12\n",
                                     still}});
  dCloseODE();
  return status;
}
