// Whole steps: the library is right about each family, and each planted fault is found and shrunk.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "families/step_scenes.hpp"
#include "fuzz/processes/no_reply.hpp"
#include "fuzz/steps/fuzz_steps.hpp"
#include "fuzz/steps/judge_step.hpp"
#include "fuzz/steps/pipe_steps.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using touchstone::tests::effort;
using touchstone::tests::whole_effort;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A broad phase of the test's own: boxes of vertices over the step, in single precision if asked for.
struct ToyBroadPhase {
  std::function<float(double, bool)> rounded;  ///< outwards or not: a coordinate, and whether it is an upper end
  bool centred = false;                        ///< by centres and half widths, in single precision
  std::function<bool(const Mesh&, const MeshPair&, const Positions& x0)> proposes = nullptr;
  bool only_start = false;  ///< a tree that is not refitted

  static bool are_centred_near(const double* low, const double* high, double distance) {
    float centre[2], half[2];
    for (int i = 0; i < 2; ++i) {
      const auto a = static_cast<float>(low[i]), b = static_cast<float>(high[i]);
      centre[i] = (a + b) / 2, half[i] = (b - a) / 2;
    }
    return std::fabs(centre[0] - centre[1]) <= half[0] + half[1] + static_cast<float>(distance);
  }

  StepReply operator()(const Mesh& mesh, const Positions& x0, const Positions& x1) const {
    std::vector<std::array<double, 6>> boxes;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      std::array<double, 6> box{};
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = x0.data[3 * v + k], b = only_start ? a : x1.data[3 * v + k];
        box[2 * k] = std::min(a, b), box[2 * k + 1] = std::max(a, b);
        if (rounded) box[2 * k] = rounded(box[2 * k], false), box[2 * k + 1] = rounded(box[2 * k + 1], true);
      }
      boxes.push_back(box);
    }
    StepReply reply;
    reply.candidates.emplace();
    for (const MeshPair& pair : families::every_pair(mesh, [](const MeshPair&) { return true; })) {
      const auto corners = mesh.corners(pair);
      const std::size_t first = pair.kind == Kind::edge_edge ? 2 : 1, count = corner_count(pair.kind);
      const double distance = mesh.separation(pair).distance;
      bool near = true;
      for (std::size_t k = 0; k < 3; ++k) {
        double low[2] = {kNever, kNever}, high[2] = {-kNever, -kNever};
        for (std::size_t c = 0; c < count; ++c) {
          const auto& box = boxes[corners[c]];
          const std::size_t element = c < first ? 0 : 1;
          low[element] = std::min(low[element], box[2 * k]), high[element] = std::max(high[element], box[2 * k + 1]);
        }
        const double room = distance * (1 + 0x1p-40);
        near = near &&
               (centred ? are_centred_near(low, high, distance) : low[0] - high[1] <= room && low[1] - high[0] <= room);
      }
      if (near && (!proposes || proposes(mesh, pair, x0))) reply.candidates->push_back(pair);
    }
    return reply;
  }
};

float to_float(double x, float towards) {
  auto rounded = static_cast<float>(x);
  if ((towards > 0 && rounded < x) || (towards < 0 && rounded > x)) rounded = std::nextafter(rounded, towards);
  return rounded;
}

StepFuzzReport found_in(const StepSolver& solver, std::uint64_t cases, std::vector<std::string> families = {}) {
  StepFuzzOptions options;
  options.cases = cases;
  options.families = std::move(families);
  options.threads = 2;
  options.findings = 1;
  return fuzz_steps(solver, options);
}

std::size_t elements_of(const StepFuzzFinding& finding) {
  std::size_t points = 0;  // loose ones
  for (MeshIndex v = 0; v < finding.mesh.vertex_count(); ++v) {
    const auto has = [v](const auto& corners) { return std::count(corners.begin(), corners.end(), v) > 0; };
    const auto& edges = finding.mesh.edges();
    points += std::none_of(edges.begin(), edges.end(), has) ? 1 : 0;
  }
  std::set<std::array<MeshIndex, 2>> wires;
  for (auto edge : finding.mesh.edges()) {
    std::sort(edge.begin(), edge.end());
    const bool is_side = std::any_of(finding.mesh.faces().begin(), finding.mesh.faces().end(), [&](const auto& face) {
      return std::count(face.begin(), face.end(), edge[0]) + std::count(face.begin(), face.end(), edge[1]) == 2;
    });
    if (!is_side) wires.insert(edge);
  }
  return points + wires.size() + finding.mesh.faces().size();
}

}  // namespace

TEST_CASE("fuzzed steps: a contact that is denied at the very end of a step is found") {
  const StepSolver solver = [](const Mesh& mesh, const Positions& x0, const Positions& x1) {
    StepReply reply = fuzz::library_reply(mesh, x0, x1);
    reply.candidates.reset();
    if (*reply.first_contact > 1 - 0x1p-40) reply.first_contact = kNever, reply.free = 1;
    return reply;
  };
  StepFuzzOptions options;
  options.families = {"steps_grazing"};
  options.cases = 200;
  const StepFuzzReport report = fuzz_steps(solver, options);
  CHECK(report.failures >= 10);
  REQUIRE(!report.findings.empty());
  CHECK(report.findings[0].failure == FuzzFailure::missed);
}

TEST_CASE("fuzzed steps: the library is right, and each family has contacts and free steps", "[slow]") {
  const std::size_t cases = effort(60);
  for (std::size_t family = 0; family < families::step_families().size(); ++family) {
    std::size_t contacts = 0, free = 0, whole = 0, most = 0;
    for (std::uint64_t i = 0; i < cases; ++i) {
      const families::StepScene scene = families::step_scene(static_cast<families::StepFamily>(family), 1, i);
      CAPTURE(families::step_families()[family], i);
      most = std::max(most, scene.x0.size());
      const auto failure = fuzz::judge_step(scene,
                                            [&](const Mesh& mesh, const Positions& x0, const Positions& x1) {
                                              const StepReply reply = fuzz::library_reply(mesh, x0, x1);
                                              contacts += reply.first_contact != kNever ? 1 : 0;
                                              free += reply.free > 0 ? 1 : 0;
                                              whole += reply.free == 1 ? 1 : 0;
                                              return reply;
                                            },
                                            {});
      INFO((failure ? failure->question + ": " + failure->detail : std::string()));
      CHECK(!failure);
    }
    CHECK(most <= 64);
    if (!whole_effort("that each family has contacts and free steps")) continue;
    CAPTURE(families::step_families()[family], contacts, free, whole);
    CHECK(contacts > 0);
    CHECK(free > 0);
    CHECK(whole > 0);
  }
}

TEST_CASE("fuzzed steps: a broad phase that is right has no finding") {
  const auto right = [](double x, bool up) { return to_float(x, up ? INFINITY : -INFINITY); };
  CHECK(found_in(ToyBroadPhase{}, effort(400)).failures == 0);
  CHECK(found_in(ToyBroadPhase{right}, effort(400)).failures == 0);
}

TEST_CASE("fuzzed steps: faults between a pair solver and a step are found, and shrunk", "[slow]") {
  struct Planted {
    const char* name;
    StepSolver solver;
  };
  std::atomic<std::uint64_t> pairs = 0;
  // A pair that a full buffer loses, by the places of its corners: shrinking keeps them.
  const auto dropped = [](const Mesh& mesh, const MeshPair& pair, const Positions& x0) {
    const auto corners = mesh.corners(pair);
    std::uint64_t hash = 0;
    for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, x0.data + 3 * std::size_t{corners[c]} + k, sizeof bits);
        hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
      }
    }
    return (hash >> 32) % 1000 != 0;
  };
  const auto neighbours = [](const Mesh& mesh, const MeshPair& pair, const Positions&) {  // that an edge joins
    const auto corners = mesh.corners(pair);
    const std::size_t first = pair.kind == Kind::edge_edge ? 2 : 1;
    for (std::size_t i = 0; i < first; ++i) {
      for (std::size_t j = first; j < corner_count(pair.kind); ++j) {
        for (const auto& [a, b] : mesh.edges()) {
          if ((a == corners[i] && b == corners[j]) || (b == corners[i] && a == corners[j])) return false;
        }
      }
    }
    return true;
  };
  ToyBroadPhase stale;
  stale.only_start = true;
  const std::vector<Planted> all = {
      {"a box rounded inwards",
       ToyBroadPhase{[](double x, bool up) { return to_float(x, up ? -INFINITY : INFINITY); }}},
      {"a float32 tree", ToyBroadPhase{nullptr, true}},
      {"a pair of a thousand is lost", ToyBroadPhase{nullptr, false, dropped}},
      {"neighbours' neighbours are left out", ToyBroadPhase{nullptr, false, neighbours}},
      {"a tree that is not refitted", stale},
      {"a race: now and then a pair is lost",
       [&](const Mesh& mesh, const Positions& x0, const Positions& x1) {
         StepReply reply = ToyBroadPhase{}(mesh, x0, x1);
         pairs += reply.candidates->size();
         if (!reply.candidates->empty() && pairs % 3 == 0) reply.candidates->pop_back();
         return reply;
       }},
  };
  for (const Planted& planted : all) {
    CAPTURE(planted.name);
    const StepFuzzReport report = found_in(planted.solver, 1500);
    REQUIRE(report.findings.size() == 1);
    const StepFuzzFinding& finding = report.findings[0];
    CAPTURE(to_string(finding));
    if (std::string(planted.name).starts_with("a race")) continue;  // nothing holds of it twice
    CHECK(finding.failure == FuzzFailure::missed);
    CHECK(finding.question == "candidates");
    CHECK(finding.mesh.vertex_count() <= 8);
    CHECK(elements_of(finding) <= 4);
  }
}

TEST_CASE("fuzzed steps: each sort of wrong reply is found") {
  struct Planted {
    const char* question;
    FuzzFailure failure;
    std::function<void(StepReply&)> fault;
  };
  const std::vector<Planted> all = {
      {"free", FuzzFailure::late, [](StepReply& reply) { *reply.free = std::min(0.99, *reply.free * 1.5); }},
      {"free", FuzzFailure::missed, [](StepReply& reply) { reply.free = 1; }},
      {"free", FuzzFailure::early, [](StepReply& reply) { reply.free = 0; }},
      {"free", FuzzFailure::malformed, [](StepReply& reply) { reply.free = std::nan(""); }},
      {"free", FuzzFailure::malformed, [](StepReply& reply) { reply.free = 1.5; }},
      {"first contact", FuzzFailure::missed, [](StepReply& reply) { reply.first_contact = kNever; }},
      {"first contact", FuzzFailure::late,
       [](StepReply& reply) {
         if (*reply.first_contact < 1) *reply.first_contact = std::nextafter(*reply.first_contact, 2);
       }},
      {"first contact", FuzzFailure::phantom,
       [](StepReply& reply) { *reply.first_contact = std::min(*reply.first_contact, 1.0); }},
      {"first contact", FuzzFailure::malformed, [](StepReply& reply) { reply.first_contact = -0.5; }},
      {"candidates", FuzzFailure::missed, [](StepReply& reply) { reply.candidates->clear(); }},
      {"candidates", FuzzFailure::malformed,
       [](StepReply& reply) {
         reply.candidates->push_back({Kind::edge_edge, 10'000'000, 3});
       }},
      {"all", FuzzFailure::crash, [](StepReply&) { throw Error("planted"); }}};
  for (const Planted& planted : all) {
    CAPTURE(planted.question, name_of(planted.failure));
    StepFuzzOptions options;
    options.cases = 130;
    const StepFuzzReport report = fuzz_steps(
        [&](const Mesh& mesh, const Positions& x0, const Positions& x1) {
          StepReply reply = fuzz::library_reply(mesh, x0, x1);
          planted.fault(reply);
          return reply;
        },
        options);
    CHECK(std::any_of(report.findings.begin(), report.findings.end(), [&](const StepFuzzFinding& finding) {
      return finding.failure == planted.failure && finding.question == planted.question;
    }));
    for (const StepFuzzFinding& finding : report.findings) CHECK(finding.mesh.has_pairs());
    CHECK(report.steps == options.cases);
    CHECK(report.failures > 0);
  }
  // What is left out is not judged, and a reply that changes is told.
  CHECK(found_in([](const Mesh&, const Positions&, const Positions&) { return StepReply{}; }, 50).failures == 0);
  std::atomic<int> calls = 0;
  const StepFuzzReport changing = found_in(
      [&](const Mesh& mesh, const Positions& x0, const Positions& x1) {
        StepReply reply = fuzz::library_reply(mesh, x0, x1);
        *reply.free *= ++calls % 2 == 0 ? 0.5 : 0.75;
        return reply;
      },
      50);
  REQUIRE(changing.findings.size() == 1);
  CHECK(changing.findings[0].failure == FuzzFailure::differs);
}

TEST_CASE("fuzzed steps: what counts as early, late and a stall is the caller's") {
  const auto failures = [](const StepFuzzOptions& options, const std::function<void(StepReply&)>& change) {
    return fuzz_steps(
               [&](const Mesh& mesh, const Positions& x0, const Positions& x1) {
                 StepReply reply;
                 const FirstContact first = first_contact(mesh, x0, x1);
                 reply.free = reply.first_contact = first.at_start.empty() ? std::min(first.toi, 1.0) : 0;
                 if (!first.contact && first.at_start.empty()) reply.first_contact = kNever;
                 change(reply);
                 return reply;
               },
               options)
        .failures;
  };
  StepFuzzOptions options;
  options.cases = 130;
  CHECK(failures(options, [](StepReply&) {}) > 0);  // it ends in contacts at doubles
  options.may_end_in_contact = true;
  CHECK(failures(options, [](StepReply&) {}) == 0);
  const auto shorter = [](StepReply& reply) { *reply.free *= 0.75; };
  CHECK(failures(options, shorter) == 0);
  options.early_fraction = 0;
  CHECK(failures(options, [](StepReply& reply) { *reply.free = std::nextafter(*reply.free, 0); }) == 0);
  options.early_fraction = 0.125;
  CHECK(failures(options, shorter) > 0);
  CHECK(failures(options, [](StepReply& reply) { *reply.free = std::min(*reply.free, 1e-300); }) > 0);
  options.early_fraction = 0.25;
  CHECK(failures(options, shorter) == 0);
  const auto later = [](StepReply& reply) { *reply.first_contact += 1e-6; };
  CHECK(failures(options, later) > 0);
  options.late_fraction = 1e-5;
  options.separations = options.groups = false;
  options.families = {"steps_sheets", "steps_rods"};
  const auto within = [](StepReply& reply) {
    if (*reply.first_contact < 0.9) *reply.first_contact += 1e-6;
  };
  CHECK(failures(options, within) == 0);
}

TEST_CASE("fuzzed steps: options without meaning are refused") {
  const StepSolver solver = fuzz::library_reply;
  const auto refused = [&](const std::function<void(StepFuzzOptions&)>& change) {
    StepFuzzOptions options;
    change(options);
    CHECK_THROWS_AS(fuzz_steps(solver, options), InvalidQuery);
  };
  refused([](StepFuzzOptions& options) { options.cases = 0; });
  refused([](StepFuzzOptions& options) { options.threads = 0; });
  refused([](StepFuzzOptions& options) { options.stall = 2; });
  refused([](StepFuzzOptions& options) { options.late_fraction = -1; });
  refused([](StepFuzzOptions& options) { options.early_fraction = std::nan(""); });
  refused([](StepFuzzOptions& options) { options.seconds = 0; });
  refused([](StepFuzzOptions& options) { options.families = {"sheets"}; });
}

TEST_CASE("fuzzed steps: the line of a step, and the replies that a program may give") {
  const families::StepScene scene = families::step_scene(families::StepFamily::steps_groups, 1, 0);
  const Mesh mesh = scene.mesh();
  const std::string line = fuzz::step_line(mesh, Positions(scene.x0), Positions(scene.x1));
  CHECK(line.starts_with("{\"vertices\":" + std::to_string(mesh.vertex_count()) + ",\"x0\":[["));
  CHECK(line.ends_with("\"ignored_groups\":[[0,0]]}\n"));
  const StepReply all = fuzz::read_step_reply(
      R"({"free": 0.5, "first_contact": null, "candidates": [["vertex-face", 3, 0], ["point-point", 1, 0]]})");
  CHECK(all.free == 0.5);
  CHECK(all.first_contact == kNever);
  REQUIRE(all.candidates);
  CHECK(*all.candidates == std::vector<MeshPair>{{Kind::vertex_face, 3, 0}, {Kind::point_point, 1, 0}});
  // In any order, and with either element first.
  StepReply other = all;
  std::reverse(other.candidates->begin(), other.candidates->end());
  std::swap((*other.candidates)[0].first, (*other.candidates)[0].second);
  CHECK(other == all);
  other.candidates->pop_back();
  CHECK(!(other == all));
  const auto refused = [&](const std::string& reply, const std::string& reason) {
    CAPTURE(reply.substr(0, 100));
    try {
      fuzz::read_step_reply(reply);
      FAIL_CHECK("it was read");
    } catch (const fuzz::NoReply& trouble) {
      CAPTURE(trouble.what());
      CHECK(trouble.failure() == FuzzFailure::malformed);
      CHECK(std::string(trouble.what()).find(reason) != std::string::npos);
    }
  };
  refused("", "is no reply");
  refused("no", "is no reply; a reply is such as {\"free\": 0.5}");
  refused("{}", "is no reply");
  refused("[0.5]", "is no reply");
  refused(std::string(100'000, '['), "is no reply");
  refused("{\"free\":" + std::string(400'000, '[') + std::string(400'000, ']') + "}", "is no word of a reply");
  refused("{\"candidates\":[" + std::string(400'000, '[') + std::string(400'000, ']') + "]}",
          "a candidate must be such as");
  refused(R"({"free": "x"})", "'free' is no word of a reply, or has no such value");
  refused(R"({"free": null})", "is no word of a reply");
  refused(R"({"time": 1})", "is no word of a reply");
  refused(R"({"candidates": [["edge-edge", 0]]})", "a candidate must be such as [\"edge-edge\", 0, 3]");
  refused(R"({"candidates": [["edge-face", 0, 1]]})", "a candidate must be such as");
  refused(R"({"candidates": [["edge-edge", 0, -1]]})", "a candidate must be such as");
  // Whether there are such elements is for the judge to say.
  for (const char* number : {"9999", "4294967296", "18446744073709551615"}) {
    const std::string text = std::string(R"({"candidates": [["edge-edge", 0, )") + number + "]]}";
    const auto failure = fuzz::judge_step(
        scene, [&](auto&&...) { return fuzz::read_step_reply(text); }, StepFuzzOptions{});
    REQUIRE(failure);
    CHECK(failure->failure == FuzzFailure::malformed);
    CHECK(failure->detail.find(" names an element that the mesh has not") != std::string::npos);
  }
}
