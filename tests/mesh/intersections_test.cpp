// Intersections at rest are those that exact orientations of points show, element by element.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "mesh/scenes.hpp"
#include "numbers/integers/exact_number.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using numbers::Exact;

namespace {

using Point = std::array<Exact, 3>;

Point exact_point(const Vec3& v) { return {Exact(v.x), Exact(v.y), Exact(v.z)}; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Exact dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
int sign(const Exact& x) { return numbers::sign_of(x); }
bool is_zero(const Point& p) { return sign(p[0]) == 0 && sign(p[1]) == 0 && sign(p[2]) == 0; }
int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  return sign(dot(cross(minus(b, a), minus(c, a)), minus(d, a)));
}

bool on_segment(const Point& p, const Point& a, const Point& b) {
  return is_zero(cross(minus(p, a), minus(b, a))) && sign(dot(minus(p, a), minus(p, b))) <= 0;
}

/// Whether two segments share a point, and whether they cross in their interiors at a single point.
std::pair<bool, bool> segments(const Point& a, const Point& b, const Point& c, const Point& d) {
  const bool end = on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b);
  if (end) return {true, false};
  if (orientation(a, b, c, d) != 0) return {false, false};
  // In one plane with the normal n: each segment's ends are strictly on both sides of the other one's line.
  const Point n = cross(minus(b, a), minus(d, c));
  if (is_zero(n)) return {false, false};
  const auto side = [&](const Point& p, const Point& q, const Point& r) {
    return sign(dot(cross(minus(q, p), minus(r, p)), n));
  };
  const bool crosses = side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
  return {crosses, crosses};
}

/// Whether a point of the triangle's plane is in it; the triangle may be flat.
bool in_triangle(const Point& p, const std::array<Point, 3>& f) {
  const Point n = cross(minus(f[1], f[0]), minus(f[2], f[0]));
  if (is_zero(n)) return on_segment(p, f[0], f[1]) || on_segment(p, f[1], f[2]) || on_segment(p, f[2], f[0]);
  if (sign(dot(n, minus(p, f[0]))) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (sign(dot(cross(minus(f[(i + 1) % 3], f[i]), minus(p, f[i])), n)) < 0) return false;
  }
  return true;
}

std::pair<bool, bool> segment_and_triangle(const Point& a, const Point& b, const std::array<Point, 3>& f) {
  if (in_triangle(a, f) || in_triangle(b, f)) return {true, false};
  for (std::size_t i = 0; i < 3; ++i) {
    if (segments(a, b, f[i], f[(i + 1) % 3]).first) return {true, false};
  }
  if (orientation(f[0], f[1], f[2], a) * orientation(f[0], f[1], f[2], b) >= 0) return {false, false};
  const int side[3] = {orientation(a, b, f[0], f[1]), orientation(a, b, f[1], f[2]), orientation(a, b, f[2], f[0])};
  const bool pierces = side[0] == side[1] && side[1] == side[2];
  return {pierces, pierces};
}

/// Whether a segment from the first corner of an element has a point of it beyond that corner: the direction of its
/// other end is in the cone of the element's.
bool folds(const Point& shared, const Point& end, const std::vector<Point>& others) {
  const Point to = minus(end, shared);
  const auto along = [&](const Point& other) {
    return is_zero(cross(to, minus(other, shared))) && sign(dot(to, minus(other, shared))) > 0;
  };
  if (others.size() == 1) return along(others[0]);
  const Point a = minus(others[0], shared), b = minus(others[1], shared), n = cross(a, b);
  if (is_zero(n)) return along(others[0]) || along(others[1]);
  return !is_zero(to) && sign(dot(n, to)) == 0 && sign(dot(cross(a, to), n)) >= 0 && sign(dot(cross(to, b), n)) >= 0;
}

using Key = std::tuple<MeshElement, MeshElement, MeshIndex, MeshIndex, IntersectionSort>;
using Sort = IntersectionSort;

std::set<Key> brute_force(const Scene& scene) {
  std::set<Key> found;
  const Parts parts = parts_of(scene.elements);
  const auto at = [&](MeshIndex v) { return exact_point(scene.corner(scene.x0, v)); };
  const auto is_wire = [&](MeshIndex e) { return std::count(parts.wires.begin(), parts.wires.end(), e) != 0; };
  const auto add = [&](MeshElement first, MeshElement second, MeshIndex i, MeshIndex j, std::pair<bool, bool> verdict) {
    if (verdict.first) found.insert({first, second, i, j, verdict.second ? Sort::pierces : Sort::touches});
  };
  const auto add_fold = [&](MeshElement second, MeshIndex i, MeshIndex j, const auto& corners) {
    const auto& e = parts.edges[i];
    const bool first = std::count(corners.begin(), corners.end(), e[0]) != 0;
    if (first && std::count(corners.begin(), corners.end(), e[1]) != 0) return;
    std::vector<Point> others;
    for (const MeshIndex corner : corners) {
      if (corner != e[first ? 0 : 1]) others.push_back(at(corner));
    }
    if (!folds(at(e[first ? 0 : 1]), at(e[first ? 1 : 0]), others)) return;
    found.insert({MeshElement::edge, second, i, j, Sort::folds});
  };
  using E = MeshElement;
  const bool in_space = scene.elements.dimension == 3;
  for (MeshIndex i = 0; i < parts.edges.size(); ++i) {
    const auto& e = parts.edges[i];
    for (MeshIndex j = 0; j < scene.elements.faces.size(); ++j) {
      const auto& f = scene.elements.faces[j];
      if (std::count(f.begin(), f.end(), e[0]) + std::count(f.begin(), f.end(), e[1]) != 0) {
        add_fold(E::face, i, j, f);
        continue;
      }
      add(E::edge, E::face, i, j, segment_and_triangle(at(e[0]), at(e[1]), {at(f[0]), at(f[1]), at(f[2])}));
    }
    for (MeshIndex j = i + 1; j < parts.edges.size(); ++j) {
      const auto& o = parts.edges[j];
      if (in_space && !is_wire(i) && !is_wire(j)) continue;
      if (e[0] == o[0] || e[0] == o[1] || e[1] == o[0] || e[1] == o[1]) {
        add_fold(E::edge, i, j, o);
        continue;
      }
      add(E::edge, E::edge, i, j, segments(at(e[0]), at(e[1]), at(o[0]), at(o[1])));
    }
  }
  for (const MeshIndex p : parts.points) {
    for (MeshIndex j = 0; j < scene.elements.faces.size(); ++j) {
      const auto& f = scene.elements.faces[j];
      add(E::vertex, E::face, p, j, {in_triangle(at(p), {at(f[0]), at(f[1]), at(f[2])}), false});
    }
    for (MeshIndex j = 0; j < parts.edges.size(); ++j) {
      if (in_space && !is_wire(j)) continue;
      add(E::vertex, E::edge, p, j, {on_segment(at(p), at(parts.edges[j][0]), at(parts.edges[j][1])), false});
    }
    for (const MeshIndex q : parts.points) {
      if (p < q) add(E::vertex, E::vertex, p, q, {is_zero(minus(at(p), at(q))), false});
    }
  }
  return found;
}

}  // namespace

TEST_CASE("intersections are those of all elements by brute force") {
  seeded::Rng random(201);
  std::map<std::tuple<MeshElement, MeshElement, Sort>, int> seen;
  for (std::size_t round = 0; round < effort(150); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 24);
      if (random.one_in(2)) {  // everything of few bits: corners in faces, edges through corners
        for (double& x : scene.x0) x = random.between(-2, 2);
      }
      MeshOptions options;
      options.threads = random.one_in(3) ? 2 : 1;
      std::set<Key> found;
      std::size_t common = 0;
      const Mesh mesh(scene.elements);
      const auto all = intersections(mesh, scene.start(), options);
      const Parts parts = parts_of(scene.elements);
      for (const Intersection& i : all) {
        if (i.sort == Sort::inside) continue;  // tests/mesh/inside_test.cpp
        ++common;
        found.insert({i.first_element, i.second_element, i.first, i.second, i.sort});
        ++seen[{i.first_element, i.second_element, i.sort}];
        // The two points that the weights describe are near each other.
        std::array<double, 3> a{}, b{};
        double size = 0;
        const auto accumulate = [&](std::array<double, 3>& sum, MeshIndex v, double weight) {
          const Vec3 at = scene.corner(scene.x0, v);
          const double x[3] = {at.x, at.y, at.z};
          for (std::size_t k = 0; k < 3; ++k) {
            sum[k] += weight * x[k];
            size = std::max(size, std::fabs(x[k]));
          }
        };
        const auto add = [&](std::array<double, 3>& sum, MeshElement element, MeshIndex number,
                             const std::array<double, 3>& weights) {
          for (std::size_t c = 0; c < 3; ++c) {
            if (element == MeshElement::vertex && c < 1) accumulate(sum, number, weights[c]);
            if (element == MeshElement::edge && c < 2) accumulate(sum, parts.edges[number][c], weights[c]);
            if (element == MeshElement::face) accumulate(sum, scene.elements.faces[number][c], weights[c]);
          }
        };
        add(a, i.first_element, i.first, i.weights_first);
        add(b, i.second_element, i.second, i.weights_second);
        for (std::size_t k = 0; k < 3; ++k) REQUIRE(std::fabs(a[k] - b[k]) <= 0x1p-46 * size);
      }
      CAPTURE(round, scene.name);
      REQUIRE(found.size() == common);
      REQUIRE(found == brute_force(scene));
      REQUIRE(intersects(mesh, scene.start(), options) == !all.empty());
    }
  }
  using E = MeshElement;
  for (const auto& sort : {std::tuple{E::edge, E::face, Sort::pierces}, std::tuple{E::edge, E::face, Sort::touches},
                           std::tuple{E::edge, E::face, Sort::folds}, std::tuple{E::edge, E::edge, Sort::pierces},
                           std::tuple{E::edge, E::edge, Sort::touches}, std::tuple{E::edge, E::edge, Sort::folds},
                           std::tuple{E::vertex, E::face, Sort::touches}, std::tuple{E::vertex, E::edge, Sort::touches},
                           std::tuple{E::vertex, E::vertex, Sort::touches}}) {
    CHECK((seen[sort] > 0 || !whole_effort("that each sort of intersection is seen")));
  }
}

TEST_CASE("one unit in the last place is the difference between piercing, touching and neither") {
  MeshElements elements;
  elements.vertex_count = 5;
  elements.faces = {{0, 1, 2}};
  elements.edges = {{3, 4}};
  std::vector<double> x = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 0.25, 0.25, -1};
  const Mesh mesh(elements);
  const auto verdict = [&]() -> std::string {
    for (const Intersection& found : intersections(mesh, {x, 3})) {
      if (found.second_element == MeshElement::face) return std::string(name_of(found.sort));
    }
    return "none";
  };
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  CHECK(verdict() == "pierces");
  x[14] = -kTiny;
  CHECK(verdict() == "pierces");
  x[14] = 0;
  CHECK(verdict() == "touches");
  x[14] = kTiny;
  CHECK(verdict() == "none");
  x[14] = -1;
  x[9] = x[12] = 0;
  CHECK(verdict() == "touches");
  x[9] = x[12] = -kTiny;
  CHECK(verdict() == "none");
}

TEST_CASE("the rules hold for intersections too") {
  MeshElements elements;
  elements.vertex_count = 6;
  elements.faces = {{0, 1, 2}};
  elements.edges = {{3, 4}};
  const std::vector<double> x = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 0.25, 0.25, -1, 0.25, 0.25, 0};
  CHECK(intersections(Mesh(elements), {x, 3}).size() == 3);  // the edge, the loose point, and both
  elements.rules.groups = {0, 0, 0, 1, 1, 2};
  elements.rules.group_pairs = {{1, 0}};
  CHECK(intersections(Mesh(elements), {x, 3}).size() == 2);
  elements.rules.element_pairs = {{Kind::vertex_face, 5, 0}};
  CHECK(intersections(Mesh(elements), {x, 3}).size() == 1);
}
