// Layers of cables, crosswise, that fall on one another and on the floor.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "scene/parts.hpp"
#include "scene/shipped_scenes.hpp"

namespace touchstone::sim {

Scene make_cable_drop(Index segments) {
  constexpr Index kPerCable = 20;
  constexpr double kSegment = 0.03, kBetween = 0.06, kLayer = 0.03;
  Scene scene;
  scene.settings.duration = 2;
  scene.settings.contact.restitution = 0.1;
  scene.settings.contact.friction = 0.4;
  scene.settings.contact.thickness = 1e-3;
  scene.settings.drag = 0.2;
  scene.settings.newton_tolerance = 1e-4;
  const Index cables = std::max(Index{2}, segments / kPerCable);
  // Bundles of crossed layers side by side: a layer is as wide as a cable is long, a bundle has ten layers.
  constexpr Index kInLayer = 10, kLayers = 10;
  const Index bundles = (cables + kInLayer * kLayers - 1) / (kInLayer * kLayers);
  const auto columns = static_cast<Index>(std::ceil(std::sqrt(static_cast<double>(bundles))));
  const double length = kPerCable * kSegment, pitch = 1.5 * length;
  for (Index i = 0; i < cables; ++i) {
    const Index bundle = i / (kInLayer * kLayers), layer = i / kInLayer % kLayers, in_row = i % kInLayer;
    const Vector3 corner((bundle % columns) * pitch, static_cast<double>(bundle / columns) * pitch,
                         0.05 + kLayer * layer);
    const Vector3 along = layer % 2 == 0 ? Vector3::UnitX() : Vector3::UnitY();
    const Vector3 across = layer % 2 == 0 ? Vector3::UnitY() : Vector3::UnitX();
    // Not two of them exactly alike.
    const double shift = 0.01 * std::sin(12.9898 * i), tilt = 0.01 * std::sin(78.233 * i);
    const Vector3 from = corner + across * (kBetween * (in_row + 0.25) + shift) + along * tilt;
    Cable cable = straight_cable(scene, from, from + along * length + Vector3(0, 0, 0.2 * tilt), kPerCable);
    set_material(cable, 1e7, 0.4, 0.003, 1200);
    cable.solid = true;
    cable.twist = 0;
    cable.damping = 2e-3;
    scene.cables.push_back(std::move(cable));
  }
  add_floor(scene, 2 * pitch * columns + 1);
  return scene;
}

}  // namespace touchstone::sim
