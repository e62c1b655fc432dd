// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include "generators/moving_mesh.hpp"
#include "generators/waves.hpp"

namespace touchstone::generators {
namespace {

/// Fixed at one end, and whipped sideways more and more towards the other.
struct Cable {
  Vec3 anchor;
  Vec3 along;
  Waves sideways;
  Waves up;
};

class Cables final : public MovingMesh {
 public:
  Cables(seeded::Rng random, std::size_t edges) : rotation_(random_rotation(random)), swell_({4, 0.5, 1}, random) {
    // As many crossings as edges: neither the cables' own joints nor empty space take most of the pairs.
    const auto in_bundle = static_cast<std::size_t>(0.7 * std::sqrt(static_cast<double>(edges)));
    per_cable_ = edges / (2 * in_bundle);
    edge_length_ = 1 / static_cast<double>(per_cable_);
    for (std::size_t i = 0; i < 2 * in_bundle; ++i) {
      const double position = (static_cast<double>(i / 2) + random.unit()) / static_cast<double>(in_bundle) - 0.5;
      const bool across = i % 2 == 1;
      cables_.push_back({across ? Vec3{position, -0.5, 0} : Vec3{-0.5, position, 0},
                         across ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, Waves({3, 0.3, 0.9}, random),
                         Waves({3, 0.2, 0.6}, random)});
      mesh_.append(chain_mesh(per_cable_), "cable-" + std::to_string(i + 1));
    }
  }

  void set_corners(double time, std::vector<Vec3>& corners) const override {
    corners.clear();
    for (const Cable& cable : cables_) {
      const Vec3 side{cable.along.y, cable.along.x, 0};
      for (std::size_t i = 0; i <= per_cable_; ++i) {
        const double s = edge_length_ * static_cast<double>(i);
        const Vec3 at = cable.anchor + s * cable.along;
        const double height = 0.3 * swell_(at, time) + 1.5 * edge_length_ * cable.up(at, time);
        corners.push_back(rotation_(at + 0.3 * s * cable.sideways(at, time) * side + Vec3{0, 0, height}));
      }
    }
  }

 private:
  Rotation rotation_;
  Waves swell_;  ///< of both bundles, so that they stay close to each other
  std::size_t per_cable_;
  std::vector<Cable> cables_;
};

}  // namespace

std::unique_ptr<MovingMesh> make_cables(std::uint64_t seed, std::size_t edges) {
  return std::make_unique<Cables>(seeded::Rng(seed), edges);
}

}  // namespace touchstone::generators
