// SPDX-License-Identifier: MIT
#include "cli/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/version.hpp>

#include "cli/audit/audit.hpp"
#include "cli/bench/bench.hpp"
#include "cli/bodies/bodies.hpp"
#include "cli/certify/certify.hpp"
#include "cli/convert/convert.hpp"
#include "cli/describe/describe.hpp"
#include "cli/doctor/doctor.hpp"
#include "cli/explain/explain.hpp"
#include "cli/fuzz/fuzz.hpp"
#include "cli/fuzz/fuzz_steps.hpp"
#include "cli/generate/generate.hpp"
#include "cli/merge.hpp"
#include "cli/mesh/mesh.hpp"
#include "cli/prove.hpp"
#include "cli/report/report.hpp"
#include "cli/scenes/scenes.hpp"
#include "cli/shared/build_facts.hpp"
#include "cli/shared/command_line/typed_command.hpp"
#include "cli/shared/nearest_name.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "cli/simulate/simulate.hpp"
#include "cli/solve.hpp"
#include "cli/stress.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"

namespace touchstone::cli {
namespace {

void print(const std::string& text) {
  auto console = io::OutputFile::standard_output();
  console.write(text);
  console.commit();
}

int complain(const std::string& line) {
  print_error(line + '\n');
  return kBadInput;
}

/// The first line of the message of the parser of arguments. It repeats the arguments, which may be of any length.
std::string first_line(const std::string& text) { return io::with_short_words(text.substr(0, text.find('\n'))); }

/// The subcommands that --help shows.
std::vector<std::string> subcommand_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command :
       program.get_subcommands([](const CLI::App* app) { return !app->get_group().empty(); })) {
    names.push_back(command->get_name());
  }
  return names;
}

/// "solve, certify and merge".
std::string in_a_row(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

int complain_about_subcommand(const CLI::App& program, const std::string& word) {
  const std::vector<std::string> names = subcommand_names(program);
  const std::string meant = did_you_mean(word, names);
  return complain("touchstone: " + io::with_short_words(word) + " is no subcommand" +
                  (meant.empty() ? "; they are " + in_a_row(names) : meant + " The others are in touchstone --help"));
}

/// An argument that the subcommand has no use for.
int complain_about_argument(const CLI::App& program, const std::string& word) {
  const auto given = program.get_subcommands();
  const CLI::App& app = given.empty() ? program : *given.front();
  const std::string command = given.empty() ? "touchstone" : "touchstone " + app.get_name();
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string option = word.substr(0, word.find('='));
  const bool is_option = option.starts_with("-");
  if (std::find(names.begin(), names.end(), option) != names.end()) {
    return complain("touchstone: " + option + " stands behind the command: " + command + " " + option);
  }
  return complain("touchstone: " + io::with_short_words(option) +
                  (is_option ? " is no option of " + command + did_you_mean(option, names)
                             : " is one argument too many for " + command) +
                  " (see " + command + " --help)");
}

int complain_about_usage(const CLI::App& program, const CLI::ParseError& error) {
  const auto given = program.get_subcommands();
  const std::string command = given.empty() ? "" : " " + given.front()->get_name();
  const std::string see = "see touchstone" + command + " --help", text = first_line(error.what());
  return complain("touchstone: " + text + (text.ends_with(see) ? "" : " (" + see + ")"));
}

int parse_and_run(int argc, const char* const* argv) {
  CLI::App program(
      "Touchstone: do two moving elements ever touch, and when first? Exact answers, and verdicts on claimed\n"
      "ones. An element is an edge, a face or a point whose corners move for t in [0, 1], on straight lines or\n"
      "on curves.",
      "touchstone");
  program.set_version_flag("--version", std::string("touchstone ") + version(), "Say the version, and end");
  bool wants_more = false;  // --version ends the parsing before this is set, so the option itself is asked
  const CLI::Option* const verbose =
      program.add_flag("--verbose", wants_more, "With --version: say how the program was built")->needs("--version");
  program.require_subcommand(1);
  program.footer(
      "touchstone help COMMAND says what touchstone COMMAND --help says.\n\n"
      "Examples\n"
      "  touchstone certify                                the queries bundled with the program\n"
      "  touchstone certify data/*/edge-edge/*.csv         are the truth columns of these files true?\n"
      "  touchstone certify --claims mine.csv edge-edge/a.csv --report report.json\n"
      "  touchstone solve --out answers.csv edge-edge/a.csv vertex-face/b.csv\n"
      "  touchstone explain --query 12 edge-edge/a.csv\n"
      "  touchstone view --query 12 --out page.html edge-edge/a.csv\n"
      "  touchstone prove --out proofs.txt edge-edge/a.csv a proof of each answer, for touchstone-check\n"
#ifndef TOUCHSTONE_QUERIES_ONLY
      "  touchstone generate --out queries                 query files like a simulation's\n"
      "  touchstone bench --filter simulation              the time of an answer\n"
      "  touchstone report --out report                    error against run time of every method\n"
      "  touchstone fuzz --solver paper                    the simplest queries on which a solver is wrong\n"
      "  touchstone fuzz-steps --solver-command ./theirs   the simplest steps of a mesh on which a program is wrong\n"
      "  touchstone stress --out stress                    where each method breaks as queries get stiff\n"
      "  touchstone simulate hoop --out hoop               a basketball through a net, each step proved\n"
      "  touchstone mesh --report report.json cloth-*.obj  is each step of an animation free of contact?\n"
      "  touchstone bodies box.obj wall.obj --poses p.csv  the same of rigid bodies that turn, from recorded poses\n"
      "  touchstone doctor                                 what is missing, and is arithmetic sound here?\n"
#endif
      "\n"
      "A query file has a row for each corner at t = 0 and then for each at t = 1, in the order\n"
      "  edge-edge    a0 a1 b0 b1      vertex-face  v f0 f1 f2      point-edge  p e0 e1      point-point  p q\n"
      "and seven integers a row: x_num,x_den,y_num,y_den,z_num,z_den,truth; all rows of a query, or none, have a "
      "truth.\n"
      "Or decimals: x,y,z a row, or all numbers of a query in one row, and truth or not.\n"
      "--kind, or else the name of its folder, is the kind of its queries. Lines that start with # and blank lines "
      "are\n"
      "skipped. Rows are counted as lines from 1, queries from 0.\n"
      "A file whose first row is touchstone-curved,1 holds queries of bodies that turn and corners on Bezier curves, "
      "with\n"
      "the rows query,truth; motion,index,q0,q1,p0,p1; body,index,x,y,z; curve,x,y,z,...: solve, certify and explain "
      "read\n"
      "it, and docs/program.md defines it.\n"
      "Binary query files and .npy arrays of shape (n, 2, corners, 3) are read as well, by what they start with;\n"
      "convert writes each format.\n\n"
      "Exit status: 0 done and every claim holds, 1 some claim is refuted, 2 bad usage or bad input.");
  Command command;
  add_solve(program, command);
  add_certify(program, command);
  add_explain(program, command);
  add_view(program, command);
  add_prove(program, command);
#ifndef TOUCHSTONE_QUERIES_ONLY  // a program for browsers, for example
  add_convert(program, command);
  add_generate(program, command);
  add_bench(program, command);
  add_report(program, command);
  add_fuzz(program, command);
  add_fuzz_steps(program, command);
  add_audit(program, command);
  add_stress(program, command);
  add_simulate(program, command);
  add_mesh(program, command);
  add_bodies(program, command);
  add_merge(program, command);
  add_scenes(program, command);
  add_doctor(program, command);
  add_describe(program, command);
#endif
  try {
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (!words.empty() && words.front() == "help") {  // "help mesh" is "mesh --help", and "help" is "--help"
      if (words.size() > 2) return complain("touchstone: help takes the name of one command");
      const auto all = program.get_subcommands([](const CLI::App*) { return true; });
      const auto is_asked = [&](const CLI::App* one) { return words.size() == 2 && one->get_name() == words.back(); };
      if (words.size() == 2 && std::none_of(all.begin(), all.end(), is_asked)) {
        return complain_about_subcommand(program, words.back());
      }
      words.erase(words.begin());
      words.emplace_back("--help");
    }
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    program.parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    print(program.help());
    return kAllHold;
  } catch (const CLI::CallForVersion& version_text) {
    print(verbose->count() == 0 ? std::string(version_text.what()) + "\n"
                                : build_facts() + text_of(build_components()));
    return kAllHold;
  } catch (const CLI::RequiredError& error) {
    const auto unknown = program.remaining();
    if (program.get_subcommands().empty() && !unknown.empty()) {
      return unknown.front().starts_with("-") ? complain_about_argument(program, unknown.front())
                                              : complain_about_subcommand(program, unknown.front());
    }
    return complain_about_usage(program, error);
  } catch (const CLI::ExtrasError& error) {
    const auto unknown = program.remaining(true);
    return unknown.empty() ? complain_about_usage(program, error) : complain_about_argument(program, unknown.front());
  } catch (const CLI::ParseError& error) {
    return complain_about_usage(program, error);
  }
  return command();
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  try {
    remember_command(argc, argv);
    return parse_and_run(argc, argv);
  } catch (const Interrupted&) {
    throw;
  } catch (const io::ReaderGone&) {
    throw_if_interrupted();
    throw;
  } catch (const FileError& error) {
    throw_if_interrupted();
    return complain(error.what());
  } catch (const std::bad_alloc&) {
    return complain("touchstone: out of memory");
  } catch (const std::exception& error) {
    // Ctrl-C on a terminal ends child processes too, such as a solver. The signal is then the reason for the error.
    throw_if_interrupted();
    // The standard library's errors repeat names of any length.
    constexpr std::size_t kLongest = 10'000;
    const std::string text = error.what();
    return complain(std::string("touchstone: ").append(text.size() > kLongest ? io::with_short_words(text) : text));
  }
}

}  // namespace touchstone::cli
