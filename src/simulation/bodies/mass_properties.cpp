// Integrals of 1, x and x x^T over tetrahedra and segments (Mirtich, "Fast and accurate computation of polyhedral mass
// properties", 1996; the closed forms for a simplex are in Tonon, "Explicit exact formulas for the 3-D tetrahedron
// inertia tensor", 2005).
// SPDX-License-Identifier: MIT
#include "bodies/mass_properties.hpp"

#include <Eigen/Geometry>

namespace touchstone::sim {
namespace {

/// The integrals over a shape, about a point.
struct Moments {
  double volume = 0;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
};

/// Takes the integrals about a vertex, which gives the centre, and again about the centre: far from the origin, the
/// moments about it would be differences of large numbers.
template <class Integrate>
MassProperties properties(const Vector3& vertex, double density, Integrate integrate) {
  const Moments about_vertex = integrate(vertex);
  MassProperties result;
  result.mass = density * about_vertex.volume;
  result.centre = vertex;
  if (about_vertex.volume == 0) return result;
  result.centre += about_vertex.first / about_vertex.volume;
  const Moments about_centre = integrate(result.centre);
  const Vector3 rest = about_centre.first / about_centre.volume;  // rounding
  const Matrix3 second = density * (about_centre.second - about_centre.volume * rest * rest.transpose());
  result.inertia = second.trace() * Matrix3::Identity() - second;
  return result;
}

}  // namespace

MassProperties solid_properties(const std::vector<Vector3>& vertices,
                                const std::vector<std::array<std::uint32_t, 3>>& faces, double density) {
  return properties(vertices[faces[0][0]], density, [&](const Vector3& about) {
    Moments sum;
    for (const auto& face : faces) {
      const Vector3 a = vertices[face[0]] - about, b = vertices[face[1]] - about, c = vertices[face[2]] - about;
      const double six_volumes = a.dot(b.cross(c));
      const Vector3 all = a + b + c;
      sum.volume += six_volumes / 6;
      sum.first += six_volumes / 24 * all;
      sum.second +=
          six_volumes / 120 * (all * all.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
    return sum;
  });
}

MassProperties wire_properties(const std::vector<Vector3>& vertices,
                               const std::vector<std::array<std::uint32_t, 2>>& edges, double density) {
  return properties(vertices[edges[0][0]], density, [&](const Vector3& about) {
    Moments sum;
    for (const auto& edge : edges) {
      const Vector3 a = vertices[edge[0]] - about, b = vertices[edge[1]] - about;
      const double length = (b - a).norm();
      const Vector3 all = a + b;
      sum.volume += length;
      sum.first += length / 2 * all;
      sum.second += length / 6 * (all * all.transpose() + a * a.transpose() + b * b.transpose());
    }
    return sum;
  });
}

}  // namespace touchstone::sim
