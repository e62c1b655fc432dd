// Proofs of answers to queries with curved motion, judged by the checker.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <touchstone/curved.hpp>
#include <touchstone/solve.hpp>

#include "proofs/proved.hpp"
#include "proofs/run_checker.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

Proved curved_file() {
  Proved proved;
  proved.queries = std::string(io::kCurvedHeader) + "\n";
  return proved;
}

/// The largest coordinate of the query's points: distances between them are of this size, or smaller.
double largest_of(const CurvedQuery& query) {
  double largest = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    const std::size_t points =
        corner.motion == CurvedCorner::kOnCurve ? static_cast<std::size_t>(corner.control_points) : 1;
    for (std::size_t k = 0; k < points; ++k) {
      const Vec3& x = corner.points[k];
      largest = std::max({largest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
    }
  }
  return largest;
}

void expect_accepted(const Proved& proved, Kind kind, std::string_view family) {
  const CheckerRun result = check_texts(proved.text(kind), {proved.queries});
  INFO(family << ' ' << name_of(kind) << ": " << result.text << proved.text(kind) << proved.queries);
  CHECK(result.status == 0);
  const std::string count = std::to_string(proved.proofs.size());
  const std::string total =
      count + (count == "1" ? " query" : " queries") + " checked: " + std::to_string(proved.contacts) + " ";
  CHECK(result.text.find(total) != std::string::npos);
  CHECK(result.text.find(" with curved motion") != std::string::npos);
}

}  // namespace

TEST_CASE("the answers to curved queries of every family are proved, and the checker accepts the proofs", "[slow]") {
  const std::size_t count = effort(8);
  std::size_t contacts = 0, queries = 0;
  for (const Kind kind : kKinds) {
    for (const FamilyInfo& family : curved_families()) {
      Proved proved = curved_file();
      for (std::uint64_t i = 0; i < count; ++i) {
        proved.add(make_curved(CaseId{family.family, kind, 16, i}).query);
      }
      expect_accepted(proved, kind, family.name);
      contacts += proved.contacts;
      queries += proved.proofs.size();
    }
  }
  CHECK(contacts > queries / 4);
  CHECK(contacts < queries);
}

TEST_CASE("a body whose quaternion shrinks to nothing between the last doubles before a contact has a proof") {
  // Between 1 - 2^-53 and 1 its squared length is positive, but has a Bernstein coefficient that is not.
  CurvedQuery query;
  query.kind = Kind::point_point;
  const double one = 0x1.152feb22a9846p+593, other = 0x1.152feb22a9846p-315;
  query.motions[0] = {{-one, one / 2, one, 0}, {other, -other, -2 * other, 2 * other}, {-4, -1, 0}, {-4, -1, 0}};
  query.corners[0] = CurvedCorner::on_body(0, {114, -114, 114});
  query.corners[1] = CurvedCorner::on_curve({{-170, 13, 106}});
  Proved proved = curved_file();
  proved.add(query);
  REQUIRE(proved.contacts == 1);
  expect_accepted(proved, query.kind, "");
}

TEST_CASE("a power of a short interval's width that underflows leaves the sign of a polynomial to exact numbers") {
  // 2^-400 - 2^800 t^21, which is negative from t = 2^-57.2 on; 2^(-52 21) is no double.
  proofs::Dense p(22);
  p[0] = proofs::Exact(0x1p-400);
  p[21] = proofs::Exact(-0x1p800);
  const auto sign = [&](double to) {
    return proofs::sign_over(p, proofs::Exact(0), proofs::Exact(to), proofs::Inner::not_zero);
  };
  CHECK(sign(0x1p-58) == 1);
  CHECK(sign(0x1p-52) == 0);
}

TEST_CASE("answers to curved queries with a separation are proved in both metrics", "[slow]") {
  const std::size_t count = effort(2);
  std::size_t contacts = 0, later = 0, queries = 0, number = 0;
  for (const Kind kind : kKinds) {
    for (const FamilyInfo& family : curved_families()) {
      const double largest = largest_of(make_curved(CaseId{family.family, kind, 17, 0}).query);
      for (const Metric metric : {Metric::euclidean, Metric::max}) {
        for (const double fraction : {0.125, 1e-3}) {
          if (!runs_case(number++)) continue;
          Proved proved = curved_file();
          proved.separation = {fraction * largest, metric};
          for (std::uint64_t i = 0; i < count && proved.separation.distance > 0; ++i) {
            const CurvedQuery query = make_curved(CaseId{family.family, kind, 17, i}).query;
            const Answer answer = solve(query, {.separation = proved.separation});
            later += answer.contact && answer.toi > 0 ? 1 : 0;
            proved.add(query, answer);
          }
          if (!proved.proofs.empty()) expect_accepted(proved, kind, family.name);
          contacts += proved.contacts;
          queries += proved.proofs.size();
        }
      }
    }
  }
  if (!whole_effort("how many answers with a separation are contacts")) return;
  CHECK(contacts > queries / 4);
  CHECK(contacts < queries);
  CHECK(later > queries / 20);
}

TEST_CASE("straight motion given as curves has the same proofs", "[slow]") {
  std::size_t number = 0;
  for (const Kind kind : kKinds) {
    for (const FamilyInfo& family : all_families()) {
      if (!runs_case(number++)) continue;
      const Query query = make(CaseId{family.family, kind, 18, 0});
      for (const Separation& separation : {Separation{}, Separation{0.125, Metric::euclidean}}) {
        const Answer answer = solve(query, {.separation = separation});
        Proved proved = curved_file();
        proved.separation = separation;
        proved.add(CurvedQuery(query), answer);
        expect_accepted(proved, kind, family.name);
        // The checker takes the proof of one for the other: the corners are the same polynomials.
        std::string rows;
        io::append_query(rows, query, answer.contact);
        CHECK(check_texts(proved.text(kind), {rows}).status == 0);
      }
    }
  }
}

TEST_CASE("a time one double off is rejected for a curved query, with the proof that belongs to it") {
  std::size_t rejected = 0;
  for (const Kind kind : kKinds) {
    for (const FamilyInfo& family : curved_families()) {
      const CurvedQuery query = make_curved(CaseId{family.family, kind, 19, 1}).query;
      const Answer answer = solve(query);
      if (!answer.contact) continue;
      const proofs::Proof proof = proofs::prove(query, answer);
      for (const double direction : {0.0, 1.0}) {
        const std::optional<Answer> off = shifted(answer, direction);
        if (!off) continue;
        Proved proved = curved_file();
        io::append_query(proved.queries, query, true);
        proofs::append_proof(proved.proofs.emplace_back(), 0, *off, proof);
        proved.contacts = 1;
        const CheckerRun result = check_texts(proved.text(kind), {proved.queries});
        INFO(family.name << ' ' << name_of(kind) << ": " << result.text);
        CHECK(result.status == 1);
        ++rejected;
      }
    }
  }
  CHECK(rejected > 40);
}
