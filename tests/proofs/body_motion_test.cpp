// Motions with bodies that turn: the boxes of their corners, and proofs that the checker accepts.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "proofs/body_box.hpp"
#include "proofs/mesh_motion.hpp"
#include "proofs/proof_text.hpp"
#include "proofs/run_checker.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using proofs::MotionElements;
using proofs::MotionFrame;
using proofs::MotionPair;
using seeded::Rng;

namespace {

Vec3 random_point(Rng& random, double size) {
  return {size * random.symmetric(), size * random.symmetric(), size * random.symmetric()};
}

/// A quaternion of some length that is no more than a half turn from `before`.
std::array<double, 4> random_turn(Rng& random, const std::array<double, 4>& before) {
  std::array<double, 4> q{};
  double product = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    q[i] = before[i] + 0.7 * random.symmetric();
    product += q[i] * before[i];
  }
  const double factor = std::ldexp(product < 0 ? -1 : 1, random.between(-2, 2));
  for (double& c : q) c *= factor;
  return q;
}

/// Tetrahedra and a wire on bodies, one of them fixed, among free triangles.
MotionElements elements_of_bodies(Rng& random) {
  MotionElements elements;
  const auto add_edge = [&](std::uint32_t a, std::uint32_t b) { elements.edges.push_back({a, b}); };
  elements.vertex_count = 6;
  elements.faces = {{0, 1, 2}, {3, 4, 5}};
  for (const std::uint32_t v : {0U, 3U}) add_edge(v, v + 1), add_edge(v + 1, v + 2), add_edge(v + 2, v);
  for (std::uint32_t body = 0; body < 4; ++body) {
    const auto first = static_cast<std::uint32_t>(elements.vertex_count);
    for (std::uint32_t i = 0; i < 4; ++i) {
      elements.on_bodies.push_back({body, random_point(random, 0.5)});
      for (std::uint32_t j = 0; j < i; ++j) {
        if (body < 3 || i == j + 1) add_edge(first + j, first + i);
      }
    }
    if (body < 3) elements.faces.push_back({first, first + 1, first + 2});
    elements.vertex_count += 4;
  }
  for (std::uint32_t v = 0; v < elements.vertex_count; ++v) {
    elements.points.push_back(v);
    elements.fixed.push_back(v >= 6 && v < 10 ? 1 : 0);
  }
  return elements;
}

MotionFrame next_frame(Rng& random, const MotionFrame& before) {
  MotionFrame frame = before;
  for (Vec3& x : frame) x = {x.x + 0.1 * random.symmetric(), x.y + 0.1 * random.symmetric(), x.z};
  for (std::size_t b = 1; b < frame.poses.size(); ++b) {
    frame.poses[b].q = random_turn(random, before.poses[b].q);
    frame.poses[b].p = random_point(random, 0.6);
  }
  return frame;
}

bool names_body(const MotionElements& elements, const MotionPair& pair) {
  const auto on_body = [&](std::uint32_t v) { return v >= elements.free_count(); };
  if (pair.kind == Kind::edge_edge) {
    return on_body(elements.edges[pair.first][0]) || on_body(elements.edges[pair.second][0]);
  }
  return on_body(elements.points[pair.first]) || on_body(elements.faces[pair.second][0]);
}

}  // namespace

TEST_CASE("the box of a body's point has the doubles of the page") {
  const proofs::PointBox quarter = proofs::box_on_body({{1, 0, 0, 0}, {1, 0, 0, 1}, {}, {}}, {1, 0, 0});
  CHECK((quarter.low.x == 0 && quarter.high.x == 1));
  CHECK((quarter.low.y == 0 && quarter.high.y == 1));
  CHECK((quarter.low.z == 0 && quarter.high.z == 0));
  const proofs::PointBox less = proofs::box_on_body({{-7, 0, 0, 0}, {-4, 0, 0, -2}, {}, {}}, {-1, 0, 0});
  CHECK((less.high.x == -0x1.3333333333333p-1 && less.low.y == -0x1.999999999999ap-1));
  CHECK_THROWS_AS(proofs::box_on_body({{1, 0, 0, 0}, {-1, 0, 0, 0.1}, {}, {}}, {1, 0, 0}), Error);
  CHECK_THROWS_AS(proofs::box_on_body({{1, 0, 0, 0}, {1, 0, 0, 1}, {}, {}}, {0x1.8p1023, 0x1.8p1023, 0}), Error);
}

TEST_CASE("the box of a body's point holds its way") {
  Rng random(3);
  double slack = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::array<double, 4> q0 = random_turn(random, {1, 0, 0, 0});
    const RigidMotion motion{q0, random_turn(random, q0), random_point(random, 1), random_point(random, 1)};
    const Vec3 point = random_point(random, 1);
    const proofs::PointBox box = proofs::box_on_body(motion, point);
    double least = 10;
    for (int i = 0; i <= 64; ++i) {
      const double t = i / 64.0, s = 1 - t;
      std::array<double, 4> q{};
      for (std::size_t c = 0; c < 4; ++c) q[c] = s * motion.q0[c] + t * motion.q1[c];
      const double w = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
      const double x = (q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3]) * point.x +
                       2 * (q[1] * q[2] - q[0] * q[3]) * point.y + 2 * (q[1] * q[3] + q[0] * q[2]) * point.z;
      const double at = x / w + s * motion.p0.x + t * motion.p1.x;
      REQUIRE(at >= box.low.x - 1e-12);
      REQUIRE(at <= box.high.x + 1e-12);
      least = std::min({least, at - box.low.x, box.high.x - at});
    }
    slack = std::max(slack, least);
  }
  CHECK(slack < 1);  // no box is far too wide
}

TEST_CASE("the checker finds the pairs of motions with bodies, and accepts their proofs", "[slow]") {
  Rng random(8);
  std::size_t curved = 0, straight = 0, all_contacts = 0;
  for (const Separation& separation :
       {Separation{}, Separation{0.05, Metric::euclidean}, Separation{0.05, Metric::max}}) {
    for (int trial = 0; trial < 3; ++trial) {
      const proofs::StepProver prover(elements_of_bodies(random), separation);
      MotionFrame frame(prover.elements().free_count());
      for (Vec3& x : frame) x = random_point(random, 0.7);
      frame.poses.resize(4);
      std::string motion = proofs::motion_head(prover.elements()), text = proofs::kFirstLine;
      proofs::append_frame(motion, frame);
      proofs::append_separation(text, separation);
      text += "file mesh - motion.txt\n";
      std::size_t pairs = 0, contacts = 0;
      for (int step = 0; step < 2; ++step) {
        const MotionFrame end = next_frame(random, frame);
        proofs::append_frame(motion, end);
        text += "step " + std::to_string(step) + "\n";
        const auto found = prover.pairs(frame, end, 1);
        for (std::size_t i = 0; i < found.size(); ++i) {
          (names_body(prover.elements(), found[i]) ? curved : straight) += 1;
          contacts += prover.append_proof(text, i, found[i], frame, end).contact ? 1 : 0;
        }
        pairs += found.size();
        frame = end;
      }
      all_contacts += contacts;
      const auto ended = [&](std::size_t count) {
        return text + "end " + std::to_string(count) + " " + std::to_string(contacts) + "\n";
      };
      const CheckerRun run = check_texts(ended(pairs), {motion});
      INFO(run.text);
      REQUIRE(run.status == 0);
      const CheckerRun more = check_texts(ended(pairs + 1), {motion});
      CHECK(more.status == 1);
    }
  }
  CAPTURE(curved, straight, all_contacts);
  CHECK(curved > 500);
  CHECK(straight > 10);
  CHECK(all_contacts > 50);
}
