// SPDX-License-Identifier: MIT
#include "cli/stress.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/words.hpp"
#include "io/output_file.hpp"
#include "stress/stress.hpp"

namespace touchstone::cli {
namespace {

struct StressOptions {
  stress::Options stress;
  std::string out;
  SeparationOption separation;
};

std::string dial_names() {
  std::string names;
  for (const stress::Dial& dial : stress::dials()) names += (names.empty() ? "" : ", ") + std::string(dial.name);
  return names;
}

int run_stress(const StressOptions& options) {
  NewFolders folders;
  folders.make(std::filesystem::path(options.out) / "plots");
  // A folder that cannot be written to is found before minutes are spent, not after.
  const std::string file = (std::filesystem::path(options.out) / "stress.md").string();
  io::OutputFile{file};

  ProgressLine line;
  const auto progress = draw_fraction_on(line);
  stress::Options asked = options.stress;
  asked.separation = options.separation.separation;
  const stress::Stress made = stress::run_stress(asked, progress);
  stress::write_stress(made, options.out);
  folders.keep();

  auto console = io::OutputFile::standard_output();
  console.write(file + "\n");
  console.commit();
  const std::size_t errors = stress::own_errors(made) + made.oracle_differs.size();
  if (errors == 0) return kAllHold;
  print_error(fmt::format("touchstone: {} of its own, which must never be: see {}\n", counted(errors, "error"), file));
  return kRefuted;
}

}  // namespace

void add_stress(CLI::App& program, Command& command) {
  const auto options = std::make_shared<StressOptions>();
  CLI::App* const subcommand = program.add_subcommand(
      "stress", "Show where each method breaks as queries get stiff: a stability table and pictures");
  subcommand
      ->add_option("--out", options->out, "The folder for the table and the pictures; it is made when it is missing")
      ->required()
      ->check([](const std::string& text) { return text.empty() ? "the folder's name is empty" : ""; })
      ->type_name("FOLDER");
  subcommand
      ->add_option_function<std::vector<std::string>>(
          "--dial",
          [options](const std::vector<std::string>& names) {
            for (const std::string& name : names) {
              const stress::Dial* const dial = stress::find_dial(name);
              auto& which = options->stress.which;
              if (std::find(which.begin(), which.end(), dial) == which.end()) which.push_back(dial);
            }
          },
          "Only this dial: " + dial_names() + "; may be given more than once (default: all)")
      ->type_name("NAME")
      ->check([](const std::string& name) {
        return stress::find_dial(name) ? std::string() : name + " is no dial; they are " + dial_names();
      });
  subcommand
      ->add_option("--count", options->stress.count,
                   "The number of queries at each setting, of each kind (default: 200)")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
  add_seed_option(*subcommand, options->stress.seed);
  add_separation_options(*subcommand, options->separation,
                         "The distance at which two elements are in contact, at every setting of a dial");
  subcommand->footer(
      "Asks every method queries that get stiffer as a dial is turned:\n"
      "  scale       of all coordinates, 2^-1070 to 2^1020\n"
      "  offset      from the origin, relative to the size, up to 2^60\n"
      "  sliver      aspect of faces, length of one edge relative to the other's, down to 2^-60\n"
      "  parallel    angle between edges, or between a vertex's path and the face, down to 2^-100\n"
      "  separation  of two roots of the cubic, down to 2^-200\n"
      "  speed       distance moved in a step, relative to the size, up to 2^60\n"
      "Exact arithmetic judges, and the oracle judges it on some queries of each setting. Writes\n"
      "  FOLDER/stress.md    missed, phantom, late, time error, run time and levels, and how run time grows\n"
      "  FOLDER/stress.csv   every number, with version, machine and compiler\n"
      "  FOLDER/plots/       pictures, NAME.svg\n"
      "in about half a minute, longer on a busy machine.\n\n"
      "Examples\n"
      "  touchstone stress --out stress\n"
      "  touchstone stress --out stress --dial sliver --dial parallel --count 2000\n\n"
      "Exit status: 0 done, 1 touchstone itself was wrong somewhere, 2 bad usage or a file that cannot be written.");
  subcommand->callback([options, &command] { command = [options] { return run_stress(*options); }; });
}

}  // namespace touchstone::cli
