// The path to the positions that free_step returns is free of contact, pair by pair, and as long as rounding lets it
// be.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

#include <touchstone/touchstone.hpp>

#include "mesh/same_bytes.hpp"
#include "mesh/scenes.hpp"
#include "numbers/integers/exact_number.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using numbers::Exact;

namespace {

/// Whether no pair comes as near as its separation, on the path from x0 to `end`, by one query for each pair.
bool path_is_free(const Scene& scene, const std::vector<double>& end) {
  const Parts parts = parts_of(scene.elements);
  const std::vector<MeshPair> pairs = all_pairs(scene.elements);
  return std::none_of(pairs.begin(), pairs.end(), [&](const MeshPair& pair) {
    const Separation separation{separation_between(scene, parts, pair), scene.elements.separation.metric};
    return solve(query_between(scene, parts, pair, scene.x0, end),
                 {.separation = separation, .wanted = Wanted::contact})
        .contact;
  });
}

/// The distance from x to the next double of greater size.
double unit_of(double x) { return std::nextafter(std::fabs(x), INFINITY) - std::fabs(x); }

/// Whether `at` is a + length (b - a), but for a unit in its last place, or 2^-100 of |a| + |b|.
bool is_rounded(double a, double b, double length, double at) {
  const Exact error = Exact(a) + Exact(length) * (Exact(b) - Exact(a)) - Exact(at);
  const Exact size = Exact(std::fabs(a)) + Exact(std::fabs(b));
  const auto within = [&](const Exact& bound) { return !(bound < error) && !(error < -bound); };
  return within(Exact(unit_of(at))) || within(Exact(0x1p-100) * size);
}

/// The greatest unit in the last place of the positions, and the least speed with which a pair that meets first closes
/// in, by the distances just before and at the time of impact.
double time_of_rounding(const Scene& scene, const FreeStep& step) {
  double unit = 0;
  for (const double x : scene.x0) unit = std::max(unit, unit_of(x));
  for (const double x : scene.x1) unit = std::max(unit, unit_of(x));
  const Parts parts = parts_of(scene.elements);
  double speed = INFINITY;
  for (const MeshContact& contact : step.first_contact.earliest) {
    const Query query = query_between(scene, parts, contact.pair, scene.x0, scene.x1);
    const double before = contact.answer.toi * (1 - 0x1p-12);
    const double closed = distance(query, before, contact.separation.metric).value - contact.separation.distance;
    speed = std::min(speed, closed / (contact.answer.toi - before));
  }
  return unit / speed;
}

}  // namespace

TEST_CASE("the path of a free step is free by brute force, and ends at the rounded positions") {
  seeded::Rng random(301);
  std::map<StepOutcome, int> outcomes;
  std::vector<double> lost;  // of shortened steps, in units of the time in which a coordinate's last bit passes
  int most_proofs = 0;
  for (std::size_t round = 0; round < effort(400); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 10);
      if (random.one_in(2)) add_separation(random, scene);
      if (random.one_in(6)) add_pair_separations(random, scene);
      if (random.one_in(4)) {  // far from the origin, where rounding is coarse
        double size = 0;
        for (const double x : scene.x0) size = std::max(size, std::fabs(x));
        for (double& x : scene.x0) x += 1e9 * size;
        for (double& x : scene.x1) x += 1e9 * size;
      }
      const Mesh mesh(scene.elements);
      FreeStepOptions options;
      options.threads = random.one_in(4) ? 2 : 1;
      options.check_start = random.one_in(2);
      const FreeStep step = free_step(mesh, scene.start(), scene.end(), options);
      ++outcomes[step.outcome];
      most_proofs = std::max(most_proofs, step.proofs);
      CAPTURE(round, scene.name, step.length);
      REQUIRE(step.positions.size() == scene.x0.size());
      REQUIRE(step.first_contact.start_checked == options.check_start);
      switch (step.outcome) {
        case StepOutcome::whole:
          REQUIRE(step.length == 1);
          REQUIRE(step.positions == scene.x1);
          REQUIRE(path_is_free(scene, scene.x1));
          break;
        case StepOutcome::contact_at_start:
          REQUIRE(step.length == 0);
          REQUIRE(step.positions == scene.x0);
          REQUIRE_FALSE(path_is_free(scene, scene.x0));
          break;
        case StepOutcome::intersects_at_start:
          REQUIRE(options.check_start);
          REQUIRE(step.length == 0);
          REQUIRE(step.positions == scene.x0);
          REQUIRE(path_is_free(scene, scene.x0));
          REQUIRE_FALSE(intersections(mesh, scene.start()).empty());
          break;
        case StepOutcome::no_room:
          REQUIRE(step.positions == scene.x0);
          REQUIRE(path_is_free(scene, scene.x0));
          REQUIRE_FALSE(path_is_free(scene, scene.x1));
          break;
        case StepOutcome::shortened: {
          REQUIRE(step.length > 0);
          REQUIRE(step.positions != scene.x0);
          REQUIRE(path_is_free(scene, step.positions));
          REQUIRE_FALSE(path_is_free(scene, scene.x1));
          const FirstContact whole = first_contact(mesh, scene.start(), scene.end());
          REQUIRE(whole.toi == step.first_contact.toi);
          REQUIRE((step.length < whole.toi || (step.length == whole.toi && whole.toi < whole.toi_upper)));
          const double rounding = std::max(time_of_rounding(scene, step), 0x1p-53 * whole.toi);
          lost.push_back((whole.toi - step.length) / rounding);
          break;
        }
      }
      for (std::size_t i = 0; i < step.positions.size(); ++i) {
        const double a = scene.x0[i], b = scene.x1[i], at = step.positions[i];
        if (step.length > 0) REQUIRE(is_rounded(a, b, step.length, at));
        REQUIRE(std::clamp(at, std::min(a, b), std::max(a, b)) == at);
      }
    }
  }
  std::sort(lost.begin(), lost.end());
  REQUIRE(lost.size() > 5);
  const auto quantile = [&](double q) {
    return lost[static_cast<std::size_t>(q * static_cast<double>(lost.size() - 1))];
  };
  std::printf("steps: %d whole, %d shortened, %d without room, %d in contact at the start; at most %d proofs\n",
              outcomes[StepOutcome::whole], outcomes[StepOutcome::shortened], outcomes[StepOutcome::no_room],
              outcomes[StepOutcome::contact_at_start], most_proofs);
  std::printf("time given away, in units of the rounding: median %.3g, 90 %% %.3g, 99 %% %.3g, most %.3g\n",
              quantile(0.5), quantile(0.9), quantile(0.99), lost.back());
  for (const StepOutcome outcome :
       {StepOutcome::whole, StepOutcome::shortened, StepOutcome::contact_at_start, StepOutcome::intersects_at_start}) {
    CHECK((outcomes[outcome] > 0 || !whole_effort("each outcome of a step is seen")));
  }
  CHECK(quantile(0.5) < 1);
  CHECK(lost.back() < 4);
}

TEST_CASE("a pair that comes too near and never meets is found though another one meets soon after") {
  MeshElements elements;
  elements.vertex_count = 6;
  elements.edges = {{4, 5}};
  const Mesh mesh(elements);
  // Points 0 and 1 meet at t = 1/1000. Points 2 and 3 pass by each other: they are sqrt(2) apart, and 0.9 of that at
  // t = 8.5e-5. Points 0 and 1 have 0.9 of their distance at 1e-4. All of this along each of the axes.
  const std::vector<double> along_x = {0, 0, 0, 1, 0, 0, 0, 0, 1e6, 1, 1, 1e6, 0, 1e6, 0, 1, 1e6, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> x0(along_x.size());
    for (std::size_t i = 0; i < x0.size(); ++i) x0[i / 3 * 3 + (i + axis) % 3] = along_x[i];
    std::vector<double> x1 = x0;
    x1[axis] += 500, x1[3 + axis] -= 500, x1[6 + axis] += 1250, x1[9 + axis] -= 1250;
    FreeStepOptions options;
    options.kept_fraction = 0.9;
    const FreeStep step = free_step(mesh, {x0, 3}, {x1, 3}, options);
    CAPTURE(axis);
    CHECK(step.outcome == StepOutcome::shortened);
    REQUIRE(step.first_contact.earliest.size() == 1);
    CHECK(step.first_contact.earliest[0].pair == MeshPair{Kind::point_point, 2, 3});
    CHECK(std::fabs(step.length - (1 - std::sqrt(0.81 * 2 - 1)) / 2500) < 1e-9);
    MeshSteps steps(mesh);
    for (int i = 0; i < 3; ++i) CHECK(same_bytes(steps.free_step({x0, 3}, {x1, 3}, options), step));
  }
}

TEST_CASE("with float32 a step ends at floats, and its path is free by brute force") {
  seeded::Rng random(302);
  const auto to_floats = [](std::vector<double>& x) {
    for (double& one : x) one = static_cast<float>(one);
  };
  std::map<StepOutcome, int> outcomes;
  int rounded_into_contact = 0;
  for (std::size_t round = 0; round < effort(200); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 10);
      // Some coordinates are below the least normal float.
      const double scale = std::ldexp(1.0, random.one_in(8) ? -140 : random.between(-20, 20));
      for (double& x : scene.x0) x *= scale;
      for (double& x : scene.x1) x *= scale;
      to_floats(scene.x0);
      const Mesh mesh(scene.elements);
      FreeStepOptions options;
      options.float32 = true;
      options.threads = random.one_in(4) ? 2 : 1;
      if (random.one_in(3)) options.kept_fraction = random.uniform(0, 0.9);
      const FreeStep step = free_step(mesh, scene.start(), scene.end(), options);
      ++outcomes[step.outcome];
      CAPTURE(round, scene.name, step.length);
      to_floats(scene.x1);
      std::vector<double> end = step.positions;
      to_floats(end);
      REQUIRE(step.positions == end);
      if (step.outcome == StepOutcome::contact_at_start) continue;
      REQUIRE(path_is_free(scene, end));
      REQUIRE((step.outcome == StepOutcome::whole) == (end == scene.x1));
      for (std::size_t i = 0; i < end.size(); ++i) {
        const double a = scene.x0[i], b = scene.x1[i], exact = a + step.length * (b - a);
        REQUIRE((std::min(a, b) <= end[i] && end[i] <= std::max(a, b)));
        const auto near = static_cast<float>(exact);
        REQUIRE((step.outcome == StepOutcome::no_room ||
                 (std::nextafter(near, -INFINITY) <= end[i] && end[i] <= std::nextafter(near, INFINITY))));
      }
      if (step.outcome != StepOutcome::shortened) continue;
      // The step that ends at doubles, rounded by the caller.
      std::vector<double> later = free_step(mesh, scene.start(), scene.end()).positions;
      to_floats(later);
      rounded_into_contact += path_is_free(scene, later) ? 0 : 1;
      std::vector<float> x0(scene.x0.begin(), scene.x0.end()), x1;
      for (std::size_t i = 0; i < scene.x1.size(); ++i) {  // two floats from a coordinate to the next
        x1.push_back(static_cast<float>(scene.x1[i]));
        x1.push_back(NAN);
      }
      const int dimension = scene.elements.dimension;
      Positions strided(x1.data(), scene.elements.vertex_count, dimension);
      strided.coordinate_stride = 2;
      strided.vertex_stride = 2 * dimension;
      REQUIRE(free_step(mesh, {x0, dimension}, strided, options).positions == end);
    }
  }
  CHECK(outcomes[StepOutcome::whole] > 0);
  CHECK(outcomes[StepOutcome::shortened] > 0);
  if (whole_effort("steps that end at doubles touch when they are rounded")) CHECK(rounded_into_contact > 0);
}

TEST_CASE("with float32 a start between floats, and an end beyond them, are refused") {
  MeshElements elements;
  elements.vertex_count = 2;
  const Mesh mesh(elements);
  FreeStepOptions options;
  options.float32 = true;
  std::vector<double> x0 = {0, 0, 0, 1, 0, 0}, x1 = x0;
  CHECK(free_step(mesh, {x0, 3}, {x1, 3}, options).outcome == StepOutcome::whole);
  x1[4] = 0.1;
  CHECK(free_step(mesh, {x0, 3}, {x1, 3}, options).positions[4] == 0.1f);
  const auto refusal = [&] {
    try {
      free_step(mesh, {x0, 3}, {x1, 3}, options);
    } catch (const InvalidQuery& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  x1[4] = 0x1p128;
  CHECK(refusal() ==
        "vertex 1 has y = 3.402823669209385e+38 at t = 1, which is beyond the largest float32 number, 3.4e38");
  x1[4] = 0;
  x0[5] = 0.5 + 0x1p-30;
  CHECK(refusal() ==
        "vertex 1 has z = 0.5000000009313226 at t = 0, which is no float32 number; with float32 a step "
        "starts at such numbers");
}

TEST_CASE("a step towards a face stops at the last double above it") {
  Scene scene;
  scene.elements.vertex_count = 4;
  scene.elements.faces = {{0, 1, 2}};
  scene.x0 = {0, 0, 1, 1, 0, 1, 0, 1, 1, 0.25, 0.25, 2};
  scene.x1 = scene.x0;
  scene.x1[11] = 0;  // meets z = 1 at 1/2
  const Mesh mesh(scene.elements);
  const FreeStep step = free_step(mesh, scene.start(), scene.end());
  CHECK(step.outcome == StepOutcome::shortened);
  CHECK(step.positions[11] == std::nextafter(1.0, 2));
  CHECK(step.length < 0.5);
  CHECK(step.length > 0.5 - 0x1p-52);

  // A vertex one double above the face has no room, though the contact is later than 0.
  scene.x0[11] = std::nextafter(1.0, 2);
  scene.x1[11] = 1;
  const FreeStep none = free_step(mesh, scene.start(), scene.end());
  CHECK(none.outcome == StepOutcome::no_room);
  CHECK(none.positions == scene.x0);
  CHECK(none.length > 0);
  CHECK(none.first_contact.toi == 1);

  // In contact at the start.
  scene.x0[11] = 1;
  const FreeStep stuck = free_step(mesh, scene.start(), scene.end());
  CHECK(stuck.outcome == StepOutcome::contact_at_start);
  REQUIRE(stuck.first_contact.at_start.size() == 1);
  CHECK(stuck.first_contact.at_start[0].pair == MeshPair{Kind::vertex_face, 3, 0});
}

TEST_CASE("pairs that meet within rounding of the first one are in the way too") {
  seeded::Rng random(305);
  int most_proofs = 0, shortened = 0;
  for (std::size_t round = 0; round < effort(60); ++round) {
    Scene scene;
    constexpr std::size_t kPoints = 40;
    scene.elements.vertex_count = 3 + kPoints;
    scene.elements.faces = {{0, 1, 2}};
    const double c = random.uniform(-1, 1), d = random.uniform(-1, 1);
    const auto height = [&](double x, double y) { return c * x + d * y; };
    for (const auto& [x, y] : {std::pair{-5000.0, -4000.0}, std::pair{6000.0, -5000.0}, std::pair{100.0, 7000.0}}) {
      scene.x0.insert(scene.x0.end(), {x, y, height(x, y)});
    }
    scene.x1 = scene.x0;
    for (std::size_t p = 0; p < kPoints; ++p) {  // each passes the plane at half of its way, but for a few roundings
      const double x = random.uniform(-900, 900);
      const double y = random.uniform(-900, 900);
      const double fall = random.uniform(0.5, 3);
      scene.x0.insert(scene.x0.end(), {x, y, height(x, y) + fall});
      scene.x1.insert(scene.x1.end(), {x + 0.5, y - 0.25, height(x + 0.5, y - 0.25) - fall});
    }
    const Mesh mesh(scene.elements);
    const FreeStep step = free_step(mesh, scene.start(), scene.end());
    most_proofs = std::max(most_proofs, step.proofs);
    shortened += step.outcome == StepOutcome::shortened ? 1 : 0;
    CAPTURE(round, step.length);
    REQUIRE(path_is_free(scene, step.positions));
    REQUIRE(step.first_contact.toi - step.length < 1e-10);
  }
  std::printf("steps with many pairs in the way: at most %d proofs\n", most_proofs);
  CHECK(shortened > 0);
  CHECK((most_proofs > 2 || !whole_effort("that a proof fails at first")));
}

TEST_CASE("a step between the greatest doubles is rounded like any other") {
  constexpr double kMost = std::numeric_limits<double>::max();
  Scene scene;
  scene.elements.vertex_count = 4;
  scene.elements.faces = {{0, 1, 2}};
  scene.x0 = {-kMost, -kMost, 0, kMost, -kMost, 0, 0, kMost, 0, 0, 0, kMost};
  scene.x1 = scene.x0;
  scene.x1[11] = -kMost;
  const FreeStep step = free_step(Mesh(scene.elements), scene.start(), scene.end());
  CHECK(step.outcome == StepOutcome::shortened);
  CHECK(step.first_contact.toi == 0.5);
  CHECK(step.length < 0.5);
  CHECK(step.length >= 0.5 - 0x1p-53);
  CHECK(step.positions[11] > 0);
  CHECK(step.positions[11] <= 0x1p-51 * kMost);
  CHECK(path_is_free(scene, step.positions));
}

TEST_CASE("a line search that steps and asks again is always free, and comes to rest") {
  seeded::Rng random(302);
  int steps = 0;
  for (std::size_t round = 0; round < effort(60); ++round) {
    Scene scene = random_scene(random, kLayouts[round % kLayouts.size()], 10);
    if (random.one_in(2)) add_separation(random, scene);
    const Mesh mesh(scene.elements);
    if (!first_contact(mesh, scene.start(), scene.start()).at_start.empty()) continue;
    FreeStepOptions options;
    if (random.one_in(3)) options.kept_fraction = 0.1;
    for (int i = 0; i < 20; ++i) {
      const FreeStep step = free_step(mesh, scene.start(), scene.end(), options);
      REQUIRE(step.outcome != StepOutcome::contact_at_start);
      scene.x0 = step.positions;
      ++steps;
      if (step.outcome != StepOutcome::shortened) break;
    }
    CHECK(first_contact(mesh, scene.start(), scene.start()).free());
  }
  CHECK(steps > 0);
}

TEST_CASE("a step keeps a fraction of every distance") {
  seeded::Rng random(303);
  std::map<StepOutcome, int> outcomes;
  for (std::size_t round = 0; round < effort(60); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 10);
      if (random.one_in(3)) add_separation(random, scene);
      const Mesh mesh(scene.elements);
      FreeStepOptions options;
      options.kept_fraction = random.pick(std::array<double, 4>{0.1, 0.5, 0.9, 1e-3});
      const FreeStep step = free_step(mesh, scene.start(), scene.end(), options);
      ++outcomes[step.outcome];
      if (step.outcome == StepOutcome::contact_at_start) continue;
      CAPTURE(round, scene.name, options.kept_fraction, step.length);
      const Parts parts = parts_of(scene.elements);
      const Metric metric = scene.elements.separation.metric;
      bool least_lost = step.outcome == StepOutcome::whole;
      for (const MeshPair& pair : all_pairs(scene.elements)) {
        const double d = separation_between(scene, parts, pair);
        const Query path = query_between(scene, parts, pair, scene.x0, step.positions);
        const double at_start = distance(path, 0, metric).value;
        // A double or two below the distance that is to be kept.
        const double kept = (d + options.kept_fraction * (at_start - d)) * (1 - 0x1p-50);
        REQUIRE_FALSE(solve(path, {.separation = {kept, metric}, .wanted = Wanted::contact}).contact);
        const Query whole = query_between(scene, parts, pair, scene.x0, scene.x1);
        const double more = (d + options.kept_fraction * (at_start - d) * (1 + 0x1p-10)) * (1 + 0x1p-45);
        const Answer answer = solve(whole, {.separation = {more, metric}});
        if (answer.contact && answer.toi <= step.length * (1 + 0x1p-20)) least_lost = true;
      }
      if (step.outcome == StepOutcome::shortened && step.length > 1e-6) REQUIRE(least_lost);
    }
  }
  for (const StepOutcome outcome : {StepOutcome::whole, StepOutcome::shortened}) {
    CHECK((outcomes[outcome] > 0 || !whole_effort("each outcome of a step is seen")));
  }
  Scene scene = random_scene(random, Layout::soup, 10);
  FreeStepOptions options;
  for (const double bad : {-0.1, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.kept_fraction = bad;
    CHECK_THROWS_AS(free_step(Mesh(scene.elements), scene.start(), scene.end(), options), InvalidQuery);
  }
}

TEST_CASE("one thread and several take the same step") {
  seeded::Rng random(304);
  for (const Layout layout : kLayouts) {
    const Scene scene = random_scene(random, layout, 16);
    const Mesh mesh(scene.elements);
    FreeStepOptions options;
    for (const double fraction : {0.0, 0.2}) {
      options.kept_fraction = fraction;
      options.threads = 1;
      const FreeStep one = free_step(mesh, scene.start(), scene.end(), options);
      for (const int threads : {2, 5, 64}) {
        options.threads = threads;
        const FreeStep other = free_step(mesh, scene.start(), scene.end(), options);
        CHECK(one.outcome == other.outcome);
        CHECK(one.length == other.length);
        CHECK(one.positions == other.positions);
        CHECK(one.proofs == other.proofs);
      }
    }
  }
}

TEST_CASE("a kept fraction: the thick vertex of an element rests, and the thin one moves") {
  for (const double fraction : {0.3, 0.5, 0.8}) {
    MeshElements elements;
    elements.vertex_count = 3;
    elements.edges = {{0, 1}};
    elements.points = {{2}};
    elements.radii = {1, 0, 0};
    // The separation is 1. The edge's end comes within `near` of the point, which began at the distance 2.9.
    const double near = 1.9, kept = 1 + fraction * (2.9 - 1);
    const std::vector<double> x0 = {-10, 0, 0, 0, 0, 0, 2.9, 0, 0}, x1 = {-10, 0, 0, 2.9 - near, 0, 0, 2.9, 0, 0};
    FreeStepOptions options;
    options.kept_fraction = fraction;
    const FreeStep step = free_step(Mesh(elements), {x0, 3}, {x1, 3}, options);
    CAPTURE(fraction, step.length);
    CHECK(step.outcome == (kept < near ? StepOutcome::whole : StepOutcome::shortened));
    if (kept > near) CHECK(std::fabs(step.length - (2.9 - kept)) < 1e-3);
  }
}
