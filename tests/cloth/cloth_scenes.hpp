// Sheets of cloth that several of these tests share.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/sheet.hpp"
#include "seeded/rng.hpp"
#include "sim/sim_scenes.hpp"

namespace touchstone::sim {

/// A sheet with these sides at rest in the plane z = 0, and with no gravity.
struct SheetScene {
  Scene scene;
  SheetMesh mesh;

  Surface& surface() { return scene.surfaces.front(); }
};
SheetScene sheet_scene(double along, double across, Index columns);

/// Moves each particle that is not on the sheet's border by up to `most` in its plane: a mesh without any regularity.
void make_irregular(SheetScene& sheet, double most, seeded::Rng& random);

/// Whether the particle is a corner of an edge that belongs to one face only.
std::vector<char> border_of(const SheetScene& sheet);

/// The principal stretches of the surfaces' triangles, two of each: an independent measure, by singular values.
std::vector<double> principal_stretches(const Scene& scene, const VectorX& q);
double largest_stretch(const Scene& scene, const VectorX& q);

}  // namespace touchstone::sim
