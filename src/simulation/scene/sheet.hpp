// Rectangular sheets of cloth, without a direction that their triangles prefer.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace touchstone::sim {

struct SheetShape {
  Vector3 corner = Vector3::Zero(), along = Vector3::UnitX(), across = Vector3::UnitY();  ///< m: two sides of a corner
  Index columns = 1;                                                                      ///< triangles along
};

/// Rows of particles along the sheet, one above the other. Every second row is shifted by half a column, and ends with
/// half a column on both sides, so that the triangles are nearly equilateral and the sheet has both mirror symmetries
/// in its plane.
struct SheetMesh {
  std::vector<std::vector<Index>> rows;  ///< particles
  std::vector<Face> faces;
};

/// Adds the particles, without mass of their own. The number of rows of triangles is even.
SheetMesh add_sheet(Scene& scene, const SheetShape& shape);

/// The number of columns with which a sheet of these sides has about `triangles` triangles.
Index columns_for(double along, double across, Index triangles);

}  // namespace touchstone::sim
