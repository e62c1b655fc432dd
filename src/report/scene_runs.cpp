// SPDX-License-Identifier: MIT
#include "report/scene_runs.hpp"

#include <fmt/format.h>

#include <cmath>

#include <touchstone/version.hpp>

#include "io/answer_writer.hpp"
#include "report/machine.hpp"
#include "report/text.hpp"
#include "sim/shipped_scenes.hpp"
#include "sim/simulation.hpp"

namespace touchstone::report {
namespace {

SceneRun run_scene(const std::string& name, sim::Index size, std::uint64_t steps, const std::function<void()>& pulse) {
  sim::Simulation simulation(sim::make_shipped_scene(name, size), {});
  SceneRun run;
  run.scene = name;
  run.size = size;
  run.edges = simulation.elements().edges().size();
  run.steps = steps;
  for (std::uint64_t i = 0; i < steps; ++i) {
    pulse();
    for (const auto& record : simulation.step()) {
      run.contacts += record.response.contacts;
      run.crossings += record.proof.crossings;
    }
  }
  run.seconds = simulation.times().total();
  run.collision_share = simulation.times().collision() / run.seconds;
  return run;
}

}  // namespace

double SceneRuns::exponent() const {
  const SceneRun &small = cable_drop.front(), &large = cable_drop.back();
  return std::log(large.seconds_per_step() / small.seconds_per_step()) /
         std::log(static_cast<double>(large.edges) / static_cast<double>(small.edges));
}

SceneRuns run_scenes(bool quick, const std::function<void()>& pulse) {
  SceneRuns runs;
  runs.hoop = quick ? run_scene("hoop", 200, 75, pulse) : run_scene("hoop", 560, 600, pulse);
  const std::vector<sim::Index> sizes =
      quick ? std::vector<sim::Index>{200, 800} : std::vector<sim::Index>{1000, 3000, 10000};
  // The layers fall for five steps and then lie on each other.
  for (const sim::Index size : sizes) runs.cable_drop.push_back(run_scene("cable-drop", size, quick ? 12 : 24, pulse));
  return runs;
}

std::string scene_runs_csv(const SceneRuns& runs, bool quick) {
  std::string text =
      "version,machine,compiler,quick,scene,size,edges,steps,contacts,crossings,seconds,seconds_per_step,"
      "collision_share\n";
  const auto row = [&](const SceneRun& run) {
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.4g}\n", io::csv_field(version()),
                       io::csv_field(machine_name()), io::csv_field(compiler_name()), quick ? 1 : 0, run.scene,
                       run.size, run.edges, run.steps, run.contacts, run.crossings, run.seconds, run.seconds_per_step(),
                       run.collision_share);
  };
  text += row(runs.hoop);
  for (const SceneRun& run : runs.cable_drop) text += row(run);
  return text;
}

std::string scene_runs_section(const SceneRuns& runs) {
  std::string text = fmt::format(
      "## Simulation\n\nThe first steps of scenes of `touchstone simulate`, a sixtieth of a second each, on one "
      "thread; "
      "every step is proved. `hoop` makes {:.0f} steps a second of processor time. The time of a step of `cable-drop`, "
      "in which most steps have contacts, grows with the number of edges to the power of {:.2f}. *Collision* is the "
      "share of broad phase, narrow phase, response and proof.\n\n"
      "| scene | edges | steps | contacts | crossings | ms a step | collision |\n|---|---:|---:|---:|---:|---:|---:|\n",
      1 / runs.hoop.seconds_per_step(), runs.exponent());
  const auto row = [](const SceneRun& run) {
    return fmt::format("| {} {} | {} | {} | {} | {} | {:.3g} | {} |\n", run.scene, run.size, run.edges, run.steps,
                       run.contacts, run.crossings, 1e3 * run.seconds_per_step(), percent(run.collision_share));
  };
  text += row(runs.hoop);
  for (const SceneRun& run : runs.cable_drop) text += row(run);
  return text + "\n";
}

}  // namespace touchstone::report
