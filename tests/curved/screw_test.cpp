// Bodies that turn at a constant rate: the bounds of their arcs and the verdicts, against the true motion in MPFR.
// SPDX-License-Identifier: MIT
#include <touchstone/screw.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <touchstone/curved.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>

#include "curved/big.hpp"
#include "curved/expected.hpp"
#include "curved/queries.hpp"
#include "solver/screw_arcs.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 59;

Big distance_between(const BigPoint& a, const BigPoint& b) {
  Big sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum = sum + (a[k] - b[k]) * (a[k] - b[k]);
  return sqrt(sum);
}

/// Puts the position on a curve: far from its chord, near it, or on it at another pace.
void bend(RigidMotion& motion, Rng& rng) {
  const double size = std::ldexp(20, -rng.between(0, 50));
  motion.control_points = rng.between(3, 4);
  for (Vec3& x : motion.inner) {
    x = motion.p0;
    if (rng.one_in(4)) continue;
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) x.*axis += size * rng.symmetric();
  }
}

/// Random bodies, of all turns from none to nearly a whole one, and of all sizes.
CurvedQuery any_turn(Rng& rng) {
  CurvedQuery query = random_query(rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face, rng);
  for (RigidMotion& motion : query.motions) {
    for (double& c : motion.q1) c = rng.one_in(2) ? c : -c;
    if (rng.one_in(4)) {
      const double size = std::ldexp(1, -rng.between(1, 40));
      for (std::size_t k = 0; k < 4; ++k) motion.q1[k] = motion.q0[k] + size * rng.symmetric();
    }
    if (rng.one_in(4)) {  // a turn about z by an angle below 360 degrees
      motion.q0 = {1, 0, 0, 0};
      motion.q1 = {-rng.unit(), 0, 0, 1};
    }
    if (rng.one_in(3)) motion.p0 = motion.p1 = {0, 0, 0};  // nothing but the turn is off
    const double length = std::ldexp(1, rng.between(-300, 300));
    for (double& c : motion.q1) c *= length;
    if (rng.one_in(3)) bend(motion, rng);
  }
  if (rng.one_in(4)) {
    for (CurvedCorner& corner : query.corners) {
      if (corner.motion != CurvedCorner::kOnCurve) corner.points[0] = {0, 0, 0};  // nothing but the position is
    }
  } else if (rng.one_in(4)) {
    for (CurvedCorner& corner : query.corners) {
      for (Vec3& x : corner.points) x = {1e6 + x.x, x.y - 1e9, x.z};
    }
  }
  return query;
}

TEST_CASE("no corner is farther from its arcs than the bound") {
  double most = 0, most_rounding = 0;
  for (std::uint64_t index = 0; index < effort(400); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed, index));
    CurvedQuery query = any_turn(rng);
    const int count = 1 << rng.between(2, rng.one_in(3) ? 12 : 5);
    const solver::ScrewArcs arcs(query, count);
    for (int sample = 0; sample < 6; ++sample) {
      const int i = rng.between(0, count - 1);
      // Where the deviation of an arc is largest, near 0.211 and 0.789, at its ends, or anywhere.
      const double local = sample == 0 ? 0.2113 : sample == 1 ? 0.7887 : sample == 2 ? 0 : sample == 3 ? 1 : rng.unit();
      const Big time = (Big(i) + Big(local)) / Big(count);
      const CurvedQuery arc = arcs.arc(i);
      for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
        const Big off = distance_between(true_position(query, c, time), rational_position(arc, c, local));
        const double bound = arcs.deviation(query.kind == Kind::edge_edge ? c / 2 : c == 0 ? 0 : 1);
        INFO("seed " << kSeed << ", index " << index << ", " << count << " arcs, arc " << i << " at " << local
                     << ", corner " << c << "\n"
                     << text_of(query));
        REQUIRE(off.to_double() <= bound);
        if (bound == 0) continue;
        double& greatest = sample == 2 || sample == 3 ? most_rounding : most;
        greatest = std::max(greatest, off.to_double() / bound);
      }
    }
  }
  std::printf("seed %llu: the greatest deviation is %.3f of its bound, at the arcs' ends %.3f\n",
              static_cast<unsigned long long>(kSeed), most, most_rounding);
  if (whole_effort("that the bound on the deviation is not far from the truth")) CHECK(most > 0.45);
}

TEST_CASE("a corner is in the box of a range of times") {
  for (std::uint64_t index = 0; index < effort(150); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 1, index));
    const CurvedQuery query = any_turn(rng);
    const solver::ScrewArcs arcs(query, 1 << rng.between(2, 10));
    const double from = rng.unit(), to = std::min(1.0, from + std::ldexp(rng.unit(), -rng.between(1, 40)));
    for (const double place : {0.0, 0.5, 1.0, rng.unit()}) {
      const Big time = Big(from) + Big(place) * (Big(to) - Big(from));
      for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
        const auto box = arcs.position(c, from, to);
        const BigPoint x = true_position(query, c, time);
        INFO("seed " << kSeed << ", index " << index << ", from " << hexfloat(from) << " to " << hexfloat(to) << "\n"
                     << text_of(query));
        for (std::size_t k = 0; k < 3; ++k) {
          REQUIRE(!(x[k] < Big(box[k].low)));
          REQUIRE(!(Big(box[k].high) < x[k]));
        }
      }
    }
  }
}

TEST_CASE("twice as many arcs have an eighth of the deviation") {
  CurvedQuery query = curved(Kind::point_point, {body(0, {3, 4, 0}), rest({0, 0, 1})}, {RigidMotion()});
  query.motions[0].q1 = {1, 0, 0, 1};
  for (int count = 8; count <= 512; count *= 2) {
    const double ratio =
        solver::ScrewArcs(query, count).deviation(0) / solver::ScrewArcs(query, 2 * count).deviation(0);
    CHECK(ratio > 7.5);
    CHECK(ratio < 8.5);
  }
}

/// The tip of a rod of length 5 that makes a quarter turn about z, against a face in the plane y = height.
CurvedQuery tip_and_wall(double height) {
  CurvedQuery query = curved(
      Kind::vertex_face, {body(0, {5, 0, 0}), rest({-20, height, -9}), rest({20, height, -9}), rest({0, height, 9})},
      {RigidMotion()});
  query.motions[0].q1 = {1, 0, 0, 1};
  return query;
}

TEST_CASE("the tip of a rod passes through a wall at a third of a quarter turn") {
  // sin(30 degrees) = 1/2. As `solve` reads the query, the body turns at another pace.
  const CurvedQuery query = tip_and_wall(2.5);
  CHECK(std::fabs(solve(query).toi - 1 / 3.0) > 1e-3);
  double width = 1;
  for (int arcs = 8; arcs <= 4096; arcs *= 8) {
    const ScrewAnswer answer = solve_screw(query, {1, {}, arcs, arcs});
    CAPTURE(arcs, answer.free_until, answer.contact_by, answer.deviation);
    REQUIRE(answer.verdict == ScrewVerdict::contact);
    CHECK(answer.arcs == arcs);
    CHECK(answer.free_until < 1 / 3.0);
    CHECK(answer.contact_by > 1 / 3.0);
    CHECK(answer.contact_by - answer.free_until < width / 8);
    width = answer.contact_by - answer.free_until;
  }
  CHECK(width < 1e-9);
  CHECK(solve_screw(query, {0.33}).verdict == ScrewVerdict::free);
  CHECK(solve_screw(query, {0.33}).free_until == 0.33);
  CHECK(solve_screw(query, {0.34}).verdict == ScrewVerdict::contact);
  CHECK(name_of(ScrewVerdict::contact) == "contact");
}

/// A point of a body that flies the parabola y = 4 h t (1 - t), and turns about itself, against a wall at y = 1.
CurvedQuery thrown_at_wall(double h) {
  CurvedQuery query = tip_and_wall(1);
  RigidMotion& motion = query.motions[0];
  query.corners[0].points[0] = {};
  motion.p1 = {1, 0, 0};
  motion.control_points = 3;
  motion.inner[0] = {0.5, 2 * h, 0};
  return query;
}

TEST_CASE("a body on a parabola reaches a wall when its formula says so") {
  double width = 1;
  for (int arcs = 16; arcs <= 4096; arcs *= 4) {
    const ScrewAnswer answer = solve_screw(thrown_at_wall(4.0 / 3), {1, {}, arcs, arcs});  // y = 1 at t = 1/4
    CAPTURE(arcs, answer.free_until, answer.contact_by, answer.deviation);
    REQUIRE(answer.verdict == ScrewVerdict::contact);
    CHECK(answer.free_until <= 0.25);
    CHECK(answer.contact_by >= 0.25);
    CHECK(answer.contact_by - answer.free_until < width / 8);
    width = answer.contact_by - answer.free_until;
  }
  CHECK(solve_screw(thrown_at_wall(0.999)).verdict == ScrewVerdict::free);
  CHECK(solve_screw(thrown_at_wall(1)).verdict == ScrewVerdict::within_bound);  // a graze
  // With four control points the same parabola.
  CurvedQuery cubic = thrown_at_wall(4.0 / 3);
  cubic.motions[0].control_points = 4;
  cubic.motions[0].inner = {{{1 / 3.0, 16 / 9.0, 0}, {2 / 3.0, 16 / 9.0, 0}}};
  const ScrewAnswer same = solve_screw(cubic, {1, {}, 4096, 4096});
  CHECK(same.verdict == ScrewVerdict::contact);
  CHECK(std::fabs(same.contact_by - 0.25) < 1e-6);
  // A point that stays in the plane of an edge, but for its way between.
  CurvedQuery flat = curved(Kind::point_edge, {body(0, {0, 0, 0}), rest({-9, 1, 0}), rest({9, 1, 0})}, {RigidMotion()});
  flat.motions[0] = thrown_at_wall(4.0 / 3).motions[0];
  flat.motions[0].q1 = {1, 0, 0, 1};
  CHECK(solve_screw(flat).verdict == ScrewVerdict::contact);
  flat.motions[0].inner[0].z = 1;
  CHECK(solve_screw(flat).verdict == ScrewVerdict::free);
}

TEST_CASE("the tip of a rod comes near a wall, and the bound decides") {
  const CurvedQuery near = tip_and_wall(5.0001);
  CHECK(solve_screw(near, {1, {}, 4, 4}).verdict == ScrewVerdict::within_bound);
  CHECK(solve_screw(near).verdict == ScrewVerdict::free);
  // It touches the wall at t = 1 only: y = 5. There the pose is exact.
  const ScrewAnswer end = solve_screw(tip_and_wall(5));
  CHECK(end.verdict == ScrewVerdict::contact);
  CHECK(end.contact_by == 1);
  CHECK(end.free_until > 0.9);
  // It grazes the wall at t = 1/2: no number of arcs proves that or its absence.
  CurvedQuery graze = tip_and_wall(5);
  graze.motions[0].q0 = {1, 0, 0, -0.5};
  graze.motions[0].q1 = {1, 0, 0, 0.5};
  graze.corners[0].points[0] = {0, 5, 0};
  const ScrewAnswer answer = solve_screw(graze);
  CHECK(answer.verdict == ScrewVerdict::within_bound);
  CHECK(answer.arcs == 256);
  CHECK(answer.free_until > 0.49);
  CHECK(answer.free_until <= 0.5);
  const ScrewAnswer start = solve_screw(tip_and_wall(0));
  CHECK(start.verdict == ScrewVerdict::contact);
  CHECK(start.contact_by == 0);
}

TEST_CASE("the tip of a rod comes within a distance of a wall") {
  const CurvedQuery query = tip_and_wall(6);
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const ScrewAnswer answer = solve_screw(query, {1, {3.5, metric}, 1024, 1024});  // y = 5/2 at t = 1/3
    CAPTURE(answer.free_until, answer.contact_by);
    REQUIRE(answer.verdict == ScrewVerdict::contact);
    CHECK(answer.free_until < 1 / 3.0);
    CHECK(answer.contact_by > 1 / 3.0);
    CHECK(answer.contact_by - answer.free_until < 1e-8);
    CHECK(solve_screw(query, {1, {0.99, metric}}).verdict == ScrewVerdict::free);
    CHECK(solve_screw(query, {1, {7, metric}}).contact_by == 0);
  }
}

/// The elements' distance on the true motion, but for the rounding of the corners.
double true_distance(const CurvedQuery& query, double t) {
  Query at;
  at.kind = query.kind;
  for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
    const BigPoint x = true_position(query, c, t);
    at.start[c] = at.end[c] = {x[0].to_double(), x[1].to_double(), x[2].to_double()};
  }
  return distance(at).value;
}

TEST_CASE("verdicts on random motions hold on the true motion") {
  std::array<std::size_t, 3> verdicts{};
  for (std::uint64_t index = 0; index < effort(120); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 2, index));
    const Kind kind = rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
    CurvedQuery query = rng.one_in(2) ? random_query(kind, rng) : meeting_query(kind, rng);
    for (RigidMotion& motion : query.motions) {
      if (rng.one_in(3)) bend(motion, rng);
    }
    ScrewOptions options;
    options.arcs = 1 << rng.between(2, 5);
    options.most_arcs = rng.one_in(2) ? options.arcs : 256;
    const ScrewAnswer answer = solve_screw(query, options);
    INFO("seed " << kSeed << ", index " << index << ": " << name_of(answer.verdict) << ", free until "
                 << hexfloat(answer.free_until) << ", contact by " << hexfloat(answer.contact_by) << "\n"
                 << text_of(query));
    ++verdicts[static_cast<std::size_t>(answer.verdict)];
    REQUIRE(answer.free_until <= answer.contact_by);
    constexpr int kSamples = 60;
    for (int i = 0; i < kSamples; ++i) {
      const double t = answer.free_until * i / kSamples;
      REQUIRE(true_distance(query, t) > 0);
    }
    if (answer.verdict == ScrewVerdict::free) REQUIRE(answer.free_until == 1);
    if (answer.verdict != ScrewVerdict::contact || answer.contact_by == 0) continue;
    // The first contact is between the two times: the distance there falls to less than a corner moves in a part.
    const double width = answer.contact_by - answer.free_until;
    double least = true_distance(query, answer.contact_by);
    for (int i = 0; i < kSamples; ++i) {
      least = std::min(least, true_distance(query, answer.free_until + width * i / kSamples));
    }
    const double speed = 2 * (2 * 3.2 * 40 + 3 * 2 * 60);  // corners of these families are less than 40 from the origin
    REQUIRE(least <= speed * width / kSamples + 1e-12);
  }
  std::printf("seed %llu: %zu motions free, %zu with contact, %zu within the bound\n",
              static_cast<unsigned long long>(kSeed), verdicts[0], verdicts[1], verdicts[2]);
  if (whole_effort("that all verdicts occur")) {
    for (const std::size_t count : verdicts) CHECK(count > 0);
  }
}

std::string message_of(const CurvedQuery& query, const ScrewOptions& options) {
  try {
    (void)solve_screw(query, options);
  } catch (const InvalidQuery& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("a point passes through an edge in the plane of both") {
  // Two rectangles in the plane, one of which flies and turns: each corner against each side of the other one.
  const auto turn = [](double angle) { return std::array<double, 4>{std::cos(angle / 2), 0, 0, std::sin(angle / 2)}; };
  const auto rectangle = [](double x, double y, double z) {
    return std::array<Vec3, 4>{{{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}}};
  };
  for (const double height : {0.0, 0.1, -30.0}) {
    const std::array corners{rectangle(20, 4, height), rectangle(2, 2, height / 2)};
    std::array<RigidMotion, 2> motions;
    motions[0].q0 = motions[0].q1 = turn(2.2);
    motions[0].p0 = motions[0].p1 = {18, -45, 0};
    motions[1].q0 = turn(0.7);
    motions[1].q1 = turn(1.3);
    int contacts = 0, frees = 0;
    for (int step = 0; step < 8; ++step) {
      motions[1].p0 = {26.0 - step, -40, height - height / 2};
      motions[1].p1 = {29.5 - step, -44, height - height / 2};
      for (std::size_t one = 0; one < 2; ++one) {
        for (std::size_t i = 0; i < 16; ++i) {
          const auto& sides = corners[1 - one];
          CurvedQuery query;
          query.kind = Kind::point_edge;
          query.motions = {motions[one], motions[1 - one], {}, {}};
          query.corners = {CurvedCorner::on_body(0, corners[one][i / 4]), CurvedCorner::on_body(1, sides[i % 4]),
                           CurvedCorner::on_body(1, sides[(i + 1) % 4]), CurvedCorner{}};
          const ScrewAnswer answer = solve_screw(query);
          CAPTURE(height, step, one, i);
          CHECK(answer.verdict != ScrewVerdict::within_bound);
          // The same with the sides as walls, in space.
          query.kind = Kind::vertex_face;
          query.corners[3] = query.corners[2];
          query.corners[1].points[0].z -= 30;
          query.corners[2].points[0].z -= 30;
          query.corners[3].points[0].z += 60;
          const ScrewAnswer wall = solve_screw(query);
          if (answer.verdict == ScrewVerdict::contact) {
            ++contacts;
            CHECK(answer.contact_by - answer.free_until < 1e-3);
          } else {
            ++frees;
          }
          if (wall.verdict != ScrewVerdict::contact) continue;
          CHECK(answer.verdict == ScrewVerdict::contact);
          CHECK(wall.contact_by >= answer.free_until);
        }
      }
    }
    CHECK(contacts > 0);
    CHECK(frees > 0);
  }
}

TEST_CASE("options of a motion of constant rate that have no meaning are errors") {
  CurvedQuery query = tip_and_wall(1);
  CHECK(message_of(query, {1, {}, 3, 8}).find("arcs is 3; the number of arcs must be a power of two from 4") == 0);
  CHECK(message_of(query, {1, {}, 8, 1 << 21}).find("most_arcs is 2097152") == 0);
  CHECK(message_of(query, {1, {}, 2, 8}).find("arcs is 2") == 0);
  CHECK(message_of(query, {2}).find("t_max") != std::string::npos);
  CHECK(message_of(query, {1, {-1}}).find("the separation is -1") != std::string::npos);
  query.motions[0].q1 = {-1, 0, 0, 0};
  CHECK(message_of(query, {}).find("change the sign") != std::string::npos);
  query.motions[0].q1 = {1, 0, 0, 0};
  query.motions[0].control_points = 5;
  CHECK(message_of(query, {}).find("motion 0: the position has 5 control points; its curve has 2 to 4") == 0);
  query.motions[0].control_points = 4;
  query.motions[0].inner[1].y = std::nan("");
  CHECK(message_of(query, {}).find("motion 0: the inner control point 1 has y = nan") == 0);
  query.motions[0].control_points = 3;  // the second inner point does not count
  CHECK(message_of(query, {}).empty());
  CHECK_THROWS_WITH(solve(query), Catch::Contains("the position is on a curve of 3 control points; only solve_screw"));
}

}  // namespace
}  // namespace touchstone::tests
