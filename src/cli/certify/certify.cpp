// SPDX-License-Identifier: MIT
#include "cli/certify/certify.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include <touchstone/error.hpp>

#include "certify/tally.hpp"
#include "cli/certify/claims.hpp"
#include "cli/certify/json_report.hpp"
#include "cli/certify/summary.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/pipeline.hpp"
#include "cli/shared/query_progress.hpp"
#include "cli/shared/summary.hpp"
#include "cli/shared/words.hpp"
#include "io/output_file.hpp"
#include "io/query_parser.hpp"

namespace touchstone::cli {
namespace {

constexpr std::size_t kShownClaims = 5;

struct CertifyItem : QueryItem {
  std::vector<Claim> claims;  ///< of an answers file; fewer than the queries when that ends too soon
  certify::Tally tally;
  std::vector<certify::RefutedClaim> first_refuted;  ///< at most kShownClaims
  std::string refuted_json;                          ///< all of them, each after a separator; only for a report
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

void judge_queries(CertifyItem& item, const CertifyOptions& options, const std::vector<Input>& inputs) {
  if (item.chunk.file == nullptr) return;  // reading failed
  const bool from_file = !options.claims.empty();
  io::QueryParser parser(item.chunk);
  io::QueryRecord record;
  for (std::size_t i = 0; parser.next(record); ++i) {
    if (from_file && i == item.claims.size()) break;  // item.error says why
    const Claim claim = from_file ? item.claims[i] : Claim{record.truth, std::nullopt};
    const Answer answer = answer_to(record.query, options.method);
    const Verdict verdict = std::visit([&](const auto& query) { return judge(claim, query, answer); }, record.query);
    item.tally.add(claim, answer, verdict);
    if (verdict == Verdict::holds) continue;
    certify::RefutedClaim refuted{inputs[item.input].name,
                                  record.number,
                                  record.first_row,
                                  record.last_row,
                                  claim,
                                  verdict,
                                  answer,
                                  io::query_as_given(item.chunk.kind, record.text)};
    if (!options.report.empty()) item.refuted_json += kClaimSeparator + refuted_claim_json(refuted);
    if (item.first_refuted.size() < kShownClaims) item.first_refuted.push_back(std::move(refuted));
  }
}

std::string what_was_judged(const CertifyOptions& options, const std::vector<Input>& inputs) {
  std::string text = "claims of ";
  text += options.claims.empty() ? "the truth column" : options.claims;
  text += options.files.empty() ? ", the bundled queries" : ", " + counted(inputs.size(), "file");
  return text;
}

std::string summary(const CertifyOptions& options, const std::vector<Input>& inputs, const certify::Tally& tally,
                    const std::vector<certify::RefutedClaim>& first_refuted, double seconds, int threads) {
  const certify::VerdictCounts& verdicts = tally.verdicts;
  const std::uint64_t refuted = verdicts.refuted();
  std::string text = refuted == 0
                         ? fmt::format("all {} claims hold", grouped(verdicts.claims()))
                         : fmt::format("{} of {} claims refuted", grouped(refuted), grouped(verdicts.claims()));
  text += fmt::format(" ({})\n", what_was_judged(options, inputs));
  text += verdicts_for_person(verdicts);
  text += counts_for_person({verdicts.claims(), tally.levels, tally.natures});
  text += early_for_person(tally.early);
  text += speed_for_person(verdicts.claims(), seconds, threads);
  if (refuted == 0) return text;
  text += "\nrefuted:\n";
  for (const auto& claim : first_refuted) text += refuted_for_person(claim);
  if (refuted > first_refuted.size()) {
    text += fmt::format("  and {} more; {}\n", grouped(refuted - first_refuted.size()),
                        options.report.empty() ? "--report FILE lists them all" : options.report + " lists them all");
  }
  return text;
}

}  // namespace

int run_certify(const CertifyOptions& options) {
  if (options.files.empty() && options.kind) throw Error("--kind goes with files; the bundled queries know theirs");
  const std::vector<Input> inputs = options.files.empty() ? bundled_inputs() : find_inputs(options.files, options.kind);
  std::vector<std::string> read_files = options.files;
  if (!options.claims.empty()) read_files.push_back(options.claims);
  refuse_to_overwrite(options.report, read_files);

  std::optional<ClaimStream> claims;
  if (!options.claims.empty()) claims.emplace(options.claims, inputs, options.chunk_bytes);
  std::optional<GrowingReport> report;
  if (!options.report.empty()) report.emplace(options.report);

  certify::Tally tally;
  std::vector<certify::FileTally> files;
  for (const auto& input : inputs) files.push_back({input.name, input.kind, {}});
  std::vector<certify::RefutedClaim> first_refuted;
  const int threads = thread_count(options.threads);
  QueryStream stream(inputs, options.chunk_bytes);
  QueryProgress progress(inputs);
  run_in_order<CertifyItem>(
      threads,
      [&](CertifyItem& item) {
        const bool more = stream.next(item);
        if (claims && more) claims->read(item, item.claims);
        if (claims && !more) claims->finish();
        return more;
      },
      [&](CertifyItem& item) { judge_queries(item, options, inputs); },
      [&](CertifyItem& item) {
        tally.merge(item.tally);
        files[item.input].verdicts.merge(item.tally.verdicts);
        const std::size_t room = kShownClaims - first_refuted.size();
        const std::size_t shown = std::min(room, item.first_refuted.size());
        std::move(item.first_refuted.begin(), item.first_refuted.begin() + static_cast<std::ptrdiff_t>(shown),
                  std::back_inserter(first_refuted));
        if (report) report->add(item.refuted_json);
        progress.add(item.chunk.text().size(), item.tally.verdicts.claims());
      });
  const double seconds = progress.seconds();

  if (report) {
    const std::string source = options.claims.empty() ? "truth column" : options.claims;
    report->finish(report_begin({std::string(method_name(options.method)), source}, tally, files));
  }
  if (options.report != "-") {
    auto console = io::OutputFile::standard_output();
    console.write(summary(options, inputs, tally, first_refuted, seconds, threads));
    console.commit();
  }
  return tally.verdicts.refuted() == 0 ? kAllHold : kRefuted;
}

void add_certify(CLI::App& program, Command& command) {
  const auto options = std::make_shared<CertifyOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("certify", "Judge claimed answers exactly: each holds or is refuted");
  subcommand->add_option("FILE", options->files, "Query files (default: the queries bundled with the program)")
      ->type_name("");
  add_query_options(*subcommand, *options);
  subcommand
      ->add_option("--claims", options->claims,
                   "The claims to judge: CSV whose header names query and contact, and optionally file and toi, one "
                   "row a query in the order of the queries (default: the truth column of the query files)")
      ->type_name("FILE");
  subcommand
      ->add_option(
          "--report", options->report,
          "Write a JSON report that lists every refuted claim; - writes it to standard output instead of the summary")
      ->type_name("FILE");
  subcommand->footer(
      "A claim is missed (contact denied, but there is one), phantom (contact claimed, but there is none), late (its "
      "toi\n"
      "lies after the exact time: stepping there would pass through), or it holds.\n"
      "Exit status: 0 all claims hold, 1 some are refuted, 2 bad usage or bad input.\n\n"
      "The report is one JSON object: counts of verdicts (claims), of deciding levels (decided_by) and of the "
      "contacts'\n"
      "natures; how early the claims are that hold and have a toi (early: in ulps and in time, with histograms); the\n"
      "counts of each file (files); and every refuted claim (refuted) with its file, query, rows, verdict, claim, "
      "exact\n"
      "answer and corners as given. Times in it are hexfloats.");
  subcommand->callback([options, &command] { command = [options] { return run_certify(*options); }; });
}

}  // namespace touchstone::cli
