// SPDX-License-Identifier: MIT
#include "report/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "io/write_whole.hpp"
#include "report/csv.hpp"
#include "report/markdown.hpp"
#include "report/pictures/pictures.hpp"
#include "report/sets/body_pairs.hpp"
#include "report/sets/body_steps.hpp"
#include "report/sets/family_sets.hpp"
#include "seeded/rng.hpp"
#include "seeded/shuffle.hpp"

namespace touchstone::report {
namespace {

namespace fs = std::filesystem;

const std::vector<double> kTolerances{1e-3, 1e-6, 1e-9};
constexpr std::array<int, 11> kExponents{-900, -600, -300, -100, -30, 0, 30, 100, 300, 600, 900};
constexpr double kSimulating = 0.4;  ///< fraction of the time
constexpr double kMeasuring = 0.6;   ///< the rest

/// Numbers of queries, and seconds.
struct Amounts {
  SceneSize simulation, aligned;
  std::size_t random, near, scale;
  BodyPairOptions bodies;
  std::size_t curved;  ///< cases of each family and kind
  std::size_t steps;   ///< of whole bodies, of each sort
  Effort effort, scale_effort;
};

Amounts amounts(bool quick) {
  if (quick)
    return {{300, 1000, 4}, {100, 1000, 2}, 200, 300, 60, {200}, 4, 4, {0.01, 3, 0.0002, 2}, {0.003, 3, 0.0002, 2}};
  return {{6000, 4000, 20}, {2000, 4000, 4}, 4000, 4000, 1000, {4000}, 40, 100, {0.3, 7, 0.01, 3}, {0.1, 5, 0.01, 3}};
}

std::vector<QuerySet> scale_sets(std::uint64_t seed, std::size_t count) {
  // Ordinary and near queries take turns.
  QuerySet base = random_sets(seed, count / 2).front();
  const auto near = near_sets(seed, count - count / 2).front().queries;
  base.queries.insert(base.queries.end(), near.begin(), near.end());
  base.name = "scale/" + std::string(name_of(base.kind));
  base.about = "One set of " + std::to_string(count) +
               " edge-edge queries, half of them like random/edge-edge and half like near/edge-edge, with every "
               "coordinate times a power of two";
  seeded::shuffle(base.queries, seeded::seed_of_stream(seed, 30));
  std::vector<QuerySet> sets;
  for (const int exponent : kExponents) {
    sets.push_back(base);
    sets.back().queries = scaled(base.queries, exponent);
  }
  return sets;
}

std::vector<Contestant> usual_ones(const std::vector<Contestant>& all) {
  std::vector<Contestant> usual;
  for (const Contestant& contestant : all) {
    if (contestant.is_usual()) usual.push_back(contestant);
  }
  return usual;
}

}  // namespace

std::size_t most_given(const Size& size) noexcept { return size.quick ? 400 : 20'000; }

Report make_report(const Size& size, std::vector<QuerySet> given, const Progress& progress) {
  const Amounts amount = amounts(size.quick);
  Report report;
  report.size = size;
  report.contestants = contestants(kTolerances, size.separation);
  report.curved_contestants = curved_contestants(kTolerances, size.separation);
  if (size.separation.distance == 0) report.body_contestants = body_contestants();

  // The scenes run first, while this process is small: the processes of the runs are copies of it.
  report.scene_runs = run_scenes(size.quick, [&](double fraction) { progress("simulating", kSimulating * fraction); });

  progress("generating", kSimulating);
  std::vector<QuerySet> sets = simulation_sets(size.seed, amount.simulation, size.separation.distance);
  BodyPairOptions of_bodies = amount.bodies;
  of_bodies.separation = size.separation.distance;
  const auto generating = [&] { progress("generating", kSimulating); };
  const auto append = [&sets](std::vector<QuerySet> more) {
    std::move(more.begin(), more.end(), std::back_inserter(sets));
  };
  append(std::move(given));
  append(aligned_sets(size.seed, amount.aligned, size.separation.distance));
  append(random_sets(size.seed, amount.random));
  append(near_sets(size.seed, amount.near));
  for (const auto scene : kBodyScenes) append(body_pair_sets(scene, of_bodies, generating));
  append(curved_sets(size.seed, amount.curved));
  if (size.separation.distance == 0) append(body_step_sets(size.seed, amount.steps, generating));
  std::vector<QuerySet> scales = scale_sets(size.seed, amount.scale);

  const double total = static_cast<double>(sets.size()) + 0.3 * static_cast<double>(scales.size());
  double done = 0;
  for (QuerySet& set : sets) {
    if (set.size() == 0) continue;
    seeded::shuffle(set.queries, seeded::seed_of_stream(size.seed, 20));
    seeded::shuffle(set.curved, seeded::seed_of_stream(size.seed, 20));
    const std::string name = set.name;
    set.separation = size.separation;
    const auto pulse = [&] { progress(name, kSimulating + kMeasuring * done / total); };
    const auto& asked = set.is_of_bodies() ? report.body_contestants
                        : set.is_curved()  ? report.curved_contestants
                                           : report.contestants;
    Effort effort = amount.effort;
    if (set.is_of_bodies()) effort.passes = size.quick ? 1 : 3, effort.tries = 1;  // some methods take a second a step
    report.sets.push_back(measure(std::move(set), asked, effort, pulse));
    done += 1;
  }
  const auto usual = usual_ones(report.contestants);
  for (std::size_t i = 0; i < scales.size(); ++i) {
    // Queries and separation are multiplied by the same power of two.
    scales[i].separation = {std::ldexp(size.separation.distance, kExponents[i]), size.separation.metric};
    const auto pulse = [&] { progress("scales", kSimulating + kMeasuring * done / total); };
    report.scales.push_back(measure(std::move(scales[i]), usual, amount.scale_effort, pulse));
    report.scales.back().exponent = kExponents[i];
    done += 0.3;
  }
  return report;
}

void write_report(const Report& report, const std::string& folder) {
  const fs::path root = folder;
  io::write_whole((root / "report.csv").string(), csv_text(report));
  io::write_whole((root / "simulation.csv").string(), scene_runs_csv(report.scene_runs, report.size.quick));
  write_pictures(pictures(report), root / "plots");
  io::write_whole((root / "report.md").string(), markdown_text(report));
}

}  // namespace touchstone::report
