// SPDX-License-Identifier: MIT
#include "cloth/cloth_scenes.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <map>

namespace touchstone::sim {

SheetScene sheet_scene(double along, double across, Index columns) {
  SheetScene sheet;
  sheet.scene.settings.gravity.setZero();
  sheet.mesh = add_sheet(sheet.scene, {Vector3::Zero(), {along, 0, 0}, {0, across, 0}, columns});
  Surface surface;
  surface.faces = sheet.mesh.faces;
  surface.stretch = 100;
  surface.areal_density = 0.2;
  surface.bend = 1e-3;
  sheet.scene.surfaces.push_back(surface);
  return sheet;
}

std::vector<char> border_of(const SheetScene& sheet) {
  std::map<Edge, int> faces_at;
  for (const Face& face : sheet.mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = face[k], b = face[(k + 1) % 3];
      ++faces_at[{std::min(a, b), std::max(a, b)}];
    }
  }
  std::vector<char> border(sheet.scene.particles.size(), 0);
  for (const auto& [edge, count] : faces_at) {
    if (count == 1) border[edge[0]] = border[edge[1]] = 1;
  }
  return border;
}

void make_irregular(SheetScene& sheet, double most, seeded::Rng& random) {
  const std::vector<char> border = border_of(sheet);
  for (std::size_t i = 0; i < border.size(); ++i) {
    if (!border[i])
      sheet.scene.particles[i].position += Vector3(most * random.symmetric(), most * random.symmetric(), 0);
  }
}

std::vector<double> principal_stretches(const Scene& scene, const VectorX& q) {
  std::vector<double> stretches;
  for (const Surface& surface : scene.surfaces) {
    for (const Face& face : surface.faces) {
      Eigen::Matrix<double, 3, 2> rest, now;
      for (Eigen::Index k = 0; k < 2; ++k) {
        const Index other = face[static_cast<std::size_t>(k + 1)];
        rest.col(k) = scene.particles[other].position - scene.particles[face[0]].position;
        now.col(k) = position(q, other) - position(q, face[0]);
      }
      // F = now R^-1 with the triangular factor R of the rest edges: an orthonormal basis of the triangle's plane.
      const Eigen::Matrix2d r =
          rest.householderQr().matrixQR().topRows<2>().triangularView<Eigen::Upper>().toDenseMatrix();
      const Eigen::Matrix<double, 3, 2> f = now * r.inverse();
      const auto both = Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>>(f).singularValues();
      stretches.insert(stretches.end(), {both[0], both[1]});
    }
  }
  return stretches;
}

double largest_stretch(const Scene& scene, const VectorX& q) {
  const std::vector<double> stretches = principal_stretches(scene, q);
  return *std::max_element(stretches.begin(), stretches.end());
}

}  // namespace touchstone::sim
