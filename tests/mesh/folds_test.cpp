// Elements that share vertices and fold onto each other: at rest, in motion, and the test in doubles that leaves most
// neighbours out. Faces are judged by integers, from the definition: the corners of the common part of two triangles.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "mesh/folds.hpp"
#include "mesh/scenes.hpp"
#include "numbers/integers/exact_number.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Whole = std::int64_t;
using Place = std::array<Whole, 3>;

/// The point p / w, w > 0.
struct Fraction {
  Place p;
  Whole w = 1;
};

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Whole dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
bool is_zero(const Place& a) { return a == Place{0, 0, 0}; }

/// w times the vector from a to the point.
Place from(const Place& a, const Fraction& x) {
  return {x.p[0] - x.w * a[0], x.p[1] - x.w * a[1], x.p[2] - x.w * a[2]};
}

using Triangle = std::array<Place, 3>;

bool is_in(const Fraction& x, const Triangle& f) {
  const Place n = cross(minus(f[1], f[0]), minus(f[2], f[0]));
  if (dot(n, from(f[0], x)) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(cross(minus(f[(i + 1) % 3], f[i]), from(f[i], x)), n) < 0) return false;
  }
  return true;
}

/// Whether the point is on the segment a b, which may be a point.
bool is_on(const Fraction& x, const Place& a, const Place& b) {
  return is_zero(cross(from(a, x), minus(b, a))) && dot(from(a, x), from(b, x)) <= 0;
}

/// Adds the single point that the lines a b and c d share, unless they are parallel or pass each other.
void add_crossing(const Place& a, const Place& b, const Place& c, const Place& d, std::vector<Fraction>& points) {
  const Place n = cross(minus(b, a), minus(d, c));
  if (is_zero(n) || dot(n, minus(c, a)) != 0) return;
  const Whole w = dot(n, n), s = dot(cross(minus(c, a), minus(d, c)), n);  // at a + (s / w) (b - a)
  points.push_back({{w * a[0] + s * (b[0] - a[0]), w * a[1] + s * (b[1] - a[1]), w * a[2] + s * (b[2] - a[2])}, w});
}

/// Adds the single point of the line a b in the triangle's plane.
void add_passage(const Place& a, const Place& b, const Triangle& f, std::vector<Fraction>& points) {
  const Place n = cross(minus(f[1], f[0]), minus(f[2], f[0]));
  Whole w = dot(n, minus(b, a)), s = dot(n, minus(f[0], a));
  if (w == 0) return;
  if (w < 0) w = -w, s = -s;
  points.push_back({{w * a[0] + s * (b[0] - a[0]), w * a[1] + s * (b[1] - a[1]), w * a[2] + s * (b[2] - a[2])}, w});
}

/// Whether two triangles with an area have a common point outside the hull of the vertices that they share. The common
/// part is convex; its corners are corners of one, or on the border of one and the border or plane of the other.
bool overlap(const Triangle& a, const Triangle& b, const std::vector<Place>& shared) {
  std::vector<Fraction> points;
  for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    for (std::size_t i = 0; i < 3; ++i) {
      points.push_back({(*one)[i]});
      add_passage((*one)[i], (*one)[(i + 1) % 3], *other, points);
      for (std::size_t j = 0; j < 3; ++j) {
        add_crossing((*one)[i], (*one)[(i + 1) % 3], (*other)[j], (*other)[(j + 1) % 3], points);
      }
    }
  }
  return std::any_of(points.begin(), points.end(), [&](const Fraction& x) {
    if (!is_in(x, a) || !is_in(x, b)) return false;
    if (shared.empty()) return true;
    return !is_on(x, shared.front(), shared.back());
  });
}

}  // namespace

TEST_CASE("two faces overlap beyond their common vertices exactly when an edge and a face intersect or fold") {
  seeded::Rng random(303);
  std::map<std::pair<std::size_t, bool>, int> seen;  // by the number of common vertices, and the verdict
  int folded_alone = 0;
  for (std::size_t round = 0; round < effort(6000); ++round) {
    const auto vertices = static_cast<std::size_t>(random.between(4, 7));
    const Whole most = random.one_in(2) ? 2 : 3;
    std::vector<Place> places(vertices);
    std::vector<double> x;
    for (Place& place : places) {
      for (Whole& k : place) {
        k = random.between(0, static_cast<int>(most));
        x.push_back(static_cast<double>(k));
      }
    }
    MeshElements elements;
    elements.vertex_count = vertices;
    elements.points.emplace();
    std::set<std::array<MeshIndex, 3>> taken;
    for (int i = 0; i < 3; ++i) {
      std::array<MeshIndex, 3> face;
      for (MeshIndex& corner : face) corner = static_cast<MeshIndex>(random.below(vertices));
      std::array<MeshIndex, 3> sorted = face;
      std::sort(sorted.begin(), sorted.end());
      if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !taken.insert(sorted).second) continue;
      const Place n = cross(minus(places[face[1]], places[face[0]]), minus(places[face[2]], places[face[0]]));
      if (!is_zero(n)) elements.faces.push_back(face);  // a face without an area has no definition of its own here
    }
    bool any = false;
    for (std::size_t i = 0; i < elements.faces.size(); ++i) {
      for (std::size_t j = i + 1; j < elements.faces.size(); ++j) {
        const auto &a = elements.faces[i], &b = elements.faces[j];
        std::vector<Place> shared;
        for (const MeshIndex corner : a) {
          if (std::count(b.begin(), b.end(), corner) != 0) shared.push_back(places[corner]);
        }
        const bool verdict =
            overlap({places[a[0]], places[a[1]], places[a[2]]}, {places[b[0]], places[b[1]], places[b[2]]}, shared);
        ++seen[{shared.size(), verdict}];
        any = any || verdict;
      }
    }
    const Mesh mesh(elements);
    const auto all = intersections(mesh, {x, 3});
    CAPTURE(round, x, elements.faces);
    REQUIRE(any == !all.empty());
    REQUIRE(any == intersects(mesh, {x, 3}));
    const bool folds = std::any_of(all.begin(), all.end(),
                                   [](const Intersection& one) { return one.sort == IntersectionSort::folds; });
    const bool others = std::any_of(all.begin(), all.end(),
                                    [](const Intersection& one) { return one.sort != IntersectionSort::folds; });
    folded_alone += folds && !others ? 1 : 0;
    // A step from here begins with a contact, unless edges merely pierce.
    if (folds) REQUIRE_FALSE(first_contact(mesh, {x, 3}, {x, 3}).at_start.empty());
  }
  for (const auto& [key, count] : seen) {
    std::printf("%zu common vertices, %s: %d pairs of faces\n", key.first, key.second ? "overlap" : "apart", count);
  }
  CHECK((seen.size() == 6 || !whole_effort("each number of common vertices with each verdict")));
  CHECK((folded_alone > 0 || !whole_effort("meshes in which folds are all that is found")));
}

TEST_CASE("a fold at rest is a contact at the start of a step, along wires and in the plane too") {
  seeded::Rng random(304);
  std::map<std::string, int> folded;
  for (std::size_t round = 0; round < effort(400); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 12);
      for (double& x : scene.x0) x = random.between(-1, 1);
      if (random.one_in(2)) add_separation(random, scene);
      scene.elements.points.emplace();  // without loose points, which touch often
      const Mesh mesh(scene.elements);
      const auto all = intersections(mesh, scene.start());
      CAPTURE(round, scene.name);
      if (std::none_of(all.begin(), all.end(), [](const auto& one) { return one.sort == IntersectionSort::folds; })) {
        continue;
      }
      ++folded[scene.name];
      REQUIRE_FALSE(first_contact(mesh, scene.start(), scene.start()).at_start.empty());
    }
  }
  CHECK((folded.size() == kLayouts.size() || !whole_effort("a fold in each sort of scene")));
}

TEST_CASE("the end of a rod that swings through its own next segment is met at the exact time") {
  MeshElements elements;
  elements.vertex_count = 3;
  elements.edges = {{0, 1}, {1, 2}};
  elements.radii = {0.125, 0.125, 0.125};
  const Mesh mesh(elements);
  const std::vector<double> x0 = {0, 0, 0, 3, 0, 0, 3, 2, 0}, x1 = {0, 0, 0, 3, 0, 0, 1, -4, 0};
  const MeshPair pair{Kind::point_edge, 2, 0};
  REQUIRE(mesh.may_collide(pair));
  CHECK(mesh.separation(pair).distance == 0);
  const FirstContact found = first_contact(mesh, {x0, 3}, {x1, 3});
  REQUIRE(found.contact);
  CHECK(found.at_start.empty());
  CHECK(found.toi < found.toi_upper);  // 1/3, which is no double
  CHECK(std::fma(3, found.toi, -1) < 0);
  CHECK(std::fma(3, found.toi_upper, -1) > 0);
  REQUIRE(found.earliest.size() == 1);
  CHECK(found.earliest[0].pair == pair);
  CHECK(candidates(mesh, {x0, 3}, {x1, 3}) == std::vector<MeshPair>{pair});

  const FreeStep step = free_step(mesh, {x0, 3}, {x1, 3});
  CHECK(step.outcome == StepOutcome::shortened);
  CHECK(step.length == found.toi);

  // It stops beside the segment, or a rule excludes the pair, or it has a separation of its own.
  std::vector<double> beside = x1;
  beside[7] = 0x1p-40;
  CHECK(first_contact(mesh, {x0, 3}, {beside, 3}).free());
  beside[7] = 0;
  CHECK(first_contact(mesh, {x0, 3}, {beside, 3}).toi == 1);
  elements.rules.element_pairs = {pair};
  CHECK(first_contact(Mesh(elements), {x0, 3}, {x1, 3}).free());
  elements.rules.element_pairs.clear();
  elements.pair_separations = {{pair, 1}};
  CHECK(first_contact(Mesh(elements), {x0, 3}, {x1, 3}).toi < found.toi);
}

TEST_CASE("a longer segment that swings onto a shorter one is met too, and a star of wires pair by pair") {
  MeshElements elements;
  elements.vertex_count = 4;
  elements.edges = {{0, 1}, {0, 2}, {0, 3}};
  const std::vector<double> x0 = {0, 0, 0, 2, 0, 0, 0, 8, 0, 0, 0, 5};
  std::vector<double> x1 = x0;
  x1[6] = 8, x1[7] = -8;  // vertex 2 passes the line of edge 0-1 at t = 1/2, where x = 4
  const Mesh mesh(elements);
  const FirstContact found = first_contact(mesh, {x0, 3}, {x1, 3});
  REQUIRE(found.earliest.size() == 1);
  CHECK(found.earliest[0].pair == MeshPair{Kind::point_edge, 1, 1});
  CHECK(found.toi == 0.5);
  int pairs = 0;
  for (MeshIndex v = 0; v < 4; ++v) {
    for (MeshIndex e = 0; e < 3; ++e) pairs += mesh.may_collide({Kind::point_edge, v, e}) ? 1 : 0;
  }
  CHECK(pairs == 6);
}

TEST_CASE("closing folds of faces are met through the pairs of a corner and a face, and of two edges") {
  MeshElements elements;
  elements.vertex_count = 4;
  elements.faces = {{0, 1, 2}, {1, 0, 3}};
  const Mesh mesh(elements);
  const std::vector<double> x0 = {0, 0, 0, 6, 0, 0, 0, 6, 0, 2, -2, 0};
  std::vector<double> x1 = x0;
  x1[10] = 2;  // in the plane, over the common edge
  CHECK(first_contact(mesh, {x0, 3}, {x1, 3}).toi == 0.5);
  x1[11] = 1;  // above it
  CHECK(first_contact(mesh, {x0, 3}, {x1, 3}).free());
  std::vector<double> above = x0;
  above[10] = 2, above[11] = 3;
  x1[11] = -1;  // down through the other face
  const FirstContact found = first_contact(mesh, {above, 3}, {x1, 3});
  CHECK(found.toi == 0.75);
  REQUIRE(found.earliest.size() == 1);
  CHECK(found.earliest[0].pair == MeshPair{Kind::vertex_face, 3, 0});
  CHECK(intersections(mesh, {x0, 3}).empty());
  std::vector<double> folded = x0;
  folded[10] = 2;
  const auto all = intersections(mesh, {folded, 3});
  REQUIRE(all.size() == 2);  // both edges of vertex 3 lie in face 0
  CHECK(all[0].sort == IntersectionSort::folds);
  CHECK(all[0].weights_first == std::array<double, 3>{0, 1, 0});  // at the corner that is not shared
  CHECK(first_contact(mesh, {folded, 3}, {folded, 3}).at_start.size() == 1);
}

TEST_CASE("whether the start was asked about is a part of the answer") {
  MeshElements elements;  // an edge through a face
  elements.vertex_count = 5;
  elements.faces = {{0, 1, 2}};
  elements.edges = {{3, 4}};
  const Mesh mesh(elements);
  const std::vector<double> x = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 1};
  FirstContactOptions options;
  const FirstContact unasked = first_contact(mesh, {x, 3}, {x, 3}, options);
  CHECK(unasked.free());
  CHECK_FALSE(unasked.start_checked);
  options.check_start = true;
  const FirstContact asked = first_contact(mesh, {x, 3}, {x, 3}, options);
  CHECK(asked.start_checked);
  CHECK_FALSE(asked.free());
  REQUIRE(asked.start_intersections.size() == 1);
  CHECK(asked.start_intersections[0].sort == IntersectionSort::pierces);
  FreeStepOptions step;
  CHECK(free_step(mesh, {x, 3}, {x, 3}, step).outcome == StepOutcome::whole);
  step.check_start = true;
  const FreeStep refused = free_step(mesh, {x, 3}, {x, 3}, step);
  CHECK(refused.outcome == StepOutcome::intersects_at_start);
  CHECK(refused.length == 0);
  CHECK(refused.positions == x);
}

// The bounds of certainly_unfolded are attacked where they matter: directions that nearly lie in the other element.
TEST_CASE("neighbours that are left out by doubles do not fold, and most are left out") {
  using numbers::Exact;
  using Point = std::array<Exact, 3>;
  const auto difference = [](const Vec3& a, const Vec3& b) {
    return Point{Exact(b.x) - Exact(a.x), Exact(b.y) - Exact(a.y), Exact(b.z) - Exact(a.z)};
  };
  const auto times = [](const Point& a, const Point& b) {
    return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto scalar = [](const Point& a, const Point& b) {
    return numbers::sign_of(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  };
  const auto zero = [](const Point& a) {
    return numbers::is_zero(a[0]) && numbers::is_zero(a[1]) && numbers::is_zero(a[2]);
  };
  seeded::Rng random(305);
  int folded = 0, left_out = 0, ordinary = 0, ordinary_left_out = 0;
  for (std::size_t round = 0; round < effort(400000); ++round) {
    const int sort = random.between(0, 3);
    const int exponent = sort == 0 ? random.between(-150, 150) : random.between(-1000, 990);
    const double offset = random.one_in(2) ? 0 : 1;
    const auto any = [&] {  // differences and small sums of such coordinates are exact
      Vec3 at;
      for (double* k : {&at.x, &at.y, &at.z})
        *k = std::ldexp(offset + std::rint(std::ldexp(random.symmetric(), 49)) * 0x1p-49, exponent);
      return at;
    };
    const Vec3 shared = any();
    const std::array<Vec3, 2> others = {any(), any()};
    const std::size_t count = random.one_in(2) ? 1 : 2;
    Vec3 end = any();
    if (sort > 0) {  // a point of the other element's cone, or a little beside it
      const double s = sort == 1 ? random.between(0, 2) : random.unit();
      const double t = count == 1 ? 0 : sort == 1 ? random.between(0, 1) : random.unit();
      const auto mix = [&](double v, double a, double b) {
        double at = v + s * (a - v) + t * (b - v);
        if (sort < 3) return at;
        for (int ulps = random.between(0, 2); ulps > 0; --ulps) {
          at = std::nextafter(at, random.one_in(2) ? INFINITY : -INFINITY);
        }
        return at;
      };
      end.x = mix(shared.x, others[0].x, others[1].x);
      end.y = mix(shared.y, others[0].y, others[1].y);
      end.z = mix(shared.z, others[0].z, others[1].z);
    }
    const bool out = mesh::certainly_unfolded(shared, end, others, count);
    left_out += out ? 1 : 0;
    if (sort == 0) ++ordinary, ordinary_left_out += out ? 1 : 0;
    const Point to = difference(shared, end), a = difference(shared, others[0]), b = difference(shared, others[1]);
    const auto along = [&](const Point& other) { return zero(times(to, other)) && scalar(to, other) > 0; };
    bool folds = along(a) || (count == 2 && along(b));
    if (count == 2 && !folds) {
      const Point n = times(a, b);
      folds =
          !zero(n) && !zero(to) && scalar(n, to) == 0 && scalar(times(a, to), n) >= 0 && scalar(times(to, b), n) >= 0;
    }
    folded += folds ? 1 : 0;
    CAPTURE(round, count, shared.x, shared.y, shared.z, end.x, end.y, end.z);
    REQUIRE_FALSE((out && folds));
  }
  std::printf("%d folds, %d left out; of ordinary neighbours %d of %d\n", folded, left_out, ordinary_left_out,
              ordinary);
  CHECK((folded > 10000 || !whole_effort("folds among neighbours")));
  CHECK(100 * ordinary_left_out >= 99 * ordinary);
}

TEST_CASE("a mesh of which nothing may collide says so") {
  MeshElements elements;
  CHECK_FALSE(Mesh(elements).has_pairs());
  elements.vertex_count = 5;
  elements.faces = {{0, 1, 2}};
  elements.points = std::vector<MeshIndex>{};
  CHECK_FALSE(Mesh(elements).has_pairs());
  elements.edges = {{3, 4}};
  CHECK(Mesh(elements).has_pairs());
  elements.rules.groups = {0, 0, 0, 0, 0};
  CHECK(Mesh(elements).has_pairs());
  elements.rules.group_pairs = {{0, 0}};
  CHECK_FALSE(Mesh(elements).has_pairs());
  elements.rules.groups = {0, 1, 2, 3, 4};
  elements.rules.group_pairs = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
  CHECK_FALSE(Mesh(elements).has_pairs());
  elements.rules.group_pairs.pop_back();
  CHECK(Mesh(elements).has_pairs());
  elements.rules.groups = {0, 0, 0, 7, 7};
  elements.rules.group_pairs = {{0, 0}};
  CHECK(Mesh(elements).has_pairs());
  elements.rules.group_pairs = {{0, 0}, {7, 0}};
  CHECK(Mesh(elements).has_pairs());
  elements.rules.group_pairs = {{0, 0}, {7, 0}, {0, 7}, {0, 7}};
  CHECK(Mesh(elements).has_pairs());
  elements.rules.group_pairs = {{0, 0}, {7, 0}, {7, 7}, {8, 8}};
  CHECK_FALSE(Mesh(elements).has_pairs());
  elements.rules.group_rule = GroupRule::only_listed;
  CHECK(Mesh(elements).has_pairs());
  elements.rules.group_pairs = {{0, 8}};
  CHECK_FALSE(Mesh(elements).has_pairs());
}
