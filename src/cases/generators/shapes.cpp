// SPDX-License-Identifier: MIT
#include "generators/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace touchstone::generators {
namespace {

std::vector<std::array<Index, 2>> edges_of(const std::vector<std::array<Index, 3>>& faces) {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i], b = face[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// The points of the octahedron |x| + |y| + |z| = n with integer coordinates.
class OctahedronCorners {
 public:
  explicit OctahedronCorners(int n) : n_(n) {}

  /// The number of the point s (a, b, n - a - b), each coordinate times its sign.
  Index number(const std::array<int, 3>& sign, int a, int b) {
    const std::array<int, 3> point{sign[0] * a, sign[1] * b, sign[2] * (n_ - a - b)};
    const auto [found, is_new] = numbers_.try_emplace(point, static_cast<Index>(directions_.size()));
    if (is_new) {
      const double x = point[0], y = point[1], z = point[2];
      const double size = std::sqrt(x * x + y * y + z * z);
      directions_.push_back({x / size, y / size, z / size});
    }
    return found->second;
  }

  const std::vector<Vec3>& directions() const { return directions_; }

 private:
  int n_;
  std::map<std::array<int, 3>, Index> numbers_;
  std::vector<Vec3> directions_;
};

}  // namespace

void Mesh::append(const Mesh& other, const std::string& name) {
  objects.push_back({name, faces.size()});
  const auto shift = static_cast<Index>(corner_count);
  for (const auto& e : other.edges) edges.push_back({e[0] + shift, e[1] + shift});
  for (const auto& f : other.faces) faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  corner_count += other.corner_count;
}

Mesh sheet_mesh(std::size_t n) {
  Mesh mesh;
  mesh.corner_count = (n + 1) * (n + 1);
  const auto number = [n](std::size_t i, std::size_t j) { return static_cast<Index>(i * (n + 1) + j); };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Index a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1), d = number(i, j + 1);
      if ((i + j) % 2 == 0) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
      } else {
        mesh.faces.push_back({a, b, d});
        mesh.faces.push_back({b, c, d});
      }
    }
  }
  mesh.edges = edges_of(mesh.faces);
  return mesh;
}

Mesh chain_mesh(std::size_t n) {
  Mesh mesh;
  mesh.corner_count = n + 1;
  for (std::size_t i = 0; i < n; ++i) mesh.edges.push_back({static_cast<Index>(i), static_cast<Index>(i + 1)});
  return mesh;
}

Mesh box_mesh() {
  Mesh mesh;
  mesh.corner_count = 8;
  // Of each side, four corners in order around it, seen from outside.
  static constexpr std::array<std::array<Index, 4>, 6> kSides{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& side : kSides) {
    mesh.faces.push_back({side[0], side[1], side[2]});
    mesh.faces.push_back({side[0], side[2], side[3]});
  }
  mesh.edges = edges_of(mesh.faces);
  return mesh;
}

Sphere sphere_mesh(std::size_t n) {
  Sphere sphere;
  const int count = static_cast<int>(n);
  OctahedronCorners corners(count);
  for (int octant = 0; octant < 8; ++octant) {
    const std::array<int, 3> sign{octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1};
    for (int a = 0; a < count; ++a) {
      for (int b = 0; a + b < count; ++b) {
        const Index right = corners.number(sign, a + 1, b), up = corners.number(sign, a, b + 1);
        sphere.mesh.faces.push_back({corners.number(sign, a, b), right, up});
        if (a + b + 1 < count) sphere.mesh.faces.push_back({right, corners.number(sign, a + 1, b + 1), up});
      }
    }
  }
  sphere.directions = corners.directions();
  sphere.mesh.corner_count = sphere.directions.size();
  sphere.mesh.edges = edges_of(sphere.mesh.faces);
  return sphere;
}

}  // namespace touchstone::generators
