// Scenes along the axes, as people build them by hand: boxes, bricks, a plane, a grid, a cloth that lies on a box. Faces
// and edges lie in common planes, exactly, and most coordinates have few bits.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "generators/moving_mesh.hpp"
#include "generators/waves.hpp"

namespace touchstone::generators {
namespace {

constexpr double kSteps = 64;  // of an edge's length: sliding things are at multiples of its 64th part

/// The greatest power of two <= x.
double power_of_two_below(double x) noexcept { return std::ldexp(1.0, std::ilogb(x)); }

double snapped(double x, double unit) noexcept { return unit * std::floor(x / unit + 0.5); }

/// About the distance that something has slid along its line: there and back by up to 1/8, at about one unit of length
/// a unit of time. Phases differ from item to item.
double slid(std::size_t item, double time) noexcept {
  return 0.125 * sine(1.25 * time + 0.375 * static_cast<double>(item));
}

/// Boxes in layers, each resting on the one below it.
class Boxes final : public MovingMesh {
 public:
  /// @param bricks  twice as long, each course shifted by half of one and at rest; otherwise cubes whose layers slide
  Boxes(std::size_t edges, bool bricks) : bricks_(bricks) {
    constexpr double kEdgesEach = 18;
    const double boxes = static_cast<double>(edges) / kEdgesEach;
    // A wall is one brick thick.
    columns_ =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(bricks ? std::sqrt(boxes) : std::cbrt(boxes))));
    rows_ = bricks ? 1 : columns_;
    const double in_layer = static_cast<double>(columns_ * rows_);
    layers_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(boxes / in_layer)));
    edge_length_ = power_of_two_below(1.0 / static_cast<double>(std::max(layers_, columns_ * (bricks ? 2 : 1))));
    for (std::size_t i = 0; i < layers_ * columns_ * rows_; ++i) {
      mesh_.append(box_mesh(), (bricks ? "brick-" : "box-") + std::to_string(i + 1));
    }
  }

  void set_corners(double time, std::vector<Vec3>& corners) const override {
    corners.clear();
    const double side = edge_length_, length = bricks_ ? 2 * side : side;
    for (std::size_t layer = 0; layer < layers_; ++layer) {
      const double shift = bricks_ ? (layer % 2 == 0 ? 0 : side) : snapped(slid(layer, time), side / kSteps);
      const double low = side * static_cast<double>(layer);
      for (std::size_t column = 0; column < columns_; ++column) {
        for (std::size_t row = 0; row < rows_; ++row) {
          const Vec3 corner{length * static_cast<double>(column) + shift, side * static_cast<double>(row), low};
          for (unsigned i = 0; i < 8; ++i) {
            corners.push_back({corner.x + ((i & 1U) != 0 ? length : 0), corner.y + ((i & 2U) != 0 ? side : 0),
                               corner.z + ((i & 4U) != 0 ? side : 0)});
          }
        }
      }
    }
  }

 private:
  bool bricks_;
  std::size_t columns_, rows_, layers_;
};

/// Two bundles of cables in the plane z = 0, which bend and slide within it.
class Plane final : public MovingMesh {
 public:
  Plane(seeded::Rng random, std::size_t edges) : bend_({4, 0.5, 1}, random) {
    const auto in_bundle = static_cast<std::size_t>(0.7 * std::sqrt(static_cast<double>(edges)));
    per_cable_ = edges / (2 * in_bundle);
    cables_ = 2 * in_bundle;
    edge_length_ = 1 / static_cast<double>(per_cable_);
    for (std::size_t i = 0; i < cables_; ++i) mesh_.append(chain_mesh(per_cable_), "cable-" + std::to_string(i + 1));
  }

  void set_corners(double time, std::vector<Vec3>& corners) const override {
    corners.clear();
    for (std::size_t c = 0; c < cables_; ++c) {
      const double across = (static_cast<double>(c / 2) + 0.5) / (0.5 * static_cast<double>(cables_)) - 0.5;
      for (std::size_t i = 0; i <= per_cable_; ++i) {
        const double along = edge_length_ * static_cast<double>(i) - 0.5;
        const Vec3 rest = c % 2 == 0 ? Vec3{along, across, 0} : Vec3{across, along, 0};
        const double aside = 0.2 * bend_(rest + Vec3{0, 0, static_cast<double>(c)}, 2 * time);
        corners.push_back(c % 2 == 0 ? Vec3{rest.x, rest.y + aside, 0} : Vec3{rest.x + aside, rest.y, 0});
      }
    }
  }

 private:
  Waves bend_;
  std::size_t per_cable_, cables_;
};

/// Two plates on one grid, in one plane: the second slides over the first.
class Grid final : public MovingMesh {
 public:
  explicit Grid(std::size_t edges) {
    n_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(edges) / 6));
    edge_length_ = power_of_two_below(1 / static_cast<double>(n_));
    mesh_.append(sheet_mesh(n_), "fixed");
    mesh_.append(sheet_mesh(n_), "sliding");
  }

  void set_corners(double time, std::vector<Vec3>& corners) const override {
    corners.clear();
    for (std::size_t plate = 0; plate < 2; ++plate) {
      const double unit = edge_length_ / kSteps;
      const double x = plate == 0 ? 0 : snapped(slid(0, time), unit), y = plate == 0 ? 0 : snapped(slid(2, time), unit);
      for (std::size_t i = 0; i <= n_; ++i) {
        for (std::size_t j = 0; j <= n_; ++j) {
          corners.push_back({edge_length_ * static_cast<double>(i) + x, edge_length_ * static_cast<double>(j) + y, 0});
        }
      }
    }
  }

 private:
  std::size_t n_ = 0;
};

/// A runner that lies on a box and hangs down on both sides, at rest. Its corners are anywhere in the box's planes.
class Lying final : public MovingMesh {
 public:
  Lying(seeded::Rng random, std::size_t edges) {
    n_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(edges) / 3));
    edge_length_ = 1.5 / static_cast<double>(n_);
    mesh_.append(sheet_mesh(n_), "cloth");
    mesh_.append(box_mesh(), "box");
    for (std::size_t i = 0; i <= n_; ++i) {
      for (std::size_t j = 0; j <= n_; ++j) {
        const double along = edge_length_ * (static_cast<double>(i) + random.uniform(-0.2, 0.2)) - 0.75;
        const double across =
            0.4 * (2 * (static_cast<double>(j) + random.uniform(-0.2, 0.2)) / static_cast<double>(n_) - 1);
        const double beyond = std::max(0.0, std::fabs(along) - 0.5);
        rest_.push_back({std::clamp(along, -0.5, 0.5), across, -beyond});
      }
    }
    for (unsigned i = 0; i < 8; ++i) {
      rest_.push_back({(i & 1U) != 0 ? 0.5 : -0.5, (i & 2U) != 0 ? 0.5 : -0.5, (i & 4U) != 0 ? 0.0 : -1.0});
    }
  }

  void set_corners(double /*time*/, std::vector<Vec3>& corners) const override { corners = rest_; }

 private:
  std::size_t n_ = 0;
  std::vector<Vec3> rest_;
};

/// Another scene, each of whose corners is placed anew.
class Placed final : public MovingMesh {
 public:
  Placed(std::unique_ptr<MovingMesh> scene, Placement placement, seeded::Rng random)
      : scene_(std::move(scene)), placement_(placement), rotation_(random_rotation(random)) {
    mesh_ = scene_->mesh();
    edge_length_ = scene_->edge_length();
  }

  void set_corners(double time, std::vector<Vec3>& corners) const override {
    scene_->set_corners(time, corners);
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = positioned(i, corners[i]);
  }

 private:
  Vec3 positioned(std::size_t corner, const Vec3& x) const {
    constexpr Vec3 kOffset{101.3, -77.7, 150.1};
    switch (placement_) {
      case Placement::as_built: return x;
      case Placement::turned: return rotation_(x);
      case Placement::turned_90: return turned_twice(x, 0x1.1a62633145c07p-54, 1);
      case Placement::turned_45: return turned_twice(x, 0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bccp-1);
      case Placement::float32: return rounded(x + kOffset);
      case Placement::moved: return rounded(x) + 10 * kOffset;
      case Placement::far_corners: return (corner % 17 == 0 ? 1000.0 : 1.0) * x;
    }
    return x;
  }

  /// About z, then about x, by the angle of this cosine and sine: that of the doubles nearest to pi/2 and pi/4.
  static Vec3 turned_twice(const Vec3& x, double cosine, double sine) {
    const Vec3 y{cosine * x.x - sine * x.y, sine * x.x + cosine * x.y, x.z};
    return {y.x, cosine * y.y - sine * y.z, sine * y.y + cosine * y.z};
  }
  static Vec3 rounded(const Vec3& x) {
    const auto nearest = [](double number) { return static_cast<double>(static_cast<float>(number)); };
    return {nearest(x.x), nearest(x.y), nearest(x.z)};
  }

  std::unique_ptr<MovingMesh> scene_;
  Placement placement_;
  Rotation rotation_;
};

}  // namespace

std::unique_ptr<MovingMesh> make_boxes(std::uint64_t /*seed*/, std::size_t edges) {
  return std::make_unique<Boxes>(edges, false);
}
std::unique_ptr<MovingMesh> make_bricks(std::uint64_t /*seed*/, std::size_t edges) {
  return std::make_unique<Boxes>(edges, true);
}
std::unique_ptr<MovingMesh> make_plane(std::uint64_t seed, std::size_t edges) {
  return std::make_unique<Plane>(seeded::Rng(seed), edges);
}
std::unique_ptr<MovingMesh> make_grid(std::uint64_t /*seed*/, std::size_t edges) {
  return std::make_unique<Grid>(edges);
}
std::unique_ptr<MovingMesh> make_lying(std::uint64_t seed, std::size_t edges) {
  return std::make_unique<Lying>(seeded::Rng(seed), edges);
}

std::unique_ptr<MovingMesh> placed(std::unique_ptr<MovingMesh> scene, Placement placement, std::uint64_t seed) {
  return std::make_unique<Placed>(std::move(scene), placement, seeded::Rng(seed));
}

}  // namespace touchstone::generators
