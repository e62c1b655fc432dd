// SPDX-License-Identifier: MIT
#include "report/scene_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

#include <touchstone/version.hpp>

#include "io/answers/answer_writer.hpp"
#include "report/machine.hpp"
#include "report/own_process.hpp"
#include "report/text.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/memory.hpp"
#include "sim/simulation.hpp"

namespace touchstone::report {
namespace {

/// One run, and roughly its time relative to the other runs.
struct RunPlan {
  const char* scene;
  sim::Index size;
  std::uint64_t steps;
  double weight;
};

struct Plans {
  RunPlan hoop;
  std::vector<RunPlan> cable_drop, whip, twist, link_chain;
};

/// The layers of cable-drop fall for five steps and then lie on each other, and its time is that of their contacts; the
/// whip, in steps far longer than its own, meets its wire in the first one, and hangs over it from then on. So series
/// of one scene are for one span.
Plans plans(bool quick) {
  if (quick) {
    return {{"hoop", 200, 75, 2},
            {{"cable-drop", 200, 12, 1}, {"cable-drop", 800, 12, 4}},
            {{"whip", 100, 10, 1}, {"whip", 400, 10, 4}},
            {{"twist", 100, 10, 1}, {"twist", 400, 10, 4}},
            {{"link-chain", 3, 100, 1}, {"link-chain", 12, 100, 4}}};
  }
  return {{"hoop", 560, 600, 3},
          {{"cable-drop", 5'000, 24, 5}, {"cable-drop", 50'000, 24, 58}},
          {{"whip", 1'000, 30, 0.5}, {"whip", 10'000, 30, 5}},
          {{"twist", 1'000, 10, 0.5}, {"twist", 5'000, 10, 2}, {"twist", 20'000, 10, 15}},
          {{"link-chain", 12, 800, 0.5}, {"link-chain", 50, 800, 2}}};
}

double weight(const std::vector<RunPlan>& plans) {
  double sum = 0;
  for (const RunPlan& plan : plans) sum += plan.weight;
  return sum;
}

/// The result that the process of a run sends back.
struct Counts {
  std::uint64_t edges, contacts, crossings;
  double seconds, collision_fraction;
};

Counts count(const RunPlan& plan, const ScenePulse& pulse) {
  sim::Scene scene = sim::make_shipped_scene(plan.scene, plan.size);
  if (plan.scene == std::string_view("whip")) {
    scene.settings.time_step = 1.0 / 60;
    scene.settings.integrator = sim::Integrator::implicit_euler;
  }
  sim::Simulation simulation(std::move(scene), {});
  Counts counts{};
  counts.edges = simulation.colliders().edges().size();
  for (std::uint64_t i = 0; i < plan.steps; ++i) {
    pulse(static_cast<double>(i) / static_cast<double>(plan.steps));
    for (const auto& record : simulation.step()) {
      counts.contacts += record.response.contacts + record.bodies.close;
      counts.crossings += record.proof.crossings;
    }
  }
  counts.seconds = simulation.times().total();
  counts.collision_fraction = simulation.times().collision() / counts.seconds;
  return counts;
}

/// `small` is a small form of the scene. It runs first, so that the memory of the code does not count as the scene's.
SceneRun run_scene(const RunPlan& plan, const RunPlan& small, const ScenePulse& pulse) {
  const auto prepare = [&] {
    sim::give_memory_back();  // as `touchstone simulate` does
    count(small, [](double) {});
  };
  const auto [counts, memory] = run_in_own_process(prepare, [&] { return count(plan, pulse); });
  return {plan.scene,      static_cast<std::uint64_t>(plan.size),
          counts.edges,    plan.steps,
          counts.contacts, counts.crossings,
          counts.seconds,  counts.collision_fraction,
          memory};
}

template <class Use>
void for_each_run(const SceneRuns& runs, const Use& use) {
  use(runs.hoop);
  for (const SceneSeries* series : {&runs.cable_drop, &runs.whip, &runs.twist, &runs.link_chain}) {
    for (const SceneRun& run : *series) use(run);
  }
}

}  // namespace

double exponent(const SceneSeries& series) {
  const SceneRun &small = series.front(), &large = series.back();
  return std::log(large.seconds_per_step() / small.seconds_per_step()) /
         std::log(static_cast<double>(large.edges) / static_cast<double>(small.edges));
}

SceneRuns run_scenes(bool quick, const ScenePulse& pulse) {
  const Plans all = plans(quick), small = plans(true);
  const double total =
      all.hoop.weight + weight(all.cable_drop) + weight(all.whip) + weight(all.twist) + weight(all.link_chain);
  double done = 0;
  const auto run = [&](const RunPlan& plan, const RunPlan& before) {
    SceneRun result = run_scene(plan, before, [&](double fraction) { pulse((done + fraction * plan.weight) / total); });
    done += plan.weight;
    return result;
  };
  SceneRuns runs;
  runs.hoop = run(all.hoop, small.hoop);
  for (const RunPlan& plan : all.cable_drop) runs.cable_drop.push_back(run(plan, small.cable_drop.front()));
  for (const RunPlan& plan : all.whip) runs.whip.push_back(run(plan, small.whip.front()));
  for (const RunPlan& plan : all.twist) runs.twist.push_back(run(plan, small.twist.front()));
  for (const RunPlan& plan : all.link_chain) runs.link_chain.push_back(run(plan, small.link_chain.front()));
  return runs;
}

std::string scene_runs_csv(const SceneRuns& runs, bool quick) {
  std::string text =
      "version,machine,compiler,quick,scene,size,edges,steps,contacts,crossings,seconds,seconds_per_step,"
      "collision_share,memory_bytes\n";
  for_each_run(runs, [&](const SceneRun& run) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.4g},{}\n", io::csv_field(version()),
                    io::csv_field(machine_name()), io::csv_field(compiler_name()), quick ? 1 : 0, run.scene, run.size,
                    run.edges, run.steps, run.contacts, run.crossings, run.seconds, run.seconds_per_step(),
                    run.collision_fraction, run.memory ? fmt::format("{}", *run.memory) : std::string());
  });
  return text;
}

std::string scene_runs_section(const SceneRuns& runs) {
  std::string text = fmt::format(
      "## Simulation\n\nThe first steps of scenes of `touchstone simulate`, on one thread; every step is proved. "
      "`hoop` makes {:.0f} steps a second of processor time. The time of a step of "
      "`cable-drop`, in which most steps have contacts, grows with the number of edges to the power of {:.2f}, and of "
      "`whip`, a cable at 100 m/s, to the power of {:.2f}; that of `twist`, a sheet that is wrung, to the power of "
      "{:.2f}, and of `link-chain`, rigid links of 100 edges, to the power of {:.2f}. *Collision* is the share of "
      "broad "
      "phase, narrow phase, response and proof. *Memory* is by how much the resident memory of a process that does "
      "nothing else grew until "
      "its peak, with the scene and with what the allocator holds back, but without the code.\n\n"
      "| scene | edges | steps | contacts | crossings | ms a step | steps a second | collision | memory | bytes an "
      "edge |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      1 / runs.hoop.seconds_per_step(), exponent(runs.cable_drop), exponent(runs.whip), exponent(runs.twist),
      exponent(runs.link_chain));
  for_each_run(runs, [&](const SceneRun& run) {
    std::string memory = "unknown", an_edge;
    if (run.memory) {
      memory = fmt::format("{:.1f} MB", 1e-6 * static_cast<double>(*run.memory));
      an_edge = fmt::format("{:.0f}", static_cast<double>(*run.memory) / static_cast<double>(run.edges));
    }
    text += fmt::format("| {} {} | {} | {} | {} | {} | {:.4g} | {:.3g} | {} | {} | {} |\n", run.scene, run.size,
                        run.edges, run.steps, run.contacts, run.crossings, 1e3 * run.seconds_per_step(),
                        1 / run.seconds_per_step(), percent(run.collision_fraction), memory, an_edge);
  });
  return text + "\n";
}

}  // namespace touchstone::report
