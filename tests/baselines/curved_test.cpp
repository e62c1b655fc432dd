// The methods for curved queries: right where they are known to be, and each of their known failures, judged exactly.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "baselines/curved_baseline.hpp"
#include "families/families.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using baselines::CurvedBaseline;
using baselines::Result;
using families::Family;

Result ask(const CurvedBaseline& method, const CurvedQuery& query, double t_max = 1) {
  return method.solve(query, t_max, method.usual_tolerance);
}

const CurvedBaseline& redon() { return *baselines::find_curved_method("redon"); }
const CurvedBaseline& advancement() { return *baselines::find_curved_method("curved_advancement"); }

/// A blade of length 5 makes a quarter turn about z; its tip comes to a wall in the plane x = 4 at t = 1/2.
CurvedQuery blade() {
  CurvedQuery query;
  query.kind = Kind::vertex_face;
  query.motions[0].q1 = {1, 0, 0, 1};
  query.corners = {CurvedCorner::on_body(0, {5, 0, 0}), CurvedCorner::on_curve({{2, 4, 0}}),
                   CurvedCorner::on_curve({{4, 4, -1}}), CurvedCorner::on_curve({{4, 4, 1}})};
  return query;
}

/// One edge turns in the plane z = 0 and one crosses that plane. At t = 1/2 they lie on each other; only then they are
/// parallel.
CurvedQuery parallel_edges() {
  CurvedQuery query;
  query.motions[0].q1 = {1, 0, 0, 1};
  query.corners = {CurvedCorner::on_body(0, {5, 0, 0}), CurvedCorner::on_body(0, {10, 0, 0}),
                   CurvedCorner::on_curve({{3, 4, -1}, {3, 4, 1}}), CurvedCorner::on_curve({{6, 8, -1}, {6, 8, 1}})};
  return query;
}

TEST_CASE("curved baselines: the registry") {
  CHECK(baselines::curved_methods().size() == 2);
  for (const CurvedBaseline& method : baselines::curved_methods()) {
    CHECK(baselines::find_curved_method(method.name) == &method);
    CHECK(method.usual_tolerance > 0);
    CHECK(method.supports(Kind::edge_edge));
    CHECK(method.supports(Kind::vertex_face));
    CHECK_FALSE(method.supports(Kind::point_edge));
    CurvedQuery points;
    points.kind = Kind::point_point;
    CHECK_THROWS_AS(ask(method, points), InvalidQuery);
  }
  CHECK(baselines::find_curved_method("paper") == nullptr);
}

TEST_CASE("curved baselines: an ordinary contact is found, and a pair far apart is not") {
  for (const CurvedBaseline& method : baselines::curved_methods()) {
    INFO(method.name);
    CurvedQuery query = blade();
    query.corners[1] = CurvedCorner::on_curve({{2, 4, -3}});
    query.corners[2] = CurvedCorner::on_curve({{4, 4, -3}});
    query.corners[3] = CurvedCorner::on_curve({{3, 4, 9}});
    const Answer exact = solve(query);
    REQUIRE(exact.contact);
    const Result found = ask(method, query);
    REQUIRE(found.contact);
    CHECK(std::fabs(found.toi - exact.toi) < 1e-4);
    CHECK_FALSE(ask(method, query, 0.25).contact);
    for (std::size_t i = 1; i < 4; ++i) query.corners[i].points[0].y += 2;
    CHECK_FALSE(ask(method, query).contact);
  }
}

TEST_CASE("curved baselines: redon misses edges that are parallel when they meet") {
  const CurvedQuery query = parallel_edges();
  const Answer exact = solve(query);
  REQUIRE(exact.contact);
  CHECK(exact.toi == 0.5);
  CHECK(exact.feature_a == Feature::overlap);
  CHECK_FALSE(ask(redon(), query).contact);
  CHECK(ask(advancement(), query).contact);  // which knows distances only
}

// The fuzzer found these: `touchstone fuzz --curved --solver redon`, and `--solver curved_advancement`.
TEST_CASE("curved baselines: misses that the fuzzer found") {
  CurvedQuery corner;  // touches a corner of the face at once; the face's other corners make its normal cancel
  corner.kind = Kind::vertex_face;
  corner.motions[1].q0 = {0, 1, -2, 0};
  corner.motions[1].q1 = {0, 0, 1, 1};
  corner.motions[1].p0 = corner.motions[1].p1 = {-8, 6, 0};
  corner.corners = {CurvedCorner::on_curve({{0, 0, 0}}), CurvedCorner::on_body(1, {0, 0, 0}),
                    CurvedCorner::on_body(1, {0, -10, 0}), CurvedCorner::on_curve({{0, 0, 1}})};
  REQUIRE(solve(corner).contact);
  CHECK(solve(corner).toi_upper == 0);
  CHECK_FALSE(ask(redon(), corner).contact);

  CurvedQuery paced;  // the second body's turn is over at once, so that the bound on its speed overflows
  paced.motions[0].q1 = {0, 0, 0, 1};
  paced.motions[1].q1 = {0x1p537, 0, 0, 0};
  paced.motions[1].p0 = paced.motions[1].p1 = {0, 0, 1};
  paced.corners = {CurvedCorner::on_body(0, {1, 0, 1}), CurvedCorner::on_curve({{0, 0, 0}}),
                   CurvedCorner::on_body(1, {0, 0, 0}), CurvedCorner::on_curve({{0, 1, 0}})};
  REQUIRE(solve(paced).contact);
  CHECK(solve(paced).toi == 0.5);
  CHECK_FALSE(ask(advancement(), paced).contact);
}

TEST_CASE("curved baselines: elements that pass within the tolerance are phantoms") {
  CurvedQuery query = blade();
  for (std::size_t i = 1; i < 4; ++i) query.corners[i].points[0].y = 5 + 1e-9;  // the tip's circle ends at y = 5
  query.motions[0].q1 = {0, 0, 0, 1};
  query.corners[1].points[0].x = -2;
  query.corners[2].points[0] = {2, 5 + 1e-9, -1};
  query.corners[3].points[0] = {2, 5 + 1e-9, 1};
  CHECK_FALSE(solve(query).contact);
  CHECK(ask(redon(), query).contact);
  CHECK(ask(advancement(), query).contact);
}

TEST_CASE("curved baselines: bounded work and no crash on every family, and claims in the time range") {
  std::size_t asked = 0;
  for (const families::FamilyInfo& family : families::curved_families()) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      for (std::uint64_t index = 0; index < effort(6); ++index) {
        const families::CurvedSample sample = families::make_curved({family.family, kind, 17, index});
        for (const CurvedBaseline& method : baselines::curved_methods()) {
          INFO(method.name << " on " << curved_text(sample.query));
          const Result result = ask(method, sample.query, sample.t_max);
          ++asked;
          if (result.contact) {
            CHECK(result.toi >= 0);
            CHECK(result.toi <= sample.t_max);
          } else {
            CHECK(std::isinf(result.toi));
          }
        }
      }
    }
  }
  CHECK(asked > 0);
}

}  // namespace
}  // namespace touchstone::tests
