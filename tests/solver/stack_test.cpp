// No call needs more than a bounded part of its thread's stack: all kinds, all families, both metrics, corners on
// straight lines and on curves, and meshes on the calling thread.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "mesh/scenes.hpp"
#include "support/catch.hpp"
#include "support/painted_stack.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/skip.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

// docs/guide.md promises both.
constexpr std::size_t kMostStack = std::size_t{128} * 1024;
constexpr std::size_t kMostOfGmp = std::size_t{256} * 1024;

/// Frames are as large as the optimiser and the sanitizers make them: the bound is about release builds.
bool frames_are_those_of_a_release() {
  if (TOUCHSTONE_SLOW_BUILD == 0) return true;
  skip("frames of the stack are larger in a debug build and with a sanitizer");
  return false;
}

/// The greatest use of each sort of call, and where it was.
class Depths {
 public:
  void measure(const std::string& sort, const std::string& where, const std::function<void()>& call) {
    Deepest& deepest = deepest_[sort];
    const StackUse use = stack_.use_of(call);
    if (use.own > deepest.own) deepest.own = use.own, deepest.where = where;
    if (use.gmp > deepest.gmp) deepest.gmp = use.gmp, deepest.where_gmp = where;
  }

  void finish() const {
    REQUIRE_FALSE(deepest_.empty());
    if (!sees_calls_of_gmp()) return skip("the stack that GMP takes is not told apart where the library is shared");
    for (const auto& [sort, deepest] : deepest_) {
      std::printf("%-28s %6zu bytes of the stack, by %s\n", sort.c_str(), deepest.own, deepest.where.c_str());
      if (deepest.gmp > 0) std::printf("%28s %6zu by GMP, by %s\n", "", deepest.gmp, deepest.where_gmp.c_str());
      INFO(sort << ": " << deepest.where << "; " << deepest.where_gmp);
      CHECK(deepest.own > 0);
      CHECK(deepest.own <= kMostStack);
      CHECK(deepest.gmp <= kMostOfGmp);
    }
  }

 private:
  struct Deepest {
    std::size_t own = 0, gmp = 0;
    std::string where, where_gmp;
  };
  PaintedStack stack_;
  std::map<std::string, Deepest> deepest_;
};

RationalQuery thirds_of(const Query& query) {
  RationalQuery thirds;
  thirds.kind = query.kind;
  const auto third = [](double x) { return Fraction{std::to_string(static_cast<long long>(x)), "3"}; };
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    thirds.start[i] = {third(query.start[i].x), third(query.start[i].y), third(query.start[i].z)};
    thirds.end[i] = {third(query.end[i].x), third(query.end[i].y), third(query.end[i].z)};
  }
  return thirds;
}

const BatchOptions kOneThread = [] {
  BatchOptions options;
  options.threads = 1;
  return options;
}();

constexpr std::uint64_t kSeed = 20;

}  // namespace

TEST_CASE("stack: questions about straight motion") {
  if (!frames_are_those_of_a_release()) return;
  Depths depths;
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < effort(4); ++index) {
        const CaseId id{family.family, kind, kSeed, index};
        const Query query = make(id);
        const std::string name = case_name(id);
        depths.measure("solve, fast", name, [&] { solve(query); });
        depths.measure("solve, exact", name, [&] { solve(query, {.method = Method::exact}); });
        depths.measure("solve, up to a half", name, [&] { solve(query, {.t_max = 0.5, .wanted = Wanted::time}); });
        depths.measure("solve, contact", name, [&] { solve(query, {.wanted = Wanted::contact}); });
        depths.measure("contact_times", name, [&] { contact_times(query); });
        depths.measure("contact_normal", name, [&] { contact_normal(query); });
        const std::vector<Query> many(40, query);
        depths.measure("solve_batch", name, [&] { solve_batch(many, kOneThread); });
        if (family.group != Group::lattice) continue;
        const RationalQuery thirds = thirds_of(query);
        depths.measure("solve, rational", name, [&] { solve(thirds); });
        depths.measure("contact_times, rational", name, [&] { contact_times(thirds); });
        depths.measure("contact_normal, rational", name, [&] { contact_normal(thirds); });
      }
    }
  }
  Query refused;
  refused.start[0].x = INFINITY;
  depths.measure("an error", "an infinite coordinate", [&] { CHECK_THROWS_AS(solve(refused), InvalidQuery); });
  depths.finish();
}

TEST_CASE("stack: questions about a separation", "[slow]") {
  if (!frames_are_those_of_a_release()) return;
  Depths depths;
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const std::string in = metric == Metric::max ? ", max" : ", euclidean";
    for (const FamilyInfo& family : all_families()) {
      for (const Kind kind : kKinds) {
        for (std::uint64_t index = 0; index < effort(2); ++index) {
          const CaseId id{family.family, kind, kSeed, index};
          const Separated made = make_separated(id, metric);
          const Separation separation = {made.distance, metric};
          const Query& query = made.query;
          const std::string name = case_name(id);
          depths.measure("solve, fast" + in, name, [&] { solve(query, {.separation = separation}); });
          depths.measure("solve, exact" + in, name,
                         [&] { solve(query, {.separation = separation, .method = Method::exact}); });
          depths.measure("solve, contact" + in, name,
                         [&] { solve(query, {.separation = separation, .wanted = Wanted::contact}); });
          depths.measure("contact_times" + in, name, [&] { contact_times(query, separation); });
          depths.measure("distance" + in, name, [&] { distance(query, 0.375, metric); });
          depths.measure("compare_distance" + in, name, [&] { compare_distance(query, 1, separation); });
          if (metric == Metric::euclidean) {
            depths.measure("contact_normal" + in, name, [&] { contact_normal(query, separation); });
          }
          if (family.group != Group::lattice) continue;
          const RationalQuery thirds = thirds_of(query);
          depths.measure("solve, rational" + in, name, [&] { solve(thirds, {.separation = separation}); });
          depths.measure("contact_times, rational" + in, name, [&] { contact_times(thirds, separation); });
        }
      }
    }
  }
  depths.finish();
}

TEST_CASE("stack: questions about curves and bodies", "[slow]") {
  if (!frames_are_those_of_a_release()) return;
  Depths depths;
  for (const FamilyInfo& family : curved_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < effort(1); ++index) {
        const CaseId id{family.family, kind, kSeed, index};
        const CurvedSample sample = make_curved(id);
        const CurvedQuery& query = sample.query;
        const std::string name = case_name(id);
        depths.measure("solve, fast", name, [&] { solve(query, sample.t_max); });
        depths.measure("solve, exact", name, [&] { solve(query, {.t_max = sample.t_max, .method = Method::exact}); });
        depths.measure("solve, contact", name,
                       [&] { solve(query, {.t_max = sample.t_max, .wanted = Wanted::contact}); });
        depths.measure("contact_times", name, [&] { contact_times(query, {}, sample.t_max); });
        depths.measure("contact_normal", name, [&] { contact_normal(query, {}, sample.t_max); });
        depths.measure("solve_screw", name, [&] { solve_screw(query); });
        const std::vector<CurvedQuery> many(3, query);
        depths.measure("solve_batch", name, [&] { solve_batch(many, kOneThread); });
        for (const Metric metric : {Metric::euclidean, Metric::max}) {
          const std::string in = metric == Metric::max ? ", max" : ", euclidean";
          Rng random = rng_of(id);
          const CurvedSeparated made = make_curved_separated(family.family, kind, metric, random);
          const Separation separation = {made.distance, metric};
          const CurvedQuery& its = made.sample.query;
          depths.measure("solve, fast" + in, name, [&] { solve(its, {.separation = separation}); });
          depths.measure("solve, exact" + in, name,
                         [&] { solve(its, {.separation = separation, .method = Method::exact}); });
          depths.measure("contact_times" + in, name, [&] { contact_times(its, separation); });
          ScrewOptions options;
          options.separation = separation;
          depths.measure("solve_screw" + in, name, [&] { solve_screw(its, options); });
          if (metric == Metric::euclidean) {
            depths.measure("contact_normal" + in, name, [&] { contact_normal(its, separation); });
          }
        }
      }
    }
  }
  depths.finish();
}

TEST_CASE("stack: questions about meshes, on the calling thread") {
  if (!frames_are_those_of_a_release()) return;
  Depths depths;
  seeded::Rng random(kSeed);
  for (const Layout layout : kLayouts) {
    for (std::size_t i = 0; i < effort(8); ++i) {
      Scene scene = random_scene(random, layout, 24);
      scene.elements.separation.metric = i % 2 == 0 ? Metric::max : Metric::euclidean;
      const Mesh mesh(scene.elements);
      const std::string name = scene.name + " " + std::to_string(i);
      depths.measure("Mesh", name, [&] { const Mesh again(scene.elements); });
      depths.measure("first_contact", name, [&] { first_contact(mesh, scene.start(), scene.end()); });
      depths.measure("all_contacts", name, [&] { all_contacts(mesh, scene.start(), scene.end()); });
      depths.measure("candidates", name, [&] { candidates(mesh, scene.start(), scene.end()); });
      depths.measure("intersections", name, [&] { intersections(mesh, scene.start()); });
      depths.measure("intersects", name, [&] { intersects(mesh, scene.start()); });
      depths.measure("free_step", name, [&] { free_step(mesh, scene.start(), scene.end()); });
      FreeStepOptions kept;
      kept.kept_fraction = 0.25;
      depths.measure("free_step, kept fraction", name, [&] { free_step(mesh, scene.start(), scene.end(), kept); });
    }
  }
  depths.finish();
}

}  // namespace touchstone::tests
