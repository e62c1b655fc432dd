// SPDX-License-Identifier: MIT
#include "cli/explain/explain.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include <touchstone/certify.hpp>
#include <touchstone/error.hpp>

#include "cli/explain/one_query.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/queries/separation_text.hpp"

namespace touchstone::cli {
namespace {

struct ExplainOptions {
  OneQuery query;
  QueryPictures pictures{.page_option = "--html"};
};

int run_explain(const ExplainOptions& options) {
  const Input input = find_inputs({options.query.file}, options.query.kind, options.query.decimals).front();
  options.pictures.check(options.query, false);
  const auto found = find_query(input, options.query.query, options.query.turns);
  const auto& record = found->record;
  const Separation& separation = options.query.separation.separation;
  const Explanation explanation = explanation_of(record, options.query);

  auto console = io::OutputFile::standard_output();
  console.write(heading(input, record) + "\n\n");
  console.write(explanation.corners);
  console.write(explanation.text);
  if (found->truth_separation && !io::same_question(*found->truth_separation, separation)) {
    console.write(
        fmt::format("the file's truth column is about {}\n", separation_for_person(*found->truth_separation)));
  } else if (record.truth && options.query.t_max == 1) {
    console.write(fmt::format("the file's truth column says {}: {}\n", *record.truth ? 1 : 0,
                              name_of(judge({*record.truth, std::nullopt}, explanation.story.answer))));
  }
  options.pictures.write(input, record, explanation, options.query);
  console.commit();
  return kAllHold;
}

struct ViewOptions {
  OneQuery query;
  QueryPictures pictures{.page_option = "--out"};
};

int run_view(const ViewOptions& options) {
  const QueryPictures& pictures = options.pictures;
  if (pictures.page.empty() && pictures.svg.empty()) throw Error("name the page with --out, or a picture with --svg");
  const Input input = find_inputs({options.query.file}, options.query.kind, options.query.decimals).front();
  pictures.check(options.query, true);
  const auto found = find_query(input, options.query.query, options.query.turns);
  const Explanation explanation = explanation_of(found->record, options.query);
  const std::string lines = pictures.write(input, found->record, explanation, options.query);
  if (lines.empty() || pictures.page == "-" || pictures.svg == "-") return kAllHold;
  auto console = io::OutputFile::standard_output();
  console.write(lines);
  console.commit();
  return kAllHold;
}

}  // namespace

void add_explain(CLI::App& program, Command& command) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App* const subcommand = program.add_subcommand("explain", "Tell how one query is decided");
  add_one_query_options(*subcommand, options->query);
  options->pictures.add_options(*subcommand, "Also write a page with a picture of the query, as view does");
  subcommand->footer(
      "Shows the corners as given and as doubles, the coplanarity cubic's exact coefficients, each time at which "
      "contact\n"
      "may begin with the exact signs that decide it, and the answer. With --separation D it shows the polynomials of\n"
      "the distance instead of the cubic: each pair of features that may come within D has one.");
  subcommand->callback([options, &command] { command = [options] { return run_explain(*options); }; });
}

void add_view(CLI::App& program, Command& command) {
  const auto options = std::make_shared<ViewOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("view", "Write a page with a moving picture of one query, or the picture alone");
  add_one_query_options(*subcommand, options->query);
  options->pictures.add_options(*subcommand, "The page to write (-: standard output)");
  subcommand->footer(
      "The page is one HTML file that needs no network. It shows the two elements, their paths, a slider of time with\n"
      "the roots of V and the contact, the separating plane of the proof, and what explain tells. Its zoom goes down "
      "to\n"
      "the contact: positions relative to the contact are computed exactly before they are rounded for the picture.");
  subcommand->callback([options, &command] { command = [options] { return run_view(*options); }; });
}

}  // namespace touchstone::cli
