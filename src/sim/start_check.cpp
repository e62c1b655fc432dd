// SPDX-License-Identifier: MIT
#include "sim/start_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/mesh.hpp>

#include "broad_phase/box.hpp"
#include "sim/enclosed.hpp"

namespace touchstone::sim {
namespace {

/// A vertex of the mesh: a particle, or a vertex of a body.
struct Vertex {
  OfBody of;
  bool can_move = false;
};

/// A scene may have a face twice, for collisions and for forces; a mesh may not.
void add_once_each(std::vector<Face> faces, Index first, std::vector<Face>& all) {
  for (Face& face : faces) std::sort(face.begin(), face.end());
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  for (const Face& face : faces) all.push_back({first + face[0], first + face[1], first + face[2]});
}

/// The first vertex of each connected part of the elements.
std::vector<MeshIndex> parts_of(const MeshElements& elements) {
  std::vector<MeshIndex> leader(elements.vertex_count);
  std::iota(leader.begin(), leader.end(), MeshIndex{0});
  const auto find = [&](MeshIndex v) {
    while (leader[v] != v) v = leader[v] = leader[leader[v]];
    return v;
  };
  std::vector<char> collides(elements.vertex_count, 0);
  for (const auto& [a, b] : elements.edges) {
    collides[a] = collides[b] = 1;
    const MeshIndex first = find(a), second = find(b);
    leader[std::max(first, second)] = std::min(first, second);
  }
  for (const MeshIndex point : *elements.points) collides[point] = 1;
  std::vector<MeshIndex> parts;
  for (MeshIndex v = 0; v < leader.size(); ++v) {
    if (collides[v] != 0 && leader[v] == v) parts.push_back(v);
  }
  return parts;
}

/// The vertices of bodies come after the particles.
class StartMesh {
 public:
  explicit StartMesh(const StartPlaces& places) {
    const Colliders& colliders = *places.colliders;
    MeshElements elements;
    elements.edges = colliders.edges();
    add_once_each(colliders.faces(), 0, elements.faces);
    elements.points = colliders.points();
    for (Index p = 0; p < places.particles; ++p) {
      vertices_.push_back({{kParticles, p}, colliders.can_move(p)});
      x_.push_back(corner_of(*places.q, p));
    }
    if (places.bodies != nullptr) add_bodies(places, elements);
    elements.vertex_count = vertices_.size();
    if (places.bodies != nullptr) parts_ = parts_of(elements);
    mesh_ = Mesh(std::move(elements));
  }

  std::vector<Intersection> intersections(int threads) const {
    MeshOptions options;
    options.threads = threads;
    return touchstone::intersections(mesh_, x_, options);
  }

  bool can_move(const Intersection& found) const {
    const auto any = [&](MeshElement element, MeshIndex number) {
      const auto corners = corners_of(element, number);
      return std::any_of(corners.begin(), corners.end(), [&](MeshIndex v) { return vertices_[v].can_move; });
    };
    return any(found.first_element, found.first) || any(found.second_element, found.second);
  }

  /// Connected parts that are wholly inside a closed body, where nothing intersects.
  void find_enclosed(const StartPlaces& places, StartFindings& findings) const {
    for (Index b = 0; places.bodies != nullptr && b < places.bodies->surfaces().size(); ++b) {
      const std::vector<Face>& faces = places.bodies->surface(b).faces;
      if (!is_closed(faces)) continue;
      const Vec3* const corners = &x_[first_of_[b]];
      broad_phase::Box box = broad_phase::empty_box();
      for (const Face& face : faces) {
        for (const Index corner : face) broad_phase::extend(box, corners[corner]);
      }
      for (const MeshIndex vertex : parts_) {
        const OfBody& part = vertices_[vertex].of;
        broad_phase::Box place = broad_phase::empty_box();
        broad_phase::extend(place, x_[vertex]);
        if (part.body == b || !broad_phase::overlap(box, place)) continue;
        if (!is_enclosed(faces, corners, x_[vertex])) continue;
        if (findings.enclosed++ > 0) continue;
        findings.enclosed_first = part.body == kParticles ? fmt::format("particle {} in body {}", part.number, b)
                                                          : fmt::format("body {} in body {}", part.body, b);
      }
    }
  }

  /// "pierce each other: edge 0-1 and face 2-3-4 of body 1 at (0, 0, 0)"
  std::string describe(const Intersection& found) const {
    const auto corners = corners_of(found.first_element, found.first);
    Vector3 point = Vector3::Zero();
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const Vec3& x = x_[corners[c]];
      point += found.weights_first[c] * Vector3(x.x, x.y, x.z);
    }
    return fmt::format("{}: {} and {} at ({:.6g}, {:.6g}, {:.6g})", how(found.sort),
                       name(found.first_element, found.first), name(found.second_element, found.second), point.x(),
                       point.y(), point.z());
  }

 private:
  void add_bodies(const StartPlaces& places, MeshElements& elements) {
    std::vector<MeshIndex>& groups = elements.rules.groups;
    groups.assign(vertices_.size(), 0);
    for (Index b = 0; b < places.bodies->surfaces().size(); ++b) {
      const ElementSet& surface = places.bodies->surface(b);
      const auto first = static_cast<Index>(vertices_.size());
      first_of_.push_back(first);
      for (Index v = 0; v < surface.around.size(); ++v) {
        vertices_.push_back({{b, v}, places.bodies->can_move(b)});
        const Vector3 x = places.bodies->at({b, v}, *places.states, *places.q);
        x_.push_back({x.x(), x.y(), x.z()});
        groups.push_back(b + 1);
      }
      elements.rules.group_pairs.push_back({b + 1, b + 1});  // a body does not move against itself
      for (const Edge& edge : surface.edges) elements.edges.push_back({first + edge[0], first + edge[1]});
      add_once_each(surface.faces, first, elements.faces);
    }
  }

  static const char* how(IntersectionSort sort) noexcept {
    if (sort == IntersectionSort::folds) return "fold onto each other";
    return sort == IntersectionSort::pierces ? "pierce each other" : "touch";
  }

  std::vector<MeshIndex> corners_of(MeshElement element, MeshIndex number) const {
    switch (element) {
      case MeshElement::vertex: break;
      case MeshElement::edge: return {mesh_.edges()[number].begin(), mesh_.edges()[number].end()};
      case MeshElement::face: return {mesh_.faces()[number].begin(), mesh_.faces()[number].end()};
    }
    return {number};
  }

  std::string name(MeshElement element, MeshIndex number) const {
    const auto corners = corners_of(element, number);
    const Index body = vertices_[corners.front()].of.body;
    std::string text(element == MeshElement::vertex && body == kParticles ? "particle" : mesh_element_name(element));
    const char* separator = " ";
    for (const MeshIndex corner : corners) {
      text += fmt::format("{}{}", std::exchange(separator, "-"), vertices_[corner].of.number);
    }
    return body == kParticles ? text : fmt::format("{} of body {}", text, body);
  }

  std::vector<Vertex> vertices_;
  std::vector<Vec3> x_;
  std::vector<MeshIndex> parts_;  // in a scene with bodies
  std::vector<Index> first_of_;   // the first vertex of each body
  Mesh mesh_;
};

}  // namespace

StartFindings check_no_intersection(const StartPlaces& places, std::string_view what, int threads) {
  const StartMesh mesh(places);
  StartFindings findings;
  std::size_t moving = 0;
  std::string first;
  for (const Intersection& found : mesh.intersections(threads)) {
    if (found.sort == IntersectionSort::inside) continue;  // it may be right, and is counted below
    if (!mesh.can_move(found)) {
      ++findings.held;
    } else if (moving++ == 0) {
      first = mesh.describe(found);
    }
  }
  if (moving == 0) {
    if (findings.held == 0) mesh.find_enclosed(places, findings);  // where surfaces meet, a part is neither in nor out
    return findings;
  }
  throw Error(fmt::format("{} begins with elements that {}{}; positions at which all elements are apart would be right",
                          what, first,
                          moving > 1 ? fmt::format(", and {} more pair{}", moving - 1, moving > 2 ? "s" : "") : ""));
}

}  // namespace touchstone::sim
