// A closed surface wholly inside another one shares no point with it: `intersections` finds it by winding numbers.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "mesh/inside_surfaces/inside.hpp"
#include "mesh/inside_surfaces/pieces.hpp"
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

  /// @returns its number
  MeshIndex add_vertex(double a, double b, double c) {
    x.insert(x.end(), {a, b, c});
    return static_cast<MeshIndex>(elements.vertex_count++);
  }

  std::vector<Intersection> all(int threads = 1) const {
    const Mesh mesh(elements);
    std::vector<Intersection> found = intersections(mesh, {x, 3}, {threads});
    CHECK(intersects(mesh, {x, 3}, {threads}) == !found.empty());
    return found;
  }

  std::vector<EnclosedPart> enclosed(ClosedParts closed = ClosedParts::unasked, int threads = 1) const {
    return insides(Mesh(elements), {x, 3}, {threads}, all(), closed).enclosed;
  }
};

/// "surface 8 in 0, wire 12 in 0": the vertices and the faces.
std::string text_of(const std::vector<EnclosedPart>& parts) {
  std::string text;
  for (const EnclosedPart& part : parts) {
    text += text.empty() ? "" : ", ";
    text += part.element == MeshElement::face ? "surface " : part.element == MeshElement::edge ? "wire " : "point ";
    text += std::to_string(part.vertex) + " in " + std::to_string(part.faces.front());
  }
  return text;
}

/// The number of surfaces of which no one knows what they enclose.
std::size_t branching(const Parts& parts) {
  const Mesh mesh(parts.elements);
  return mesh::Pieces(mesh.impl(), mesh::Motion(mesh.vertex_count())).branching();
}

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
    // A star: a cube of several faces a side, whose corners are moved along their rays from the centre, each by its own
    // factor.
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

TEST_CASE("surfaces that share a vertex are asked about, one inside the other too") {
  // A box with its corner 0, and a tetrahedron that has this corner: inside, outside, or as a cavity.
  const auto with_tetrahedron = [](double size, bool outwards) {
    Parts parts;
    parts.add_box({0, 0, 0}, {4, 4, 4});
    const MeshIndex a = parts.add_vertex(size, size, 2 * size), b = parts.add_vertex(2 * size, size, size),
                    c = parts.add_vertex(size, 2 * size, size);
    for (Corners face : {Corners{0, b, a}, {0, c, b}, {0, a, c}, {a, b, c}}) {
      if (!outwards) std::swap(face[1], face[2]);
      parts.elements.faces.push_back(face);
    }
    return parts;
  };
  CHECK((inside_of(with_tetrahedron(-1, true).all()) == std::set<std::pair<MeshIndex, MeshIndex>>{}));
  CHECK(with_tetrahedron(1, false).all().empty());
  const auto found = with_tetrahedron(1, true).all();
  REQUIRE(found.size() == 1);
  CHECK(found[0].sort == IntersectionSort::inside);
  CHECK(found[0].first == 8);  // vertex 0 is in both
  CHECK(found[0].second == 0);

  // All corners of an octahedron are corners of a cube's surface too, as the centres of its sides.
  Parts both;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double sign : {-1.0, 1.0}) both.add_vertex(k == 0 ? sign : 0, k == 1 ? sign : 0, k == 2 ? sign : 0);
  }
  for (int n = 0; n < 8; ++n) both.add_vertex(2 * (n & 1) - 1, (n & 2) - 1, (n & 4) / 2 - 1);
  const auto outwards = [&](Corners face) {
    const double *const p = &both.x[3 * face[0]], *const q = &both.x[3 * face[1]], *const r = &both.x[3 * face[2]];
    const double volume =
        p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
    if (volume < 0) std::swap(face[1], face[2]);
    return face;
  };
  for (MeshIndex n = 0; n < 8; ++n) {
    const Corners octant{n & 1, 2 + (n >> 1 & 1), 4 + (n >> 2)};
    for (MeshIndex k = 0; k < 3; ++k) {
      const MeshIndex other = n ^ (1U << k);
      if (other < n) continue;
      for (const MeshIndex centre : octant) {
        if (centre / 2 != k) both.elements.faces.push_back(outwards({centre, 6 + n, 6 + other}));
      }
    }
    both.elements.faces.push_back(outwards(octant));
  }
  const auto inside = both.all(), three = both.all(3);
  REQUIRE(inside.size() == 1);
  REQUIRE(three.size() == 1);
  CHECK(inside[0].sort == IntersectionSort::inside);
  CHECK(inside[0].first == 0);
  CHECK(both.elements.faces[inside[0].second][1] >= 6);
}

TEST_CASE("surfaces that share an edge are each closed by themselves") {
  // A box, and a wedge that shares the box's edge 0-1, which has four faces then: inside, outside, or as a cavity.
  const auto with_wedge = [](double size, bool outwards) {
    Parts parts;
    parts.add_box({0, 0, 0}, {8, 8, 8});
    const MeshIndex a = parts.add_vertex(size, 2 * size, 4), b = parts.add_vertex(2 * size, size, 4);
    for (Corners face : {Corners{0, 1, b}, {0, a, 1}, {0, b, a}, {1, a, b}}) {
      if (outwards) std::swap(face[1], face[2]);
      parts.elements.faces.push_back(face);
    }
    return parts;
  };
  CHECK(with_wedge(-1, false).all().empty());
  CHECK(text_of(with_wedge(-1, false).enclosed()).empty());
  CHECK(with_wedge(1, false).all().empty());
  CHECK(text_of(with_wedge(1, false).enclosed()) == "surface 8 in 0");
  const Parts inside = with_wedge(1, true);
  REQUIRE(inside.all().size() == 1);
  CHECK(inside_of(inside.all()) == std::set<std::pair<MeshIndex, MeshIndex>>{{8, 0}});
  CHECK(inside_of(inside.all(3)) == inside_of(inside.all()));

  // The faces of both surfaces at the edge count as met by what pierces it.
  Parts pierced = inside;
  const MeshIndex outer = pierced.add_vertex(-1, -1, 3), inner = pierced.add_vertex(1, 1, 3);
  pierced.elements.edges = {{outer, inner}};
  CHECK_FALSE(pierced.all().empty());
  CHECK(text_of(pierced.enclosed()).empty());

  // A fin outside of a box leaves the box closed. A wall through it makes two rooms, which are no surfaces one by one.
  Parts fin;
  fin.add_box({0, 0, 0}, {8, 8, 8});
  fin.elements.faces.push_back({0, 1, fin.add_vertex(-4, -4, 4)});
  fin.add_cube(4, 1);
  CHECK(inside_of(fin.all()) == std::set<std::pair<MeshIndex, MeshIndex>>{{9, 0}});
  CHECK(branching(fin) == 0);
  // Fins on one edge of a closed surface are two surfaces: what one of them is inside does not depend on the other.
  for (const bool outer_first : {false, true}) {
    Parts fins;
    fins.add_box({0, 0, 0}, {8, 8, 8});
    const double first = outer_first ? -4 : 2, second = outer_first ? 2 : -4;
    fins.elements.faces.push_back({0, 1, fins.add_vertex(first, first, 4)});
    fins.elements.faces.push_back({0, 1, fins.add_vertex(second, second, 4)});
    CHECK(text_of(fins.enclosed()) == (outer_first ? "surface 9 in 0" : "surface 8 in 0"));
    CHECK(branching(fins) == 0);
  }
  Parts wall;
  wall.add_box({0, 0, 0}, {8, 8, 8});
  wall.elements.faces.push_back({0, 1, 7});
  wall.elements.faces.push_back({0, 7, 6});
  CHECK(branching(wall) == 1);
  CHECK(branching(inside) == 0);
}

TEST_CASE("open surfaces, wires and points inside closed surfaces are no intersections, and are counted") {
  const auto with_parts = [](Parts parts, double at) {
    const MeshIndex a = parts.add_vertex(at, at, at), b = parts.add_vertex(at + 0.25, at, at),
                    c = parts.add_vertex(at, at + 0.25, at);
    parts.elements.faces.push_back({a, b, c});
    const MeshIndex d = parts.add_vertex(at, at, at + 0.25), e = parts.add_vertex(at, at, at + 0.5),
                    f = parts.add_vertex(at, at, at + 0.75);
    parts.elements.edges = {{d, e}, {e, f}};
    parts.add_vertex(at, at, at - 0.25);
    CHECK(parts.all().empty());
    return text_of(parts.enclosed());
  };
  Parts solid, cavity, room, open, twisted;
  solid.add_cube(0, 4);
  CHECK(with_parts(solid, 0) == "surface 8 in 0, wire 11 in 0, point 14 in 0");
  CHECK(with_parts(solid, 5).empty());
  cavity = solid;
  cavity.add_cube(0.25, 2, false);
  // The cavity itself is counted: it may be a solid that is inside out.
  CHECK(with_parts(cavity, 0) == "surface 8 in 0");
  CHECK(with_parts(cavity, 2.5) == "surface 8 in 0, surface 16 in 0, wire 19 in 0, point 22 in 0");  // in the material
  Parts inner_first;
  inner_first.add_cube(0.25, 2, false);
  inner_first.add_cube(0, 4);
  CHECK(with_parts(inner_first, 0) == "surface 0 in 12");
  room.add_cube(0, 4, false);
  CHECK(with_parts(room, 0) == "surface 8 in 0, wire 11 in 0, point 14 in 0");
  room.add_cube(0.25, 2);
  CHECK(with_parts(room, 0) == "surface 8 in 0, surface 16 in 0, wire 19 in 0, point 22 in 0");  // in the furniture
  open = solid;
  open.elements.faces.pop_back();
  CHECK(with_parts(open, 0).empty());
  // With one face turned around, a surface still has an inside, and a closed surface there is counted.
  twisted = solid;
  std::swap(twisted.elements.faces[3][0], twisted.elements.faces[3][1]);
  CHECK(with_parts(twisted, 0) == "surface 8 in 0, wire 11 in 0, point 14 in 0");
  twisted.add_cube(0.25, 2);
  CHECK(text_of(twisted.enclosed()) == "surface 8 in 0");
  CHECK(twisted.all().empty());
  // Outside such a surface, the ray may leave it by two sides.
  Parts wedge;
  wedge.add_vertex(16, 0, 0);
  wedge.add_vertex(0, 0, 0);
  wedge.add_vertex(16, 16, 0);
  wedge.add_vertex(16, 0, 16);
  wedge.elements.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  for (Corners& face : wedge.elements.faces) {
    const Corners before = face;
    wedge.add_vertex(2, 8, 4);
    CHECK(text_of(wedge.enclosed()).empty());
    std::swap(face[0], face[1]);
    CHECK(text_of(wedge.enclosed()).empty());
    face = before;
  }
  solid.add_cube(0.25, 2);
  CHECK(text_of(solid.enclosed()).empty());  // an intersection
  CHECK(text_of(solid.enclosed(ClosedParts::all)) == "surface 8 in 0");
}

TEST_CASE("a wire that grows from a surface is inside it, and one that meets it is not") {
  Parts parts;
  parts.add_cube(0, 4);
  const MeshIndex inner = parts.add_vertex(0, 0, 0);
  parts.elements.edges = {{0, inner}};
  CHECK(text_of(parts.enclosed()) == "wire 8 in 0");
  parts.elements.edges = {{0, 7}};  // both ends are corners of the cube
  CHECK(text_of(parts.enclosed()) == "wire 0 in 0, point 8 in 0");
  parts.elements.edges = {{0, inner}, {inner, parts.add_vertex(5, 0, 0)}};
  CHECK(text_of(parts.enclosed()).empty());
  // All at one place, it is on the surface.
  Parts still;
  still.add_cube(0, 4);
  still.elements.edges = {{0, still.add_vertex(-4, -4, -4)}};
  CHECK(text_of(still.enclosed()).empty());
  still.elements.edges = {{still.add_vertex(1, 1, 1), still.add_vertex(1, 1, 1)}};
  CHECK(text_of(still.enclosed()) == "wire 9 in 0");
}

// The surfaces are the borders of filled cells of a lattice. A piece in a cell is inside exactly if its cell is filled.
// Cavities of the filled cells are counted, too.
TEST_CASE("many pieces are inside surfaces exactly when their cells are filled, for any number of threads") {
  seeded::Rng random(308);
  std::size_t inside = 0, outside = 0;
  for (std::size_t round = 0; round < effort(20); ++round) {
    Parts parts;
    constexpr int kSize = 4;
    std::array<std::array<std::array<int, kSize>, kSize>, kSize> filled{};
    for (auto& plane : filled) {
      for (auto& row : plane) {
        for (int& cell : row) cell = random.below(2 + round % 3) != 0 ? 1 : 0;
      }
    }
    const auto is_filled = [&](int a, int b, int c) {
      const auto in = [](int k) { return 0 <= k && k < kSize; };
      return in(a) && in(b) && in(c) && filled[std::size_t(a)][std::size_t(b)][std::size_t(c)] != 0;
    };
    constexpr int kCorners = kSize + 1;
    for (int n = 0; n < kCorners * kCorners * kCorners; ++n) {
      parts.add_vertex(8.0 * (n / kCorners / kCorners), 8.0 * (n / kCorners % kCorners), 8.0 * (n % kCorners));
    }
    const auto number = [&](const std::array<int, 3>& at) {
      return static_cast<MeshIndex>((at[0] * kCorners + at[1]) * kCorners + at[2]);
    };
    for (int n = 0; n < kSize * kSize * kSize; ++n) {
      const std::array<int, 3> cell{n / kSize / kSize, n / kSize % kSize, n % kSize};
      if (!is_filled(cell[0], cell[1], cell[2])) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        for (const int side : {0, 1}) {
          std::array<int, 3> next = cell;
          next[k] += 2 * side - 1;
          if (is_filled(next[0], next[1], next[2])) continue;
          std::array<std::array<int, 3>, 4> at;
          at.fill(cell);
          for (std::size_t i = 0; i < 4; ++i) {
            at[i][k] += side;
            at[i][(k + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
            at[i][(k + 2) % 3] += i >= 2 ? 1 : 0;
          }
          if (side == 0) std::swap(at[1], at[3]);
          parts.elements.faces.push_back({number(at[0]), number(at[1]), number(at[2])});
          parts.elements.faces.push_back({number(at[0]), number(at[2]), number(at[3])});
        }
      }
    }
    // Points, wires and triangles within cells, in line with corners and edges.
    std::set<MeshIndex> expected;
    std::vector<MeshIndex> points;
    for (int a = -1; a <= kSize; ++a) {
      for (int b = -1; b <= kSize; ++b) {
        for (int c = -1; c <= kSize; ++c) {
          const double x = 8 * a + 1, y = 8 * b + 1, z = 8 * c + 1;
          const MeshIndex first = parts.add_vertex(x, y, z);
          const std::uint64_t sort = random.below(3);
          if (sort > 0) parts.add_vertex(x + 2, y, z + 1);
          if (sort > 1) parts.add_vertex(x, y + 2, z + 2);
          if (sort == 0) points.push_back(first);
          if (sort == 1) parts.elements.edges.push_back({first, first + 1});
          if (sort == 2) parts.elements.faces.push_back({first, first + 1, first + 2});
          if (is_filled(a, b, c)) expected.insert(first);
          ++(is_filled(a, b, c) ? inside : outside);
        }
      }
    }
    // Points in line with corners and edges of the surfaces, if the cells around them are all filled, or none is.
    for (int n = 0; n < 2 * kCorners * 2 * kCorners * 2 * kCorners; ++n) {
      const std::array<int, 3> at{n / (4 * kCorners * kCorners) - 1, n / (2 * kCorners) % (2 * kCorners) - 1,
                                  n % (2 * kCorners) - 1};
      int filled_around = 0;
      for (int cell = 0; cell < 8; ++cell) {
        const auto before = [&](int k, int bit) { return (k + 2 - (cell >> bit & 1)) / 2 - 1; };
        filled_around += is_filled(before(at[0], 0), before(at[1], 1), before(at[2], 2)) ? 1 : 0;
      }
      if (filled_around != 0 && filled_around != 8) continue;
      points.push_back(parts.add_vertex(4 * at[0], 4 * at[1], 4 * at[2]));
      if (filled_around == 8) expected.insert(points.back());
    }
    parts.elements.points = points;
    CAPTURE(round);
    CHECK(parts.all().empty());
    const auto one = parts.enclosed(ClosedParts::unasked, 1), three = parts.enclosed(ClosedParts::unasked, 3);
    std::set<MeshIndex> found;
    std::size_t cavities = 0;
    for (const EnclosedPart& part : one) {
      const bool of_cells = part.vertex < kCorners * kCorners * kCorners;
      if (!of_cells) found.insert(part.vertex);
      cavities += of_cells ? 1 : 0;
    }
    CHECK(found == expected);
    CHECK(text_of(one) == text_of(three));
    CHECK(found.size() + cavities == one.size());
  }
  CHECK((inside > 0 || !whole_effort("pieces inside")));
  CHECK(outside > 0);
}
