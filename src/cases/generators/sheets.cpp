// SPDX-License-Identifier: MIT
#include <cmath>

#include "generators/moving_mesh.hpp"
#include "generators/waves.hpp"

namespace touchstone::generators {
namespace {

class Sheets final : public MovingMesh {
 public:
  Sheets(seeded::Rng random, std::size_t edges)
      : rotation_(random_rotation(random)),
        crumple_({6, 0.2, 0.7, 0.6}, random),
        push_x_({4, 0.3, 0.8, 0.6}, random),
        push_y_({4, 0.3, 0.8, 0.6}, random),
        gaps_({4, 0.15, 0.5, 0.3}, random),
        slide_({2, 3, 5}, random) {
    const auto n = static_cast<std::size_t>(std::sqrt(static_cast<double>(edges) / 6));
    edge_length_ = 1 / static_cast<double>(n);
    for (int sheet = 0; sheet < 2; ++sheet) {
      const Rotation within = random_turn(random);  // so that the edges of one do not lie along the edges of the other
      for (std::size_t i = 0; i <= n; ++i) {
        for (std::size_t j = 0; j <= n; ++j) {
          const double x = static_cast<double>(i) + random.uniform(-0.2, 0.2);
          const double y = static_cast<double>(j) + random.uniform(-0.2, 0.2);
          rest_.push_back(within({edge_length_ * x - 0.5, edge_length_ * y - 0.5, 0}));
        }
      }
      mesh_.append(sheet_mesh(n), sheet == 0 ? "lower" : "upper");
    }
  }

  void set_corners(double time, std::vector<Vec3>& corners) const override {
    corners.clear();
    const double slid = 0.3 * slide_({}, time);
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const double side = i < rest_.size() / 2 ? -1 : 1;
      const Vec3 at{rest_[i].x + side * slid, rest_[i].y, 0};
      const double gap = edge_length_ * (0.15 + gaps_(at, 1.5 * time));
      corners.push_back(rotation_({at.x + 0.15 * push_x_(at, time), at.y + 0.15 * push_y_(at, time),
                                   0.3 * crumple_(at, time) + 0.5 * side * gap}));
    }
  }

 private:
  /// About the z axis.
  static Rotation random_turn(seeded::Rng& random) {
    const double turns = random.unit();
    const double c = cosine(turns), s = sine(turns);
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
  }

  Rotation rotation_;
  Waves crumple_, push_x_, push_y_, gaps_, slide_;
  std::vector<Vec3> rest_;
};

}  // namespace

std::unique_ptr<MovingMesh> make_sheets(std::uint64_t seed, std::size_t edges) {
  return std::make_unique<Sheets>(seeded::Rng(seed), edges);
}

}  // namespace touchstone::generators
