// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "generators/moving_mesh.hpp"
#include "generators/waves.hpp"

namespace touchstone::generators {
namespace {

constexpr double kRadius = 0.5;     // of the sphere at rest
constexpr double kHalfSide = 1;     // of the cloth
constexpr double kLiesUpTo = 0.22;  // turns from the top of the sphere to where the cloth leaves it and hangs
constexpr double kRadiansPerTurn = 6.283185307179586;

class Cloth final : public MovingMesh {
 public:
  Cloth(seeded::Rng random, std::size_t edges)
      : rotation_(random_rotation(random)),
        bulges_({4, 0.5, 1.5}, random),
        gaps_({4, 0.2, 0.6}, random),
        folds_({5, 0.25, 0.6, 0.3}, random),
        slide_x_({2, 1, 2}, random),
        slide_y_({2, 1, 2}, random) {
    // A quarter of the edges are the sphere's.
    const auto n = static_cast<std::size_t>(std::sqrt(static_cast<double>(edges) / 4));
    const auto cuts = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(edges) / 48)));
    edge_length_ = 2 * kHalfSide / static_cast<double>(n);
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j <= n; ++j) {
        // The grid is not perfect: each corner is moved by up to a fifth of an edge.
        const double x = static_cast<double>(i) + random.uniform(-0.2, 0.2);
        const double y = static_cast<double>(j) + random.uniform(-0.2, 0.2);
        rest_.push_back({edge_length_ * x - kHalfSide, edge_length_ * y - kHalfSide, 0});
      }
    }
    Sphere sphere = sphere_mesh(cuts);
    sphere_ = std::move(sphere.directions);
    mesh_.append(sheet_mesh(n), "cloth");
    mesh_.append(sphere.mesh, "sphere");
  }

  void set_corners(double time, std::vector<Vec3>& corners) const override {
    corners.clear();
    const double c = cosine(0.1 * time), s = sine(0.1 * time);
    for (const Vec3& at : rest_) corners.push_back(rotation_(cloth_corner(at, time)));
    for (const Vec3& d : sphere_) {
      const Vec3 turned{c * d.x - s * d.y, s * d.x + c * d.y, d.z};
      corners.push_back(rotation_(radius(turned, time) * turned));
    }
  }

 private:
  double radius(const Vec3& direction, double time) const { return kRadius * (1 + 0.1 * bulges_(direction, time)); }

  Vec3 cloth_corner(const Vec3& rest, double time) const {
    const Vec3 at{rest.x + 0.15 * slide_x_(rest, time), rest.y + 0.15 * slide_y_(rest, time), 0};
    const double far = length(at);  // from the middle, along the cloth
    const double turns = std::min(far / (kRadius * kRadiansPerTurn), kLiesUpTo);
    const double hangs = far - turns * kRadius * kRadiansPerTurn;
    // Polar coordinates around the sphere's centre: far * outward is the direction in the plane of x and y.
    const Vec3 outward = far > 0 ? (1 / far) * at : Vec3{1, 0, 0};
    const double sn = sine(turns), cs = cosine(turns);
    const Vec3 normal{sn * outward.x, sn * outward.y, cs};
    const Vec3 down{cs * outward.x, cs * outward.y, -sn};
    const double gap = edge_length_ * (0.1 + gaps_(at, 2 * time)) + 0.5 * std::min(hangs, 0.5) * folds_(at, time);
    return (radius(normal, time) + gap) * normal + hangs * down;
  }

  Rotation rotation_;
  Waves bulges_, gaps_, folds_, slide_x_, slide_y_;
  std::vector<Vec3> rest_, sphere_;
};

}  // namespace

std::unique_ptr<MovingMesh> make_cloth(std::uint64_t seed, std::size_t edges) {
  return std::make_unique<Cloth>(seeded::Rng(seed), edges);
}

}  // namespace touchstone::generators
