// SPDX-License-Identifier: MIT
#include "shells/surface_elements.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <tuple>

namespace touchstone::sim {
namespace {

// Fraction of the limit of strain above which its energy stiffens the sheet.
constexpr double kLimitBegins = 0.75;

double area_of(const Face& face, const std::vector<Vector3>& placed) {
  return 0.5 * (placed[face[1]] - placed[face[0]]).cross(placed[face[2]] - placed[face[0]]).norm();
}

void set_limit(const Surface& surface, double area, Membrane& membrane) {
  if (surface.strain_limit == 0) return;
  const double most = 1 + surface.strain_limit, begin = 1 + kLimitBegins * surface.strain_limit;
  membrane.limit = most * most;
  membrane.limit_width = membrane.limit - begin * begin;
  // With this scale the force of the limit, halfway from where it begins, is about twice that of the membrane.
  membrane.limit_stiffness = surface.stretch * area * membrane.limit_width * surface.strain_limit;
}

}  // namespace

void append_elements(const Surface& surface, const std::vector<Vector3>& placed, std::vector<double>& particle_mass,
                     SurfaceElements& elements) {
  struct Side {
    Edge edge;  // sorted
    Index face = 0, corner = 0;
  };
  std::vector<Side> sides;
  for (Index f = 0; f < surface.faces.size(); ++f) {
    const Face& face = surface.faces[f];
    const double area = area_of(face, placed);
    Membrane membrane = membrane_at_rest(face, {placed[face[0]], placed[face[1]], placed[face[2]]});
    const double shear = area * surface.stretch / (2 * (1 + surface.poisson));
    membrane.stiffness = {area * surface.stretch / (2 * (1 - surface.poisson)), shear, shear};
    membrane.damping = surface.damping;
    set_limit(surface, area, membrane);
    elements.membranes.push_back(membrane);
    for (Index k = 0; k < 3; ++k) {
      particle_mass[face[k]] += surface.areal_density * area / 3;
      const Index a = face[(k + 1) % 3], b = face[(k + 2) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, f, k});
    }
  }
  if (surface.bend == 0) return;
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.edge, a.face, a.corner) < std::tie(b.edge, b.face, b.corner);
  });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].edge != sides[i + 1].edge) continue;
    const Face &one = surface.faces[sides[i].face], &two = surface.faces[sides[i + 1].face];
    Hinge hinge;
    hinge.p = {one[(sides[i].corner + 1) % 3], one[(sides[i].corner + 2) % 3], one[sides[i].corner],
               two[sides[i + 1].corner]};
    // A sheet of equilateral triangles, bent to a curvature k about any axis, has on average
    // (bend^2 |e|^2 / (A_1 + A_2)) / 2 summed over its hinges = area k^2 / 2. So the factor is the sheet's own
    // stiffness, D = E h^3 / (12 (1 - poisson^2)). The derivation is in docs/simulation.md#cloth.
    const double length = (placed[hinge.p[1]] - placed[hinge.p[0]]).norm();
    hinge.stiffness = surface.bend * length * length / (area_of(one, placed) + area_of(two, placed));
    hinge.damping = surface.damping;
    if (surface.rest_is_bent) {
      hinge.rest = HingeStrain(placed[hinge.p[0]], placed[hinge.p[1]], placed[hinge.p[2]], placed[hinge.p[3]]).bend();
    }
    elements.hinges.push_back(hinge);
  }
}

}  // namespace touchstone::sim
