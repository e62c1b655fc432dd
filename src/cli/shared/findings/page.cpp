// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>
#include <variant>

#include <touchstone/error.hpp>

#include "cli/shared/command_line/typed_command.hpp"
#include "cli/shared/findings/findings_report.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/words.hpp"
#include "fuzz/judging/finding_text.hpp"
#include "io/output_file.hpp"
#include "view/pages/findings_page.hpp"

namespace touchstone::cli {

view::FindingToShow finding_to_show(const fuzz::Finding& finding, const FuzzCommandOptions& options,
                                    const WrittenQuery& written) {
  const fuzz::Example& example = finding.example;
  view::FindingToShow shown;
  shown.heading = fmt::format("{}{}, {}", name_of(finding.failure),
                              finding.count > 1 ? fmt::format(" {} times", grouped(finding.count)) : "",
                              name_of(finding.degeneracy.kind));
  shown.degeneracy = fuzz::degeneracy_text(finding.degeneracy);
  shown.claim = fuzz::claim_text(example.reply);
  shown.truth = fuzz::truth_text(example.truth);
  shown.detail = example.detail;
  shown.corners = fuzz::corners_text(example.query, "");
  if (example.t_max != 1) shown.corners += fmt::format("asked for t in [0, {}]\n", fuzz::decimal_text(example.t_max));
  if (example.separation.distance > 0) shown.corners += separation_for_person(example.separation) + "\n";
  shown.commands.push_back(case_command(options, finding));
  if (!written.file.empty()) {
    shown.commands.push_back(explain_command(finding, written));
  }
  shown.query = std::visit([](const auto& query) { return io::FileQuery(query); }, example.query);
  shown.answer = example.truth;
  shown.t_max = example.t_max;
  shown.separation = example.separation;
  return shown;
}

void write_findings_page(const std::string& file, const std::string& title, const std::string& summary,
                         const std::vector<view::FindingToShow>& findings) {
  io::OutputFile output(file);
  view::Page page = view::findings_page(title, summary, findings);
  page.command = typed_command();
  view::write_page(page, [&output](std::string_view bytes) { output.write(bytes); });
  output.commit();
}

void check_outputs(const std::string& out, const std::string& html) {
  if (html == "-") throw Error("--html: name a file to write, standard output has the findings");
  if (!html.empty()) io::OutputFile{html};
  if (out.empty()) return;
  NewFolders folders;
  folders.make(out);
  io::OutputFile((std::filesystem::path(out) / "findings.csv").string());
}

}  // namespace touchstone::cli
