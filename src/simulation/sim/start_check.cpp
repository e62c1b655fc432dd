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

/// A scene may have a face twice, for collisions and for forces; a mesh may not.
std::vector<Face> once_each(std::vector<Face> faces) {
  const auto sorted = [](Face face) {  // of a face in both orientations, either is right
    std::sort(face.begin(), face.end());
    return face;
  };
  std::stable_sort(faces.begin(), faces.end(), [&](const Face& a, const Face& b) { return sorted(a) < sorted(b); });
  const auto same = [&](const Face& a, const Face& b) { return sorted(a) == sorted(b); };
  faces.erase(std::unique(faces.begin(), faces.end(), same), faces.end());
  return faces;
}

class StartMesh {
 public:
  StartMesh(const Colliders& colliders, const VectorX& q, const BodyStates& bodies) : colliders_(colliders) {
    MeshElements elements;
    elements.edges = colliders.edges();
    elements.faces = once_each(colliders.faces());
    elements.points = colliders.points();
    elements.vertex_count = colliders.before(colliders.group_count()).vertices;
    for (Index v = 0; v < elements.vertex_count; ++v) {
      const Vector3 x = colliders.at(v, q, bodies);
      x_.push_back({x.x(), x.y(), x.z()});
    }
    mesh_ = Mesh(std::move(elements));
  }

  std::vector<Intersection> intersections(int threads) const {
    MeshOptions options;
    options.threads = threads;
    return touchstone::intersections(mesh_, x_, options);
  }

  bool within_body(const Intersection& found) const {
    const Index first = group_of(found.first_element, found.first);
    return first != kParticles && first == group_of(found.second_element, found.second);
  }

  bool can_move(const Intersection& found) const {
    const auto any = [&](MeshElement element, MeshIndex number) {
      const auto corners = corners_of(element, number);
      return std::any_of(corners.begin(), corners.end(), [&](MeshIndex v) { return colliders_.can_move(v); });
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
      const Index inner = colliders_.group_of(piece.vertex);
      const auto outer = std::find_if(piece.faces.begin(), piece.faces.end(), [&](MeshIndex face) {
        return inner == kParticles || group_of(MeshElement::face, face) != inner;
      });
      if (outer == piece.faces.end()) continue;  // a cavity, or a body of several shells
      const Index group = group_of(MeshElement::face, *outer);
      findings.enclosed_in_bodies += group != kParticles ? 1 : 0;
      if (findings.enclosed++ > 0) continue;
      findings.enclosed_first = fmt::format(
          "{} in {}",
          inner == kParticles ? fmt::format("particle {}", piece.vertex) : fmt::format("body {}", inner - 1),
          group == kParticles ? "the surface of " + name(MeshElement::face, *outer)
                              : fmt::format("body {}", group - 1));
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
  Index group_of(MeshElement element, MeshIndex number) const {
    return colliders_.group_of(corners_of(element, number).front());
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
    return colliders_.describe(element, corners_of(element, number).data());
  }

  const Colliders& colliders_;
  std::vector<Vec3> x_;
  Mesh mesh_;
};

}  // namespace

StartFindings check_no_intersection(const Colliders& colliders, const VectorX& q, const BodyStates& bodies,
                                    std::string_view what, int threads) {
  const StartMesh mesh(colliders, q, bodies);
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
