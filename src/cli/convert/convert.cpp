// SPDX-License-Identifier: MIT
#include "cli/convert/convert.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "cli/convert/hdf5_files.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/query_progress.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::cli {
namespace {

using Claims = ConvertOptions::Claims;

struct ConvertItem : QueryItem {
  std::optional<io::EncodedQueries> encoded;
  std::uint64_t queries = 0;
};

io::QueryFormat format_to_write(const ConvertOptions& options) {
  if (options.format) return *options.format;
  if (const auto format = io::format_of_name(options.to)) return *format;
  throw Error(fmt::format("{}: in which format? Its name ends in none of .csv, .tsq, .npy, .h5 and .hdf5; --to says it",
                          options.to == "-" ? "standard output" : io::printable(options.to)));
}

/// Whether the first query has a claim. Where claims are kept, the others must then have one, or none.
bool has_claims(const QueryItem& first) {
  if (first.chunk.array != nullptr) return first.chunk.array->has_claims();
  io::QueryRecord record;
  return io::QueryParser(first.chunk).next(record) && record.truth.has_value();
}

io::WrittenFile file_to_write(const ConvertOptions& options, const QueryItem& first) {
  io::WrittenFile file;
  file.format = format_to_write(options);
  file.kind = first.chunk.kind;
  file.with_claims = options.claims == Claims::solve || (options.claims == Claims::keep && has_claims(first));
  if (file.with_claims) file.separation = io::stated_separation(first.chunk);
  file.signed_zeros = !options.unsigned_zeros;
  if (const std::string fault = io::fault_of_written_file(file); !fault.empty()) io::fail(options.to, fault);
  return file;
}

/// The queries of a file of any format.
class Source {
 public:
  Source(const std::vector<Input>& inputs, const ConvertOptions& options)
      : stream_(inputs, options.chunk_bytes, io::Motions::any) {
    const bool hdf5 = is_hdf5(inputs.front());
    if (hdf5) hdf5_.emplace(inputs.front(), options.group, options.chunk_bytes);
    if (!hdf5 && !options.group.empty()) io::fail(options.from, "is no HDF5 file, and has no groups (--group)");
  }
  bool next(QueryItem& item) { return hdf5_ ? hdf5_->next(item) : stream_.next(item); }

 private:
  QueryStream stream_;
  std::optional<Hdf5Stream> hdf5_;
};

void encode_queries(ConvertItem& item, const ConvertOptions& options, const io::WrittenFile& file) {
  if (item.chunk.file == nullptr) return;  // reading failed
  item.encoded.emplace(file);
  io::QueryParser parser(item.chunk, options.turns);
  io::QueryRecord record;
  while (parser.next(record)) {
    item.longer_turns.merge(record.longer_turns);
    std::optional<bool> claim = record.truth;
    if (options.claims == Claims::solve) {
      claim = answer_to(record.query, Method::fast, file.separation.value_or(Separation())).contact;
    } else if (options.claims == Claims::keep && claim.has_value() != file.with_claims) {
      io::fail(*item.chunk.file, record.first_row,
               fmt::format("query {} has {} claim, and the first query has {}", record.number, claim ? "a" : "no",
                           claim ? "none" : "one"));
    }
    item.encoded->add(*item.chunk.file, record, claim);
    ++item.queries;
  }
}

}  // namespace

int run_convert(const ConvertOptions& options) {
  const std::vector<Input> inputs = find_inputs({options.from}, options.kind, options.decimals);
  refuse_to_overwrite(options.to, {options.from});
  if (options.turns == io::Turns::shorter && options.claims == Claims::keep) {
    throw Error("--shorter-turn goes with --claims solve: with another turn the claims of IN may be wrong");
  }
  Source stream(inputs, options);
  QueryItem first;
  stream.next(first);  // an input without a query is an error
  const io::WrittenFile file = file_to_write(options, first);
  bool first_is_used = false;

  io::QueryFileWriter out(options.to, file);
  std::uint64_t queries = 0;
  TurnNotes turns(inputs, options.turns);
  QueryProgress progress(inputs);
  run_in_order<ConvertItem>(
      thread_count(options.threads),
      [&](ConvertItem& item) {
        if (std::exchange(first_is_used, true)) return stream.next(item);
        static_cast<QueryItem&>(item) = std::move(first);
        return true;
      },
      [&](ConvertItem& item) { encode_queries(item, options, file); },
      [&](ConvertItem& item) {
        if (item.error) return;  // it is thrown now, and nothing is written
        out.write(*item.encoded);
        queries += item.queries;
        turns.add(item.input, item.longer_turns);
        progress.add(item.chunk.size(), item.queries);
      });
  out.commit();
  progress.wipe();
  turns.tell();
  if (options.to == "-") return kAllHold;

  auto console = io::OutputFile::standard_output();
  console.write(fmt::format("{} of {} written to {} ({}, {}, {} claims)\n", counted(queries, "query"),
                            io::printable(inputs.front().name), io::printable(options.to), format_name(file.format),
                            name_of(file.kind), file.with_claims ? "with" : "without"));
  console.commit();
  return kAllHold;
}

void add_convert(CLI::App& program, Command& command) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* const subcommand = program.add_subcommand(
      "convert", "Write a query file in another format, exactly: CSV, binary, NumPy's .npy or HDF5");
  subcommand->add_option("IN", options->from, "The query file to read; its content tells its format")
      ->required()
      ->type_name("");
  subcommand->add_option("OUT", options->to, "The file to write; - is standard output")
      ->required()
      ->type_name("")
      ->check(not_empty);
  add_kind_option(*subcommand, options->kind);
  add_decimals_option(*subcommand, options->decimals);
  subcommand
      ->add_option_function<std::string>(
          "--to",
          [options = options.get()](const std::string& name) {
            for (const auto format : io::kQueryFormats) {
              if (name == io::format_name(format)) options->format = format;
            }
          },
          "The format of OUT. csv: fractions. hexfloat: CSV with hexfloats, the format of curved motion. binary: a "
          "header and columns of doubles. npy: NumPy's array of shape (n, 2, corners, 3). hdf5: the data sets "
          "rounded/points and rounded/result (default: as the name of OUT ends: .csv, .tsq for binary, .npy, .h5, "
          ".hdf5)")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"csv", "hexfloat", "binary", "npy", "hdf5"}));
  subcommand
      ->add_option_function<std::string>(
          "--claims",
          [options = options.get()](const std::string& name) {
            options->claims = name == "drop" ? Claims::drop : name == "solve" ? Claims::solve : Claims::keep;
          },
          "The claims of OUT. keep: those of IN (default). drop: none. solve: the exact answers, to the separation "
          "that IN states or else to touching")
      ->type_name("CLAIMS")
      ->check(CLI::IsMember({"keep", "drop", "solve"}));
  add_shorter_turn_option(*subcommand, options->turns);
  subcommand->add_flag("--unsigned-zeros", options->unsigned_zeros,
                       "Write -0 as 0 to csv, whose fractions have no sign of zero. Without it, csv refuses -0");
  subcommand
      ->add_option("--group", options->group,
                   "The group of an HDF5 file IN whose data sets points and result are read (default: rounded, or else "
                   "the root)")
      ->type_name("GROUP");
  add_threads_option(*subcommand, options->threads);
  subcommand->footer(
      "Every number in OUT equals that in IN, bit for bit. What the format of OUT does not hold is refused, with its "
      "row\n"
      "and column: fractions that are no doubles in all but csv, curved motion in all but hexfloat, claims in npy.\n"
      "Comments are not kept, but for the separation that the claims are about, which npy and hdf5 do not hold.\n"
      "HDF5 is as the public benchmark packs it: GROUP/points has a row x, y, z for each corner at t = 0 and then for\n"
      "each at t = 1, and GROUP/result a byte, 0 or 1, for each query.");
  subcommand->callback([options, &command] { command = [options] { return run_convert(*options); }; });
}

}  // namespace touchstone::cli
