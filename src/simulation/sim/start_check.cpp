// SPDX-License-Identifier: MIT
#include "sim/start_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/mesh.hpp>

#include "mesh/inside_surfaces/inside.hpp"

namespace touchstone::sim {
namespace {

/// A vertex of the mesh: a particle, or a vertex of a body.
struct Vertex {
  OfBody of;
  bool can_move = false;
};

/// A scene may have a face twice, for collisions and for forces; a mesh may not.
void add_once_each(std::vector<Face> faces, Index first, std::vector<Face>& all) {
  const auto sorted = [](Face face) {  // of a face in both orientations, either is right
    std::sort(face.begin(), face.end());
    return face;
  };
  std::stable_sort(faces.begin(), faces.end(), [&](const Face& a, const Face& b) { return sorted(a) < sorted(b); });
  const auto same = [&](const Face& a, const Face& b) { return sorted(a) == sorted(b); };
  faces.erase(std::unique(faces.begin(), faces.end(), same), faces.end());
  for (const Face& face : faces) all.push_back({first + face[0], first + face[1], first + face[2]});
}

/// The vertices of bodies come after the particles.
class StartMesh {
 public:
  explicit StartMesh(const StartElements& start) {
    const Colliders& colliders = *start.colliders;
    MeshElements elements;
    elements.edges = colliders.edges();
    add_once_each(colliders.faces(), 0, elements.faces);
    elements.points = colliders.points();
    for (Index p = 0; p < start.particles; ++p) {
      vertices_.push_back({{kParticles, p}, colliders.can_move(p)});
      x_.push_back(corner_of(*start.q, p));
    }
    if (start.bodies != nullptr) add_bodies(start, elements);
    elements.vertex_count = vertices_.size();
    mesh_ = Mesh(std::move(elements));
  }

  std::vector<Intersection> intersections(int threads) const {
    MeshOptions options;
    options.threads = threads;
    return touchstone::intersections(mesh_, x_, options);
  }

  bool within_body(const Intersection& found) const {
    const Index first = body_of(found.first_element, found.first);
    return first != kParticles && first == body_of(found.second_element, found.second);
  }

  bool can_move(const Intersection& found) const {
    const auto any = [&](MeshElement element, MeshIndex number) {
      const auto corners = corners_of(element, number);
      return std::any_of(corners.begin(), corners.end(), [&](MeshIndex v) { return vertices_[v].can_move; });
    };
    return any(found.first_element, found.first) || any(found.second_element, found.second);
  }

  /// Parts that are wholly inside closed surfaces, where nothing intersects.
  /// @param found  the intersections
  void find_enclosed(const std::vector<Intersection>& found, int threads, StartFindings& findings) const {
    MeshOptions options;
    options.threads = threads;
    const Insides inside = insides(mesh_, x_, options, found, ClosedParts::all);
    for (const EnclosedPart& piece : inside.enclosed) {
      const OfBody inner = vertices_[piece.vertex].of;
      const auto outer = std::find_if(piece.faces.begin(), piece.faces.end(), [&](MeshIndex face) {
        return inner.body == kParticles || body_of(MeshElement::face, face) != inner.body;
      });
      if (outer == piece.faces.end()) continue;  // a cavity, or a body of several shells
      const Index body = body_of(MeshElement::face, *outer);
      findings.enclosed_in_bodies += body != kParticles ? 1 : 0;
      if (findings.enclosed++ > 0) continue;
      findings.enclosed_first = fmt::format(
          "{} in {}",
          inner.body == kParticles ? fmt::format("particle {}", inner.number) : fmt::format("body {}", inner.body),
          body == kParticles ? "the surface of " + name(MeshElement::face, *outer) : fmt::format("body {}", body));
    }
    findings.branching = inside.branching;
    findings.in_open = inside.in_open;
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
  void add_bodies(const StartElements& start, MeshElements& elements) {
    for (Index b = 0; b < start.bodies->surfaces().size(); ++b) {
      const ElementSet& surface = start.bodies->surface(b);
      const auto first = static_cast<Index>(vertices_.size());
      for (Index v = 0; v < surface.around.size(); ++v) {
        vertices_.push_back({{b, v}, start.bodies->can_move(b)});
        const Vector3 x = start.bodies->at({b, v}, *start.states, *start.q);
        x_.push_back({x.x(), x.y(), x.z()});
      }
      for (const Edge& edge : surface.edges) elements.edges.push_back({first + edge[0], first + edge[1]});
      add_once_each(surface.faces, first, elements.faces);
    }
  }

  /// kParticles for an element of particles.
  Index body_of(MeshElement element, MeshIndex number) const {
    return vertices_[corners_of(element, number).front()].of.body;
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
    const Index body = body_of(element, number);
    std::string text(element == MeshElement::vertex && body == kParticles ? "particle" : name_of(element));
    const char* separator = " ";
    for (const MeshIndex corner : corners) {
      text += fmt::format("{}{}", std::exchange(separator, "-"), vertices_[corner].of.number);
    }
    return body == kParticles ? text : fmt::format("{} of body {}", text, body);
  }

  std::vector<Vertex> vertices_;
  std::vector<Vec3> x_;
  Mesh mesh_;
};

}  // namespace

StartFindings check_no_intersection(const StartElements& start, std::string_view what, int threads) {
  const StartMesh mesh(start);
  StartFindings findings;
  std::size_t moving = 0;
  std::string first;
  const std::vector<Intersection> all = mesh.intersections(threads);
  for (const Intersection& found : all) {
    if (found.sort == IntersectionSort::inside) continue;  // it may be right, and is counted below
    if (mesh.within_body(found)) {
      ++findings.within_bodies;  // a body does not move against itself
    } else if (!mesh.can_move(found)) {
      ++findings.held;
    } else if (moving++ == 0) {
      first = mesh.describe(found);
    }
  }
  if (moving == 0) {
    mesh.find_enclosed(all, threads, findings);
    return findings;
  }
  throw Error(fmt::format("{} begins with elements that {}{}; positions at which all elements are apart would be right",
                          what, first,
                          moving > 1 ? fmt::format(", and {} more pair{}", moving - 1, moving > 2 ? "s" : "") : ""));
}

}  // namespace touchstone::sim
