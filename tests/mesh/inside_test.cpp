// A closed surface wholly inside another one shares no point with it: `intersections` finds it by winding numbers.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Corners = std::array<MeshIndex, 3>;

/// Meshes side by side, one after the other.
struct Parts {
  MeshElements elements;
  std::vector<double> x;

  /// The box [low, high], with its normals outwards or inwards. @returns its first vertex and its first face
  std::pair<MeshIndex, MeshIndex> add_box(const std::array<double, 3>& low, const std::array<double, 3>& high,
                                          bool outwards = true) {
    static constexpr std::array<Corners, 12> kFaces = {{{0, 1, 3},
                                                        {0, 3, 2},
                                                        {4, 6, 7},
                                                        {4, 7, 5},
                                                        {0, 4, 5},
                                                        {0, 5, 1},
                                                        {2, 3, 7},
                                                        {2, 7, 6},
                                                        {0, 2, 6},
                                                        {0, 6, 4},
                                                        {1, 5, 7},
                                                        {1, 7, 3}}};
    const auto first = static_cast<MeshIndex>(elements.vertex_count);
    const auto face = static_cast<MeshIndex>(elements.faces.size());
    for (std::size_t corner = 0; corner < 8; ++corner) {
      for (std::size_t k = 0; k < 3; ++k) x.push_back((corner >> (2 - k) & 1) != 0 ? high[k] : low[k]);
    }
    for (Corners corners : kFaces) {
      for (MeshIndex& corner : corners) corner += first;
      if (!outwards) std::swap(corners[1], corners[2]);
      elements.faces.push_back(corners);
    }
    elements.vertex_count += 8;
    return {first, face};
  }

  void add_cube(double centre, double half, bool outwards = true) {
    add_box({centre - half, centre - half, centre - half}, {centre + half, centre + half, centre + half}, outwards);
  }

  std::vector<Intersection> all() const { return intersections(Mesh(elements), {x, 3}); }
};

std::set<std::pair<MeshIndex, MeshIndex>> inside_of(const std::vector<Intersection>& all) {
  std::set<std::pair<MeshIndex, MeshIndex>> found;
  for (const Intersection& one : all) {
    if (one.sort == IntersectionSort::inside) found.insert({one.first, one.second});
  }
  return found;
}

}  // namespace

TEST_CASE("a body wholly inside another one is found") {
  Parts parts;
  parts.add_cube(0.25, 0.5);
  parts.add_cube(0, 2);
  const auto all = parts.all();
  REQUIRE(all.size() == 1);
  CHECK(all[0].sort == IntersectionSort::inside);
  CHECK(all[0].first_element == MeshElement::vertex);
  CHECK(all[0].first == 0);
  CHECK(all[0].second_element == MeshElement::face);
  CHECK(all[0].second == 12);
  CHECK(all[0].weights_first == std::array<double, 3>{});

  // Beside it, through its surface, or in a surface with a hole: that is something else, or nothing.
  Parts beside;
  beside.add_cube(5, 0.5);
  beside.add_cube(0, 2);
  CHECK(beside.all().empty());
  Parts through;
  through.add_cube(2.125, 0.5);
  through.add_cube(0, 2);
  CHECK_FALSE(through.all().empty());
  CHECK(inside_of(through.all()).empty());
  Parts open = parts;
  open.elements.faces.pop_back();
  CHECK(open.all().empty());
  Parts excluded = parts;
  excluded.elements.rules.groups = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  excluded.elements.rules.group_pairs = {{0, 1}};
  CHECK(excluded.all().empty());
}

TEST_CASE("orientation tells a solid in a solid from a cavity and from a room") {
  const auto count = [](std::vector<std::pair<double, bool>> cubes) {
    Parts parts;
    for (const auto& [half, outwards] : cubes) parts.add_cube(half / 64, half, outwards);
    return parts.all().size();
  };
  CHECK(count({{4, true}, {2, true}}) == 1);
  CHECK(count({{4, true}, {2, false}}) == 0);             // a cavity
  CHECK(count({{4, true}, {2, false}, {1, true}}) == 0);  // a solid in the cavity
  CHECK(count({{8, true}, {4, false}, {2, true}, {1, true}}) == 1);
  CHECK(count({{4, false}, {2, true}}) == 0);  // furniture in a room
  CHECK(count({{4, false}, {2, false}}) == 1);
  CHECK(count({{8, true}, {4, true}, {2, true}}) == 2);
  CHECK(count({{8, false}, {4, true}, {2, true}}) == 1);   // a solid in the furniture of a room
  CHECK(count({{8, false}, {4, true}, {2, false}}) == 0);  // a cavity of it
  CHECK(count({{8, false}, {4, true}, {2, false}, {1, true}}) == 0);
  CHECK(count({{8, false}, {4, true}, {2, false}, {1, false}}) == 1);

  // Rules: a surface that the inner one may not collide with does not count, whatever its number is.
  for (const MeshIndex excluded : {0, 1}) {
    Parts parts;
    parts.add_cube(0.25, 8);
    parts.add_cube(0.125, 4);
    parts.add_cube(0, 2);
    for (MeshIndex v = 0; v < 24; ++v) parts.elements.rules.groups.push_back(v / 8);
    parts.elements.rules.group_pairs = {{0, 1}, {excluded, 2}};
    const auto found = inside_of(parts.all());
    REQUIRE(found.size() == 1);
    CHECK(*found.begin() == std::pair<MeshIndex, MeshIndex>{16, excluded == 0 ? 12 : 0});
  }
}

// The ray from a vertex of the inner box goes along x: here it meets edges, corners and faces that lie along it.
TEST_CASE("boxes on a lattice are inside each other exactly when their bounds say so") {
  seeded::Rng random(306);
  int nested = 0, apart = 0;
  for (std::size_t round = 0; round < effort(300); ++round) {
    Parts parts;
    std::vector<std::array<std::array<double, 3>, 2>> boxes;
    std::vector<std::pair<MeshIndex, MeshIndex>> names;
    const double unit = std::ldexp(1.0, random.between(-300, 300));
    for (int n = 0; n < 3; ++n) {
      std::array<double, 3> low{}, high{};
      const int most = n == 0 ? 6 : 3;
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = random.between(0, 4);
        const int size = random.between(1, most);
        low[k] = unit * from;
        high[k] = unit * (from + size);
      }
      boxes.push_back({low, high});
      names.push_back(parts.add_box(low, high));
    }
    std::set<std::pair<MeshIndex, MeshIndex>> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      MeshIndex outer = 0;
      bool inside = false;
      for (std::size_t j = 0; j < boxes.size() && !inside; ++j) {
        inside = i != j;
        for (std::size_t k = 0; k < 3; ++k) {
          inside = inside && boxes[j][0][k] < boxes[i][0][k] && boxes[i][1][k] < boxes[j][1][k];
        }
        outer = names[j].second;
      }
      if (inside) expected.insert({names[i].first, outer});
    }
    CAPTURE(round, parts.x);
    REQUIRE(inside_of(parts.all()) == expected);
    (expected.empty() ? apart : nested) += 1;
  }
  CHECK((nested > 0 || !whole_effort("boxes inside others")));
  CHECK((apart > 0 || !whole_effort("boxes that are not")));
}

TEST_CASE("the place in a surface that is not convex is told exactly") {
  seeded::Rng random(307);
  int inside = 0, outside = 0;
  for (std::size_t round = 0; round < effort(200); ++round) {
    Parts parts;
    // A star: a cube of several faces a side, whose corners are moved along their rays from the centre, each by its own factor.
    constexpr int kSteps = 3;
    std::vector<std::array<double, 3>> rays;
    const auto ray = [&](std::array<int, 3> at) {
      std::array<double, 3> r{};
      for (std::size_t k = 0; k < 3; ++k) r[k] = 2.0 * at[k] - kSteps;
      const auto found = std::find(rays.begin(), rays.end(), r);
      if (found != rays.end()) return static_cast<MeshIndex>(found - rays.begin());
      rays.push_back(r);
      return static_cast<MeshIndex>(rays.size() - 1);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, kSteps}) {
        for (int i = 0; i < kSteps; ++i) {
          for (int j = 0; j < kSteps; ++j) {
            const auto corner = [&](int a, int b) {
              std::array<int, 3> at{};
              at[axis] = side;
              at[(axis + 1) % 3] = a;
              at[(axis + 2) % 3] = b;
              return ray(at);
            };
            Corners one = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)};
            Corners two = {corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)};
            if (side == 0) std::swap(one[1], one[2]), std::swap(two[1], two[2]);
            parts.elements.faces.push_back(one);
            parts.elements.faces.push_back(two);
          }
        }
      }
    }
    for (const auto& r : rays) {
      const double factor = random.uniform(0.3, 1);
      for (const double k : r) parts.x.push_back(factor * k);
    }
    parts.elements.vertex_count = rays.size();
    std::array<double, 3> at{};
    for (double& k : at) k = random.uniform(-2.5, 2.5);
    constexpr double kHalf = 0x1p-30;
    const auto [vertex, face] =
        parts.add_box({at[0] - kHalf, at[1] - kHalf, at[2] - kHalf}, {at[0] + kHalf, at[1] + kHalf, at[2] + kHalf});
    // In which of the star's cones from the centre is it, and before its face?
    bool expected = false, near = false;
    for (std::size_t f = 0; f < face; ++f) {
      long double corner[3][3];
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k) corner[c][k] = parts.x[3 * parts.elements.faces[f][c] + k];
      }
      const auto det = [](const long double* a, const long double* b, const long double* c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
      };
      const long double p[3] = {at[0], at[1], at[2]};
      const long double all = det(corner[0], corner[1], corner[2]);
      const long double w[3] = {det(p, corner[1], corner[2]) / all, det(corner[0], p, corner[2]) / all,
                                det(corner[0], corner[1], p) / all};
      if (w[0] < 0 || w[1] < 0 || w[2] < 0) continue;
      expected = expected || w[0] + w[1] + w[2] < 1;
      near = near || std::fabs(w[0] + w[1] + w[2] - 1) < 1e-6L;
    }
    if (near) continue;  // it may pass through the surface
    CAPTURE(round, at[0], at[1], at[2]);
    REQUIRE(inside_of(parts.all()).count({vertex, 0}) == (expected ? 1 : 0));
    ++(expected ? inside : outside);
  }
  CHECK((inside > 0 || !whole_effort("places inside")));
  CHECK((outside > 0 || !whole_effort("places outside")));
}
