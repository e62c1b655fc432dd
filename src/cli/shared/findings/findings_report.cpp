// SPDX-License-Identifier: MIT
#include "cli/shared/findings/findings_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <list>
#include <map>
#include <variant>

#include <touchstone/curved.hpp>

#include "cli/shared/command_line/judging_options.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/words.hpp"
#include "fuzz/judging/finding_text.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/queries/curved_rows.hpp"
#include "io/queries/query_writer.hpp"
#include "io/queries/separation_text.hpp"

namespace touchstone::cli {
namespace {

using fuzz::FailureClass;
using fuzz::FailureTable;
using fuzz::Finding;

std::uint64_t rate(std::uint64_t queries, double seconds) {
  return static_cast<std::uint64_t>(static_cast<double>(queries) / std::max(seconds, 1e-9));
}

}  // namespace

std::string progress_for_person(const fuzz::Progress& progress) {
  std::string text = fmt::format("{}, {} a second", counted(progress.queries, "query"),
                                 grouped(rate(progress.queries, progress.seconds)));
  for (const FailureClass failure : fuzz::kEveryFailure) {
    const std::uint64_t number = progress.failures[FailureTable::index(failure)];
    if (number > 0) text += fmt::format(", {} {}", grouped(number), name_of(failure));
  }
  if (progress.to_shrink > 0) text += fmt::format("; {} of {} shrunk", progress.shrunk, progress.to_shrink);
  return text;
}

std::string search_for_person(const FuzzCommandOptions& options, const fuzz::SearchOutcome& outcome, int threads) {
  const std::string solver = options.solver.command.empty() ? options.solver.solver : options.solver.command;
  const Separation& separation = options.separation.separation;
  std::string about = separation.distance > 0 ? ", " + separation_for_person(separation) : std::string();
  if (options.separation.each)
    about = fmt::format(", each with a separation of its own, {}", name_of(separation.metric));
  return fmt::format("{} judged by {}{}, seed {}: {} in {:.1f} s on {}, {} a second{}\n", io::printable(solver),
                     name_of(options.settings.judge), about, options.settings.seed, counted(outcome.queries, "query"),
                     outcome.seconds, counted(static_cast<std::uint64_t>(threads), "thread"),
                     grouped(rate(outcome.queries, outcome.seconds)), outcome.stopped ? "; interrupted" : "");
}

std::string given_for_person(const fuzz::SearchOutcome& outcome) {
  if (outcome.given_asked == outcome.given) return "";
  std::string text =
      fmt::format("asked {} of the {}", grouped(outcome.given_asked), counted(outcome.given, "given query"));
  if (outcome.given_not_taken > 0) {
    text += fmt::format("; {} of a kind that the solver does not take",
                        outcome.given_not_taken == 1 ? "1 is" : grouped(outcome.given_not_taken) + " are");
  }
  return text + '\n';
}

std::string allowed_for_person(const FuzzCommandOptions& options, const fuzz::SearchOutcome& outcome) {
  const fuzz::Allowance& allowance = options.settings.allowance;
  std::vector<std::string> texts;
  if (allowance.late) texts.push_back("late by at most " + time_limit_text(*allowance.late));
  if (allowance.near > 0) {
    texts.push_back(fmt::format("phantom within {} of the greatest coordinate", allowance.near));
  }
  if (!allowance.classes.empty()) texts.push_back("of other classes than " + names_text(allowance.classes));
  if (texts.empty()) return "";
  return fmt::format("; {} did not count: {}", counted(outcome.allowed, "wrong answer"), fmt::join(texts, ", or "));
}

std::string table_for_person(const FailureTable& table) {
  const FailureTable::Row total = table.total();
  if (total.failed() == 0) return "";
  constexpr std::string_view kRow = "  {:<17}{:>13}";
  constexpr std::string_view kCell = "{:>13}";
  std::string text = fmt::format(fmt::runtime(kRow), "family", "queries");
  const auto cells = [&](auto&& cell) {
    for (const FailureClass failure : fuzz::kEveryFailure) {
      const std::size_t i = FailureTable::index(failure);
      if (total.failures[i] > 0) text += fmt::format(fmt::runtime(kCell), cell(failure, i));
    }
    text += '\n';
  };
  cells([](FailureClass failure, std::size_t) { return std::string(name_of(failure)); });
  std::size_t well = 0;
  const auto line = [&](std::string_view name, const FailureTable::Row& row) {
    text += fmt::format(fmt::runtime(kRow), name, grouped(row.cases));
    cells([&](FailureClass, std::size_t i) { return grouped(row.failures[i]); });
  };
  for (const auto* families : {&families::all_families(), &families::curved_families()}) {
    for (const families::FamilyInfo& family : *families) {
      const FailureTable::Row& row = table.of(family.family);
      if (row.failed() > 0) line(family.name, row);
      if (row.failed() == 0 && row.cases > 0) ++well;
    }
  }
  if (table.given().failed() > 0) line("given", table.given());
  line("all", total);
  if (well > 0)
    text += fmt::format("  ({} without a failure)\n", well == 1 ? "1 family" : fmt::format("{} families", well));
  return text;
}

std::string case_command(const FuzzCommandOptions& options, const Finding& finding) {
  if (!options.repeat.empty()) {
    const bool curved = fuzz::is_curved(finding.example.query);
    return options.repeat + " --from " +
           shell_word(findings_file(options.out, finding.degeneracy.kind, finding.failure, curved));
  }
  std::string command = "touchstone fuzz " + solver_options(options.solver);
  command += options.separation.each ? each_separation_arguments(options.separation.separation.metric)
                                     : separation_arguments(options.separation.separation);
  if (options.settings.judge != Method::exact) command += fmt::format(" --judge {}", name_of(options.settings.judge));
  const fuzz::Allowance& allowance = options.settings.allowance;
  if (allowance.early.ulps || allowance.early.fraction) command += " --early " + time_limit_text(allowance.early);
  if (allowance.late) command += " --late " + time_limit_text(*allowance.late);
  if (allowance.near > 0) command += fmt::format(" --near {}", allowance.near);
  for (const std::string& file : options.from) command += " --from " + shell_word(file);
  return command + " --case " + shell_word(fuzz::case_text(finding.example.name));
}

std::string finding_for_person(std::size_t number, const Finding& finding, const FuzzCommandOptions& options,
                               const WrittenQuery& written) {
  const fuzz::Example& example = finding.example;
  std::string text = fmt::format("\n{}. {}{}, {}: {}\n", number, name_of(finding.failure),
                                 finding.count > 1 ? fmt::format(" {} times", grouped(finding.count)) : "",
                                 name_of(finding.degeneracy.kind), fuzz::degeneracy_text(finding.degeneracy));
  text += fuzz::corners_text(example.query, "     ");
  if (example.t_max != 1) text += fmt::format("   asked for t in [0, {}]\n", fuzz::decimal_text(example.t_max));
  if (options.separation.each) text += fmt::format("   {}\n", separation_for_person(example.separation));
  text += fmt::format("   claim: {}\n", fuzz::claim_text(example.reply));
  text += fmt::format("   exact: {}\n", fuzz::truth_text(example.truth));
  if (!example.detail.empty()) text += fmt::format("   {}\n", io::printable(example.detail));
  text += fmt::format("   {}\n", case_command(options, finding));
  if (!written.file.empty()) {
    text += fmt::format("   {}\n", explain_command(finding, written));
  }
  return text;
}

std::string explain_command(const Finding& finding, const WrittenQuery& written) {
  const fuzz::Example& example = finding.example;
  return explain_command(written.file, finding.degeneracy.kind, written.query, example.separation, example.t_max);
}

std::string findings_file(const std::string& out, Kind kind, FailureClass failure, bool curved) {
  const auto folder = std::filesystem::path(out) / name_of(kind);
  return (folder / fmt::format("{}{}.csv", curved ? "curved_" : "", name_of(failure))).string();
}

namespace {

/// Whether there is a contact in the whole step, which is what a query file's truth column is about.
bool contact_in_step(const fuzz::Example& example, Method judge) {
  if (example.t_max == 1 || example.truth.contact) return example.truth.contact;
  return solve(std::get<CurvedQuery>(example.query), {.separation = example.separation, .method = judge}).contact;
}

/// The lines before the first query of a file that starts with this one.
std::string head_of_file(const fuzz::Example& example) {
  std::string text;
  if (example.separation.distance > 0) text += io::separation_comment(example.separation);
  if (fuzz::is_curved(example.query)) text.append(io::kCurvedHeader).append("\n");
  return text;
}

}  // namespace

std::vector<WrittenQuery> write_findings(const std::vector<Finding>& findings, const FuzzCommandOptions& options) {
  struct Target {
    io::OutputFile file;
    std::uint64_t queries = 0;
  };
  NewFolders folders;
  std::map<std::string, Target> targets;
  std::vector<WrittenQuery> written;
  for (const Finding& finding : findings) {
    const fuzz::Example& example = finding.example;
    const bool curved = fuzz::is_curved(example.query);
    std::string path = findings_file(options.out, finding.degeneracy.kind, finding.failure, curved);
    // A file is about one separation.
    if (options.separation.each) path.insert(path.size() - 4, fmt::format("-{}", written.size() + 1));
    auto target = targets.find(path);
    if (target == targets.end()) {
      folders.make(std::filesystem::path(path).parent_path());
      target = targets.emplace(path, Target{io::OutputFile(path)}).first;
      target->second.file.write(head_of_file(example));
    }
    const std::string range =
        example.t_max == 1 ? "" : fmt::format(", asked for t in [0, {}]", fuzz::decimal_text(example.t_max));
    std::string text =
        fmt::format("# query {}: {}, {}{}\n# {}\n", target->second.queries, name_of(finding.failure),
                    fuzz::degeneracy_text(finding.degeneracy), range, io::printable(case_command(options, finding)));
    const bool truth = contact_in_step(example, options.settings.judge);
    std::visit([&](const auto& query) { io::append_query(text, query, truth); }, example.query);
    target->second.file.write(text);
    written.push_back({path, target->second.queries++});
  }
  for (auto& [path, target] : targets) target.file.commit();
  folders.keep();
  return written;
}

}  // namespace touchstone::cli
