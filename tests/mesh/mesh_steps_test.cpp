// What MeshSteps keeps changes no result: each question of a series is also asked anew.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "mesh/candidate_search.hpp"
#include "mesh/same_bytes.hpp"
#include "mesh/scenes.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

std::vector<double> between(const std::vector<double>& x0, const std::vector<double>& x1, double s) {
  std::vector<double> x(x0.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = x0[i] + s * (x1[i] - x0[i]);
  return x;
}

double median_edge_length(const Mesh& mesh, const std::vector<double>& x) {
  std::vector<double> lengths;
  const auto n = static_cast<std::size_t>(mesh.dimension());
  for (const auto& edge : mesh.edges()) {
    double square = 0;
    for (std::size_t k = 0; k < n; ++k) square += std::pow(x[n * edge[0] + k] - x[n * edge[1] + k], 2);
    lengths.push_back(std::sqrt(square));
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths.empty() ? 0 : lengths[lengths.size() / 2];
}

/// The edges 01 and 23.
Mesh two_edges() {
  MeshElements elements;
  elements.vertex_count = 4;
  elements.edges = {{0, 1}, {2, 3}};
  return Mesh(elements);
}

/// Asks both, and compares.
void ask(MeshSteps& steps, seeded::Rng& random, const std::vector<double>& x0, const std::vector<double>& x1,
         double fraction) {
  const Mesh& mesh = steps.mesh();
  const Positions start(x0, mesh.dimension()), end(x1, mesh.dimension());
  const int threads = random.one_in(4) ? 2 : 1;
  switch (random.below(3)) {
    case 0: {
      FirstContactOptions options;
      options.threads = threads;
      options.t_max = random.one_in(3) ? random.unit() : 1;
      options.check_start = random.one_in(4);
      REQUIRE(same_bytes(steps.first_contact(start, end, options), first_contact(mesh, start, end, options)));
      break;
    }
    case 1: {
      StepOptions options;
      options.threads = threads;
      REQUIRE(same_bytes(steps.all_contacts(start, end, options), all_contacts(mesh, start, end, options)));
      break;
    }
    default: {
      FreeStepOptions options;
      options.threads = threads;
      options.kept_fraction = fraction;
      REQUIRE(same_bytes(steps.free_step(start, end, options), free_step(mesh, start, end, options)));
    }
  }
}

}  // namespace

TEST_CASE("steps that keep candidates have the results of steps that are asked anew") {
  seeded::Rng random(3801);
  std::size_t questions = 0, searches = 0;
  for (std::size_t round = 0; round < effort(60); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 24);
      if (random.one_in(3)) add_separation(random, scene);
      if (random.one_in(8)) add_pair_separations(random, scene);
      if (random.one_in(6)) {  // far from the origin
        const double far = std::ldexp(scene.x0[0], random.between(20, 50));
        for (double& x : scene.x0) x += far;
        for (double& x : scene.x1) x += far;
      }
      const Mesh mesh(scene.elements);
      MeshSteps steps(mesh);
      const double margin = median_edge_length(mesh, scene.x0) / 16;
      const double fraction = random.one_in(2) ? 0 : random.uniform(0, 0.9);
      std::vector<double> x0 = scene.x0, x1 = scene.x1;
      if (random.one_in(2)) x1 = between(x0, x1, 0.1);  // a gentle step
      CAPTURE(round, scene.name, fraction);
      for (int question = 0; question < 12; ++question, ++questions) {
        std::vector<double> y0 = x0, y1 = between(x0, x1, std::max(0.0, random.uniform(-0.3, 1)));
        if (random.one_in(3)) {  // about the margin away, on either side of it
          const double by = margin * random.uniform(0, 1.2);
          for (double& x : y0) x += by * random.symmetric();
          for (double& x : y1) x += random.one_in(2) ? by : -by;
        }
        const double lesser = random.one_in(3) ? fraction * random.unit() : fraction;
        ask(steps, random, y0, y1, random.one_in(10) ? 0.5 : lesser);
        if (random.one_in(12)) steps.release();
        if (random.one_in(8)) {  // the next step
          const std::vector<double> way = between(x0, x1, -1);
          x0 = x1;
          for (std::size_t i = 0; i < x1.size(); ++i) x1[i] += x1[i] - way[i] > 0 ? margin / 8 : -margin / 8;
        }
      }
      searches += steps.searches();
    }
  }
  CHECK(searches < questions);  // of which free steps count several
}

TEST_CASE("a contact at the edge of the margin is found among the pairs that are kept") {
  seeded::Rng random(3802);
  int kept = 0, anew = 0;
  for (std::size_t round = 0; round < effort(2000); ++round) {
    // Two edges of length 1, so the margin is 1/16: they come towards each other by a part of it each, and touch.
    const double part = random.uniform(0.5, 1.1) / 16;
    const double turn = random.one_in(2) ? 0 : 1e6 * random.unit();
    const double gap = 2 * part * (1 - 1e-6);
    const Mesh mesh = two_edges();
    MeshSteps steps(mesh);
    std::vector<double> x0 = {-0.5, 0, 0, 0.5, 0, 0, 0, -0.5, gap, 0, 0.5, gap};
    for (std::size_t i = 0; i < x0.size(); i += 3) x0[i] += turn;
    std::vector<double> far = x0;  // the reference: both move aside, as fast as each other
    for (std::size_t i = 1; i < far.size(); i += 3) far[i] += 0.25;
    for (int i = 0; i < 2; ++i) REQUIRE(steps.first_contact({x0, 3}, {far, 3}).free());
    REQUIRE(steps.searches() == 1);
    const double s = random.unit();
    std::vector<double> x1 = between(x0, far, s);
    for (std::size_t i = 2; i < x1.size(); i += 3) x1[i] += i < 6 ? part : -part;
    const FirstContact found = steps.first_contact({x0, 3}, {x1, 3});
    CAPTURE(round, part, s, turn);
    REQUIRE(found.contact);
    REQUIRE(same_bytes(found, first_contact(mesh, {x0, 3}, {x1, 3})));
    (steps.searches() == 1 ? kept : anew) += 1;
  }
  CHECK(kept > 0);
  CHECK(anew > 0);
}

TEST_CASE("a pair that keeps too little by a move within the margin is among the pairs that are kept") {
  const Mesh mesh = two_edges();
  MeshSteps steps(mesh);
  FreeStepOptions options;
  options.kept_fraction = 0.8;
  // The edges have the length 1, so the margin is 1/16. They keep 0.8 of 6/16, and come within 4.6/16.
  std::vector<double> x0 = {-0.5, 0, 0, 0.5, 0, 0, 0, -0.5, 6. / 16, 0, 0.5, 6. / 16}, x1 = x0;
  for (std::size_t i = 2; i < x1.size(); i += 3) x1[i] += i < 6 ? 0.7 / 16 : -0.7 / 16;
  for (int i = 0; i < 2; ++i) REQUIRE(steps.free_step({x0, 3}, {x0, 3}, options).outcome == StepOutcome::whole);
  const FreeStep step = steps.free_step({x0, 3}, {x1, 3}, options);
  CHECK(steps.searches() == 1);
  CHECK(step.outcome == StepOutcome::shortened);
  CHECK(same_bytes(step, free_step(mesh, {x0, 3}, {x1, 3}, options)));
}

TEST_CASE("pairs that are kept for a part of the distance answer questions about a lesser part") {
  MeshSteps steps(two_edges());
  const std::vector<double> x0 = {-0.5, 0, 0, 0.5, 0, 0, 0, -0.5, 1, 0, 0.5, 1};
  std::vector<double> x1 = x0;
  for (std::size_t i = 8; i < x1.size(); i += 3) x1[i] = -1;
  FreeStepOptions options;
  for (const double fraction : {0.5, 0.25, 0.0}) {
    options.kept_fraction = fraction;
    for (int i = 0; i < 3; ++i) {
      REQUIRE(
          same_bytes(steps.free_step({x0, 3}, {x0, 3}, options), free_step(steps.mesh(), {x0, 3}, {x0, 3}, options)));
      REQUIRE(steps.first_contact({x0, 3}, {x0, 3}).free());
    }
    CHECK(steps.searches() == 1);
  }
  options.kept_fraction = 0.75;
  REQUIRE(steps.free_step({x0, 3}, {x0, 3}, options).outcome == StepOutcome::whole);
  CHECK(steps.searches() == 2);
  CHECK(same_bytes(steps.free_step({x0, 3}, {x1, 3}, options), free_step(steps.mesh(), {x0, 3}, {x1, 3}, options)));
}

TEST_CASE("one large face beside many small ones leaves the margin as it is") {
  MeshElements elements;
  std::vector<double> x;
  for (MeshIndex i = 0; i < 200; ++i) {  // triangles with legs of 1/16
    elements.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    x.insert(x.end(), {0.25 * i, 0, 1, 0.25 * i + 1. / 16, 0, 1, 0.25 * i, 1. / 16, 1});
  }
  elements.faces.push_back({600, 601, 602});
  x.insert(x.end(), {-1e6, -1e6, 0, 1e6, -1e6, 0, 0, 1e6, 0});
  elements.vertex_count = 603;
  MeshSteps steps{Mesh(elements)};
  for (int question = 0; question < 5; ++question) {
    REQUIRE(steps.first_contact({x, 3}, {x, 3}).free());
    CHECK(steps.searches() == 1);
    for (double& one : x) one += 1e-4;
  }
}

TEST_CASE("pairs are kept from the first question on, or from the second if the reference before was of no use") {
  MeshSteps steps(two_edges());
  const std::vector<double> x0 = {0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 1};
  const auto ask_at = [&](double height) {
    std::vector<double> x = x0;
    for (std::size_t i = 2; i < x.size(); i += 3) x[i] += height;
    CHECK(steps.first_contact({x, 3}, {x, 3}).free());
    return steps.searches();
  };
  CHECK(ask_at(0) == 1);
  CHECK(ask_at(0) == 1);
  CHECK(ask_at(1) == 2);  // kept at once
  CHECK(ask_at(2) == 3);  // the one before was of no use
  CHECK(ask_at(2) == 4);
  CHECK(ask_at(2) == 4);
  CHECK(ask_at(3) == 5);
  CHECK(ask_at(3) == 5);
  steps.release();
  CHECK(ask_at(3) == 6);
  CHECK(ask_at(3) == 6);
}

/// Two loose points, and an edge of length 1 far away, so that the margin is 1/16. The points are `gap` apart at the
/// start and move by the parts of the margin along each axis: outwards at the start, inwards at the end.
struct TwoPoints {
  Mesh mesh;
  std::vector<double> at_rest;
  std::vector<double> moved(double by) const {
    std::vector<double> x = at_rest;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] += by / 16;
      x[3 + k] -= by / 16;
    }
    return x;
  }
};

TwoPoints two_points(double gap, const Separation& separation = {}) {
  MeshElements elements;
  elements.vertex_count = 4;
  elements.edges = {{2, 3}};
  elements.separation = separation;
  const double side = gap / std::sqrt(3.0);
  return {Mesh(elements), {0, 0, 0, side, side, side, 100, 0, 0, 101, 0, 0}};
}

TEST_CASE("two points that meet by moves of the whole margin, along all axes, are among the pairs that are kept") {
  // Each may move by 3/64, so the gap falls by sqrt(3) 6/64 = 0.1624.
  for (const Separation separation : {Separation{}, {0.015, Metric::euclidean}, {0.01, Metric::max}}) {
    const double euclidean =
        separation.metric == Metric::max ? std::sqrt(3.0) * separation.distance : separation.distance;
    const TwoPoints points = two_points(0.1599 + euclidean, separation);
    MeshSteps steps(points.mesh);
    REQUIRE(steps.first_contact({points.at_rest, 3}, {points.at_rest, 3}).free());
    const std::vector<double> end = points.moved(0.74);
    const FirstContact found = steps.first_contact({points.at_rest, 3}, {end, 3});
    CAPTURE(separation.distance);
    CHECK(steps.searches() == 1);
    CHECK(found.contact);
    CHECK(same_bytes(found, first_contact(points.mesh, {points.at_rest, 3}, {end, 3})));
  }
}

TEST_CASE("two points that keep too little, by a start farther apart and an end nearer, are among the pairs kept") {
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const TwoPoints points = two_points(1.4, {0, metric});
    MeshSteps steps(points.mesh);
    FreeStepOptions options;
    options.kept_fraction = 0.8;
    REQUIRE(steps.free_step({points.at_rest, 3}, {points.at_rest, 3}, options).outcome == StepOutcome::whole);
    const std::vector<double> start = points.moved(-0.74), end = points.moved(0.74);
    const FreeStep step = steps.free_step({start, 3}, {end, 3}, options);
    CHECK(steps.searches() == 1);
    CHECK(step.outcome == StepOutcome::shortened);
    CHECK(same_bytes(step, free_step(points.mesh, {start, 3}, {end, 3}, options)));
  }
}

TEST_CASE("of pairs whose boxes meet, few are kept in a sheet, and none where too many do") {
  using mesh::Index;
  constexpr Index kSide = 20;
  MeshElements sheet, crowd;
  std::vector<double> x, y;
  for (Index i = 0; i < kSide; ++i) {
    for (Index j = 0; j < kSide; ++j) x.insert(x.end(), {0.1 * i, 0.1 * j, 0.03 * std::sin(0.7 * i + 0.3 * j)});
  }
  sheet.vertex_count = kSide * kSide;
  for (Index i = 0; i + 1 < kSide; ++i) {
    for (Index j = 0; j + 1 < kSide; ++j) {
      const Index a = i * kSide + j, b = a + kSide;
      sheet.faces.insert(sheet.faces.end(), {{a, b, a + 1}, {b, b + 1, a + 1}});
    }
  }
  const Mesh mesh(sheet);
  const mesh::Motion motion = mesh::motion_of(mesh.impl(), {x, 3}, {x, 3}, 1);
  mesh::CandidateSearch search(mesh.impl());
  std::size_t handed_out = 0;
  const auto count = [&](Kind, const broad_phase::Pair*, std::size_t size) { handed_out += size; };
  search.for_each_block(motion, 0, {}, nullptr, count);
  CHECK(search.searches() == 1);
  CHECK(candidates(mesh, {x, 3}, {x, 3}).size() > 500);
  CHECK(handed_out == 0);

  for (Index i = 0; i < 300; ++i) {
    crowd.edges.push_back({2 * i, 2 * i + 1});
    y.insert(y.end(), {0, 0, 1e-6 * i, std::cos(0.01 * i), std::sin(0.01 * i), 1e-6 * i});
  }
  crowd.vertex_count = 600;
  MeshSteps steps{Mesh(crowd)};
  for (const std::size_t searches : {2, 3, 4}) {  // the first one ends as soon as there are too many pairs
    const auto found = steps.all_contacts({y, 3}, {y, 3});
    CHECK(steps.searches() == searches);
    CHECK(same_bytes(found, all_contacts(steps.mesh(), {y, 3}, {y, 3})));
  }
}

TEST_CASE("kept steps: mistakes and stops leave them as they were") {
  MeshSteps steps(two_edges());
  const std::vector<double> x0 = {0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 1};
  std::vector<double> x1 = x0;
  x1[8] = x1[11] = -1;
  REQUIRE(steps.first_contact({x0, 3}, {x1, 3}).toi == 0.5);
  std::vector<double> bad = x1;
  bad[4] = NAN;
  CHECK_THROWS_AS(steps.first_contact({x0, 3}, {bad, 3}), InvalidQuery);
  CHECK_THROWS_AS(steps.first_contact({x0, 3}, {x1, 2}), InvalidQuery);
  CHECK_THROWS_AS(steps.free_step({x0, 3}, {x1, 3},
                                  [] {
                                    FreeStepOptions options;
                                    options.kept_fraction = 1;
                                    return options;
                                  }()),
                  InvalidQuery);
  const std::atomic<bool> stop{true};
  FirstContactOptions stopped;
  stopped.stop = &stop;
  steps.release();  // so that pairs are looked for again
  CHECK_THROWS_AS(steps.first_contact({x0, 3}, {x1, 3}, stopped), Stopped);
  for (int i = 0; i < 3; ++i) CHECK(steps.first_contact({x0, 3}, {x1, 3}).toi == 0.5);
  MeshSteps moved = std::move(steps);
  CHECK(moved.first_contact({x0, 3}, {x1, 3}).toi == 0.5);
  steps = MeshSteps{Mesh()};
  CHECK(steps.first_contact(Positions(), Positions()).free());
}

TEST_CASE("kept steps: positions so small that products underflow") {
  constexpr double kUnit = 0x1p-1074;
  MeshElements elements;
  elements.vertex_count = 3;
  MeshSteps steps{Mesh(elements)};
  std::vector<double> x0 = {1, 0, 0, -1, -1, 0, 0, 0, 0}, far = {1, 0, 0, 2, 1, 0, 0, 0, 10};
  std::vector<double> x1 = {1, 0, 0, 1, 0, 0, 0, 0, 5};
  for (auto* x : {&x0, &far, &x1}) {
    for (double& one : *x) one *= kUnit;
  }
  for (int i = 0; i < 2; ++i) CHECK(steps.first_contact({x0, 3}, {far, 3}).free());
  CHECK(steps.first_contact({x0, 3}, {x1, 3}).toi == 1);

  // Two points that rest a unit apart: what a fraction keeps is rounded to more than that.
  const std::vector<double> at_rest = {0, 0, 0, kUnit, 0, 0, 1, 0, 0};
  FreeStepOptions options;
  options.kept_fraction = 0.5;
  for (int i = 0; i < 3; ++i) {
    CHECK(same_bytes(steps.free_step({at_rest, 3}, {at_rest, 3}, options),
                     free_step(steps.mesh(), {at_rest, 3}, {at_rest, 3}, options)));
  }
}
