// The pairs of a motion's steps, compared with all pairs one by one in exact arithmetic, and the text of motions.
// SPDX-License-Identifier: MIT
#include "proofs/mesh_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/solve.hpp>

#include "io/times.hpp"
#include "numbers/integers/exact_number.hpp"
#include "proofs/proof.hpp"
#include "proofs/proof_text.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using numbers::Exact;
using proofs::MotionElements;
using proofs::MotionFrame;
using proofs::MotionPair;
using seeded::Rng;

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

using Corners = std::vector<std::uint32_t>;

double coordinate(const Vec3& x, int k) { return k == 0 ? x.x : k == 1 ? x.y : x.z; }

/// Whether two boxes are at most `distance` apart along each axis, with the differences of this number type.
template <class Number>
bool boxes_at_most_apart(const Corners& a, const Corners& b, const MotionFrame& start, const MotionFrame& end,
                         double distance) {
  for (int k = 0; k < 3; ++k) {
    const auto bounds = [&](const Corners& corners) {
      Number low(coordinate(start[corners[0]], k)), high = low;
      for (const auto* frame : {&start, &end}) {
        for (const std::uint32_t corner : corners) {
          const Number x(coordinate((*frame)[corner], k));
          if (x < low) low = x;
          if (high < x) high = x;
        }
      }
      return std::pair(low, high);
    };
    const auto [low_a, high_a] = bounds(a);
    const auto [low_b, high_b] = bounds(b);
    const Number d(distance);
    if (d < low_a - high_b || d < low_b - high_a) return false;
  }
  return true;
}

/// Whether the rules leave two elements, by the definition of CollisionRules.
bool are_asked(const CollisionRules& rules, const Corners& a, const Corners& b) {
  for (const std::uint32_t v : a) {
    for (const std::uint32_t w : b) {
      const std::uint32_t g = rules.groups[v], h = rules.groups[w];
      const auto names_both = [&](const auto& pair) { return pair == std::array{g, h} || pair == std::array{h, g}; };
      const bool listed = std::any_of(rules.group_pairs.begin(), rules.group_pairs.end(), names_both);
      if (listed == (rules.group_rule == GroupRule::only_listed)) return true;
    }
  }
  return false;
}

/// The pairs of the page, from all pairs.
template <class Number = Exact>
std::vector<MotionPair> all_pairs(const MotionElements& motion, const MotionFrame& start, const MotionFrame& end,
                                  double distance, const CollisionRules& rules = {}) {
  std::vector<Corners> points, edges, faces;
  for (const std::uint32_t vertex : motion.points) points.push_back({vertex});
  for (const auto& edge : motion.edges) edges.emplace_back(edge.begin(), edge.end());
  for (const auto& face : motion.faces) faces.emplace_back(face.begin(), face.end());
  const auto in_edge = [&](std::uint32_t vertex) {
    return std::any_of(edges.begin(), edges.end(),
                       [&](const Corners& edge) { return edge[0] == vertex || edge[1] == vertex; });
  };
  std::vector<MotionPair> pairs;
  const auto add = [&](Kind kind, std::size_t i, std::size_t j, const Corners& a, const Corners& b) {
    bool shared = false, moves = false;
    for (const std::uint32_t v : a) shared = shared || std::find(b.begin(), b.end(), v) != b.end();
    for (const auto* corners : {&a, &b}) {
      for (const std::uint32_t v : *corners) moves = moves || motion.fixed.empty() || motion.fixed[v] == 0;
    }
    if (!rules.groups.empty() && !are_asked(rules, a, b)) return;
    if (shared || !moves || !boxes_at_most_apart<Number>(a, b, start, end, distance)) return;
    pairs.push_back({kind, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) add(Kind::edge_edge, i, j, edges[i], edges[j]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < faces.size(); ++j) add(Kind::vertex_face, i, j, points[i], faces[j]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (in_edge(points[i][0])) continue;
    for (std::size_t j = 0; j < edges.size(); ++j) add(Kind::point_edge, i, j, points[i], edges[j]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if (!in_edge(points[i][0]) && !in_edge(points[j][0])) add(Kind::point_point, i, j, points[i], points[j]);
    }
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> wires;  // both ways
  for (const Corners& edge : edges) {
    const auto has_both = [&](const Corners& face) {
      return std::count(face.begin(), face.end(), edge[0]) > 0 && std::count(face.begin(), face.end(), edge[1]) > 0;
    };
    if (std::none_of(faces.begin(), faces.end(), has_both)) wires.insert({{edge[0], edge[1]}, {edge[1], edge[0]}});
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto joins = [&](std::uint32_t v) { return wires.count({points[i][0], v}) > 0; };
    for (std::size_t j = 0; j < edges.size(); ++j) {
      const bool is_fold = wires.count({edges[j][0], edges[j][1]}) > 0 && (joins(edges[j][0]) || joins(edges[j][1]));
      if (is_fold) add(Kind::point_edge, i, j, points[i], edges[j]);
    }
  }
  return pairs;
}

template <std::size_t N>
std::array<std::uint32_t, N> different_vertices(Rng& random, std::size_t count) {
  std::array<std::uint32_t, N> vertices{};
  for (std::size_t k = 0; k < N;) {
    vertices[k] = static_cast<std::uint32_t>(random.below(count));
    if (std::find(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(k), vertices[k]) ==
        vertices.begin() + static_cast<std::ptrdiff_t>(k)) {
      ++k;
    }
  }
  return vertices;
}

/// Points in another order than their vertices', edges and faces that share vertices, and some that are held. A third
/// of the vertices is in no edge.
MotionElements random_elements(Rng& random, std::size_t vertices, std::size_t edges, std::size_t faces) {
  MotionElements elements;
  elements.vertex_count = vertices;
  for (std::size_t v = vertices; v-- > 0;) {
    if (!random.one_in(5)) elements.points.push_back(static_cast<std::uint32_t>(v));
  }
  for (std::size_t i = 0; i < edges; ++i) elements.edges.push_back(different_vertices<2>(random, 2 * vertices / 3));
  for (std::size_t i = 0; i < faces; ++i) elements.faces.push_back(different_vertices<3>(random, vertices));
  if (!random.one_in(3)) {
    for (std::size_t v = 0; v < vertices; ++v) elements.fixed.push_back(random.one_in(2) ? 1 : 0);
  }
  return elements;
}

/// Rules of a few groups, or none.
CollisionRules random_rules(Rng& random, std::size_t vertices) {
  CollisionRules rules;
  if (random.one_in(2)) return rules;
  for (std::size_t v = 0; v < vertices; ++v) rules.groups.push_back(static_cast<std::uint32_t>(random.below(5)));
  rules.group_rule = random.one_in(2) ? GroupRule::only_listed : GroupRule::all_but_listed;
  for (auto count = 1 + random.below(8); count > 0; --count) {
    const auto g = static_cast<std::uint32_t>(random.below(5));
    rules.group_pairs.push_back({g, static_cast<std::uint32_t>(random.below(6))});
  }
  return rules;
}

/// A coordinate that is a few distances from 0 or from `origin`, exactly or but for the last bit.
double near_a_multiple(Rng& random, double distance, double origin) {
  double x = origin + random.between(-4, 4) * distance;
  if (random.one_in(3)) x = std::nextafter(x, random.one_in(2) ? kLargest : -kLargest);
  return std::clamp(x, -kLargest, kLargest);
}

std::string shown(const MotionPair& pair) {
  return std::to_string(static_cast<int>(pair.kind)) + ": " + std::to_string(pair.first) + ", " +
         std::to_string(pair.second);
}

}  // namespace

TEST_CASE("at most apart is decided exactly") {
  Rng random(7);
  std::size_t apart = 0, within = 0, equal = 0;
  const auto check = [&](double a, double b, double distance) {
    const Exact room = Exact(b) + Exact(distance) - Exact(a);
    CAPTURE(io::hexfloat(a), io::hexfloat(b), io::hexfloat(distance));
    REQUIRE(proofs::at_most_apart(a, b, distance) == (room.sign() >= 0));
    (room.sign() < 0 ? apart : room.sign() > 0 ? within : equal) += 1;
  };
  const double values[] = {0,    kTiny,    0x1p-1022, 0x1p-600, 0.1, 0.3, 1.0 / 3, 1, 1.5, 0x1p53, 0x1.fffffffffffffp52,
                           1e16, 0x1p1000, 1e308,     kLargest};
  for (const double distance : values) {
    for (const double b : values) {
      for (const double sign : {1.0, -1.0}) {
        const double sum = sign * b + distance;
        for (const double a : values) check(a, sign * b, distance), check(-a, sign * b, distance);
        if (!std::isfinite(sum)) continue;
        for (const double a : {sum, std::nextafter(sum, -kLargest), std::nextafter(sum, kLargest)}) {
          check(a, sign * b, distance);
        }
      }
    }
  }
  for (int i = 0; i < 20'000; ++i) {
    const double b = std::ldexp(random.symmetric(), random.between(-60, 60));
    const double distance = std::ldexp(random.unit(), random.between(-60, 60));
    const double sum = b + distance;
    check(sum, b, distance);
    check(std::nextafter(sum, -kLargest), b, distance);
    check(std::nextafter(sum, kLargest), b, distance);
  }
  CHECK(apart > 10'000);
  CHECK(within > 10'000);
  CHECK(equal > 100);
}

TEST_CASE("the pairs of a step are those of the page: boxes that are just at the distance, or a last bit beyond it") {
  Rng random(11);
  std::array<std::size_t, 5> kinds{};  // the last: folds
  std::size_t wrong_in_doubles = 0, ignored = 0;
  for (const double distance : {0.0, 1.0, 0.1, 1.0 / 3, 1e-300, kTiny, 3 * kTiny, 0x1p-1022, 1e300, kLargest / 2}) {
    const double step = distance > 0 ? distance : 0.7;
    for (const double origin : {0.0, 1.0, 0x1p52, -1e300, kLargest}) {
      for (int trial = 0; trial < 4; ++trial) {
        MotionElements elements = random_elements(random, 21, 14, 7);
        const CollisionRules rules = random_rules(random, 21);
        elements.groups = proofs::motion_groups(rules);
        MotionFrame start(elements.vertex_count), end(elements.vertex_count);
        for (std::size_t v = 0; v < start.size(); ++v) {
          for (auto* const frame : {&start, &end}) {
            for (double* const x : {&(*frame)[v].x, &(*frame)[v].y, &(*frame)[v].z}) {
              *x = near_a_multiple(random, step, random.one_in(4) ? 0 : origin);
            }
          }
          if (random.one_in(2) || (!elements.fixed.empty() && elements.fixed[v])) end[v] = start[v];
        }
        const auto expected = all_pairs(elements, start, end, distance, rules);
        if (expected != all_pairs(elements, start, end, distance)) ++ignored;
        const proofs::StepProver prover(elements, {distance, Metric::euclidean});
        const auto pairs = prover.pairs(start, end, 1);
        CAPTURE(io::hexfloat(distance), io::hexfloat(origin), trial, pairs.size(), expected.size());
        const auto difference = std::mismatch(pairs.begin(), pairs.end(), expected.begin(), expected.end());
        if (difference.first != pairs.end()) UNSCOPED_INFO("first differs " << shown(*difference.first));
        if (difference.second != expected.end()) UNSCOPED_INFO("should be " << shown(*difference.second));
        REQUIRE((pairs == expected));
        for (const MotionPair& pair : pairs) {
          const bool is_fold = distance > 0 && prover.separation_of(pair).distance == 0;
          ++kinds[is_fold ? 4 : static_cast<std::size_t>(pair.kind)];
        }
        if (all_pairs<double>(elements, start, end, distance, rules) != expected) ++wrong_in_doubles;
      }
    }
  }
  CAPTURE(kinds, wrong_in_doubles, ignored);
  CHECK(ignored > 50);
  for (const std::size_t count : kinds) CHECK(count > 100);
  CHECK(wrong_in_doubles > 10);
}

TEST_CASE("the pairs of many elements are the same for any number of threads", "[slow]") {
  Rng random(5);
  const std::size_t count = 6000;
  MotionElements elements;
  elements.vertex_count = count;
  for (std::uint32_t v = 0; v + 2 < count; v += 3) {
    elements.edges.push_back({v, v + 1});
    elements.points.push_back(v + 2);
  }
  for (std::uint32_t v = 0; v + 5 < count; v += 60) elements.faces.push_back({v, v + 1, v + 2});
  MotionFrame start(count), end(count);
  for (std::size_t v = 0; v < count; ++v) {
    const auto at = [&](double x) { return x + 0.6 * random.symmetric(); };
    const auto cell = static_cast<double>(v / 3);
    start[v] = {at(std::fmod(cell, 13)), at(std::fmod(cell, 17)), at(std::fmod(cell, 11))};
    end[v] = {at(start[v].x), at(start[v].y), at(start[v].z)};
  }
  const proofs::StepProver prover(elements, {0.0625, Metric::max});
  const auto one = prover.pairs(start, end, 1);
  CHECK((one == all_pairs(elements, start, end, 0.0625)));
  CHECK(one.size() > 2000);
  for (const int threads : {2, 5}) CHECK((prover.pairs(start, end, threads) == one));
}

TEST_CASE("a pair's proof is that of its query, with the separation of the motion") {
  MotionElements elements;
  elements.vertex_count = 6;
  elements.points = {5, 4};
  elements.edges = {{1, 0}, {2, 3}};
  elements.faces = {{0, 1, 2}};
  const MotionFrame start = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 4}, {0.25, 0.25, 1}, {0.25, 0.25, 3}};
  MotionFrame end = start;
  end[4].z = -1;
  for (const double distance : {0.0, 0.125}) {
    const Separation separation{distance, Metric::euclidean};
    const proofs::StepProver prover(elements, separation);
    const MotionPair pair{Kind::vertex_face, 1, 0};
    const Query query = prover.query_of(pair, start, end);
    CHECK(query.kind == Kind::vertex_face);
    const std::array<std::uint32_t, 4> corners{4, 0, 1, 2};
    for (std::size_t c = 0; c < 4; ++c) {
      for (int k = 0; k < 3; ++k) {
        CHECK(coordinate(query.start[c], k) == coordinate(start[corners[c]], k));
        CHECK(coordinate(query.end[c], k) == coordinate(end[corners[c]], k));
      }
    }
    std::string text = "before\n", expected = "before\n";
    const Answer answer = prover.append_proof(text, 3, pair, start, end);
    CHECK(answer.contact);
    CHECK(answer.toi == (distance > 0 ? 0.4375 : 0.5));
    proofs::append_proof(expected, 3, answer, proofs::prove(query, answer, separation));
    CHECK(text == expected);
    CHECK(text.rfind("before\n3 contact ", 0) == 0);
  }
}

TEST_CASE("a wire's fold has a proof that the elements touch, or do not, whatever the separation is") {
  MotionElements elements;
  elements.vertex_count = 3;
  elements.points = {0, 1, 2};
  elements.edges = {{0, 1}, {1, 2}};
  const MotionFrame start = {{-2, 0, 0}, {0, 0, 0}, {-1, 1, 0}}, bent = {{-2, 0, 0}, {0, 0, 0}, {-1, 0.125, 0}};
  MotionFrame folded = start;
  folded[2].y = -1;
  for (const double distance : {0.0, 0.5}) {
    const proofs::StepProver prover(elements, {distance, Metric::max});
    const MotionPair pair{Kind::point_edge, 2, 0};
    const std::vector<MotionPair> expected = distance > 0 ? std::vector{pair} : std::vector<MotionPair>{};
    CHECK((prover.pairs(start, bent, 1) == expected));
    CHECK((prover.pairs(start, folded, 1) == std::vector{pair}));
    CHECK(prover.separation_of(pair).distance == 0);
    std::string text;
    CHECK_FALSE(prover.append_proof(text, 0, pair, start, bent).contact);
    const Answer answer = prover.append_proof(text, 0, pair, start, folded);
    CHECK(answer.contact);
    CHECK(answer.toi == 0.5);
  }
  elements.faces = {{0, 1, 2}};  // no wires
  CHECK(proofs::StepProver(elements, {1, Metric::max}).pairs(start, folded, 1).empty());
}

TEST_CASE("a star of many wires has no folds where their boxes are apart") {
  MotionElements elements;
  constexpr std::uint32_t kWires = 3000;
  elements.vertex_count = kWires + 1;
  MotionFrame frame = {{0, 0, 0}};
  for (std::uint32_t i = 1; i <= kWires; ++i) {
    elements.points.push_back(i);
    elements.edges.push_back({0, i});
    const double x = std::ldexp(i, -20);  // on a falling curve: no end is in the box of another wire
    frame.push_back({x, 1 - x, 0});
  }
  CHECK(proofs::StepProver(elements, {}).pairs(frame, frame, 2).empty());
}

TEST_CASE("whether any two elements could meet") {
  const auto has_pair = [](const MotionElements& elements) { return proofs::StepProver(elements, {}).has_pair(); };
  MotionElements elements;
  elements.vertex_count = 5;
  CHECK_FALSE(has_pair(elements));
  elements.points = {0};
  CHECK_FALSE(has_pair(elements));
  elements.edges = {{0, 1}, {1, 2}, {1, 0}};
  elements.faces = {{0, 1, 2}};
  CHECK_FALSE(has_pair(elements));
  elements.faces = {{0, 1, 3}};
  CHECK_FALSE(has_pair(elements));
  elements.points = {0, 2};
  CHECK(has_pair(elements));  // point 2 and the face
  elements.faces.clear();
  CHECK(has_pair(elements));  // a fold
  elements.fixed = {1, 1, 1, 0, 0};
  CHECK_FALSE(has_pair(elements));
  elements.fixed = {1, 1, 0, 0, 0};
  CHECK(has_pair(elements));
  elements.edges.clear();
  CHECK(has_pair(elements));  // two points
  elements.groups = {{0, 3, 7, 3, 3}, {{0, 3}, {0, 7}, {7, 7}}};
  CHECK_FALSE(has_pair(elements));
  elements.groups.ignored = {{0, 3}, {7, 7}};
  CHECK(has_pair(elements));
}

TEST_CASE("groups that are asked about with the same ones become one") {
  // Two objects among many, and vertices in none, which are asked about with all unless a list names them.
  CollisionRules rules = {{}, {}, {5, 0, 1, 2, 3, 4}, GroupRule::all_but_listed, {{3, 1}}};
  constexpr std::uint32_t kNone = proofs::MotionGroups::kNone;
  auto groups = proofs::motion_groups(rules);
  CHECK(groups.of_vertices == std::vector<std::uint32_t>{kNone, kNone, 0, kNone, 1, kNone});
  CHECK(groups.ignored == std::vector<std::array<std::uint32_t, 2>>{{0, 1}});
  rules.group_pairs = {{0, 0}, {1, 1}};
  groups = proofs::motion_groups(rules);
  CHECK(groups.of_vertices == std::vector<std::uint32_t>{kNone, 0, 1, kNone, kNone, kNone});
  CHECK(groups.ignored == std::vector<std::array<std::uint32_t, 2>>{{0, 0}, {1, 1}});
  rules.group_rule = GroupRule::only_listed;
  rules.group_pairs = {{0, 4}, {4, 1}, {1, 4}};
  groups = proofs::motion_groups(rules);
  CHECK(groups.of_vertices == std::vector<std::uint32_t>{1, 0, 0, 1, 1, 2});
  CHECK(groups.ignored == std::vector<std::array<std::uint32_t, 2>>{{0, 0}, {0, 1}, {1, 1}, {1, 2}, {2, 2}});
  rules = {{}, {}, {0, 1}, GroupRule::all_but_listed, {}};
  CHECK(proofs::motion_groups(rules).of_vertices.empty());
}

TEST_CASE("the text of a motion: its elements, the vertices that are held, and frames with every bit") {
  MotionElements elements;
  elements.vertex_count = 4;
  elements.points = {0, 3};
  elements.edges = {{2, 1}};
  elements.faces = {{0, 1, 2}};
  elements.fixed = {0, 0, 1, 0};
  CHECK(proofs::motion_head(elements) ==
        "touchstone-motion 1\nvertices 4\npoint 0\npoint 3\nedge 2 1\nface 0 1 2\nfixed 2\n");
  elements.groups = {{0, 1, proofs::MotionGroups::kNone, 0}, {{0, 0}, {0, 1}}};
  elements.touching = {{Kind::vertex_face, 1, 0}, {Kind::point_edge, 0, 0}};
  CHECK(proofs::motion_head(elements).ends_with("ignore 0 1\ntouching vertex-face 1 0\ntouching point-edge 0 0\n"));
  elements.touching.clear();
  CHECK(proofs::motion_head(elements).ends_with("fixed 2\ngroup 0 0\ngroup 1 1\ngroup 3 0\nignore 0 0\nignore 0 1\n"));
  std::string text;
  proofs::append_frame(text, {{0.1, -0.0, kTiny}, {kLargest, -1, 3}});
  CHECK(text == "frame\n0x1.999999999999ap-4 0 0x0.0000000000001p-1022\n0x1.fffffffffffffp+1023 -0x1p+0 0x1.8p+1\n");
  CHECK(proofs::colliding_vertices({{4, 2}, {2, 7}}, {5, 0}) == std::vector<std::uint32_t>{0, 2, 4, 5, 7});
}
