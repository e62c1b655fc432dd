// SPDX-License-Identifier: MIT
#include "cli/report/report.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include <touchstone/error.hpp>

#include "cli/report/page.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/queries/kind_of_file.hpp"
#include "report/report.hpp"

namespace touchstone::cli {
namespace {

struct ReportOptions {
  report::Size size;
  std::string out;
  std::string html;  ///< the page to write; empty: none
  std::vector<std::string> files;
  std::optional<Kind> kind;
  SeparationOption separation;
};

/// The queries of files, one set a kind. The sets are thinned evenly, so that memory does not grow with the files.
struct GivenQueries {
  std::vector<report::QuerySet> sets;
  std::uint64_t not_doubles = 0;
};

template <class AnyQuery>
class Thinned {
 public:
  explicit Thinned(std::size_t most) : most_(most) {}

  void add(const AnyQuery& query) {
    if (seen_++ % stride_ != 0) return;
    queries_.push_back(query);
    if (queries_.size() <= most_) return;
    for (std::size_t i = 0; 2 * i < queries_.size(); ++i) queries_[i] = queries_[2 * i];
    queries_.resize((queries_.size() + 1) / 2);
    stride_ *= 2;
  }

  std::uint64_t seen() const noexcept { return seen_; }
  std::uint64_t stride() const noexcept { return stride_; }
  std::vector<AnyQuery> take() { return std::move(queries_); }

 private:
  std::size_t most_;
  std::uint64_t seen_ = 0;
  std::uint64_t stride_ = 1;
  std::vector<AnyQuery> queries_;
};

/// The queries of one sort, by kind.
template <class AnyQuery>
class ThinnedKinds {
 public:
  explicit ThinnedKinds(std::size_t most)
      : by_kind_{Thinned<AnyQuery>(most), Thinned<AnyQuery>(most), Thinned<AnyQuery>(most), Thinned<AnyQuery>(most)} {}

  void add(const AnyQuery& query) { by_kind_[static_cast<std::size_t>(query.kind)].add(query); }

  /// @param queries_of  the member of a set that the queries go to
  void append_sets(const std::string& source, const std::string& about,
                   std::vector<AnyQuery> report::QuerySet::*queries_of, std::vector<report::QuerySet>& sets) {
    for (const Kind kind : kKinds) {
      Thinned<AnyQuery>& queries = by_kind_[static_cast<std::size_t>(kind)];
      if (queries.seen() == 0) continue;
      report::QuerySet set;
      set.name = source + "/" + std::string(name_of(kind));
      set.about = about;
      if (queries.stride() > 1) {
        set.about += fmt::format("; one in {} of their {}", queries.stride(), counted(queries.seen(), "query"));
      }
      set.kind = kind;
      set.*queries_of = queries.take();
      sets.push_back(std::move(set));
    }
  }

 private:
  std::array<Thinned<AnyQuery>, 4> by_kind_;
};

GivenQueries read_queries(const std::string& source, const std::string& about, const std::vector<Input>& inputs,
                          std::size_t most) {
  GivenQueries given;
  ThinnedKinds<Query> straight(most);
  ThinnedKinds<CurvedQuery> curved(most);
  TurnNotes turns(inputs, io::Turns::as_given, kConvertForShorterTurns);
  const auto take = [&](std::size_t input, const io::QueryRecord& record) {
    turns.add(input, record.longer_turns);
    if (const auto* const query = std::get_if<Query>(&record.query)) {
      straight.add(*query);
    } else if (const auto* const of_curves = std::get_if<CurvedQuery>(&record.query)) {
      curved.add(*of_curves);
    } else {
      ++given.not_doubles;
    }
  };
  for_each_query(inputs, take, io::Motions::any);
  turns.tell();
  straight.append_sets(source, about, &report::QuerySet::queries, given.sets);
  curved.append_sets(source + "-curved", about + ", those of curved motion", &report::QuerySet::curved, given.sets);
  return given;
}

int run_report(const ReportOptions& options) {
  if (options.html == "-") throw Error("--html: name a file to write, standard output has the report's name");
  const std::filesystem::path root = options.out;
  for (const char* const name : {"report.md", "report.csv", "simulation.csv"}) {
    refuse_one_file_twice({{"--html", options.html}, {"--out", (root / name).string()}});
  }
  NewFolders folders;
  folders.make(root / "plots");
  // A folder that cannot be written to is found before minutes are spent, not after.
  io::OutputFile((root / "report.md").string());
  std::optional<io::OutputFile> page;
  if (!options.html.empty()) {
    refuse_to_overwrite(options.html, options.files);
    page.emplace(options.html);
  }

  ProgressLine line;
  const auto progress = draw_fraction_on(line);
  const std::size_t most = report::most_given(options.size);
  std::vector<report::QuerySet> sets;
  std::vector<std::string> remarks;
  const auto append = [&](const std::string& source, const std::string& about, const std::vector<Input>& inputs) {
    GivenQueries given = read_queries(source, about, inputs, most);
    std::move(given.sets.begin(), given.sets.end(), std::back_inserter(sets));
    if (given.not_doubles == 0) return;
    remarks.push_back(
        fmt::format("Of the {} queries, {} not in the sets: their coordinates are fractions that doubles "
                    "do not hold, which only `touchstone` takes.",
                    source, given.not_doubles == 1 ? "1 is" : grouped(given.not_doubles) + " are"));
  };
  append("bundled", "The hand-made, mostly degenerate queries that are bundled with the program",
         bundled_touching_inputs(io::Motions::any));
  append("files", counted(options.files.size(), "file") + " named on the command line",
         find_inputs(options.files, options.kind));

  report::Size size = options.size;
  size.separation = options.separation.separation;
  report::Report made = report::make_report(size, std::move(sets), progress);
  made.remarks = std::move(remarks);
  report::write_report(made, options.out);
  folders.keep();
  std::string pages;
  if (page) {
    const std::string text = report_page(made);
    page->write(text);
    page->commit();
    pages = fmt::format("{}, {} bytes: open it in a browser\n", io::printable(options.html), grouped(text.size()));
  }

  auto console = io::OutputFile::standard_output();
  console.write((root / "report.md").string() + "\n" + pages);
  console.commit();
  return kAllHold;
}

}  // namespace

void add_report(CLI::App& program, Command& command) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("report", "Compare error and run time of every method: tables and pictures");
  subcommand->add_option("FILE", options->files, "Query files to ask as well, as the sets files/KIND")->type_name("");
  add_kind_option(*subcommand, options->kind);
  subcommand->add_option("--out", options->out, "The folder for the report; it is made when it is missing")
      ->required()
      ->type_name("FOLDER");
  subcommand
      ->add_option("--html", options->html,
                   "Write a page with the error against the run time, and tables that sort. It is one file")
      ->type_name("PAGE.html")
      ->check(named_as(Output::page));
  subcommand->add_flag("--quick", options->size.quick, "A few queries of each set: half a minute, and rough numbers");
  add_seed_option(*subcommand, options->size.seed);
  add_separation_options(*subcommand, options->separation,
                         "The distance at which two elements are in contact. The methods beside the solver's are then "
                         "additive advancement and the degree-6 polynomial in doubles, in the Euclidean metric");
  subcommand->footer(
      "Asks every method simulation-like candidates, the bundled queries, the given files, candidates of scenes along\n"
      "the axes and of the same turned, random and nearly touching elements: the paper's closed form, a careful one,\n"
      "Newton, inclusion, conservative advancement (at several tolerances where they have one), exact arithmetic "
      "alone,\n"
      "touchstone paired with CGAL, and touchstone. Of curved motion it asks pairs of the scenes link-chain and nut-\n"
      "and-bolt, the bundled and given queries, and the families of touchstone fuzz --curved; the methods of others "
      "are\n"
      "then Redon's intervals and conservative advancement. Of whole bodies that turn it asks steps; the methods of\n"
      "others are then waypoints, as in motion planners, and conservative advancement. Exact arithmetic judges. "
      "Writes\n"
      "  FOLDER/report.md    tables: errors, mean run time, percentiles, levels, scales, and the methods on the front\n"
      "  FOLDER/report.csv   every number, with version, machine and compiler\n"
      "  FOLDER/simulation.csv  how fast scenes are simulated, and in how much memory\n"
      "  FOLDER/plots/       pictures, NAME.svg\n"
      "in six minutes or more.\n\n"
      "Examples\n"
      "  touchstone report --out report\n"
      "  touchstone report --quick --out report --html report.html\n"
      "  touchstone report --quick --out report data/*/edge-edge/*.csv\n\n"
      "Exit status: 0 done, 2 bad usage, bad input or a file that cannot be written.");
  subcommand->callback([options, &command] { command = [options] { return run_report(*options); }; });
}

}  // namespace touchstone::cli
