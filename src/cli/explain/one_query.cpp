// SPDX-License-Identifier: MIT
#include "cli/explain/one_query.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <touchstone/contact_normal.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "cli/explain/story.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/command_line/typed_command.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/times.hpp"
#include "solver/ladder.hpp"
#include "view/pages/query_page.hpp"
#include "view/pages/story_html.hpp"
#include "view/picture.hpp"
#include "view/still.hpp"

namespace touchstone::cli {
namespace {

template <class AQuery>
Explanation explained(const AQuery& query, const io::QueryRecord& record, const OneQuery& options) {
  constexpr bool kCurved = std::is_same_v<AQuery, CurvedQuery>;
  const Separation& separation = options.separation.separation;
  // solve comes first: it refuses the queries that exact::explain does not accept.
  static_cast<void>(solve(query, {.t_max = options.t_max, .separation = separation, .method = Method::exact}));
  const exact::Story story = separation.distance == 0 ? exact::explain(query, options.t_max)
                                                      : exact::explain(query, options.t_max, separation);
  std::optional<std::array<double, 3>> normal;
  if (separation.distance == 0 || separation.metric == Metric::euclidean) {
    normal = contact_normal(query, separation, options.t_max);
  }
  std::string corners;
  if constexpr (kCurved) {
    corners = curves_for_person(query);
  } else {
    corners = corners_for_person(record.query, io::query_as_given(record));
  }
  std::string text = story_for_person(query.kind, kCurved, story, options.t_max, separation, normal);
  if constexpr (std::is_same_v<AQuery, Query>) {
    if (separation.distance == 0) text += rung_for_person(solver::answer_and_rung(query, options.t_max).rung);
  }
  if constexpr (kCurved) text += times_for_person(contact_times(query, separation, options.t_max));
  return {corners, text, story};
}

}  // namespace

Explanation explanation_of(const io::QueryRecord& record, const OneQuery& options) {
  return std::visit([&](const auto& query) { return explained(query, record, options); }, record.query);
}

void QueryPictures::add_options(CLI::App& subcommand, const std::string& page_description) {
  subcommand.add_option(page_option, page, page_description)->type_name("PAGE.html")->check(named_as(Output::page));
  subcommand.add_option("--svg", svg, "Write a moving picture alone, which needs no script, for slides or a README")
      ->type_name("FILE.svg")
      ->check(named_as(Output::picture));
}

void QueryPictures::check(const OneQuery& query, bool standard_output_is_free) const {
  const std::vector<std::pair<std::string, std::string>> files = {{page_option, page}, {"--svg", svg}};
  for (const auto& [option, file] : files) {
    if (file == "-" && !standard_output_is_free) {
      throw Error(option + ": name a file to write, standard output has the story");
    }
    if (!file.empty()) refuse_to_overwrite(file, {query.file});
  }
  refuse_one_file_twice(files);
}

std::string QueryPictures::write(const Input& input, const io::QueryRecord& record, const Explanation& explanation,
                                 const OneQuery& query) const {
  const Separation& separation = query.separation.separation;
  const std::string title = heading(input, record);
  std::string lines;
  const auto write_file = [&](const std::string& path, const std::string& text) {
    auto out = path == "-" ? io::OutputFile::standard_output() : io::OutputFile(path);
    out.write(text);
    out.commit();
    if (path == "-") return;
    lines +=
        fmt::format("{} in {}, {} bytes: open it in a browser\n", title, io::printable(path), grouped(text.size()));
  };
  if (!page.empty()) {
    const view::QueryToShow shown{title,       typed_command(), explanation.corners, record.query, explanation.story,
                                  query.t_max, separation};
    write_file(page, view::page_text(view::query_page(shown)));
  }
  if (!svg.empty()) {
    const Answer& answer = explanation.story.answer;
    const Kind kind = std::visit([](const auto& any) { return any.kind; }, record.query);
    write_file(svg, view::moving_svg(view::picture_of(record.query, answer, query.t_max, separation),
                                     view::answer_sentence(kind, answer, query.t_max, separation),
                                     title + ". The elements are faint at both ends of the step."));
  }
  return lines;
}

void add_one_query_options(CLI::App& subcommand, OneQuery& options) {
  subcommand.add_option("FILE", options.file, "The query file")->required()->type_name("");
  subcommand.add_option("--query", options.query, "The number of the query in the file, counted from 0")
      ->required()
      ->type_name("N")
      ->check(check_query_number);
  add_kind_option(subcommand, options.kind);
  add_decimals_option(subcommand, options.decimals);
  add_shorter_turn_option(subcommand, options.turns);
  subcommand
      .add_option_function<std::string>(
          "--t-max", [&options](const std::string& text) { options.t_max = io::parse_finite_double(text).value_or(1); },
          "The end of the time range, in [0, 1], decimal or hexfloat (default: 1)")
      ->type_name("T")
      ->check([](const std::string& text) {
        const auto value = io::parse_finite_double(text);
        if (value && *value >= 0 && *value <= 1) return std::string();
        return text + (value ? " must be a number in [0, 1]" : fault_of_number(text));
      });
  add_separation_options(subcommand, options.separation, "The distance at which two elements are in contact");
}

}  // namespace touchstone::cli
