// SPDX-License-Identifier: MIT
#include "scene/sheet.hpp"

#include <algorithm>
#include <cmath>

#include "scene/parts.hpp"

namespace touchstone::sim {
namespace {

/// Of an equilateral triangle, over its side.
const double kHeight = std::sqrt(0.75);

}  // namespace

SheetMesh add_sheet(Scene& scene, const SheetShape& shape) {
  const Index c = shape.columns;
  const double row_pairs = shape.across.norm() / shape.along.norm() * c / kHeight / 2;
  const Index rows = 2 * static_cast<Index>(std::max(1.0, std::round(row_pairs)));
  SheetMesh mesh;
  for (Index r = 0; r <= rows; ++r) {
    const Vector3 start = shape.corner + shape.across * (static_cast<double>(r) / rows);
    std::vector<Index> row;
    const bool shifted = r % 2 == 1;
    for (Index i = 0; i <= (shifted ? c + 1 : c); ++i) {
      const double column = shifted ? std::clamp(i - 0.5, 0.0, static_cast<double>(c)) : i;
      row.push_back(add_particle(scene, start + shape.along * (column / c), 0));
    }
    mesh.rows.push_back(std::move(row));
  }
  for (Index r = 0; r < rows; ++r) {
    const bool shifted = r % 2 == 1;
    const auto& whole = mesh.rows[shifted ? r + 1 : r];
    const auto& other = mesh.rows[shifted ? r : r + 1];
    // All faces turn the same way, from `along` to `across`.
    const auto add = [&](Index p, Index q, Index s) { mesh.faces.push_back(shifted ? Face{p, s, q} : Face{p, q, s}); };
    for (Index i = 0; i <= c; ++i) {
      add(whole[i], other[i + 1], other[i]);
      if (i < c) add(whole[i], whole[i + 1], other[i + 1]);
    }
  }
  return mesh;
}

Index columns_for(double along, double across, Index triangles) {
  // Two triangles for each column and row; rows = across / along * columns / kHeight.
  return static_cast<Index>(std::max(1.0, std::round(std::sqrt(0.5 * triangles * along / across * kHeight))));
}

}  // namespace touchstone::sim
