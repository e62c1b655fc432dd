// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>

#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/simulate/simulate.hpp"
#include "scene/shipped_scenes.hpp"

namespace touchstone::cli {

void add_simulate(CLI::App& program, Command& command) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("simulate", "Move particles, springs and cables that collide, and prove each step");
  std::string scenes, names;
  for (const auto& shipped : sim::shipped_scenes()) {
    names.append(names.empty() ? "" : ",").append(shipped.name);
    scenes += fmt::format("  {:12} {} (--size: {}, {} to {}; {})\n", shipped.name, shipped.about, shipped.size_means,
                          shipped.least, shipped.most, shipped.usual);
  }
  subcommand->add_option("SCENE", options->scene, "A scene that comes with the program, or a JSON file")
      ->type_name("SCENE:{" + names + "}")  // for the completions: the footer has the list
      ->option_text(" ");
  subcommand->add_option("--size", options->size, "The size of a scene that comes with the program")
      ->type_name("N")
      ->check(CLI::Range(std::uint32_t{1}, std::numeric_limits<std::uint32_t>::max()));
  subcommand->add_option("--steps", options->steps, "The number of steps (default: the scene's duration)")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1'000'000'000'000}));
  subcommand->add_option("--time-step", options->time_step, "The length of a step in s, in place of the scene's")
      ->type_name("S");
  subcommand
      ->add_option_function<std::string>(
          "--integrator", [options](const std::string& name) { options->integrator = sim::find_integrator(name); },
          "The integrator, in place of the scene's")
      ->type_name("NAME")
      ->check(CLI::IsMember({"implicit-euler", "tr-bdf2", "implicit-midpoint", "symplectic-euler"}));
  subcommand
      ->add_option("--tolerance", options->tolerance,
                   "The error of positions in m that integration may make in a second, in place of the scene's: steps "
                   "are cut until they keep it. 0: no step is cut for it")
      ->type_name("M");
  subcommand
      ->add_option_function<std::string>(
          "--follow", [options](const std::string& text) { options->follow = sim::followed_from(text); },
          "Add the position of this particle to the table of energies, as the columns x, y and z. body:3 is the centre "
          "of mass of body 3, with its orientation in four columns more, and body:3:7 is the body's vertex 7")
      ->type_name("PARTICLE")
      ->check([](const std::string& text) {
        return sim::followed_from(text) ? "" : "neither the number of a particle nor body:B nor body:B:VERTEX";
      });
  subcommand
      ->add_option("--out", options->out, "The folder for frames (VTK, a series for ParaView), energies and their plot")
      ->type_name("FOLDER");
  subcommand
      ->add_option("--frame-every", options->frame_every, "The number of steps from one frame to the next (default: 2)")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}));
  add_animation_option(*subcommand, options->html, "its contacts and its energies");
  subcommand->add_option("--proof", options->proof, "Write a table (CSV) with the proof of each step")
      ->type_name("FILE")
      ->check(named_as(Output::csv));
  subcommand
      ->add_option("--prove", options->prove,
                   "Write the positions of all steps as FOLDER/motion.txt and a proof for each pair of elements as "
                   "FOLDER/proofs.txt, for touchstone-check. The folder must be new or empty")
      ->type_name("FOLDER");
  subcommand
      ->add_option("--energies", options->energies, "Write a table (CSV) with the energies and contacts of each step")
      ->type_name("FILE")
      ->check(named_as(Output::csv));
  subcommand
      ->add_option(
          "--queries", options->queries,
          "Write every candidate pair of the proofs as FOLDER/KIND/candidates.csv, query files with true answers. "
          "Pairs with a separation D are in candidates-D.csv")
      ->type_name("FOLDER");
  subcommand->add_option("--checkpoint", options->checkpoint, "Write the state at the end to this file (JSON)")
      ->type_name("FILE")
      ->check(named_as(Output::json));
  subcommand->add_option("--resume", options->resume, "Continue from a checkpoint as if the run had not stopped")
      ->type_name("FILE");
  CLI::Option* const scene_out =
      subcommand->add_option("--scene-out", options->scene_out, "Write the scene as JSON and end")
          ->type_name("FILE")
          ->check(named_as(Output::json));
  CLI::Option* const explain = subcommand->add_flag("--explain", options->explain,
                                                    "Print the passes that the scene needs and the reasons, and end");
  subcommand
      ->add_option_function<std::string>(
          "--narrow-phase",
          [options](const std::string& name) {
            options->narrow_phase = name == "paper" ? sim::NarrowPhase::paper : sim::NarrowPhase::exact;
          },
          "The method that finds the contacts to respond to: exact, or paper, the closed form in doubles, for edges "
          "only. The proof is always exact. With paper it reports crossings instead of refusing the step, and the "
          "radii "
          "of the scene are left aside")
      ->type_name("NAME")
      ->check(CLI::IsMember({"exact", "paper"}));
  subcommand
      ->add_option("--threads", options->threads,
                   "The number of threads that answer queries (default: 1); no result depends on it")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  for (const char* of_scene : {"--time-step", "--integrator", "--tolerance"}) {
    subcommand->get_option("--resume")->excludes(subcommand->get_option(of_scene));
  }
  subcommand->get_option("--frame-every")->needs(subcommand->get_option("--out"));
  for (const char* path :
       {"--out", "--proof", "--prove", "--energies", "--queries", "--checkpoint", "--resume", "--scene-out"}) {
    subcommand->get_option(path)->check(
        [](const std::string& name) { return name.empty() ? std::string("the name is empty") : std::string(); });
  }
  // These two make no step, so that options of a run are refused beside them.
  scene_out->excludes(explain);
  for (const char* of_run :
       {"--steps", "--out", "--html", "--proof", "--prove", "--energies", "--queries", "--checkpoint"}) {
    scene_out->excludes(subcommand->get_option(of_run));
    explain->excludes(subcommand->get_option(of_run));
  }
  subcommand->footer(
      "Scenes\n" + scenes +
      "\nUnits are SI. A step that would let two elements touch, or come within the sum of their radii, "
      "is not\ntaken: it is tried again in shorter substeps. The first line is `N steps, 0 crossings` and all that was "
      "left out.\n\n"
      "Examples\n"
      "  touchstone simulate hoop --out hoop\n"
      "  touchstone simulate two-edges --html two-edges.html\n"
      "  touchstone simulate cable-drop --size 5000 --proof proof.csv\n"
      "  touchstone simulate hoop --prove proved && touchstone-check proved/proofs.txt proved/motion.txt\n"
      "  touchstone simulate hoop --scene-out hoop.json && touchstone simulate hoop.json\n"
      "  touchstone simulate hoop --narrow-phase paper\n\n"
      "Exit status: 0 done without a crossing, 1 crossings, 2 bad usage, a bad scene or a step that "
      "cannot be taken.");
  subcommand->callback([options, &command] { command = [options] { return run_simulate(*options); }; });
}

}  // namespace touchstone::cli
