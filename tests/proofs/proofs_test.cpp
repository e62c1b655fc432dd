// Proofs of every family's answers, judged by the checker, which is a program of its own.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "io/queries/query_writer.hpp"
#include "proofs/proved.hpp"
#include "proofs/run_checker.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("the answers to queries of every family are proved, and the checker accepts the proofs", "[slow]") {
  constexpr std::uint64_t kSeed = 14;
  constexpr std::uint64_t kCount = 25;
  std::size_t number = 0;
  for (const Kind kind : kKinds) {
    for (const FamilyInfo& family : all_families()) {
      if (!runs_case(number++)) continue;
      Proved proved;
      for (std::uint64_t i = 0; i < kCount; ++i) proved.add(make(CaseId{family.family, kind, kSeed, i}));
      const CheckerRun result = check_texts(proved.text(kind), {proved.queries});
      INFO(family.name << ' ' << name_of(kind) << ": " << result.text);
      CHECK(result.status == 0);
      const std::string total = std::to_string(kCount) + " queries checked: " + std::to_string(proved.contacts) + " ";
      CHECK(result.text.find(total) != std::string::npos);
      CHECK(result.text.find(std::string(name_of(kind)) + " queries; the proofs name no digest of the file\n") !=
            std::string::npos);
    }
  }
}

namespace {

/// Separations of every size for queries like this one: some that hold at the start, some that the motion reaches, one
/// that is exactly the distance at the start, as far as a double can be.
std::vector<Separation> separations_for(const Query& query) {
  double largest = 0;
  for (const auto* corners : {&query.start, &query.end}) {
    for (const Vec3& x : *corners) {
      largest = std::max({largest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
    }
  }
  std::vector<Separation> all;
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const double start = distance(query, 0, metric).value;
    for (const double d : {start, 0.5 * start, 1e-3 * largest, 0.25 * largest}) {
      if (d > 0 && std::isfinite(d)) all.push_back({d, metric});
    }
  }
  return all;
}

}  // namespace

TEST_CASE("answers with a separation are proved in both metrics, and the checker accepts the proofs", "[slow]") {
  constexpr std::uint64_t kSeed = 15;
  constexpr std::uint64_t kCount = 6;
  std::size_t contacts = 0;
  std::size_t later = 0;  // contacts that begin after the start
  std::size_t queries = 0, number = 0;
  for (const Kind kind : kKinds) {
    for (const FamilyInfo& family : all_families()) {
      for (const Separation& separation : separations_for(make(CaseId{family.family, kind, kSeed, 0}))) {
        if (!runs_case(number++)) continue;
        Proved proved;
        proved.separation = separation;
        for (std::uint64_t i = 0; i < kCount; ++i) {
          const Query query = make(CaseId{family.family, kind, kSeed, i});
          const Answer answer = solve(query, {.separation = separation});
          later += answer.contact && answer.toi > 0 ? 1 : 0;
          proved.add(query, answer);
        }
        const CheckerRun result = check_texts(proved.text(kind), {proved.queries});
        INFO(family.name << ' ' << name_of(kind) << ' ' << name_of(separation.metric) << ' ' << separation.distance
                         << ": " << result.text);
        CHECK(result.status == 0);
        contacts += proved.contacts;
        queries += kCount;
      }
    }
  }
  if (!whole_effort("how many answers with a separation are contacts")) return;
  CHECK(queries > 5000);
  CHECK(contacts > queries / 4);
  CHECK(contacts < queries);
  CHECK(later > 300);
}

TEST_CASE("a proof of an answer with one separation proves nothing about another separation with another answer",
          "[slow]") {
  std::size_t rejected = 0, number = 0;
  for (const Kind kind : kKinds) {
    Rng rng(17);
    for (const FamilyInfo& family : all_families()) {
      const Query query = make(family.family, kind, rng);
      for (const Separation& separation : separations_for(query)) {
        if (!runs_case(number++)) continue;
        Proved proved;
        proved.separation = separation;
        const Answer answer = solve(query, {.separation = separation});
        proved.add(query, answer);
        for (const double factor : {0.5, 0.999, 1.001, 2.0}) {
          proved.separation.distance = factor * separation.distance;
          if (!std::isfinite(proved.separation.distance)) continue;
          const Answer other = solve(query, {.separation = proved.separation});
          if (other.contact == answer.contact && other.toi == answer.toi) continue;
          const CheckerRun result = check_texts(proved.text(kind), {proved.queries});
          INFO(family.name << ' ' << name_of(kind) << ": " << result.text << cpp_initializer(query));
          CHECK(result.status == 1);
          CHECK(result.text.find("query 0: ") != std::string::npos);
          ++rejected;
        }
      }
    }
  }
  CHECK((rejected > 500 || !whole_effort("that many proofs are rejected")));
}

TEST_CASE("answers to queries with rational coordinates are proved", "[slow]") {
  const auto d = GENERATE(0.0, 0.25);
  const auto metric = GENERATE(Metric::euclidean, Metric::max);
  for (const Kind kind : kKinds) {
    Rng rng(31);
    Proved proved;
    proved.separation = {d, metric};
    for (int i = 0; i < 300; ++i) {
      RationalQuery query;
      query.kind = kind;
      for (auto* corners : {&query.start, &query.end}) {
        for (auto& corner : *corners) {
          for (Fraction& coordinate : corner) {
            coordinate.numerator = std::to_string(static_cast<int>(rng.below(9)) - 4);
            coordinate.denominator = std::to_string(rng.below(3) + 1);
          }
        }
      }
      proved.add(query);
    }
    const CheckerRun result = check_texts(proved.text(kind), {proved.queries});
    INFO(name_of(kind) << ": " << result.text);
    CHECK(result.status == 0);
    CHECK(proved.contacts > 0);
    CHECK(proved.contacts < 300);
  }
}

TEST_CASE("a proof of one query proves nothing about another one with another answer") {
  std::size_t rejected = 0;
  for (const Kind kind : kKinds) {
    Rng rng(7);
    std::vector<Query> queries;
    for (const FamilyInfo& family : all_families()) queries.push_back(make(family.family, kind, rng));
    for (std::size_t i = 0; i + 1 < queries.size(); ++i) {
      const Answer answer = solve(queries[i]);
      const Answer other = solve(queries[i + 1]);
      if (answer.contact == other.contact && answer.toi == other.toi) continue;
      Proved proved;
      proved.add(queries[i]);
      std::string text;
      io::append_query(text, queries[i + 1], other.contact);
      const CheckerRun result = check_texts(proved.text(kind), {text});
      INFO(name_of(kind) << ' ' << i << ": " << result.text << cpp_initializer(queries[i + 1]));
      CHECK(result.status == 1);
      CHECK(result.text.find("query 0: ") != std::string::npos);
      ++rejected;
    }
  }
  CHECK(rejected > 80);
}

TEST_CASE("a time one double off is rejected, with the proof that belongs to it") {
  std::size_t rejected = 0;
  for (const Kind kind : kKinds) {
    Rng rng(8);
    for (const FamilyInfo& family : all_families()) {
      const Query query = make(family.family, kind, rng);
      const Answer answer = solve(query);
      if (!answer.contact) continue;
      const proofs::Proof proof = proofs::prove(query, answer);
      for (const double direction : {0.0, 1.0}) {
        const std::optional<Answer> off = shifted(answer, direction);
        if (!off) continue;
        Proved proved;
        io::append_query(proved.queries, query, true);
        proofs::append_proof(proved.proofs.emplace_back(), 0, *off, proof);
        proved.contacts = 1;
        const CheckerRun result = check_texts(proved.text(kind), {proved.queries});
        INFO(family.name << ' ' << name_of(kind) << ": " << result.text << cpp_initializer(query));
        CHECK(result.status == 1);
        ++rejected;
      }
    }
  }
  CHECK(rejected > 80);
}

TEST_CASE("an answer that is false has no proof") {
  const Query meets(PointPoint{{Vec3{0, 0, 0}, Vec3{2, 0, 0}}, {Vec3{1, 0, 0}, Vec3{1, 0, 0}}});
  Answer answer = solve(meets);
  REQUIRE(answer.contact);
  REQUIRE(answer.toi == 1);
  answer.toi = answer.toi_upper = 0.5;
  CHECK_THROWS_AS(proofs::prove(meets, answer), Error);
  const Query misses(PointPoint{{Vec3{0, 0, 0}, Vec3{2, 0, 0}}, {Vec3{1, 0, 0}, Vec3{1.5, 0, 0}}});
  CHECK_THROWS_AS(proofs::prove(misses, answer), Error);
}

TEST_CASE("a file of proofs that was cut or that has more is rejected") {
  Proved proved;
  Rng rng(9);
  for (int i = 0; i < 5; ++i) proved.add(make(all_families()[0].family, Kind::edge_edge, rng));
  const std::string text = proved.text(Kind::edge_edge);
  REQUIRE(check_texts(text, {proved.queries}).status == 0);
  std::size_t cuts = 0;
  for (std::size_t size = 0; size + 1 < text.size(); size += 7) {
    const CheckerRun result = check_texts(text.substr(0, size), {proved.queries});
    INFO("cut after " << size << ": " << result.text);
    CHECK((result.status == 1 || result.status == 2));
    ++cuts;
  }
  CHECK(cuts > 20);
  CHECK(check_texts(text + "0 none\n", {proved.queries}).status == 1);
  CHECK(check_texts(text, {proved.queries + proved.queries}).status == 1);
  CHECK(check_texts("", {proved.queries}).status == 2);
}

TEST_CASE("the proofs of fractions with many digits and different denominators stay within the checker's limits") {
  Rng rng(18);
  const auto digits = [&rng](std::size_t count) {
    std::string text(count, '1');
    for (char& c : text) c = static_cast<char>('1' + rng.below(9));
    return text;
  };
  // Two edges, or a vertex and a face, that cross near t = 1/2. The fractions are near these integers.
  const std::vector<std::array<int, 3>> edges = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}};
  const std::vector<std::array<int, 3>> face = {{0, 0, 1}, {-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}};
  struct Case {
    Separation separation;
    std::size_t digits;
  };
  for (const auto& [separation, count] :
       {Case{{}, 180}, Case{{0.125, Metric::euclidean}, 90}, Case{{0.125, Metric::max}, 180}}) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      const bool is_edge = kind == Kind::edge_edge;
      const auto fraction = [&, size = count](int near) {
        const std::string denominator = digits(size);
        std::string numerator = (near < 0 ? "-" : "") + denominator;
        if (near == 0) numerator = digits(size - 2);
        if (std::abs(near) == 2) numerator = "1" + denominator;
        return Fraction{numerator, denominator};
      };
      RationalQuery query;
      query.kind = kind;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto& at = is_edge ? edges[i] : face[i];
        const bool falls = is_edge ? i >= 2 : i == 0;
        query.start[i] = {fraction(at[0]), fraction(at[1]), fraction(at[2])};
        query.end[i] = {fraction(at[0]), fraction(at[1]), fraction(falls ? -1 : at[2])};
      }
      Proved proved;
      proved.separation = separation;
      proved.add(query);
      CHECK(proved.contacts == 1);
      const CheckerRun result = check_texts(proved.text(kind), {proved.queries});
      INFO(name_of(kind) << ' ' << separation.distance << ": " << result.text);
      CHECK(result.status == 0);
    }
  }
}
