// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/scenes/scenes.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/output_names.hpp"

namespace touchstone::cli {

void add_scenes(CLI::App& program, Command& command) {
  const auto options = std::make_shared<ScenesOptions>();
  CLI::App* const subcommand = program.add_subcommand(
      "scenes", "Check the steps of the public scenes against their truth, and say how long each takes");
  subcommand->add_option("FOLDER", options->folders, "A scene's folder, or a folder of scenes")
      ->required()
      ->type_name("");
  subcommand
      ->add_option("--threads", options->threads,
                   "The number of threads, 0 for all that the machine has (default: 1); only times depend on it")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  subcommand->add_option("--csv", options->csv, "Write the numbers as a table (CSV), too")
      ->type_name("FILE")
      ->check(named_as(Output::csv));
  subcommand->footer(
      "A scene is a folder of the time-of-impact data set (Belgrod et al. 2023), as it comes:\n"
      "  frames/    mesh files; each two that follow each other are a step, whose number is at the end of the name\n"
      "  boxes/     Nee.json and Nvf.json: the pairs of edges, and of a vertex and a face, that were judged in step N\n"
      "  mma_bool/  Nee_mma_bool.json and Nvf_mma_bool.json: whether each of them touches, by Mathematica\n"
      "For each step, all pairs of the mesh are asked about, and the contacts are compared with that truth. A contact\n"
      "of a pair that was not judged is counted as one besides. Each time is the least of three. The time of an\n"
      "answer is that of a batch of all candidates. The memory is what the first contact takes on one thread, in a\n"
      "process of its own. The digest is that of all contacts: it is the same on every machine.\n\n"
      "Examples\n"
      "  touchstone scenes scenes/cloth-ball\n"
      "  touchstone scenes --threads 0 --csv table.csv scenes\n\n"
      "Exit status: 0 all verdicts are as said, 1 some differ, or there are contacts besides, or nothing was "
      "compared,\n"
      "2 bad usage or bad input.");
  subcommand->callback([options, &command] { command = [options] { return run_scenes(*options); }; });
}

}  // namespace touchstone::cli
