// SPDX-License-Identifier: MIT
#include "scene/surface_check.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include <touchstone/error.hpp>

namespace touchstone::sim {
namespace {

// N/m, N m and kg/m^2: products with lengths and times stay far from overflow.
constexpr double kMostAbsolute = 1e12;

// Of the largest product of two of its sides: a triangle with less area has no shape that its strains could measure.
constexpr double kLeastArea = 1e-6;

constexpr double kLeastPoisson = -0.99, kMostPoisson = 0.5;
constexpr double kLeastStrainLimit = 1e-3, kMostStrainLimit = 10;

class SurfacePath {
 public:
  explicit SurfacePath(std::size_t number) : path_(fmt::format("surfaces[{}]", number)) {}

  [[noreturn]] void fail(const std::string& key, const std::string& reason) const {
    throw Error(fmt::format("{}.{}: {}", path_, key, reason));
  }
  void in_range(const char* key, double value, double low, double high) const {
    if (!(value >= low && value <= high)) fail(key, fmt::format("{} is not in [{}, {}]", value, low, high));
  }

 private:
  std::string path_;
};

Vector3 placed(const Scene& scene, Index particle) {
  const Particle& p = scene.particles[particle];
  return p.path.empty() ? p.position : p.path.front().position;
}

void check_faces(const Scene& scene, const Surface& surface, const SurfacePath& path) {
  if (surface.faces.empty()) path.fail("faces", "must be at least one");
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const std::string key = fmt::format("faces[{}]", f);
    const Face& face = surface.faces[f];
    for (std::size_t k = 0; k < 3; ++k) {
      if (face[k] >= scene.particles.size())
        path.fail(key, fmt::format("there is no particle {}: there are {}", face[k], scene.particles.size()));
      if (face[k] == face[(k + 1) % 3]) path.fail(key, fmt::format("particle {} is there twice", face[k]));
      if (!scene.particles[face[k]].collides)
        path.fail(key, fmt::format("particle {} does not collide, and this does", face[k]));
    }
    const Vector3 a = placed(scene, face[0]), u = placed(scene, face[1]) - a, w = placed(scene, face[2]) - a;
    const double longest = std::max({u.norm(), w.norm(), (w - u).norm()});
    if (!(u.cross(w).norm() > kLeastArea * longest * longest)) {
      path.fail(key, fmt::format("the particles {}, {} and {} are on a line; three corners of a triangle with an area "
                                 "would be right",
                                 face[0], face[1], face[2]));
    }
  }
}

/// An edge has one hinge at most, so at most two faces may share it.
void check_edges(const Surface& surface, const SurfacePath& path) {
  struct Side {
    Edge edge;
    std::size_t face;
    Index opposite;
  };
  std::vector<Side> sides;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const Face& face = surface.faces[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = face[k], b = face[(k + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, f, face[(k + 2) % 3]});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::tie(a.edge, a.face) < std::tie(b.edge, b.face); });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].edge != sides[i + 1].edge) continue;
    const std::string key = fmt::format("faces[{}]", sides[i + 1].face);
    if (sides[i].opposite == sides[i + 1].opposite)
      path.fail(key, fmt::format("is the same triangle as faces[{}]", sides[i].face));
    if (i + 2 < sides.size() && sides[i + 2].edge == sides[i].edge) {
      path.fail(fmt::format("faces[{}]", sides[i + 2].face),
                fmt::format("is the third face at the edge {}-{}, after faces[{}] and faces[{}]; two at most would be "
                            "right",
                            sides[i].edge[0], sides[i].edge[1], sides[i].face, sides[i + 1].face));
    }
  }
}

}  // namespace

void check_surface(const Scene& scene, std::size_t number) {
  const Surface& surface = scene.surfaces[number];
  const SurfacePath path(number);
  if (!(surface.stretch > 0 && surface.stretch <= kMostAbsolute))
    path.fail("stretch", fmt::format("{} N/m is not in (0, {}]", surface.stretch, kMostAbsolute));
  path.in_range("poisson", surface.poisson, kLeastPoisson, kMostPoisson);
  path.in_range("bend", surface.bend, 0, kMostAbsolute);
  path.in_range("areal_density", surface.areal_density, 0, kMostAbsolute);
  path.in_range("damping", surface.damping, 0, 1e6);
  if (surface.strain_limit != 0)
    path.in_range("strain_limit", surface.strain_limit, kLeastStrainLimit, kMostStrainLimit);
  if (surface.rest_is_bent && surface.bend == 0) path.fail("rest_is_bent", "goes with a surface that resists bending");
  if (const std::string reason = wrong_radius(surface.radius); !reason.empty()) path.fail("radius", reason);
  check_faces(scene, surface, path);
  check_edges(surface, path);
}

}  // namespace touchstone::sim
