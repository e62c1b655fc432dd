// The subcommands. Each has its own file: what it accepts (add_...) and what it does (run_...).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "io/query_chunks.hpp"

namespace CLI {
class App;
}

namespace touchstone::cli {

inline constexpr int kAllHold = 0;   ///< exit status: done, and every claim holds
inline constexpr int kRefuted = 1;   ///< exit status: some claim is refuted
inline constexpr int kBadInput = 2;  ///< exit status: bad usage or bad input

/// What solve and certify have in common.
struct QueryOptions {
  std::vector<std::string> files;
  std::optional<Kind> kind;
  Method method = Method::fast;
  int threads = 0;                            ///< 0: all that the machine has
  std::size_t chunk_bytes = io::kChunkBytes;  ///< for tests: no result depends on it
};

struct SolveOptions : QueryOptions {
  std::string out = "-";
};

struct CertifyOptions : QueryOptions {
  std::string claims;  ///< an answers file; empty: the truth column
  std::string report;  ///< empty: none
};

struct ExplainOptions {
  std::string file;
  std::optional<Kind> kind;
  std::uint64_t query = 0;
  double t_max = 1;
};

// Each returns the exit status, and throws Error, Interrupted or what the standard library throws.
int run_solve(const SolveOptions& options);
int run_certify(const CertifyOptions& options);
int run_explain(const ExplainOptions& options);

/// Set to the chosen subcommand's run_... while the arguments are parsed.
using Command = std::function<int()>;
void add_solve(CLI::App& program, Command& command);
void add_certify(CLI::App& program, Command& command);
void add_explain(CLI::App& program, Command& command);
void add_report(CLI::App& program, Command& command);
void add_stress(CLI::App& program, Command& command);

void add_kind_option(CLI::App& subcommand, std::optional<Kind>& kind);
void add_query_options(CLI::App& subcommand, QueryOptions& options);
void add_seed_option(CLI::App& subcommand, std::uint64_t& seed);

/// @throws FileError when writing to `output` (an empty name or "-": none) would destroy one of `inputs`; its message
/// ends with `advice`
void refuse_to_overwrite(const std::string& output, const std::vector<std::string>& inputs,
                         const std::string& advice = {});

/// `threads`, or as many as the machine has for 0.
int thread_count(int threads) noexcept;

/// The exact answer to a query of a file.
Answer answer_to(const std::variant<Query, RationalQuery>& query, Method method);

}  // namespace touchstone::cli
