// How parts lie to each other: cubes in every relation, and polycubes against a comparison of their cells.
// SPDX-License-Identifier: MIT
#include "mesh/group_relations/group_relations.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using mesh::GroupPair;
using mesh::Relation;

namespace {

using Point = std::array<double, 3>;

struct Solid {
  std::vector<Point> vertices;
  std::vector<std::array<MeshIndex, 3>> faces;
  std::vector<std::array<MeshIndex, 2>> wires;
  std::vector<MeshIndex> points;
};

/// The box between two corners. @param cut  which of two diagonals each side has
Solid box(const Point& low, const Point& high, unsigned cut = 0) {
  Solid solid;
  for (unsigned v = 0; v < 8; ++v) {
    solid.vertices.push_back({v & 1 ? high[0] : low[0], v & 2 ? high[1] : low[1], v & 4 ? high[2] : low[2]});
  }
  const std::array<MeshIndex, 4> sides[] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (unsigned i = 0; i < 6; ++i) {
    const auto& [a, b, c, d] = sides[i];
    const bool other = (cut >> i & 1) != 0;
    solid.faces.push_back(other ? std::array{a, b, d} : std::array{a, b, c});
    solid.faces.push_back(other ? std::array{b, c, d} : std::array{a, c, d});
  }
  return solid;
}

Solid joined(Solid a, const Solid& b) {
  const auto first = static_cast<MeshIndex>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [x, y, z] : b.faces) a.faces.push_back({x + first, y + first, z + first});
  for (const auto& [x, y] : b.wires) a.wires.push_back({x + first, y + first});
  for (const MeshIndex x : b.points) a.points.push_back(x + first);
  return a;
}

Solid turned_inside_out(Solid solid) {
  for (auto& face : solid.faces) std::swap(face[0], face[1]);
  return solid;
}

/// The class of the two, in this order.
Relation class_between(const Solid& a, const Solid& b) {
  const Solid both = joined(a, b);
  MeshElements elements;
  elements.vertex_count = both.vertices.size();
  elements.faces = both.faces;
  elements.edges = both.wires;
  elements.points = both.points;
  std::vector<double> x;
  for (const Point& vertex : both.vertices) x.insert(x.end(), vertex.begin(), vertex.end());
  std::vector<std::uint32_t> parts(a.vertices.size(), 0);
  parts.resize(both.vertices.size(), 1);
  const std::vector<GroupPair> found = mesh::group_relations(Mesh(elements), {x, 3}, parts, 2).pairs;
  if (found.empty()) return Relation::clear;
  REQUIRE(found.size() == 1);
  CHECK(found[0].a == 0);
  CHECK(found[0].b == 1);
  return found[0].sort;
}

Relation exchanged(Relation sort) {
  if (sort == Relation::inside) return Relation::around;
  return sort == Relation::around ? Relation::inside : sort;
}

/// A turn of the axes, which keeps orientations, with a scale and other numbers of the vertices and faces.
Solid changed(const Solid& solid, unsigned turn, double scale, seeded::Rng& random) {
  Solid other = solid;
  for (Point& p : other.vertices) {
    for (unsigned i = 0; i < turn % 3; ++i) p = {p[1], p[2], p[0]};
    if (turn >= 3) p = {-p[0], -p[1], p[2]};
    if (turn >= 6) p = {p[1], p[0], -p[2]};
    for (double& x : p) x *= scale;
  }
  std::vector<MeshIndex> to(other.vertices.size());
  for (MeshIndex v = 0; v < to.size(); ++v) to[v] = v;
  for (std::size_t v = to.size(); v > 1; --v) std::swap(to[v - 1], to[random.below(v)]);
  std::vector<Point> vertices(to.size());
  for (std::size_t v = 0; v < to.size(); ++v) vertices[to[v]] = other.vertices[v];
  other.vertices = vertices;
  for (auto& face : other.faces) {
    for (MeshIndex& corner : face) corner = to[corner];
    std::rotate(face.begin(), face.begin() + random.between(0, 2), face.end());
  }
  for (std::size_t f = other.faces.size(); f > 1; --f) std::swap(other.faces[f - 1], other.faces[random.below(f)]);
  for (auto& wire : other.wires) wire = {to[wire[1]], to[wire[0]]};
  for (MeshIndex& point : other.points) point = to[point];
  return other;
}

void check_class(const std::string& name, const Solid& a, const Solid& b, Relation right) {
  seeded::Rng random(5);
  for (unsigned turn = 0; turn < 9; ++turn) {
    const double scale = std::array{1.0, 0x1p-300, 0x1p300}[(turn + turn / 3) % 3];
    const Solid one = changed(a, turn, scale, random), two = changed(b, turn, scale, random);
    CAPTURE(name, turn, scale);
    CHECK(name_of(class_between(one, two)) == name_of(right));
    CHECK(name_of(class_between(two, one)) == name_of(exchanged(right)));
  }
}

}  // namespace

TEST_CASE("two cubes in every relation") {
  const Solid cube = box({0, 0, 0}, {1, 1, 1});
  const auto at = [](double x, double y, double z, unsigned cut = 0) {
    return box({x, y, z}, {x + 1, y + 1, z + 1}, cut);
  };
  check_class("apart", cube, at(3, 0, 0), Relation::clear);
  check_class("apart, with boxes that touch", cube, at(1, std::nextafter(1, 2), 0), Relation::clear);
  check_class("face to face", cube, at(1, 0, 0), Relation::touching);
  check_class("face to face, the other diagonal", cube, at(1, 0, 0, 63), Relation::touching);
  check_class("face to a part of a face", cube, at(1, 0.25, 0.5), Relation::touching);
  check_class("edge to edge", cube, at(1, 1, 0), Relation::touching);
  check_class("edge to a part of an edge", cube, at(1, 1, 0.5), Relation::touching);
  check_class("corner to corner", cube, at(1, 1, 1), Relation::touching);
  check_class("next to face to face", cube, at(std::nextafter(1, 0), 0, 0), Relation::overlapping);
  check_class("apart by a double", cube, at(std::nextafter(1, 2), 0, 0), Relation::clear);
  check_class("moved along a coplanar side", cube, at(0.5, 0, 0), Relation::overlapping);
  check_class("moved along two coplanar sides", cube, at(0.5, 0.5, 0), Relation::overlapping);
  check_class("moved along its diagonal", cube, at(0.5, 0.5, 0.5), Relation::overlapping);
  check_class("the same", cube, cube, Relation::same);
  for (const unsigned cut : {1u, 21u, 63u}) check_class("other diagonals", cube, at(0, 0, 0, cut), Relation::same);
  check_class("the same of two halves", cube, joined(box({0, 0, 0}, {0.5, 1, 1}), box({0.5, 0, 0}, {1, 1, 1})),
              Relation::same);
  check_class("nested", box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}), cube, Relation::inside);
  check_class("nested with a common wall", box({0, 0.25, 0.25}, {0.5, 0.5, 0.5}), cube, Relation::inside);
  check_class("nested with common edges", box({0, 0, 0}, {0.5, 0.5, 1}), cube, Relation::inside);
  check_class("one that sticks out of a wall", box({-0.5, 0.25, 0.25}, {0.5, 0.5, 0.5}), cube, Relation::overlapping);
  check_class("a rod through a cube", box({-1, 0.25, 0.25}, {2, 0.5, 0.5}), cube, Relation::overlapping);
  check_class("a flush rod through a cube", box({-1, 0, 0}, {2, 0.5, 1}), cube, Relation::overlapping);
}

TEST_CASE("hollow solids, parts of several pieces, and a tetrahedron with its corners on faces") {
  const Solid cube = box({0, 0, 0}, {1, 1, 1});
  const Solid hollow = joined(box({-2, -2, -2}, {3, 3, 3}), turned_inside_out(box({-1, -1, -1}, {2, 2, 2})));
  check_class("in a cavity", cube, hollow, Relation::clear);
  check_class("in a cavity and at its wall", box({-1, 0, 0}, {0, 1, 1}), hollow, Relation::touching);
  check_class("fills a cavity", box({-1, -1, -1}, {2, 2, 2}), hollow, Relation::touching);
  check_class("more than a cavity", box({-1.5, -1, -1}, {2, 2, 2}), hollow, Relation::overlapping);
  check_class("in the wall of a hollow one", box({-1.75, 0, 0}, {-1.25, 1, 1}), hollow, Relation::inside);
  check_class("a hollow one and the same without its cavity", hollow, box({-2, -2, -2}, {3, 3, 3}), Relation::inside);
  const Solid two = joined(box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}), box({5, 5, 5}, {6, 6, 6}));
  check_class("one piece within, and one outside", two, cube, Relation::overlapping);
  check_class("both pieces within", joined(two, {}), joined(cube, box({4, 4, 4}, {7, 7, 7})), Relation::inside);
  const Solid crossed = joined(box({0, 0, 0}, {2, 1, 1}), box({1, 0, 0}, {3, 1, 1}));  // meets itself
  check_class("the same as its two pieces, which overlap", crossed, box({0, 0, 0}, {3, 1, 1}), Relation::same);
  check_class("inside where two pieces overlap", box({1.25, 0, 0.25}, {1.5, 0.5, 0.5}), crossed, Relation::inside);
  check_class("around a surface within", box({0.5, 0, 0}, {2.5, 1, 1}), crossed, Relation::inside);

  Solid tetrahedron;
  tetrahedron.vertices = {{0, 0.25, 0.25}, {1, 0.25, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 1}};
  tetrahedron.faces = {{0, 1, 2}, {0, 2, 3}, {1, 3, 2}, {0, 3, 1}};
  const auto& v = tetrahedron.vertices;
  double volume = 0;
  {
    const auto d = [&](std::size_t i, std::size_t k) { return v[i][k] - v[0][k]; };
    volume = d(1, 0) * (d(2, 1) * d(3, 2) - d(2, 2) * d(3, 1)) - d(1, 1) * (d(2, 0) * d(3, 2) - d(2, 2) * d(3, 0)) +
             d(1, 2) * (d(2, 0) * d(3, 1) - d(2, 1) * d(3, 0));
  }
  if (volume > 0) tetrahedron = turned_inside_out(tetrahedron);
  check_class("corners on faces", tetrahedron, cube, Relation::inside);
  tetrahedron.vertices[0][0] = -0x1p-60;
  check_class("a corner beyond a face", tetrahedron, cube, Relation::overlapping);
}

TEST_CASE("parts without an inside") {
  const Solid cube = box({0, 0, 0}, {1, 1, 1});
  const auto sheet = [](double z, double low, double high) {
    Solid one;
    one.vertices = {{low, low, z}, {high, low, z}, {low, high, z}};
    one.faces = {{0, 1, 2}};
    return one;
  };
  check_class("a sheet above", sheet(2, 0, 1), cube, Relation::clear);
  check_class("a sheet on a side", sheet(1, 0.25, 0.5), cube, Relation::touching);
  check_class("a sheet within", sheet(0.5, 0.25, 0.5), cube, Relation::inside);
  check_class("a sheet within, up to the sides", sheet(0.5, 0, 1), cube, Relation::inside);
  check_class("a sheet through the sides", sheet(0.5, 0.25, 4), cube, Relation::crossing);
  check_class("two sheets", sheet(0, 0, 1), sheet(0, 0.25, 4), Relation::touching);
  Solid upright;
  upright.vertices = {{0.25, 0.25, -1}, {0.25, 0.25, 1}, {0.5, 0.25, 1}};
  upright.faces = {{0, 1, 2}};
  check_class("two sheets that pierce", upright, sheet(0, 0, 1), Relation::crossing);
  check_class("inside out", turned_inside_out(box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})), cube, Relation::inside);
  check_class("both inside out", turned_inside_out(box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})), turned_inside_out(cube),
              Relation::clear);
  const auto wire = [](const Point& from, const Point& to) {
    Solid one;
    one.vertices = {from, to};
    one.wires = {{0, 1}};
    return one;
  };
  check_class("a wire within", wire({0, 0.5, 0.5}, {1, 0.25, 1}), cube, Relation::inside);
  check_class("a wire on a side", wire({0.25, 0, 0.5}, {0.5, 0, 1}), cube, Relation::touching);
  check_class("a wire through two edges", wire({-1, -1, 0.5}, {2, 2, 0.5}), cube, Relation::crossing);
  check_class("a wire past an edge", wire({-1, 1, 0.5}, {1, -1, 0.5}), cube, Relation::touching);
  Solid point;
  point.vertices = {{0.5, 0.5, 0.5}};
  point.points = {0};
  check_class("a point within", point, cube, Relation::inside);
  point.vertices = {{0.5, 0.5, 1}};
  check_class("a point on a side", point, cube, Relation::touching);
}

namespace {

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

Cells random_cells(seeded::Rng& random, int size) {
  Cells cells;
  const int blocks = random.between(1, 3);
  for (int i = 0; i < blocks; ++i) {
    Cell low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = random.between(0, size - 1);
      high[k] = random.between(low[k], size - 1);
    }
    const bool removes = random.one_in(4);
    for (int x = low[0]; x <= high[0]; ++x) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int z = low[2]; z <= high[2]; ++z) {
          if (removes) {
            cells.erase({x, y, z});
          } else {
            cells.insert({x, y, z});
          }
        }
      }
    }
  }
  if (cells.empty()) cells.insert({0, 0, 0});
  return cells;
}

/// The sides of the cells that have no cell beyond them, with diagonals of both sorts. Vertices are joined only within
/// a cell's side where `split`; else all at one point are one.
Solid surface_of(const Cells& cells, seeded::Rng& random, const std::array<std::array<double, 8>, 3>& at) {
  Solid solid;
  std::map<Cell, MeshIndex> numbers;
  const auto vertex = [&](const Cell& p) {
    const auto [found, is_new] = numbers.emplace(p, static_cast<MeshIndex>(solid.vertices.size()));
    if (is_new) {
      solid.vertices.push_back({at[0][static_cast<std::size_t>(p[0])], at[1][static_cast<std::size_t>(p[1])],
                                at[2][static_cast<std::size_t>(p[2])]});
    }
    return found->second;
  };
  for (const Cell& cell : cells) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const int side : {0, 1}) {
        Cell beyond = cell;
        beyond[k] += 2 * side - 1;
        if (cells.count(beyond) != 0) continue;
        Cell corner = cell;
        corner[k] += side;
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        std::array<MeshIndex, 4> around{};
        for (std::size_t n = 0; n < 4; ++n) {
          Cell p = corner;
          p[i] += n == 1 || n == 2 ? 1 : 0;
          p[j] += n >= 2 ? 1 : 0;
          around[side == 1 ? n : 3 - n] = vertex(p);
        }
        const auto& [a, b, c, d] = around;
        if (random.one_in(2)) {
          solid.faces.push_back({a, b, c});
          solid.faces.push_back({a, c, d});
        } else {
          solid.faces.push_back({a, b, d});
          solid.faces.push_back({b, c, d});
        }
      }
    }
  }
  return solid;
}

double determinant(const std::array<std::array<double, 3>, 3>& m) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += m[0][k] * (m[1][(k + 1) % 3] * m[2][(k + 2) % 3] - m[1][(k + 2) % 3] * m[2][(k + 1) % 3]);
  }
  return sum;
}

Relation class_of_cells(const Cells& a, const Cells& b) {
  const auto has_all = [](const Cells& whole, const Cells& some) {
    return std::includes(whole.begin(), whole.end(), some.begin(), some.end());
  };
  if (a == b) return Relation::same;
  if (has_all(b, a)) return Relation::inside;
  if (has_all(a, b)) return Relation::around;
  bool touch = false;
  for (const Cell& x : a) {
    if (b.count(x) != 0) return Relation::overlapping;
    for (int d = 0; d < 27; ++d) {
      touch = touch || b.count({x[0] + d % 3 - 1, x[1] + d / 3 % 3 - 1, x[2] + d / 9 - 1}) != 0;
    }
  }
  return touch ? Relation::touching : Relation::clear;
}

}  // namespace

TEST_CASE("the classes of polycubes are those of their sets of cells") {
  seeded::Rng random(2024);
  std::map<Relation, std::size_t> counts;
  for (std::size_t round = 0; round < effort(1200); ++round) {
    const int size = random.between(2, 4);
    std::array<std::array<double, 8>, 3> at{};
    for (auto& axis : at) {
      double x = random.symmetric();
      for (double& one : axis) one = x, x += 0x1p-20 + random.unit() * random.unit();
    }
    const Cells one = random_cells(random, size);
    Cells two = random_cells(random, size);
    if (random.one_in(6)) two = one;
    if (random.one_in(6)) {
      for (const Cell& cell : one) {
        if (random.one_in(2)) two.insert(cell);
      }
    }
    if (random.one_in(4)) {
      Cells moved;
      const int by = random.between(0, 3);
      for (const Cell& cell : two) moved.insert({cell[0] + by, cell[1], cell[2]});
      two = moved;
    }
    const Relation right = class_of_cells(one, two);
    const bool is_turned =
        random.one_in(2);  // whole numbers, times a matrix with a determinant above 0: exact in doubles
    std::array<std::array<double, 3>, 3> matrix{};
    while (is_turned && determinant(matrix) <= 0) {
      for (auto& row : matrix)
        row = {1.0 * random.between(-3, 3), 1.0 * random.between(-3, 3), 1.0 * random.between(-3, 3)};
    }
    for (std::size_t k = 0; is_turned && k < 3; ++k) at[k] = {0, 1, 2, 3, 4, 5, 6, 7};
    Solid a = surface_of(one, random, at), b = surface_of(two, random, at);
    for (Solid* const solid : {&a, &b}) {
      for (Point& p : solid->vertices) {
        const Point x = p;
        for (std::size_t k = 0; is_turned && k < 3; ++k) {
          p[k] = matrix[k][0] * x[0] + matrix[k][1] * x[1] + matrix[k][2] * x[2];
        }
      }
    }
    CAPTURE(round, one.size(), two.size(), is_turned);
    CHECK(name_of(class_between(a, b)) == name_of(right));
    ++counts[right];
  }
  for (const Relation sort : {Relation::clear, Relation::touching, Relation::overlapping, Relation::inside,
                              Relation::around, Relation::same}) {
    CAPTURE(name_of(sort));
    CHECK((counts[sort] > 0 || !whole_effort("each class of polycubes is seen")));
  }
}

TEST_CASE("faces without an area lie as their edges do, and parts that are not solid are counted") {
  const Solid cube = box({0, 0, 0}, {4, 4, 4});
  const auto needle = [](double from, double to) {
    Solid solid;
    for (const double at : {from, (from + to) / 2, to}) solid.vertices.push_back({at, 2, 2});
    solid.faces = {{0, 1, 2}};
    return solid;
  };
  CHECK(class_between(needle(1, 3), cube) == Relation::inside);
  CHECK(class_between(cube, needle(1, 3)) == Relation::around);
  CHECK(class_between(needle(-2, 6), cube) == Relation::crossing);
  CHECK(class_between(needle(1, 6), cube) == Relation::crossing);
  CHECK(class_between(needle(4, 6), cube) == Relation::touching);
  CHECK(class_between(needle(0, 4), cube) == Relation::inside);
  CHECK(class_between(needle(5, 6), cube) == Relation::clear);

  const Solid both = joined(cube, needle(1, 3));
  MeshElements elements;
  elements.vertex_count = both.vertices.size();
  elements.faces = both.faces;
  std::vector<double> x;
  for (const Point& vertex : both.vertices) x.insert(x.end(), vertex.begin(), vertex.end());
  std::vector<std::uint32_t> parts(cube.vertices.size(), 0);
  parts.resize(both.vertices.size(), 1);
  CHECK(mesh::group_relations(Mesh(elements), {x, 3}, parts, 2).without_inside == 1);
  const std::atomic<bool> stop = true;
  CHECK_THROWS_AS(mesh::group_relations(Mesh(elements), {x, 3}, parts, 2, {1, &stop}), Stopped);
}
