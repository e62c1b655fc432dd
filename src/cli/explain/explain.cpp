// SPDX-License-Identifier: MIT
#include "cli/explain/explain.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include <touchstone/certify.hpp>
#include <touchstone/contact_normal.hpp>
#include <touchstone/curved.hpp>

#include "cli/explain/story.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/interrupt.hpp"
#include "cli/shared/options.hpp"
#include "cli/shared/separation.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/query_parser.hpp"
#include "io/separation_text.hpp"
#include "io/times.hpp"

namespace touchstone::cli {
namespace {

struct ExplainOptions {
  std::string file;
  std::optional<Kind> kind;
  std::uint64_t query = 0;
  double t_max = 1;
  SeparationOption separation;
};

/// A query and the piece of the file that holds it. Only that piece is parsed.
struct FoundQuery {
  std::optional<Separation> truth_separation;  ///< what the file says that its truth column is about
  io::QueryChunk chunk;                        ///< record.text lies in here
  io::QueryRecord record;
};

std::unique_ptr<FoundQuery> find_query(const Input& input, std::uint64_t number) {
  io::QueryChunkReader reader(input.open(), input.kind, io::kChunkBytes, io::Motions::any);
  std::uint64_t count = 0;
  auto found = std::make_unique<FoundQuery>();
  while (auto chunk = reader.next()) {
    throw_if_interrupted();
    if (chunk->first_query == 0) found->truth_separation = io::separation_of_comments(chunk->text());
    count += chunk->query_count;
    if (number >= count && !chunk->truncated) continue;
    found->chunk = std::move(*chunk);
    io::QueryParser parser(found->chunk);
    while (parser.next(found->record)) {
      if (found->record.number == number) return found;
    }
  }
  io::fail(input.name, fmt::format("has no query {}; it has {}, counted from 0", number, counted(count, "query")));
}

std::string heading(const Input& input, const io::QueryRecord& record) {
  const char* const motion = std::holds_alternative<CurvedQuery>(record.query) ? ", curved motion" : "";
  return fmt::format("query {} of {} (rows {} to {}), {}{}\n\n", record.number, io::printable(input.name),
                     record.first_row, record.last_row, kind_name(input.kind), motion);
}

/// What stands between the heading and the line about the truth column.
struct Explanation {
  std::string text;
  Answer answer;
};

template <class StraightQuery>
Explanation explanation_of(const StraightQuery& query, const io::QueryRecord& record, const ExplainOptions& options) {
  const Separation& separation = options.separation.separation;
  // solve comes first: it refuses the queries that exact::explain does not accept.
  static_cast<void>(solve(query, separation, Method::exact, options.t_max));
  const exact::Story story = separation.distance == 0 ? exact::explain(query, options.t_max)
                                                      : exact::explain(query, options.t_max, separation);
  std::optional<std::array<double, 3>> normal;
  if (separation.distance == 0 || separation.metric == Metric::euclidean) {
    normal = contact_normal(query, separation, options.t_max);
  }
  return {corners_for_person(record.query, io::query_as_given(query.kind, record.text)) +
              story_for_person(query.kind, false, story, options.t_max, separation, normal),
          story.answer};
}

Explanation explanation_of(const CurvedQuery& query, const io::QueryRecord& record, const ExplainOptions& options) {
  refuse_separation_of_curved(options.file, record, options.separation.separation);
  static_cast<void>(solve(query, Method::exact, options.t_max));
  const exact::Story story = exact::explain(query, options.t_max);
  return {curves_for_person(query) +
              story_for_person(query.kind, true, story, options.t_max, {}, contact_normal(query, options.t_max)) +
              times_for_person(contact_times(query, options.t_max)),
          story.answer};
}

int run_explain(const ExplainOptions& options) {
  const Input input = find_inputs({options.file}, options.kind).front();
  const auto found = find_query(input, options.query);
  const auto& record = found->record;
  const Separation& separation = options.separation.separation;
  const Explanation explanation =
      std::visit([&](const auto& query) { return explanation_of(query, record, options); }, record.query);

  auto console = io::OutputFile::standard_output();
  console.write(heading(input, record));
  console.write(explanation.text);
  if (found->truth_separation && !io::same_question(*found->truth_separation, separation)) {
    console.write(
        fmt::format("the file's truth column is about {}\n", separation_for_person(*found->truth_separation)));
  } else if (options.t_max == 1) {
    console.write(fmt::format("the file's truth column says {}: {}\n", record.truth ? 1 : 0,
                              verdict_name(judge({record.truth, std::nullopt}, explanation.answer))));
  }
  console.commit();
  return kAllHold;
}

}  // namespace

void add_explain(CLI::App& program, Command& command) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App* const subcommand = program.add_subcommand("explain", "Tell how one query is decided");
  subcommand->add_option("FILE", options->file, "The query file")->required()->type_name("");
  subcommand->add_option("--query", options->query, "The number of the query in the file, counted from 0")
      ->required()
      ->type_name("N")
      ->check([](const std::string& text) {
        return check_whole_number(text).empty() ? std::string() : text + " must be a number counted from 0";
      });
  add_kind_option(*subcommand, options->kind);
  subcommand
      ->add_option_function<std::string>(
          "--t-max", [options](const std::string& text) { options->t_max = io::parse_finite_double(text).value_or(1); },
          "The end of the time range, in [0, 1], decimal or hexfloat (default: 1)")
      ->type_name("T")
      ->check([](const std::string& text) {
        const auto value = io::parse_finite_double(text);
        if (value && *value >= 0 && *value <= 1) return std::string();
        return text + (value ? " must be a number in [0, 1]" : fault_of_number(text));
      });
  add_separation_options(*subcommand, options->separation, "The distance at which two elements are in contact");
  subcommand->footer(
      "Shows the corners as given and as doubles, the coplanarity cubic's exact coefficients, each time at which "
      "contact\n"
      "may begin with the exact signs that decide it, and the answer. With --separation D it shows the polynomials of\n"
      "the distance instead of the cubic: each pair of features that may come within D has one.");
  subcommand->callback([options, &command] { command = [options] { return run_explain(*options); }; });
}

}  // namespace touchstone::cli
