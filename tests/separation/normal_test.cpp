// The unit normal at the first contact: known ones, and what holds of every one.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <touchstone/contact_normal.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "separation/distances.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

using namespace touchstone;

namespace {

using Normal = std::array<double, 3>;
using LongVector = std::array<long double, 3>;

constexpr double kBound = 0x1p-49;

void check_near(const std::optional<Normal>& normal, const LongVector& expected) {
  REQUIRE(normal);
  long double square = 0;
  for (std::size_t k = 0; k < 3; ++k) square += ((*normal)[k] - expected[k]) * ((*normal)[k] - expected[k]);
  CAPTURE((*normal)[0], (*normal)[1], (*normal)[2]);
  CHECK(square < static_cast<long double>(kBound) * kBound);
}

/// a along z through the origin; b from (-1, from) to (1, to) in the plane z = 0, where `to` rests.
Query turning_edges(double from, double from_end, double to) {
  return EdgeEdge{{{{0, 0, -1}, {0, 0, 1}, {-1, from, 0}, {1, to, 0}}},
                  {{{0, 0, -1}, {0, 0, 1}, {-1, from_end, 0}, {1, to, 0}}}};
}

/// The difference of the closest points at `toi`, in long doubles.
LongVector difference_at(const Query& query, const Answer& answer) {
  LongVector c{};
  const std::size_t first = query.kind == Kind::edge_edge ? 2 : 1;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const long double weight = i < first ? -answer.weights_a[i] : answer.weights_b[i - first];
    const long double t = answer.toi, s = 1 - t;
    const Vec3 &x0 = query.start[i], &x1 = query.end[i];
    c[0] += weight * (s * x0.x + t * x1.x);
    c[1] += weight * (s * x0.y + t * x1.y);
    c[2] += weight * (s * x0.z + t * x1.z);
  }
  return c;
}

/// The normal is a unit vector. With a separation, it is along the closest points' difference, which the answer's
/// weights give. Without one, it is perpendicular to both edges, or to the face.
std::string fault_of(const Query& query, const Separation& separation, const Answer& answer, const Normal& normal) {
  const auto along = [&normal](const LongVector& v) { return normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2]; };
  if (std::fabs(along({normal[0], normal[1], normal[2]}) - 1) > 2 * kBound) return "not of length 1";
  const long double tolerance = 0x1p-45L * tests::extent(query) + 0x1p-1070L;
  if (separation.distance > 0) {
    const LongVector c = difference_at(query, answer);
    const long double length = along(c);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(std::fabs(c[k] - length * normal[k]) <= tolerance)) return "not along the difference";
    }
    return length >= -tolerance ? "" : "from the second element to the first";
  }
  const auto edge = [&](std::size_t from, std::size_t to) {
    Answer ends;
    ends.toi = answer.toi;
    const std::size_t first = query.kind == Kind::edge_edge ? 2 : 1;
    (to < first ? ends.weights_a[to] : ends.weights_b[to - first]) = 1;
    LongVector v = difference_at(query, ends);
    if (to < first) v = {-v[0], -v[1], -v[2]};
    Answer start;
    start.toi = answer.toi;
    (from < first ? start.weights_a[from] : start.weights_b[from - first]) = 1;
    const LongVector other = difference_at(query, start);
    for (std::size_t k = 0; k < 3; ++k) v[k] -= from < first ? -other[k] : other[k];
    return v;
  };
  const bool edges = query.kind == Kind::edge_edge;
  for (const LongVector& v : {edge(edges ? 0 : 1, edges ? 1 : 2), edge(edges ? 2 : 1, 3)}) {
    if (!(std::fabs(along(v)) <= 4 * tolerance)) return "not perpendicular";
  }
  return "";
}

}  // namespace

TEST_CASE("normals that a person can work out") {
  const long double half = 0.5L, root3 = std::sqrt(3.0L) / 2;
  for (const double scale : {1.0, 0x1p-300, 0x1p200}) {
    // The distance is 1 at x = -sqrt(3) / 2, y = 1/2.
    const Query passing = PointPoint{{{{-2 * scale, 0.5 * scale, 0}, {}}}, {{{2 * scale, 0.5 * scale, 0}, {}}}};
    check_near(contact_normal(passing, Separation{scale}), {root3, -half, 0});
  }
  // Edge a is the point (0, 0) seen along z. b's line has the slope t and the height 2 - t at x = 0. So the distance is
  // (2 - t) / sqrt(1 + t^2), along (-t, 1): 1 at t = 3/4, and 5/4 at the root of (9/16) t^2 + 4 t = 39/16.
  check_near(contact_normal(turning_edges(2, 0, 2), Separation{1}), {-0.6L, 0.8L, 0});
  const long double t = (-4 + std::sqrt(16 + 4 * 0.5625L * 2.4375L)) / 1.125L;
  const long double length = std::sqrt(1 + t * t);
  check_near(contact_normal(turning_edges(2, 0, 2), Separation{1.25}), {-t / length, 1 / length, 0});
}

TEST_CASE("a face's normal points from the vertex to the face as they lie before the contact") {
  const auto falling = [](double from, double to, bool turned) {
    const Vec3 f1 = {1, 0, 0}, f2 = {0, 1, 0};
    const Vec3 &one = turned ? f2 : f1, &other = turned ? f1 : f2;
    return VertexFace{{{{0.25, 0.25, from}, {}, one, other}}, {{{0.25, 0.25, to}, {}, one, other}}};
  };
  for (const bool turned : {false, true}) {
    check_near(contact_normal(Query(falling(1, -1, turned))), {0, 0, -1});
    check_near(contact_normal(Query(falling(-1, 1, turned))), {0, 0, 1});
    check_near(contact_normal(Query(falling(1, -1, turned)), Separation{0.5}), {0, 0, -1});
    check_near(contact_normal(Query(falling(-1, 1, turned)), Separation{0.5}), {0, 0, 1});
    // At rest in the plane: no side. The normal is n.
    check_near(contact_normal(Query(falling(0, 0, turned))), {0, 0, turned ? -1.0L : 1.0L});
  }
}

TEST_CASE("where there is no normal") {
  const Query apart = PointPoint{{{{0, 0, 0}, {1, 0, 0}}}, {{{0, 0, 0}, {1, 0, 0}}}};
  CHECK_FALSE(contact_normal(apart));
  CHECK_FALSE(contact_normal(apart, Separation{0.5}));
  check_near(contact_normal(apart, Separation{1}), {1, 0, 0});
  const Query together = PointPoint{{{{1, 0, 0}, {1, 0, 0}}}, {{{0, 0, 0}, {1, 0, 0}}}};
  CHECK_FALSE(contact_normal(together));
  CHECK_FALSE(contact_normal(together, Separation{0.5}));
  const Query parallel =
      EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {1, -1, 0}}}};
  REQUIRE(solve(parallel).contact);
  CHECK_FALSE(contact_normal(parallel));
  check_near(contact_normal(parallel, Separation{0.5}), {0, 1, 0});
}

TEST_CASE("a normal asks for the Euclidean metric") {
  const Query query = turning_edges(2, 0, 2);
  CHECK_THROWS_AS(contact_normal(query, Separation{1, Metric::max}), InvalidQuery);
  CHECK_THROWS_AS(contact_normal(query, Separation{-1}), InvalidQuery);
  CHECK_THROWS_AS(contact_normal(query, Separation{1}, 2), InvalidQuery);
  CHECK_NOTHROW(contact_normal(query, Separation{0, Metric::max}));
}

TEST_CASE("of every family, the normal is along the difference of the closest points") {
  tests::Report report;
  std::size_t normals = 0;
  constexpr std::size_t kCount = 12;
  tests::for_each_case(
      7, kCount, [](const tests::FamilyInfo&, Kind) { return true; },
      [&](const tests::CaseId& id) {
        tests::Rng rng = tests::rng_of(id);
        const Query query = tests::make_sample(id.family, id.kind, rng).query;
        const Separation separation = {tests::interesting_distance(query, Metric::euclidean, rng), Metric::euclidean};
        const auto normal = contact_normal(query, separation);
        const Answer answer = solve(query, {.separation = separation, .method = Method::exact});
        std::string wrong;
        if (normal) {
          ++normals;
          wrong = fault_of(query, separation, answer, *normal);
        } else if (separation.distance > 0 && answer.contact && compare_distance(query, 0, Separation{0}) > 0) {
          wrong = "no normal";
        }
        report.add(id, query, wrong);
      });
  CHECK(normals > 80 * tests::effort(kCount));
  report.finish();
}
