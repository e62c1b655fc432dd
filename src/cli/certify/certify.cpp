// SPDX-License-Identifier: MIT
#include "cli/certify/certify.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <variant>

#include <touchstone/error.hpp>

#include "certify/tally.hpp"
#include "cli/certify/json_report.hpp"
#include "cli/certify/verdict_summary.hpp"
#include "cli/shared/command_line/judging_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/query_progress.hpp"
#include "cli/shared/progress/summary.hpp"
#include "cli/shared/proofs/proof_file.hpp"
#include "cli/shared/words.hpp"
#include "io/answers/answer_writer.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/queries/query_parser.hpp"
#include "io/queries/separation_text.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::cli {
namespace {

constexpr std::size_t kShownClaims = 5;

struct CertifyItem : QueryItem {
  std::vector<StatedClaim> claims;  ///< of an answers file; fewer than the queries when that ends too soon
  Separation truth_separation;      ///< what the truth column is about
  certify::Tally tally;
  certify::NotCounted not_counted;
  Questions questions;
  std::uint64_t no_doubles = 0;
  std::vector<certify::RefutedClaim> first_refuted;  ///< at most kShownClaims
  std::string refuted_json;                          ///< all of them, each after a separator; only for a report
  std::string lines;                                 ///< of JSON, one a query; only for --json
  ProvedQueries proved;                              ///< only for --proofs
};

/// The report while it grows. Its beginning can be written only when all claims are judged, and memory may not hold
/// all refuted claims until then.
class GrowingReport {
 public:
  explicit GrowingReport(const std::string& path)
      : out_(path == "-" ? io::OutputFile::standard_output() : io::OutputFile(path)), refuted_(path) {}

  void add(std::string_view refuted_json) {
    const bool drop_separator = refuted_.empty() && !refuted_json.empty();
    refuted_.write(refuted_json.substr(drop_separator ? std::string_view(kClaimSeparator).size() : 0));
  }

  void finish(const std::string& beginning) {
    out_.write(beginning);
    refuted_.copy_to(out_);
    out_.write(kReportEnd);
    out_.commit();
  }

 private:
  io::OutputFile out_;
  io::SpoolFile refuted_;
};

Verdict verdict_on(const Claim& claim, const io::FileQuery& query, const Answer& answer, const Separation& separation) {
  return std::visit([&](const auto& given) { return judge(claim, given, answer, separation); }, query);
}

std::variant<RationalQuery, CurvedQuery> as_given(const io::QueryRecord& record) {
  if (const auto* const curved = std::get_if<CurvedQuery>(&record.query)) return *curved;
  return io::query_as_given(record);
}

/// The members of a line of JSON beside those of the exact answer. A time is the nearest double, and beside it is the
/// claim's text if that is no double.
std::string verdict_members(const Claim& claim, Verdict verdict, bool is_refuted) {
  const std::string toi = claim.toi ? io::number_text(*claim.toi, io::Numbers::decimals) : "null";
  const std::string& text = claim.toi_as_written;
  const bool is_double = text.empty() || numbers::is_exactly_a_double(text);
  const std::string written = is_double ? "" : ",\"claimed_as_written\":" + io::json_string(text);
  return fmt::format(",\"claimed_contact\":{},\"claimed_toi\":{}{},\"verdict\":\"{}\",\"refuted\":{}", claim.contact,
                     toi, written, name_of(verdict), is_refuted);
}

void judge_queries(CertifyItem& item, const CertifyOptions& options, const std::vector<Input>& inputs) {
  if (item.chunk.file == nullptr) return;  // reading failed
  const bool from_file = !options.claims.empty();
  const std::string file = io::json_string(inputs[item.input].name);
  io::QueryParser parser(item.chunk, options.turns);
  io::QueryRecord record;
  for (std::size_t i = 0; parser.next(record); ++i) {
    item.longer_turns.merge(record.longer_turns);
    item.no_doubles += record.no_doubles;
    if (from_file && i == item.claims.size()) break;  // item.error says why
    if (!from_file && !record.truth) {
      io::fail(*item.chunk.file, fmt::format("query {} has no claim; name a file of claims (--claims)", record.number));
    }
    const auto& [claim, separation] =
        from_file ? item.claims[i] : StatedClaim{{*record.truth, std::nullopt}, item.truth_separation};
    item.questions.add(separation);
    const Answer answer = answer_to(record.query, options.method, separation);
    const Verdict verdict = verdict_on(claim, record.query, answer, separation);
    item.tally.add(claim, answer, verdict);
    if (!options.proofs.empty()) {
      require_plain_rows(inputs[item.input], item.chunk, record);
      item.proved.add(inputs[item.input], record, answer, separation);
    }
    const bool is_refuted =
        verdict != Verdict::holds && counts(options.counting, claim, answer, verdict, item.not_counted);
    if (options.json) {
      io::append_answer_line(item.lines, file, record.number, answer,
                             separation.distance > 0 || options.separation.given ? &separation : nullptr,
                             verdict_members(claim, verdict, is_refuted));
    }
    if (!is_refuted) continue;
    certify::RefutedClaim refuted{
        inputs[item.input].name, record.number, record.first_row, record.last_row, claim, verdict, answer,
        as_given(record),        separation};
    if (!options.report.empty()) item.refuted_json += kClaimSeparator + refuted_claim_json(refuted);
    if (item.first_refuted.size() < kShownClaims) item.first_refuted.push_back(std::move(refuted));
  }
}

/// Reads what the truth columns are about: the option, or else what the file says, or else touching.
class TruthSeparation {
 public:
  explicit TruthSeparation(const SeparationOption& option) : option_(option) {}

  /// @param item  the items of the run in their order. @throws FileError when the file says another than the option
  Separation of(const QueryItem& item) {
    if (item.chunk.first_query != 0) return current_;
    const auto said = io::stated_separation(item.chunk);
    if (option_.given && said && !io::same_question(*said, option_.separation)) {
      io::fail(*item.chunk.file, fmt::format("its truth column is about {}; --separation and --metric ask for {}",
                                             separation_for_person(*said), separation_for_person(option_.separation)));
    }
    current_ = option_.given ? option_.separation : said.value_or(Separation());
    return current_;
  }

 private:
  const SeparationOption& option_;
  Separation current_;  ///< of the file that is being read
};

std::string what_was_judged(const CertifyOptions& options, const std::string& left_out,
                            const std::vector<Input>& inputs, const Questions& questions) {
  std::string text = "claims of ";
  text += options.claims.empty() ? "the truth column" : io::printable(options.claims);
  if (!left_out.empty()) text += " (" + left_out + ")";
  if (!options.files.empty()) {
    text += ", " + counted(inputs.size(), "file");
  } else {
    text += ", the bundled queries";
  }
  const auto separation = questions.only();
  if (!separation) return text + ", several separations";
  return separation->distance > 0 ? text + ", " + separation_for_person(*separation) : text;
}

std::string summary(const CertifyOptions& options, const std::string& left_out, const std::vector<Input>& inputs,
                    const Questions& questions, const certify::Tally& tally, const certify::NotCounted& not_counted,
                    std::uint64_t no_doubles, const std::vector<certify::RefutedClaim>& first_refuted, double seconds,
                    int threads) {
  const certify::VerdictCounts& verdicts = tally.verdicts;
  const std::uint64_t refuted = verdicts.refuted() - not_counted.claims();
  std::string text = verdicts.refuted() == 0
                         ? fmt::format("all {} claims hold", grouped(verdicts.claims()))
                         : fmt::format("{} of {} claims refuted", grouped(refuted), grouped(verdicts.claims()));
  if (not_counted.late > 0) {
    text +=
        fmt::format(", and {} late by at most {}", grouped(not_counted.late), time_limit_text(*options.counting.late));
  }
  if (not_counted.other > 0) {
    text += fmt::format(", and {} wrong in other ways than {}", grouped(not_counted.other),
                        names_text(options.counting.classes));
  }
  text += fmt::format(" ({})\n", what_was_judged(options, left_out, inputs, questions));
  text += verdicts_for_person(verdicts);
  text += counts_for_person({verdicts.claims(), tally.levels, tally.natures, no_doubles});
  text +=
      early_for_person(tally.early) + late_for_person(tally.late) + outside_for_person(tally.below_0, tally.above_1);
  if (options.histogram) text += histogram_for_person("early", tally.early) + histogram_for_person("late", tally.late);
  if (!options.proofs.empty()) {
    text += summary_line("proofs", fmt::format("{} in {}", grouped(verdicts.claims()), io::printable(options.proofs)));
  }
  text += speed_for_person(verdicts.claims(), seconds, threads);
  if (refuted == 0) return text;
  text += "\nrefuted:\n";
  for (const auto& claim : first_refuted) text += refuted_for_person(claim, options.turns, options.decimals);
  if (refuted > first_refuted.size()) {
    text += fmt::format(
        "  and {} more; {}\n", grouped(refuted - first_refuted.size()),
        options.report.empty() ? "--report FILE lists them all" : io::printable(options.report) + " lists them all");
  }
  return text;
}

}  // namespace

int run_certify(const CertifyOptions& options) {
  if (options.files.empty() && options.kind) throw Error("--kind goes with files; the bundled queries know theirs");
  if (options.claims.empty() && !options.columns.empty()) throw Error("--columns says what a file of --claims has");
  if (options.claims.empty() && options.missing != io::MissingClaim::refused) {
    throw Error("--missing says what a file of --claims leaves out");
  }
  if (options.files.empty() && options.claims.empty() && options.separation.given) {
    throw Error(
        "--separation goes with files or --claims; the truth column of each bundled file is about a separation of its "
        "own");
  }
  if (!options.proofs.empty() && options.turns == io::Turns::shorter) {
    throw Error(
        "--proofs goes without --shorter-turn: touchstone-check reads the queries as the file has them. convert "
        "--shorter-turn --claims solve writes a file with the shorter turns");
  }
  std::vector<std::string> read_files = options.files;
  if (!options.claims.empty()) read_files.push_back(options.claims);
  refuse_standard_input_twice(read_files);
  const std::vector<Input> inputs = options.files.empty() ? bundled_inputs(io::Motions::any)
                                                          : find_inputs(options.files, options.kind, options.decimals);
  refuse_to_overwrite(options.report, read_files);
  refuse_to_overwrite(options.proofs, read_files);
  refuse_one_file_twice(
      {{"--json", options.json ? "-" : ""}, {"--report", options.report}, {"--proofs", options.proofs}});

  const auto separations_of_file = options.proofs.empty() ? SeparationsOfFile::several : SeparationsOfFile::one;
  std::optional<ClaimStream> claims;
  if (!options.claims.empty()) {
    const io::ClaimColumns columns =
        options.columns.empty() ? io::ClaimColumns() : io::parse_claim_columns(options.columns);
    claims.emplace(options.claims, columns, options.decimals, inputs, options.separation, separations_of_file,
                   options.missing, options.chunk_bytes);
  }
  std::optional<io::OutputFile> lines;
  if (options.json) lines.emplace(io::OutputFile::standard_output());
  std::optional<GrowingReport> report;
  if (!options.report.empty()) report.emplace(options.report);
  std::optional<ProofFile> proofs;
  if (!options.proofs.empty()) proofs.emplace(options.proofs, inputs);

  certify::Tally tally;
  certify::NotCounted not_counted;
  std::uint64_t no_doubles = 0;
  std::vector<certify::FileTally> files;
  for (const auto& input : inputs) files.push_back({input.name, input.kind, {}});
  std::vector<certify::RefutedClaim> first_refuted;
  TruthSeparation truth_separation(options.separation);
  Questions questions;
  QueryStream stream(inputs, options.chunk_bytes, io::Motions::any);
  TurnNotes turns(inputs, options.turns);
  QueryProgress progress(inputs);
  const int threads = run_in_order<CertifyItem>(
      thread_count(options.threads),
      [&](CertifyItem& item) {
        const bool more = stream.next(item);
        if (claims && more) claims->read(item, item.claims);
        if (!claims && more) item.truth_separation = truth_separation.of(item);
        if (claims && !more) claims->finish();
        return more;
      },
      [&](CertifyItem& item) { judge_queries(item, options, inputs); },
      [&](CertifyItem& item) {
        tally.merge(item.tally);
        not_counted.merge(item.not_counted);
        no_doubles += item.no_doubles;
        questions.merge(item.questions);
        turns.add(item.input, item.longer_turns);
        files[item.input].verdicts.merge(item.tally.verdicts);
        const std::size_t room = kShownClaims - first_refuted.size();
        const std::size_t shown = std::min(room, item.first_refuted.size());
        std::move(item.first_refuted.begin(), item.first_refuted.begin() + static_cast<std::ptrdiff_t>(shown),
                  std::back_inserter(first_refuted));
        if (lines) lines->write(item.lines);
        if (report) report->add(item.refuted_json);
        if (proofs) {  // then all claims about a file have one separation
          const bool stated = !item.claims.empty();
          proofs->add(item.input, stated ? item.claims.front().separation : item.truth_separation, item.proved);
        }
        progress.add(item.chunk.size(), item.tally.verdicts.claims());
      });
  const double seconds = progress.seconds();

  const std::string left_out = claims ? claims->left_out() : "";
  if (report) {
    const std::string source = options.claims.empty() ? "truth column" : options.claims;
    report->finish(report_begin(
        {std::string(name_of(options.method)), source, left_out, questions.only(), options.counting, not_counted},
        tally, files));
  }
  if (proofs) proofs->finish();
  progress.wipe();
  turns.tell();
  const std::string text =
      summary(options, left_out, inputs, questions, tally, not_counted, no_doubles, first_refuted, seconds, threads);
  if (lines) {
    lines->commit();
    print_error(text);
  } else if (options.report != "-" && options.proofs != "-") {
    auto console = io::OutputFile::standard_output();
    console.write(in_colour(text, VerdictLine::first, tally.verdicts.refuted() == not_counted.claims()));
    console.commit();
  } else if (no_doubles > 0) {
    print_error("touchstone: " + decimals_for_person(no_doubles) + "\n");
  }
  return tally.verdicts.refuted() == not_counted.claims() ? kAllHold : kRefuted;
}

void add_certify(CLI::App& program, Command& command) {
  const auto options = std::make_shared<CertifyOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("certify", "Judge claimed answers exactly: each holds or is refuted");
  subcommand->add_option("FILE", options->files, "Query files (default: the queries bundled with the program)")
      ->type_name("");
  add_query_options(*subcommand, *options);
  add_separation_options(*subcommand, options->separation,
                         "The separation that the claims are about, for files that do not say it");
  subcommand
      ->add_option("--claims", options->claims,
                   "The claims to judge, one a query, in the order of the queries or with their numbers: CSV with the "
                   "columns contact and, perhaps, query, toi and file; or JSON, lines of JSON, .npy or .npz (default: "
                   "the truth column of the query files)")
      ->type_name("FILE");
  subcommand
      ->add_option("--columns", options->columns,
                   "What the columns of the claims are, in order, where they have other names or none: query, contact, "
                   "toi, file, separation, metric, or - for one that is not read")
      ->type_name("NAMES");
  subcommand
      ->add_option_function<std::string>(
          "--missing", [options](const std::string&) { options->missing = io::MissingClaim::no_contact; },
          "What a query is that has no claim, where claims have the numbers of their queries: no-contact, a claim that "
          "there is none. So a file may list hits alone (default: an error)")
      ->type_name("CLAIM")
      ->check(CLI::IsMember({"no-contact"}));
  add_time_limit(*subcommand, "--late",
                 "The greatest distance of a claimed toi after the exact time that does not count as refuted (default: "
                 "none)",
                 [options](const certify::TimeLimit& limit) { options->counting.late = limit; });
  add_class_option(
      *subcommand, {"missed", "phantom", "late"},
      "Wrong claims of these classes alone count as refuted, such as missed,late (default: all)",
      [options](const std::string& name) { options->counting.classes.push_back(*from_name<Verdict>(name)); });
  subcommand->add_flag("--histogram", options->histogram, "Show how early and how late the claims are");
  subcommand->add_flag(
      "--json", options->json,
      "Write a JSON object a line for each claim to standard output: its verdict and the exact answer, "
      "with decimals; the summary goes to standard error");
  subcommand
      ->add_option(
          "--report", options->report,
          "Write a JSON report that lists every refuted claim; - writes it to standard output instead of the summary")
      ->type_name("FILE")
      ->check(named_as(Output::json));
  subcommand
      ->add_option(
          "--proofs", options->proofs,
          "Write a proof of the exact answer to each judged query, as prove does, so that touchstone-check can "
          "check what the verdicts rest on; - writes them to standard output instead of the summary. The "
          "claims about a query file must then be about one separation")
      ->type_name("FILE")
      ->check(named_as(Output::text));
  subcommand->footer(
      "A claim is missed (contact denied, but there is one), phantom (contact claimed, but there is none), late (its "
      "toi\n"
      "lies after the exact time: stepping there would pass through), or it holds.\n"
      "An answers file may say what its claims are about in the columns separation and metric, as solve --separation\n"
      "writes them, and a query file what its truth column is about in a line '# separation 0x1p-3 euclidean' before "
      "its\n"
      "first row. --separation must agree with them. Claims are about touching when nothing says otherwise.\n"
      "Exit status: 0 no claim is refuted (with --late and --class: none that counts), 1 some are, 2 bad usage or bad\n"
      "input.\n\n"
      "The report is one JSON object: counts of verdicts (claims), of deciding levels (decided_by) and of the "
      "contacts'\n"
      "natures; how early the claims are that hold and have a toi, and how late the late ones (early, late: in ulps "
      "and "
      "in\n"
      "time, with histograms), but for those with a toi outside [0, 1] (outside); which wrong claims did not count\n"
      "(not_counted), with --late or --class; the\n"
      "counts of each file (files); and every refuted claim (refuted) with its file, query, rows, verdict, claim, "
      "exact\n"
      "answer and corners as given. Times in it are hexfloats.");
  subcommand->callback([options, &command] { command = [options] { return run_certify(*options); }; });
}

}  // namespace touchstone::cli
