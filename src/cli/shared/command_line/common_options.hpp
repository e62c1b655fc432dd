// Options that several subcommands have.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/separation_options.hpp"
#include "io/answers/answer_writer.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::cli {

/// The options that solve and certify have in common.
struct QueryOptions {
  std::vector<std::string> files;
  std::optional<Kind> kind;
  Method method = Method::fast;
  SeparationOption separation;
  io::Decimals decimals = io::Decimals::exact;
  io::Turns turns = io::Turns::as_given;      ///< of the bodies of curved queries
  int threads = 0;                            ///< 0: all that the machine has
  std::size_t chunk_bytes = io::kChunkBytes;  ///< for tests: no result depends on it
};

void add_kind_option(CLI::App& subcommand, std::optional<Kind>& kind);
void add_decimals_option(CLI::App& subcommand, io::Decimals& decimals);
/// " --as-doubles", or nothing.
std::string decimals_argument(io::Decimals decimals);
void add_numbers_option(CLI::App& subcommand, io::Numbers& numbers);
void add_query_options(CLI::App& subcommand, QueryOptions& options);
void add_seed_option(CLI::App& subcommand, std::uint64_t& seed);
/// @param more  said after the default
void add_threads_option(CLI::App& subcommand, int& threads, const std::string& more = {});

/// A CLI11 check: "" when `text` is a whole number from `least` to `most`, else the reason why not.
inline constexpr std::uint64_t kMostNumber = 999'999'999'999'999'999;
std::string check_whole_number(const std::string& text, std::uint64_t least = 0, std::uint64_t most = kMostNumber);

/// Such a check of a finite number, decimal or hexfloat. @param words  of the range: "in [0, 1]"
/// @param is_right  whether a number is in it
std::function<std::string(const std::string&)> check_range(const std::string& words,
                                                           const std::function<bool(double)>& is_right);

/// The same for a file's name, which must not be empty.
std::string not_empty(const std::string& name);

/// --html and --svg, two names of one option: the ending of the file says what is written.
/// @param contents  what the page has: "its contacts and its energies"
void add_animation_option(CLI::App& subcommand, std::string& file, const std::string& contents);

/// @throws FileError when writing to `output` (an empty name or "-": none) would destroy one of `inputs`; its message
/// ends with `advice`
void refuse_to_overwrite(const std::string& output, const std::vector<std::string>& inputs,
                         const std::string& advice = {});

/// @param outputs  the options that name a file to write, and these names; an empty name: none; "-": standard output
/// @throws Error when two of them lead to one file, whether it is there or not. A device may be named twice
void refuse_one_file_twice(const std::vector<std::pair<std::string, std::string>>& outputs);

/// The answer to a query of a file, whatever its motion.
Answer answer_to(const io::FileQuery& query, Method method, const Separation& separation);

}  // namespace touchstone::cli
