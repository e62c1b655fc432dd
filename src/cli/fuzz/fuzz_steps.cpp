// SPDX-License-Identifier: MIT
#include "cli/fuzz/fuzz_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <vector>

#include <touchstone/error.hpp>

#include "cli/shared/new_folders.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/words.hpp"
#include "frames/frame.hpp"
#include "frames/write_obj.hpp"
#include "fuzz/steps/fuzz_steps.hpp"
#include "fuzz/steps/pipe_steps.hpp"
#include "io/counted.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::cli {
namespace {

constexpr double kUsualStepSeconds = 10;

StepSolver step_solver(const FuzzStepsOptions& options) {
  if (options.command.empty()) return fuzz::library_reply;
  fuzz::Limits limits;
  limits.answer = std::chrono::milliseconds(static_cast<std::int64_t>(std::ceil(1000 * options.limit)));
  limits.start = std::max(limits.start, limits.answer);
  limits.line = std::size_t{1} << 20;
  return fuzz::run_step_command(options.command, limits);
}

/// The files of a finding in the folder: the frames, and the line that the program gets.
std::vector<std::string> files_of_finding(const std::string& folder, const StepFuzzFinding& finding) {
  std::string question = finding.question;
  std::replace(question.begin(), question.end(), ' ', '-');
  const std::string name =
      (std::filesystem::path(folder) / fmt::format("{}-{}", question, name_of(finding.failure))).string();
  return {name + "-0.obj", name + "-1.obj", name + ".json"};
}

void write_steps(const std::string& folder, const std::vector<StepFuzzFinding>& findings) {
  NewFolders folders;
  folders.make(folder);
  std::vector<io::OutputFile> files;
  for (const StepFuzzFinding& finding : findings) {
    frames::Topology topology;
    topology.vertex_count = finding.mesh.vertex_count();
    topology.faces = finding.mesh.faces();
    topology.edges = finding.mesh.edges();
    topology.points = finding.mesh.points();
    const std::vector<std::string> names = files_of_finding(folder, finding);
    for (std::size_t end = 0; end < 2; ++end) {
      std::string text;
      frames::append_obj(text, topology, (end == 0 ? finding.x0 : finding.x1).data());
      files.emplace_back(names[end]).write(text);
    }
    files.emplace_back(names[2]).write(
        fuzz::step_line(finding.mesh, Positions(finding.x0, 3), Positions(finding.x1, 3)));
  }
  for (io::OutputFile& file : files) file.commit();
  folders.keep();
}

/// The command that shows a finding whose files were written.
std::string show_command(const std::string& folder, const StepFuzzFinding& finding) {
  const std::vector<std::string> names = files_of_finding(folder, finding);
  const MeshElements elements = finding.mesh.elements();
  std::string options;
  if (elements.separation.distance > 0) {
    options = fmt::format(" --separation {} --metric {}", numbers::decimal_text(elements.separation.distance),
                          name_of(elements.separation.metric));
  }
  const std::string note = elements.rules.groups.empty() ? "" : "   # of all pairs: frames have no groups";
  return fmt::format("  touchstone mesh{} --html step.html {} {}{}\n", options, shell_word(names[0]),
                     shell_word(names[1]), note);
}

/// The command that asks about the step before it was shrunk.
std::string repeat_command(const FuzzStepsOptions& options, const StepFuzzFinding& finding) {
  std::string text = "  touchstone fuzz-steps";
  if (!options.command.empty()) text += " --solver-command " + shell_word(options.command);
  if (!options.search.separations) text += " --no-separation";
  if (!options.search.groups) text += " --no-groups";
  if (options.search.may_end_in_contact) text += " --may-end-in-contact";
  if (!options.search.twice) text += " --once";
  if (options.search.early_fraction) text += fmt::format(" --early {}", *options.search.early_fraction);
  if (options.search.late_fraction > 0) text += fmt::format(" --late {}", options.search.late_fraction);
  return text + " --case " + shell_word(finding.case_name) + "\n";
}

}  // namespace

int run_fuzz_steps(const FuzzStepsOptions& options) {
  StepFuzzOptions search = options.search;
  search.threads = thread_count(search.threads);
  if (options.cases) search.cases = *options.cases;
  if (!options.cases && !search.seconds) search.seconds = kUsualStepSeconds;
  if (options.cases && search.seconds) throw Error("--cases and --seconds both end the search: give one of them");
  const auto new_solver = [&] { return step_solver(options); };
  new_solver();  // a program that cannot be started is told before the search
  fuzz::SceneOutcome<families::StepScene> outcome;
  {
    ProgressLine line;
    outcome = fuzz::search_steps(new_solver, search, options.a_case, [&](std::uint64_t steps) {
      line.draw([&] { return fmt::format("{} steps", grouped(steps)); });
      return !interrupted();
    });
  }
  if (outcome.scenes == 0 && !interrupted()) throw Error("no step was asked in this time: more --seconds, or --cases");
  std::vector<StepFuzzFinding> findings;
  for (const fuzz::StepFinding& finding : outcome.findings) findings.push_back(fuzz::finding_of(finding));
  if (!options.out.empty() && !findings.empty()) write_steps(options.out, findings);
  const std::string who = options.command.empty() ? "touchstone" : io::printable(options.command);
  std::string left_out;
  for (const std::string& what : fuzz::left_out_by(search)) left_out += "; " + what + " were left out";
  std::string summary =
      fmt::format("{}: {} asked, {} with a wrong reply{}{}\n", who, io::counted(outcome.scenes, "step"),
                  grouped(outcome.failures), left_out, outcome.stopped ? "; interrupted" : "");
  const std::size_t kinds = outcome.kinds_of_failure;
  summary +=
      kinds == 0 ? "nothing found\n" : fmt::format("{} of failure", kinds == 1 ? "1 kind" : grouped(kinds) + " kinds");
  if (kinds > findings.size()) summary += fmt::format("; {} shown (--findings 0 shows all)", findings.size());
  if (kinds > 0) summary += "\n";
  auto console = io::OutputFile::standard_output();
  console.write(in_colour(summary, VerdictLine::last, kinds == 0));
  for (const StepFuzzFinding& finding : findings) {
    console.write("\n" + to_string(finding) + repeat_command(options, finding));
    if (!options.out.empty()) console.write(show_command(options.out, finding));
  }
  console.commit();
  return kinds == 0 ? kAllHold : kRefuted;
}

}  // namespace touchstone::cli
