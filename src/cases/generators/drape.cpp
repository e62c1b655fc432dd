// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "generators/moving_mesh.hpp"
#include "generators/waves.hpp"

namespace touchstone::generators {
namespace {

constexpr double kSphereRadius = 0.5;  // of the sphere at rest
constexpr double kBreath = 0.04;       // the greatest change of the whole sphere's radius
constexpr double kBulgeHeight = 0.02;  // the greatest height of a bulge
constexpr double kGreatestRadius = kSphereRadius + kBreath + kBulgeHeight;
constexpr double kLeastWave = 2;  // the least length of a bulge's waves
constexpr double kBulgeSlope =
    0.063;  // >= kBulgeHeight 2 pi / kLeastWave: the sphere's radius changes so much in a radian
constexpr double kClothHalfSide = 1;  // of the cloth, in the plane z = 1
constexpr double kJitter = 0.1;       // of an edge: the grid is not perfect
constexpr double kLiesWithin = 0.6;   // the distance from the middle, in that plane, where the cloth leaves the sphere
constexpr double kDepth = 0.01;       // of an edge: a planted vertex is so far inside the sphere

/// The least distance of a vertex of the cloth from the sphere, along its ray from the centre, with which the two do
/// not meet.
///
/// Each vertex moves on a ray of its own from the centre: it is R d with a fixed direction d and R > 0 that changes in
/// time. The directions of the cloth are a triangulation of a square in the plane z = 1, and those of the sphere are
/// one of an octahedron, each seen from the centre. So every ray meets at most one point of the cloth and one of the
/// sphere, whatever the radii are, and neither meets itself. In a direction d = sum mu_i d_i inside of a triangle, the
/// surface is at the radius 1 / sum(mu_i / R_i): between min R_i / sum mu_i and max R_i / sum mu_i. Here
/// 1 <= sum mu_i <= 1 / cos h, for a triangle whose directions are within the angle h of each other.
///
/// Let r(d) be the radius of the sphere where it is not cut into triangles: it changes by at most L a radian. Let c and
/// s bound the angles within a triangle of the cloth and of the sphere, and let g be the gap of each vertex of the
/// cloth. In a direction d the cloth is at least at (r(d_i) + g) cos c for a corner d_i of its triangle, and the sphere
/// is at most at r(d_j) for a corner d_j of its own, where r(d_j) <= r(d_i) + L (c + s). With cos c >= 1 - c^2 / 2 they
/// do not meet if
///
///   g (1 - c^2 / 2) > L (c + s) + r c^2 / 2.
///
/// Between two frames each radius is interpolated linearly in time. Then r changes by at most L a radian still, and the
/// gap of a vertex is at least the lesser one of its two gaps. So the argument holds for each time of each step, for
/// steps of any length. Rounding is far less than what set_corners adds to the gap.
///
/// @param cloth, sphere  the angles c and s in radians; c < 1.4
double least_gap(double cloth, double sphere) {
  const double bend = 0.5 * cloth * cloth;
  return (kBulgeSlope * (cloth + sphere) + kGreatestRadius * bend) / (1 - bend);
}

class Drape final : public MovingMesh {
 public:
  Drape(seeded::Rng random, std::size_t edges)
      : rotation_(random_rotation(random)),
        breath_({2, 1, 2}, random),
        bulges_({4, kLeastWave, 4}, random),
        gaps_({4, 0.2, 0.6}, random),
        folds_({5, 0.3, 0.8}, random),
        sway_{Waves({2, 1, 2}, random), Waves({2, 1, 2}, random), Waves({2, 1, 2}, random)} {
    // Half of the edges are the sphere's.
    const auto n = static_cast<std::size_t>(std::sqrt(static_cast<double>(edges) / 6));
    const auto cuts = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(edges) / 24)));
    const double spacing = 2 * kClothHalfSide / static_cast<double>(n);
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j <= n; ++j) {
        const double x = static_cast<double>(i) + random.uniform(-kJitter, kJitter);
        const double y = static_cast<double>(j) + random.uniform(-kJitter, kJitter);
        const Vec3 in_plane{spacing * x - kClothHalfSide, spacing * y - kClothHalfSide, 1};
        rays_.push_back({(1 / length(in_plane)) * in_plane, in_plane});
        if (i > 0 && i < n && j > 0 && j < n) inner_.push_back(static_cast<Index>(rays_.size() - 1));
      }
    }
    first_tried_ = static_cast<std::size_t>(random.below(inner_.size()));
    edge_length_ = kSphereRadius * spacing;
    // The angle between two points of the plane z = 1, seen from the centre, is at most their distance. The diagonal of
    // a square is the longest edge. A face of the octahedron |x| + |y| + |z| = 1 is 1 / sqrt(3) away from the centre,
    // and an edge of one of its parts is sqrt(2) / cuts long; no two directions of one face are more than pi / 2 apart.
    const double cloth_angle = std::sqrt(2.0) * (1 + 2 * kJitter) * spacing;
    const double sphere_angle = std::min(1.58, std::sqrt(6.0) / static_cast<double>(cuts));
    gap_ = least_gap(cloth_angle, sphere_angle);
    Sphere sphere = sphere_mesh(cuts);
    sphere_ = std::move(sphere.directions);
    mesh_.append(sheet_mesh(n), "cloth");
    sphere_faces_ = sphere.mesh.faces;
    mesh_.append(sphere.mesh, "sphere");
  }

  void set_corners(double time, std::vector<Vec3>& corners) const override {
    corners.clear();
    const Vec3 centre = centre_at(time);
    for (const Ray& ray : rays_) {
      const double far = std::sqrt(ray.in_plane.x * ray.in_plane.x + ray.in_plane.y * ray.in_plane.y);
      const double hangs = std::max(0.0, far - kLiesWithin);
      const double gap = gap_ + edge_length_ * (0.2 + 0.15 * gaps_(ray.direction, 2 * time)) +
                         0.3 * hangs * (1 + 0.5 * folds_(ray.in_plane, time));
      corners.push_back(centre + rotation_((radius(ray.direction, time) + gap) * ray.direction));
    }
    for (const Vec3& d : sphere_) corners.push_back(centre + rotation_(radius(d, time) * d));
  }

  std::optional<Index> plant_crossing(double time, std::vector<Vec3>& corners) const override {
    // The vertex's ray passes a face of the sphere well inside, so that the vertex is the first to get there. In all
    // but the coarsest scenes, the part of the cloth that it pulls through the face meets no edge of the face.
    constexpr double kWellInside = 0.2;
    Crossing best;
    for (std::size_t i = 0; i < inner_.size() && best.least_weight < kWellInside; ++i) {
      const Index vertex = inner_[(first_tried_ + i) % inner_.size()];
      for (const auto& face : sphere_faces_) {
        const Crossing crossing = crossing_of(vertex, face);
        if (crossing.least_weight > best.least_weight) best = crossing;
      }
    }
    double inverse = 0;  // of the radius of the face there
    for (std::size_t k = 0; k < 3; ++k) inverse += best.multiples[k] / radius(sphere_[best.face[k]], time);
    const Vec3& d = rays_[best.vertex].direction;
    corners[best.vertex] = centre_at(time) + rotation_((1 / inverse - kDepth * edge_length_) * d);
    return best.vertex;
  }

 private:
  struct Ray {
    Vec3 direction;  ///< from the sphere's centre, of length 1 up to rounding
    Vec3 in_plane;   ///< its point in the plane z = 1
  };

  /// Where the ray of a vertex passes a face of the sphere.
  struct Crossing {
    Index vertex = 0;
    std::array<Index, 3> face{};
    std::array<double, 3> multiples{};  ///< of the directions of the face's corners; their sum is the ray's direction
    double least_weight = -1;           ///< the least of them, of a sum of 1
  };

  Crossing crossing_of(Index vertex, const std::array<Index, 3>& face) const {
    const Vec3 &a = sphere_[face[0]], &b = sphere_[face[1]], &c = sphere_[face[2]], &d = rays_[vertex].direction;
    Crossing crossing{vertex, face, {}, -1};
    const double whole = dot(a, cross(b, c));
    crossing.multiples = {dot(d, cross(b, c)) / whole, dot(a, cross(d, c)) / whole, dot(a, cross(b, d)) / whole};
    const auto& [x, y, z] = crossing.multiples;
    const double least = std::min({x, y, z});
    if (least > 0) crossing.least_weight = least / (x + y + z);
    return crossing;
  }

  double radius(const Vec3& direction, double time) const {
    return kSphereRadius + kBreath * breath_({}, time) + kBulgeHeight * bulges_(direction, time);
  }

  /// The whole scene sways. All vertices move alike, so nothing meets that would not meet otherwise.
  Vec3 centre_at(double time) const {
    return {0.1 * sway_[0]({}, time), 0.1 * sway_[1]({}, time), 0.1 * sway_[2]({}, time)};
  }

  Rotation rotation_;
  Waves breath_, bulges_, gaps_, folds_;
  std::array<Waves, 3> sway_;
  double gap_ = 0;  ///< least_gap
  std::vector<Ray> rays_;
  std::vector<Index> inner_;  ///< the vertices of the cloth that are not on its border
  std::size_t first_tried_ = 0;
  std::vector<Vec3> sphere_;
  std::vector<std::array<Index, 3>> sphere_faces_;  ///< by the numbers of the directions
};

}  // namespace

std::unique_ptr<MovingMesh> make_drape(std::uint64_t seed, std::size_t edges) {
  return std::make_unique<Drape>(seeded::Rng(seed), edges);
}

}  // namespace touchstone::generators
