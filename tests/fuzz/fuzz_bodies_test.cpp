// Scenes of whole bodies: the library is right about each family, and each planted fault is found and shrunk.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "fuzz/bodies/fuzz_bodies.hpp"
#include "fuzz/bodies/shrink_bodies.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::fuzz;
using touchstone::tests::effort;
using touchstone::tests::whole_effort;

namespace {

/// The library's answers, changed by a fault.
BodySolver with_fault(const std::function<void(BodyReply&)>& fault) {
  return [fault](const Bodies& bodies, const std::vector<RigidMotion>& motions) {
    BodyReply reply = library_body_reply(bodies, motions);
    fault(reply);
    return reply;
  };
}

BodyFuzzOutcome find(const std::function<void(BodyReply&)>& fault, std::uint64_t cases = 60) {
  SceneSettings settings;
  settings.cases = cases;
  settings.seconds = 30;
  settings.threads = 2;
  settings.most_findings = 1;
  return fuzz_bodies(with_fault(fault), settings);
}

std::size_t elements_of(const families::BodyScene& scene) {
  std::size_t count = 0;
  for (const families::BodyShape& shape : scene.shapes) {
    count += shape.points.size() + shape.elements.edges.size() + shape.elements.faces.size();
  }
  return count;
}

}  // namespace

TEST_CASE("fuzzed bodies: the library is right, and each family has contacts and free steps") {
  const std::size_t cases = effort(20);
  for (const families::BodyFamily family : families::kEveryBodyFamily) {
    std::size_t contacts = 0, starts = 0, inside = 0, free = 0;
    for (std::uint64_t i = 0; i < cases; ++i) {
      CAPTURE(families::name_of(family), i);
      const auto failure = judge_bodies(families::body_scene(family, 1, i), with_fault([&](const BodyReply& reply) {
                                          contacts += reply.first.contact ? 1 : 0;
                                          starts += reply.first.at_start.empty() ? 0 : 1;
                                          inside += reply.first.start_intersections.empty() ? 0 : 1;
                                          free += reply.first.free() ? 1 : 0;
                                        }));
      INFO((failure ? failure->question + ": " + failure->detail : std::string()));
      CHECK(!failure);
    }
    if (!whole_effort("that each family has contacts")) continue;
    CAPTURE(families::name_of(family), contacts, starts, inside, free);
    CHECK(contacts > 0);
    if (family == families::BodyFamily::bodies_touch) CHECK(starts > 0);
    if (family == families::BodyFamily::bodies_inside) CHECK(inside > cases / 2);
    const bool always_meets =
        family == families::BodyFamily::bodies_inside || family == families::BodyFamily::bodies_touch;
    if (!always_meets) CHECK(free > 0);
  }
}

TEST_CASE("fuzzed bodies: a dropped pair is found, and shrunk to the two elements") {
  const auto drop = [](BodyReply& reply) {
    if (!reply.all.empty()) reply.all.pop_back();
  };
  const BodyFuzzOutcome outcome = find(drop);
  REQUIRE(outcome.findings.size() == 1);
  const BodyFinding& finding = outcome.findings[0];
  CHECK(finding.failure.failure == FuzzFailure::missed);
  CHECK(finding.failure.question == "all contacts");
  CHECK(finding.count > 1);
  CHECK(elements_of(finding.scene) <= 8);  // two edges have six
  CHECK(judge_bodies(finding.scene, with_fault(drop)));
  CHECK(!judge_bodies(finding.scene, library_body_reply));
  const families::BodyScene before =
      families::body_scene(families::kEveryBodyFamily.at(finding.name.family), finding.name.seed, finding.name.index);
  CHECK(difficulty(finding.scene) < difficulty(before));
  CHECK(judge_bodies(before, with_fault(drop)));
  const std::string text = to_string(finding);
  CAPTURE(text);
  CHECK(text.find("missed ") == 0);
  CHECK(text.find("  body 1  points (") != std::string::npos);
}

TEST_CASE("fuzzed bodies: each sort of wrong answer is found") {
  struct Planted {
    const char* question;
    FuzzFailure failure;
    std::function<void(BodyReply&)> fault;
  };
  const std::vector<Planted> all = {
      {"candidates", FuzzFailure::missed, [](BodyReply& reply) { reply.candidates.clear(); }},
      {"all contacts", FuzzFailure::late,
       [](BodyReply& reply) {
         if (!reply.all.empty()) reply.all.back().answer.toi = 1.5;
       }},
      {"all contacts", FuzzFailure::phantom,
       [](BodyReply& reply) {
         if (reply.all.empty()) reply.all.push_back({{Kind::edge_edge, {0, 0}, {1, 0}}, {}, {}});
       }},
      {"first contact", FuzzFailure::missed,
       [](BodyReply& reply) {
         if (!reply.first.earliest.empty()) reply.first.earliest.pop_back();
       }},
      {"first contact", FuzzFailure::missed, [](BodyReply& reply) { reply.first.at_start.clear(); }},
      {"first contact", FuzzFailure::differs, [](BodyReply& reply) { reply.first.toi += 0x1p-20; }},
      {"start", FuzzFailure::missed, [](BodyReply& reply) { reply.first.start_intersections.clear(); }},
      {"free step", FuzzFailure::differs, [](BodyReply& reply) { reply.step.outcome = StepOutcome::no_room; }},
      {"all", FuzzFailure::crash, [](BodyReply&) { throw Error("planted"); }}};
  for (const Planted& planted : all) {
    CAPTURE(planted.question, name_of(planted.failure));
    std::string seen;
    bool found = false;
    for (std::uint64_t i = 0; i < 60 && !found; ++i) {
      const auto family = families::kEveryBodyFamily[i % families::kEveryBodyFamily.size()];
      const auto failure = judge_bodies(families::body_scene(family, 1, i), with_fault(planted.fault));
      if (failure) seen += failure->question + " " + std::string(name_of(failure->failure)) + "; ";
      found = failure && failure->question == planted.question && failure->failure == planted.failure;
    }
    CAPTURE(seen);
    CHECK(found);
  }
}

TEST_CASE("fuzzed bodies: a free step that goes on to the contact is found") {
  bool found = false;
  for (std::uint64_t i = 0; i < 40 && !found; ++i) {
    const families::BodyScene scene = families::body_scene(families::BodyFamily::bodies_quarter, 1, i);
    const auto failure = judge_bodies(scene, with_fault([&](BodyReply& reply) {
                                        for (std::size_t b = 0; b < scene.motions.size(); ++b) {
                                          reply.step.poses[b] = {scene.motions[b].q1, scene.motions[b].p1};
                                        }
                                      }));
    found = failure && failure->question == "free step" && failure->failure == FuzzFailure::missed;
  }
  CHECK(found);
}

TEST_CASE("fuzzed bodies: the name of a scene makes it again") {
  const auto families = body_families();
  const auto read = parse_scene_case(families, "bodies_gears 7 12");
  REQUIRE(read);
  CHECK(families.at(read->family) == "bodies_gears");
  CHECK(read->seed == 7);
  CHECK(read->index == 12);
  CHECK(case_text(families, *read) == "bodies_gears 7 12");
  for (const char* wrong : {"", "bodies_gears", "bodies_gears 7", "gears 7 12", "bodies_gears 7 12 1",
                            "bodies_gears 7 x", "bodies_gears  7 12", "bodies_gears -7 12"}) {
    CAPTURE(wrong);
    CHECK(!parse_scene_case(families, wrong));
  }
}
