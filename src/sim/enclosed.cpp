// SPDX-License-Identifier: MIT
#include "sim/enclosed.hpp"

#include <algorithm>
#include <utility>

namespace touchstone::sim {
namespace {

// A ray that meets a border of a face, or lies in a face, is of no use. Few directions meet any.
constexpr int kMostDirections = 32;

struct Box {
  Vec3 low, high;

  explicit Box(const std::vector<Vec3>& corners) : low(corners.front()), high(corners.front()) {
    for (const Vec3& x : corners) {
      low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
      high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
  }
  bool contains(const Vec3& x) const noexcept {
    return x.x >= low.x && x.x <= high.x && x.y >= low.y && x.y <= high.y && x.z >= low.z && x.z <= high.z;
  }
};

/// From a point in the box to beyond its right side, a little to the side. No two directions are alike.
Vec3 end_of_ray(const Box& box, const Vec3& from, int direction) {
  const double length = 2 * (box.high.x - box.low.x) + (box.high.y - box.low.y) + (box.high.z - box.low.z);
  const double turn = 1 + direction;
  return {from.x + length, from.y + length * 0.011 * turn / (1 + 0.13 * turn), from.z + length * 0.007 / turn};
}

/// The numbers of the places in `rays` whose ray meets a border, and of the others whether it leaves once more.
struct Counted {
  std::vector<char> odd, useless;
};

Counted count(const std::vector<std::array<MeshIndex, 3>>& faces, const std::vector<Vec3>& corners,
              const std::vector<std::pair<Vec3, Vec3>>& rays, int threads) {
  MeshElements elements;
  elements.faces = faces;
  std::vector<Vec3> x = corners;
  elements.rules.groups.assign(corners.size(), 0);
  elements.rules.group_pairs = {{0, 0}, {1, 1}};  // a ray meets faces alone
  for (const auto& [from, to] : rays) {
    const auto first = static_cast<MeshIndex>(x.size());
    elements.edges.push_back({first, first + 1});
    x.push_back(from);
    x.push_back(to);
    elements.rules.groups.insert(elements.rules.groups.end(), {1, 1});
  }
  elements.vertex_count = x.size();
  elements.points = std::vector<MeshIndex>();
  MeshOptions options;
  options.threads = threads;
  Counted counted{std::vector<char>(rays.size(), 0), std::vector<char>(rays.size(), 0)};
  for (const Intersection& found : intersections(Mesh(std::move(elements)), x, options)) {
    // The rays are the edges that are given, so their numbers come first.
    if (found.first_element != MeshElement::edge || found.first >= rays.size()) continue;
    if (found.second_element == MeshElement::face && found.pierces) {
      counted.odd[found.first] ^= 1;
    } else {
      counted.useless[found.first] = 1;
    }
  }
  return counted;
}

}  // namespace

bool is_closed(const std::vector<std::array<MeshIndex, 3>>& faces) {
  std::vector<std::array<MeshIndex, 2>> edges;
  edges.reserve(3 * faces.size());
  for (const auto& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back({std::min(face[k], face[(k + 1) % 3]), std::max(face[k], face[(k + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if ((next - edge) % 2 != 0) return false;
    edge = next;
  }
  return !faces.empty();
}

std::vector<char> enclosed(const std::vector<std::array<MeshIndex, 3>>& faces, const std::vector<Vec3>& corners,
                           const std::vector<Vec3>& points, int threads) {
  std::vector<char> inside(points.size(), 0);
  if (corners.empty()) return inside;
  const Box box(corners);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (box.contains(points[i])) open.push_back(i);
  }
  for (int direction = 0; direction < kMostDirections && !open.empty(); ++direction) {
    std::vector<std::pair<Vec3, Vec3>> rays;
    for (const std::size_t i : open) rays.emplace_back(points[i], end_of_ray(box, points[i], direction));
    const Counted counted = count(faces, corners, rays, threads);
    std::vector<std::size_t> again;
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (counted.useless[k] != 0) {
        again.push_back(open[k]);
      } else {
        inside[open[k]] = counted.odd[k];
      }
    }
    open = std::move(again);
  }
  return inside;
}

}  // namespace touchstone::sim
