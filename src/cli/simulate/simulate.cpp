// SPDX-License-Identifier: MIT
#include "cli/simulate/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include <touchstone/error.hpp>

#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/whole_file.hpp"
#include "cli/shared/words.hpp"
#include "cli/simulate/output.hpp"
#include "cli/simulate/paths.hpp"
#include "cli/simulate/run_summary.hpp"
#include "cli/simulate/scene_input.hpp"
#include "io/write_whole.hpp"
#include "scene/scene_file.hpp"
#include "sim/memory.hpp"

namespace touchstone::cli {
namespace {

/// The simulation at its first step, or at the step of the checkpoint.
std::unique_ptr<sim::Simulation> make_simulation(sim::Scene scene, std::optional<sim::Checkpoint> checkpoint,
                                                 const SimulateOptions& options) {
  // Reading a large scene and setting it up take seconds each.
  throw_if_interrupted();
  auto simulation = naming_file(options.resume.empty() ? options.scene : options.resume, [&] {
    const sim::SimulationOptions settings{options.narrow_phase,
                                          options.threads,
                                          throw_if_interrupted,
                                          !options.prove.empty(),
                                          !options.energies.empty() || !options.out.empty(),
                                          !options.html.empty()};
    auto made = std::make_unique<sim::Simulation>(std::move(scene), settings);
    if (checkpoint) made->resume(std::move(checkpoint->state), checkpoint->steps, std::move(checkpoint->bodies));
    return made;
  });
  throw_if_interrupted();
  return simulation;
}

std::uint64_t steps_to_make(const SimulateOptions& options, const sim::Simulation& simulation) {
  if (options.steps) return *options.steps;
  const auto& settings = simulation.scene().settings;
  const auto all = static_cast<std::uint64_t>(std::ceil(settings.duration / settings.time_step - 1e-6));
  return all - std::min(all, simulation.steps());
}

struct Run {
  StepTotals totals;
  double rate = 0;  ///< steps a second
};

/// Makes the steps. An exception of a step first lets `output` finish the files up to the step before.
Run run_steps(sim::Simulation& simulation, std::uint64_t steps, SimulateOutput& output) {
  Run run;
  ProgressLine line;
  const auto rate = [&] { return static_cast<double>(run.totals.steps) / line.seconds(); };
  while (run.totals.steps < steps) {
    try {
      const auto records = simulation.step();
      run.totals.add(records);
      output.step(records);
    } catch (...) {
      try {
        output.finish_early();
      } catch (const std::exception& error) {  // must not hide why the run ends
        print_error(fmt::format("touchstone: some files of the proved steps are incomplete: {}\n", error.what()));
      }
      throw;
    }
    line.draw([&] {
      const double fraction = static_cast<double>(run.totals.steps) / static_cast<double>(steps);
      return fmt::format("{} {} of {} steps, {:.0f} a second", progress_bar(fraction), grouped(run.totals.steps),
                         grouped(steps), rate());
    });
  }
  run.rate = rate();
  return run;
}

int simulate(sim::Simulation& simulation, const SimulateOptions& options, io::OutputFile& console) {
  SimulateOutput output(options, simulation);
  const Run run = run_steps(simulation, steps_to_make(options, simulation), output);
  std::exception_ptr unwritten;  // a file that cannot be written does not change the proofs made so far
  try {
    output.finish(simulation_for_person(simulation, run.totals, {}));
  } catch (const Error&) {
    unwritten = std::current_exception();
  }
  const std::string summary = simulation_for_person(simulation, run.totals, run_times_for_person(simulation, run.rate));
  console.write(in_colour(summary, VerdictLine::first, simulation.crossings().empty()) + output.proofs_summary() +
                output.page_summary());
  console.commit();
  if (unwritten) std::rethrow_exception(unwritten);
  return simulation.crossings().empty() && output.proved_free() ? kAllHold : kRefuted;
}

}  // namespace

int run_simulate(const SimulateOptions& options) {
  if (options.resume.empty() == options.scene.empty()) {
    throw Error("name a scene, or a checkpoint with --resume, and not both");
  }
  if (!options.resume.empty() && options.size) throw Error("--size: a checkpoint has its size");
  if (options.follow && options.energies.empty() && options.out.empty()) {
    throw Error("--follow: its positions are written with --energies or --out, and neither is given");
  }
  if (options.html == "-") throw Error("--html: name a file to write, standard output has the summary");
  check_paths(options);
  sim::give_memory_back();
  std::optional<sim::Checkpoint> checkpoint;
  if (!options.resume.empty()) checkpoint = read_checkpoint(options.resume);
  sim::Scene scene = checkpoint ? checkpoint->scene : scene_of(options);
  if (options.time_step) scene.settings.time_step = *options.time_step;
  if (options.integrator) scene.settings.integrator = *options.integrator;
  if (options.tolerance) scene.settings.tolerance = *options.tolerance;
  if (options.follow) {
    const std::string missing = sim::missing_in(scene, *options.follow);
    if (!missing.empty()) throw Error("--follow: " + missing);
  }
  if (!options.scene_out.empty()) {
    io::write_whole(options.scene_out, sim::scene_to_json(scene));
    return kAllHold;
  }
  const auto simulation = make_simulation(std::move(scene), std::move(checkpoint), options);
  auto console = io::OutputFile::standard_output();
  if (!options.explain) return simulate(*simulation, options, console);
  console.write(sim::explain(*simulation));
  console.commit();
  return kAllHold;
}

}  // namespace touchstone::cli
