// The narrow phase for ipc-toolkit: its verdicts are the oracle's, its times are before contact, a step to such a time
// is free, and threads change nothing.
// SPDX-License-Identifier: MIT
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include <touchstone/fuzz.hpp>
#include <touchstone/ipc_toolkit.hpp>
#include <touchstone/touchstone.hpp>

#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using touchstone::ExactNarrowPhaseCCD;
using touchstone::InvalidQuery;
using touchstone::Kind;
using touchstone::Method;
using touchstone::Query;
using touchstone::Separation;
using touchstone::Vec3;
using touchstone::seeded::Rng;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Result {
  bool hit = false;
  double toi = -1;
  bool operator==(const Result& other) const { return hit == other.hit && toi == other.toi; }
};

ipc::VectorMax3d position(const Vec3& corner, int dimension) {
  ipc::VectorMax3d vector(dimension);
  vector[0] = corner.x;
  vector[1] = corner.y;
  if (dimension == 3) vector[2] = corner.z;
  return vector;
}

Eigen::Vector3d position3(const Vec3& corner) { return {corner.x, corner.y, corner.z}; }

/// Asks through the interface of ipc-toolkit, as its own code does.
Result ask(const ipc::NarrowPhaseCCD& ccd, const Query& q, double min_distance = 0, double tmax = 1,
           int dimension = 3) {
  Result result;
  const auto at = [&](const Vec3& corner) { return position(corner, dimension); };
  const auto& s = q.start;
  const auto& e = q.end;
  switch (q.kind) {
    case Kind::edge_edge:
      result.hit =
          ccd.edge_edge_ccd(position3(s[0]), position3(s[1]), position3(s[2]), position3(s[3]), position3(e[0]),
                            position3(e[1]), position3(e[2]), position3(e[3]), result.toi, min_distance, tmax);
      break;
    case Kind::vertex_face:
      result.hit =
          ccd.point_triangle_ccd(position3(s[0]), position3(s[1]), position3(s[2]), position3(s[3]), position3(e[0]),
                                 position3(e[1]), position3(e[2]), position3(e[3]), result.toi, min_distance, tmax);
      break;
    case Kind::point_edge:
      result.hit = ccd.point_edge_ccd(at(s[0]), at(s[1]), at(s[2]), at(e[0]), at(e[1]), at(e[2]), result.toi,
                                      min_distance, tmax);
      break;
    case Kind::point_point:
      result.hit = ccd.point_point_ccd(at(s[0]), at(s[1]), at(e[0]), at(e[1]), result.toi, min_distance, tmax);
      break;
  }
  return result;
}

bool oracle_contact(const Query& query, double min_distance, double tmax = 1) {
  return touchstone::solve(query, {.t_max = tmax, .separation = Separation{min_distance}, .method = Method::oracle})
      .contact;
}

Vec3 lattice_corner(Rng& rng, int size, int dimension) {
  Vec3 corner;
  corner.x = rng.between(-size, size);
  corner.y = rng.between(-size, size);
  if (dimension == 3) corner.z = rng.between(-size, size);
  return corner;
}

/// Small integers: contacts at the ends of the step, in corners and in coplanar elements happen by chance.
Query lattice_query(Rng& rng, Kind kind, int dimension) {
  Query query;
  query.kind = kind;
  for (std::size_t i = 0; i < touchstone::corner_count(kind); ++i) {
    query.start[i] = lattice_corner(rng, 3, dimension);
    query.end[i] = lattice_corner(rng, 3, dimension);
  }
  return query;
}

Vec3 random_corner(Rng& rng, double scale) {
  Vec3 corner;
  corner.x = scale * rng.symmetric();
  corner.y = scale * rng.symmetric();
  corner.z = scale * rng.symmetric();
  return corner;
}

/// Two elements that meet in a corner of each, exactly at t = 1.
Query corner_hit(Rng& rng, Kind kind, double scale) {
  Query query;
  query.kind = kind;
  for (std::size_t i = 0; i < touchstone::corner_count(kind); ++i) {
    query.start[i] = random_corner(rng, scale);
    query.end[i] = random_corner(rng, scale);
  }
  query.end[kind == Kind::edge_edge ? 2 : 1] = query.end[0];
  return query;
}

/// The query after a step to `time`, rounded as a line search rounds it.
Query stepped(const Query& query, double time) {
  Query step = query;
  for (std::size_t i = 0; i < touchstone::corner_count(query.kind); ++i) {
    const Eigen::Vector3d from = position3(query.start[i]);
    const Eigen::Vector3d to = (position3(query.end[i]) - from) * time + from;
    step.end[i] = {to.x(), to.y(), to.z()};
  }
  return step;
}

}  // namespace

TEST_CASE("a verdict is the oracle's, and the time is before contact") {
  const ExactNarrowPhaseCCD ccd;
  Rng rng(1);
  int hits = 0, misses = 0, starts = 0;
  for (int i = 0; i < 480; ++i) {
    const Kind kind = touchstone::kKinds[static_cast<std::size_t>(i) % 4];
    const int dimension = i % 8 < 4 && (kind == Kind::point_edge || kind == Kind::point_point) ? 2 : 3;
    const Query query = lattice_query(rng, kind, dimension);
    const double min_distance = std::array<double, 3>{0, 0.3, 1}[static_cast<std::size_t>(i) % 3];
    for (const double tmax : {1.0, 0.5, 0.3}) {
      CAPTURE(i, static_cast<int>(kind), dimension, min_distance, tmax);
      const touchstone::Answer expected =
          touchstone::solve(query, {.t_max = tmax, .separation = Separation{min_distance}, .method = Method::oracle});
      const Result result = ask(ccd, query, min_distance, tmax, dimension);
      CHECK(result.hit == expected.contact);
      if (!expected.contact) {
        CHECK(result.toi == kInfinity);
        ++misses;
      } else if (expected.starts_within) {
        CHECK(result.toi == 0);
        ++starts;
      } else {
        CHECK(result.toi > 0);
        CHECK(result.toi <= expected.toi);
        CHECK(result.toi > expected.toi - 1e-6);  // a grazing contact is slow
        CHECK_FALSE(oracle_contact(query, min_distance, result.toi));
        CHECK_FALSE(ask(ccd, query, min_distance, result.toi, dimension).hit);
        ++hits;
      }
    }
  }
  CHECK(hits > 60);
  CHECK(misses > 60);
  CHECK(starts > 60);
}

TEST_CASE("a rescaling keeps a fraction of the distance at the start, no less and little more") {
  Rng rng(2);
  int hits = 0;
  for (const double rescaling : {0.8, 0.25}) {
    const ExactNarrowPhaseCCD ccd(rescaling);
    CHECK(ccd.conservative_rescaling == rescaling);
    for (int i = 0; i < 160; ++i) {
      const Query query = lattice_query(rng, touchstone::kKinds[static_cast<std::size_t>(i) % 4], 3);
      const double min_distance = i % 2 == 0 ? 0 : 0.5;
      CAPTURE(rescaling, i, min_distance);
      const Result result = ask(ccd, query, min_distance);
      CHECK(result.hit == oracle_contact(query, min_distance));
      if (!result.hit || result.toi == 0) continue;
      const double start = touchstone::distance(query).value;
      const double kept = min_distance + (1 - rescaling) * (start - min_distance);
      CHECK_FALSE(oracle_contact(query, kept * (1 - 1e-14), result.toi));
      CHECK(oracle_contact(query, kept * (1 + 1e-12), result.toi));
      ++hits;
    }
  }
  CHECK(hits > 20);
}

TEST_CASE("with a rescaling the least time over all pairs does not depend on their order") {
  const ExactNarrowPhaseCCD ccd(0.8);
  Rng rng(3);
  int shortened = 0;
  for (int round = 0; round < 50; ++round) {
    std::vector<Query> pairs;
    for (int i = 0; i < 12; ++i) {
      const Query query = lattice_query(rng, touchstone::kKinds[static_cast<std::size_t>(i) % 4], 3);
      if (touchstone::compare_distance(query, 0, Separation{}) > 0) pairs.push_back(query);
    }
    const auto least = [&](auto first, auto last) {
      double time = 1;
      for (; first != last; ++first) {
        const Result result = ask(ccd, *first, 0, time);
        if (result.hit && result.toi < time) time = result.toi;
      }
      return time;
    };
    const double forward = least(pairs.begin(), pairs.end());
    CHECK(forward == least(pairs.rbegin(), pairs.rend()));
    shortened += forward < 1;
  }
  CHECK(shortened > 10);
}

TEST_CASE("with a rescaling the time is that of the whole step, or there is none before tmax") {
  Rng rng(4);
  std::size_t hits = 0, later = 0;
  for (const double rescaling : {0.9, 0.5, 0x1p-30, 1 - 0x1p-50}) {
    const ExactNarrowPhaseCCD ccd(rescaling);
    for (std::size_t i = 0; i < touchstone::tests::effort(2000); ++i) {
      Query query = lattice_query(rng, touchstone::kKinds[i % 4], 3);
      const double scale = std::ldexp(1, i % 5 == 0 ? rng.between(-1070, 970) : 0);
      const double offset = i % 3 == 0 ? scale * 0x1p40 : 0;
      for (auto* corners : {&query.start, &query.end}) {
        for (Vec3& corner : *corners) corner = {scale * corner.x + offset, scale * corner.y, scale * corner.z};
      }
      const double min_distance = i % 2 == 0 ? 0 : scale / 2;
      const Result whole = ask(ccd, query, min_distance);
      const double tmax = i % 7 == 0 && whole.hit ? whole.toi : rng.unit();
      CAPTURE(rescaling, i, scale, min_distance, tmax);
      const bool hit = whole.hit && (whole.toi < tmax || oracle_contact(query, min_distance, tmax));
      REQUIRE(ask(ccd, query, min_distance, tmax) == (hit ? whole : Result{false, kInfinity}));
      hits += hit;
      later += whole.hit && !hit;
    }
  }
  CHECK(hits > 20);
  CHECK(later > touchstone::tests::effort(2000) / 10);
}

TEST_CASE("a way that overflows is stepped along") {
  const Query query = touchstone::PointPoint{{{{-1e308, 0, 0}, {0, 0, 0}}}, {{{1e308, 0, 0}, {0, 0, 0}}}};
  for (const double rescaling : {1.0, 0.5}) {
    const Result result = ask(ExactNarrowPhaseCCD(rescaling), query);
    CHECK(result.hit);
    CHECK((0 < result.toi && result.toi < 0.5));
  }
}

TEST_CASE("no exact hit of a corner is missed at any scale", "[slow]") {
  const ExactNarrowPhaseCCD ccd;
  Rng rng(4);
  for (const Kind kind : {Kind::vertex_face, Kind::edge_edge}) {
    for (const double scale : {0.01, 1.0, 64.0, 100.0, 1000.0}) {
      int missed = 0, in_contact = 0;
      for (int i = 0; i < 2000; ++i) {
        const Query query = corner_hit(rng, kind, scale);
        const Result result = ask(ccd, query);
        missed += !result.hit;
        in_contact += result.hit && result.toi > 0 && ask(ccd, stepped(query, result.toi)).hit;
      }
      CAPTURE(static_cast<int>(kind), scale);
      CHECK(missed == 0);
      CHECK(in_contact == 0);
    }
  }
}

TEST_CASE("a gap of 1e-15 has a finite time above 0, and the step to it is free") {
  const double gap = 1e-15;
  for (const double rescaling : {1.0, 0.8}) {
    const ExactNarrowPhaseCCD ccd(rescaling);
    Query query = touchstone::VertexFace{{{{0.25, 0.25, gap}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                         {{{0.25, 0.25, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
    for (const double height : {0.0, 1.0}) {  // at a height of 1 the gap is four units in the last place
      for (Vec3& corner : query.start) corner.z += height;
      for (Vec3& corner : query.end) corner.z += height;
      CAPTURE(rescaling, height);
      const Result result = ask(ccd, query);
      CHECK(result.hit);
      CHECK(result.toi > 0);
      CHECK(result.toi < 2 * gap);
      CHECK_FALSE(ask(ccd, stepped(query, result.toi)).hit);
    }
  }
}

TEST_CASE("a line search that steps and asks again is never in contact") {
  Rng rng(5);
  int steps = 0;
  for (const double rescaling : {1.0, 0.8}) {
    const ExactNarrowPhaseCCD ccd(rescaling);
    for (int i = 0; i < 400; ++i) {
      Query query = i % 2 == 0 ? lattice_query(rng, touchstone::kKinds[static_cast<std::size_t>(i / 2) % 4], 3)
                               : corner_hit(rng, touchstone::kKinds[static_cast<std::size_t>(i / 2) % 4], 100.0);
      const double min_distance = i % 3 == 0 ? 0.25 : 0;
      CAPTURE(rescaling, i, min_distance);
      for (int step = 0; step < 4; ++step) {  // on and on towards the same end
        const Result result = ask(ccd, query, min_distance);
        if (!result.hit) break;
        if (result.toi == 0) {
          CHECK(step == 0);
          CHECK(touchstone::compare_distance(query, 0, Separation{min_distance}) <= 0);
          break;
        }
        const Query taken = stepped(query, result.toi);
        CHECK(ask(ccd, taken, min_distance) == Result{false, kInfinity});
        query.start = taken.end;
        ++steps;
      }
    }
  }
  CHECK(steps > 500);
}

TEST_CASE("elements that start within the distance have the time 0, whatever comes then") {
  const ExactNarrowPhaseCCD ccd;
  const Query leaving = touchstone::PointPoint{{{{0, 0, 0}, {1, 0, 0}}}, {{{0, 0, 0}, {9, 0, 0}}}};
  CHECK(ask(ccd, leaving, 1.0) == Result{true, 0});
  CHECK(ask(ccd, leaving, 1.0, 0.0) == Result{true, 0});
  CHECK(ask(ccd, leaving, std::nextafter(1.0, 0.0)) == Result{false, kInfinity});
  CHECK(ask(ccd, leaving, 1.5, 1.0, 2) == Result{true, 0});
}

TEST_CASE("what has no meaning is refused") {
  const ExactNarrowPhaseCCD ccd;
  const Query query = touchstone::PointPoint{{{{0, 0, 0}, {1, 0, 0}}}, {{{0, 0, 0}, {9, 0, 0}}}};
  const double nan = std::nan("");
  for (const double wrong : {nan, kInfinity, -kInfinity}) {
    Query bad = query;
    bad.end[1].y = wrong;
    CHECK_THROWS_AS(ask(ccd, bad), InvalidQuery);
    CHECK_THROWS_AS(ask(ccd, query, wrong), InvalidQuery);
    CHECK_THROWS_AS(ask(ccd, query, 0, wrong), InvalidQuery);
    CHECK_THROWS_AS(ExactNarrowPhaseCCD(wrong), InvalidQuery);
  }
  CHECK_THROWS_AS(ask(ccd, query, -1), InvalidQuery);
  CHECK_THROWS_AS(ask(ccd, query, 0, 1.5), InvalidQuery);
  CHECK_THROWS_AS(ExactNarrowPhaseCCD(0), InvalidQuery);
  CHECK_THROWS_AS(ExactNarrowPhaseCCD(1.1), InvalidQuery);
  ExactNarrowPhaseCCD changed;
  changed.conservative_rescaling = 2;
  CHECK_THROWS_AS(ask(changed, query), InvalidQuery);
  for (const double rescaling : {1.0, 0.5}) {
    for (const double wrong : {-0x1p-1074, 1 + 0x1p-52, nan, kInfinity}) {
      CHECK_THROWS_AS(ask(ExactNarrowPhaseCCD(rescaling), query, 0, wrong), InvalidQuery);
    }
    CHECK_THROWS_AS(ask(ExactNarrowPhaseCCD(rescaling), query, -1, 0.5), InvalidQuery);
  }
  double toi = 0;
  const ipc::VectorMax3d flat = ipc::VectorMax3d::Zero(2), deep = ipc::VectorMax3d::Ones(3);
  CHECK_THROWS_AS(ccd.point_point_ccd(flat, deep, flat, deep, toi), InvalidQuery);
  const ipc::VectorMax3d number = ipc::VectorMax3d::Ones(1);
  CHECK_THROWS_AS(ccd.point_point_ccd(number, number, number, number, toi), InvalidQuery);
}

TEST_CASE("many threads get the answers that one gets") {
  const ExactNarrowPhaseCCD ccd(0.8);
  Rng rng(6);
  std::vector<Query> queries;
  std::vector<Result> expected;
  for (int i = 0; i < 200; ++i) {
    queries.push_back(lattice_query(rng, touchstone::kKinds[static_cast<std::size_t>(i) % 4], 3));
    expected.push_back(ask(ccd, queries.back(), 0.25));
  }
  std::array<int, 8> differences{};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < differences.size(); ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = 0; i < queries.size(); ++i) {
        const std::size_t k = (i + t * 25) % queries.size();
        differences[t] += !(ask(ccd, queries[k], 0.25) == expected[k]);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const int count : differences) CHECK(count == 0);
}

TEST_CASE("a line search over whole meshes ends before the first contact, and does not stall") {
  touchstone::StepFuzzOptions options;
  options.cases = touchstone::tests::effort(650);
  const auto line_search = [](double rescaling) {
    return [ccd = ExactNarrowPhaseCCD(rescaling)](const touchstone::Mesh& mesh, const touchstone::Positions& x0,
                                                  const touchstone::Positions& x1) {
      touchstone::StepReply reply;
      if (mesh.metric() != touchstone::Metric::euclidean) return reply;  // ipc-toolkit has no other
      reply.free = 1;
      for (const touchstone::MeshPair& pair : touchstone::candidates(mesh, x0, x1)) {
        const Query query = touchstone::query_of(mesh, pair, x0, x1);
        const Result result = ask(ccd, query, mesh.separation(pair).distance, *reply.free);
        if (result.hit) reply.free = std::min(*reply.free, result.toi);
      }
      return reply;
    };
  };
  for (const double rescaling : {1.0, 0.9}) {
    const touchstone::StepFuzzReport report = touchstone::fuzz_steps(line_search(rescaling), options);
    CAPTURE(rescaling);
    for (const auto& finding : report.findings) UNSCOPED_INFO(touchstone::to_string(finding));
    CHECK(report.failures == 0);
  }
}
