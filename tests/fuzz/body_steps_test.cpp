// Steps of whole bodies: the library is right about each family, planted faults are found, and lines read back.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <touchstone/touchstone.hpp>

#include "fuzz/bodies/body_steps.hpp"
#include "fuzz/bodies/fuzz_bodies.hpp"
#include "fuzz/bodies/pipe_bodies.hpp"
#include "fuzz/processes/no_reply.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using touchstone::tests::effort;

namespace {

constexpr double kNoTime = std::numeric_limits<double>::infinity();

fuzz::SceneOutcome<families::BodyScene> wrong_steps(const fuzz::BodyStepSolver& solver, std::uint64_t cases,
                                                    std::vector<std::string> families = {}) {
  StepFuzzOptions options;
  options.cases = cases;
  options.families = std::move(families);
  options.threads = 2;
  return fuzz::search_body_steps([&] { return solver; }, options, std::nullopt, {});
}

/// The library's replies, changed by a fault.
fuzz::BodyStepSolver with_reply(const std::function<void(fuzz::BodyStepReply&)>& fault) {
  return [fault](const Bodies& bodies, const std::vector<RigidMotion>& motions) {
    fuzz::BodyStepReply reply = fuzz::library_step_reply(bodies, motions);
    fault(reply);
    return reply;
  };
}

Vec3 placed(const RigidMotion& motion, const Vec3& x, double t) {
  std::array<double, 4> q{};
  double squares = 0;
  for (std::size_t i = 0; i < 4; ++i) q[i] = (1 - t) * motion.q0[i] + t * motion.q1[i], squares += q[i] * q[i];
  const auto cross = [](const Vec3& a, const Vec3& b) {
    return Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const Vec3 v{q[1], q[2], q[3]}, c = cross(v, x), d = cross(v, c);
  const auto at = [&](double p0, double p1, double from, double once, double twice) {
    return (1 - t) * p0 + t * p1 + from + 2 * (q[0] * once + twice) / squares;
  };
  return {at(motion.p0.x, motion.p1.x, x.x, c.x, d.x), at(motion.p0.y, motion.p1.y, x.y, c.y, d.y),
          at(motion.p0.z, motion.p1.z, x.z, c.z, d.z)};
}

/// A broad phase of the test's own: boxes around an element's corners at some times, wider by a margin.
std::vector<BodyPair> pairs_by_boxes(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                     const std::vector<double>& times, double margin) {
  using Box = std::array<double, 6>;
  const auto box_of = [&](BodyIndex body, const std::vector<MeshIndex>& corners) {
    Box box{kNoTime, kNoTime, kNoTime, -kNoTime, -kNoTime, -kNoTime};
    for (const MeshIndex v : corners) {
      for (const double t : times) {
        const Vec3 p = placed(motions[body], bodies.bodies[body].points()[v], t);
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = k == 0 ? p.x : k == 1 ? p.y : p.z;
          box[k] = std::min(box[k], x - margin), box[k + 3] = std::max(box[k + 3], x + margin);
        }
      }
    }
    return box;
  };
  std::vector<BodyPair> pairs;
  for (const BodyPair& pair : families::every_pair(bodies)) {
    const auto element = [&](const BodyElement& one, bool first) {
      const Mesh& mesh = bodies.bodies[one.body].mesh();
      std::vector<MeshIndex> corners{one.element};
      const bool is_edge = pair.kind == Kind::edge_edge || (pair.kind == Kind::point_edge && !first);
      if (is_edge) corners.assign(mesh.edges()[one.element].begin(), mesh.edges()[one.element].end());
      if (pair.kind == Kind::vertex_face && !first) {
        corners.assign(mesh.faces()[one.element].begin(), mesh.faces()[one.element].end());
      }
      return box_of(one.body, corners);
    };
    const Box a = element(pair.first, true), b = element(pair.second, false);
    const double room = separation_of(bodies, pair).distance;
    bool near = true;
    for (std::size_t k = 0; k < 3; ++k) near = near && a[k] - b[k + 3] <= room && b[k] - a[k + 3] <= room;
    if (near) pairs.push_back(pair);
  }
  return pairs;
}

/// The doubles of rows of three or four, bit for bit.
template <class Row>
bool reads_back(const nlohmann::json& read, const Row& row) {
  return read.size() == row.size() && std::equal(row.begin(), row.end(), read.begin(), [](double x, const auto& y) {
           const double value = y.template get<double>();
           return std::memcmp(&x, &value, sizeof x) == 0;
         });
}
std::array<double, 3> row_of(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

TEST_CASE("fuzzed steps of bodies: the library is right about each family", "[slow]") {
  const auto families = fuzz::body_families();
  std::vector<std::size_t> contacts(families.size()), free(families.size());
  for (std::size_t family = 0; family < families.size(); ++family) {
    for (std::uint64_t i = 0; i < effort(25); ++i) {
      CAPTURE(families[family], i);
      const auto failure = fuzz::judge_body_step(fuzz::body_step_of({family, 1, i}, {}),
                                                 with_reply([&](const fuzz::BodyStepReply& reply) {
                                                   contacts[family] += reply.first_contact != kNoTime ? 1 : 0;
                                                   free[family] += reply.free > 0 ? 1 : 0;
                                                 }),
                                                 {});
      INFO((failure ? failure->question + ": " + failure->detail : std::string()));
      CHECK(!failure);
    }
    CAPTURE(families[family]);
    CHECK(contacts[family] > 0);
    CHECK(free[family] > 0);
  }
}

TEST_CASE("fuzzed steps of bodies: boxes of both ends of an arc are too small, and many waypoints with room are not",
          "[slow]") {
  const auto by_boxes = [](std::vector<double> times, double margin) {
    return [=](const Bodies& bodies, const std::vector<RigidMotion>& motions) {
      return fuzz::BodyStepReply{std::nullopt, std::nullopt, pairs_by_boxes(bodies, motions, times, margin)};
    };
  };
  const std::vector<std::string> near = {"bodies_quarter", "bodies_gears", "bodies_inside"};
  std::vector<double> many;
  for (int i = 0; i <= 64; ++i) many.push_back(i / 64.0);
  CHECK(wrong_steps(by_boxes(many, 0.5), effort(60), near).failures == 0);
  const auto outcome = wrong_steps(by_boxes({0, 1}, 1e-9), 120, near);
  REQUIRE(outcome.findings.size() == 1);
  const fuzz::BodyFinding& finding = outcome.findings[0];
  CAPTURE(to_string(finding));
  CHECK(finding.failure.failure == FuzzFailure::missed);
  CHECK(finding.failure.question == "candidates");
  CHECK(finding.scene.shapes.size() == 2);
  CHECK(finding.scene.shapes[0].points.size() + finding.scene.shapes[1].points.size() <= 4);
  // The case from which it was shrunk fails in the same way.
  const auto again =
      fuzz::judge_body_step(fuzz::body_step_of(finding.name, {}), by_boxes({0, 1}, 1e-9), StepFuzzOptions{});
  REQUIRE(again);
  CHECK(again->question == "candidates");
}

TEST_CASE("fuzzed steps of bodies: each sort of wrong reply is found", "[slow]") {
  struct Planted {
    const char* question;
    FuzzFailure failure;
    std::function<void(fuzz::BodyStepReply&)> fault;
  };
  const std::vector<Planted> all = {
      {"free", FuzzFailure::late, [](auto& reply) { *reply.free = std::min(0.99, *reply.free * 1.5); }},
      {"free", FuzzFailure::missed, [](auto& reply) { reply.free = 1; }},
      {"free", FuzzFailure::early, [](auto& reply) { reply.free = 0; }},
      {"first contact", FuzzFailure::missed, [](auto& reply) { reply.first_contact = kNoTime; }},
      {"first contact", FuzzFailure::late,
       [](auto& reply) {
         if (*reply.first_contact < 1) *reply.first_contact = std::nextafter(*reply.first_contact, 2);
       }},
      {"first contact", FuzzFailure::phantom,
       [](auto& reply) { *reply.first_contact = std::min(*reply.first_contact, 1.0); }},
      {"first contact", FuzzFailure::malformed, [](auto& reply) { reply.first_contact = std::nan(""); }},
      {"candidates", FuzzFailure::missed,
       [](auto& reply) {
         if (!reply.candidates->empty())
           reply.candidates->erase(reply.candidates->begin() + reply.candidates->size() / 2);
       }},
      {"candidates", FuzzFailure::malformed,
       [](auto& reply) {
         reply.candidates->push_back({Kind::edge_edge, {0, 0}, {7, 0}});
       }},
      {"all", FuzzFailure::crash, [](auto&) { throw Error("planted"); }}};
  for (const Planted& planted : all) {
    CAPTURE(planted.question, name_of(planted.failure));
    bool found = false;
    for (std::uint64_t i = 0; i < 60 && !found; ++i) {
      const auto failure =
          fuzz::judge_body_step(fuzz::body_step_of({i % 4, 1, i}, {}), with_reply(planted.fault), StepFuzzOptions{});
      found = failure && failure->question == planted.question && failure->failure == planted.failure;
    }
    CHECK(found);
  }
}

TEST_CASE("fuzzed steps of bodies: a reply of 0 is right where bodies intersect at the start, and only there") {
  std::uint64_t intersecting = 0;
  const auto replies_0 = [&](bool only_there) {
    return wrong_steps(
        [&, only_there](const Bodies& bodies, const std::vector<RigidMotion>& motions) {
          std::vector<Pose> poses;
          for (const RigidMotion& motion : motions) poses.push_back({motion.q0, motion.p0});
          const bool there = !intersections(bodies, poses).empty();
          static std::mutex mutex;
          const std::lock_guard lock(mutex);
          intersecting += there;
          fuzz::BodyStepReply reply;
          if (there || !only_there) reply.free = reply.first_contact = 0;
          return reply;
        },
        40, {"bodies_random"});
  };
  CHECK(replies_0(true).findings.empty());
  CHECK(intersecting > 0);
  CHECK_FALSE(replies_0(false).findings.empty());
}

TEST_CASE("fuzzed steps of bodies: what the options leave out is not there") {
  StepFuzzOptions options;
  bool has_radii = false, has_separation = false, has_rules = false;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const auto radii = [](const families::BodyScene& scene) { return !scene.shapes[0].elements.radii.empty(); };
    options.separations = options.groups = true;
    const families::BodyScene all = fuzz::body_step_of({0, 1, i}, options);
    has_radii = has_radii || radii(all), has_separation = has_separation || all.separation.distance > 0;
    has_rules = has_rules || !all.rules.body_pairs.empty();
    options.separations = options.groups = false;
    const families::BodyScene less = fuzz::body_step_of({0, 1, i}, options);
    CHECK(!radii(less));
    CHECK(less.separation.distance == 0);
    CHECK(less.rules.body_pairs.empty());
  }
  CHECK(has_radii);
  CHECK(has_separation);
  CHECK(has_rules);
}

TEST_CASE("fuzzed steps of bodies: a line reads back as the same numbers") {
  for (std::uint64_t i = 0; i < 30; ++i) {
    const families::BodyScene scene = fuzz::body_step_of({i % 6, 3, i}, {});
    const Bodies bodies = scene.bodies();
    const std::string line = fuzz::bodies_line(bodies, scene.motions);
    CHECK(line.find('\n') == line.size() - 1);
    const auto read = nlohmann::json::parse(line);
    CAPTURE(line);
    REQUIRE(read["bodies"].size() == scene.shapes.size());
    REQUIRE(read["motions"].size() == scene.shapes.size());
    for (std::size_t b = 0; b < scene.shapes.size(); ++b) {
      const auto& body = read["bodies"][b];
      const Mesh& mesh = bodies.bodies[b].mesh();
      REQUIRE(body["points"].size() == scene.shapes[b].points.size());
      for (std::size_t v = 0; v < body["points"].size(); ++v) {
        CHECK(reads_back(body["points"][v], row_of(scene.shapes[b].points[v])));
      }
      CHECK(body["faces"].get<std::vector<std::array<MeshIndex, 3>>>() == mesh.faces());
      CHECK(body["edges"].get<std::vector<std::array<MeshIndex, 2>>>() == mesh.edges());
      CHECK(body["loose_points"].get<std::vector<MeshIndex>>() == mesh.points());
      const std::vector<double>& radii = scene.shapes[b].elements.radii;
      CHECK(body.contains("radii") == !radii.empty());
      if (!radii.empty()) CHECK(reads_back(body["radii"], radii));
      const auto& motion = read["motions"][b];
      CHECK(reads_back(motion["q0"], scene.motions[b].q0));
      CHECK(reads_back(motion["q1"], scene.motions[b].q1));
      CHECK(reads_back(motion["p0"], row_of(scene.motions[b].p0)));
      CHECK(reads_back(motion["p1"], row_of(scene.motions[b].p1)));
    }
    CHECK(read["body_pairs"].get<std::vector<std::array<BodyIndex, 2>>>() == scene.rules.body_pairs);
    CHECK(read["separation"].get<double>() == scene.separation.distance);
    CHECK(read["metric"] == std::string(name_of(scene.separation.metric)));
  }
}

TEST_CASE("fuzzed steps of bodies: the replies that a program may give") {
  const fuzz::BodyStepReply all = fuzz::read_body_reply(
      R"({"free": 1, "first_contact": null,
          "candidates": [["vertex-face", [1, 3], [0, 2]], ["point-point", [0, 1], [1, 0]]]})");
  CHECK(all.free == 1);
  CHECK(all.first_contact == kNoTime);
  CHECK(all.candidates ==
        std::vector<BodyPair>{{Kind::vertex_face, {1, 3}, {0, 2}}, {Kind::point_point, {0, 1}, {1, 0}}});
  const auto refused = [&](const std::string& reply, const std::string& reason) {
    CAPTURE(reply.substr(0, 100));
    try {
      fuzz::read_body_reply(reply);
      FAIL_CHECK("it was read");
    } catch (const fuzz::NoReply& trouble) {
      CAPTURE(trouble.what());
      CHECK(trouble.failure() == FuzzFailure::malformed);
      CHECK(std::string(trouble.what()).find(reason) != std::string::npos);
    }
  };
  const std::string example = R"(a candidate must be such as ["edge-edge", [0, 3], [1, 5]])";
  refused("no", R"(or {"candidates": [["edge-edge", [0, 3], [1, 5]]]})");
  refused("{\"candidates\":[[\"edge-edge\",[0,1]," + std::string(400'000, '[') + std::string(400'000, ']') + "]]}",
          example);
  refused("{\"candidates\":[" + std::string(400'000, '[') + std::string(400'000, ']') + "]}", example);
  refused(R"({"candidates": [["edge-edge", 0, 3]]})", example);
  refused(R"({"candidates": [["edge-edge", [0, 3]]]})", example);
  refused(R"({"candidates": [["edge-edge", [0, 3], [1, 5, 6]]]})", example);
  refused(R"({"candidates": [["edge-edge", [0, 3], [1, -5]]]})", example);
  refused(R"({"candidates": [["edge-edge", [0, 3], [1, 5.5]]]})", example);
  refused(R"({"candidates": [["edge-face", [0, 3], [1, 5]]]})", example);
}
