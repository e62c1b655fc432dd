// SPDX-License-Identifier: MIT
#include "cli/shared/command_line/common_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>
#include <variant>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "cli/shared/command_line/kind_check.hpp"
#include "cli/shared/command_line/number_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/words.hpp"
#include "geometry/kind_aliases.hpp"
#include "io/answers/claim_columns.hpp"
#include "io/fail.hpp"
#include "io/queries/kind_of_file.hpp"
#include "io/times.hpp"

namespace touchstone::cli {

namespace {

/// The file that a name leads to, whether it is there or not.
std::filesystem::path resolved(const std::string& name) {
  if (name == "-") return name;
  std::error_code error;
  const auto path = std::filesystem::weakly_canonical(std::filesystem::absolute(name, error), error);
  return error || path.empty() ? std::filesystem::path(name) : path;
}

}  // namespace

CLI::Validator kind_check() {
  std::string names;
  for (const Kind kind : kKinds) {
    names.append(names.empty() ? "{" : ",").append(name_of(kind));
  }
  return CLI::Validator(
      [](const std::string& name) {
        return geometry::kind_named(name) ? std::string() : name + " is no kind; it must be " + io::kind_names();
      },
      names + "}");
}

void add_kind_option(CLI::App& subcommand, std::optional<Kind>& kind) {
  subcommand
      .add_option_function<std::string>(
          "--kind", [&kind](const std::string& name) { kind = geometry::kind_named(name); },
          "The kind of the files' queries: " + io::kind_names() +
              " (default: that of a binary file, or else the name of each file's folder, or of a file such as "
              "227ee.csv)")
      ->type_name("KIND")
      ->check(kind_check());
}

void add_seed_option(CLI::App& subcommand, std::uint64_t& seed) {
  add_whole_number(subcommand, "--seed", seed, "The seed of the generated queries (default: 1)");
}

void add_threads_option(CLI::App& subcommand, int& threads, const std::string& more) {
  add_whole_number(subcommand, "--threads", threads, "The number of threads (default: all that the machine has)" + more,
                   1, 1024);
}

std::string not_empty(const std::string& name) { return name.empty() ? "the name is empty" : std::string(); }

void add_animation_option(CLI::App& subcommand, std::string& file, const std::string& contents) {
  subcommand
      .add_option("--html,--svg", file,
                  "Write a page with the animation, " + contents +
                      ". It is one file, for any browser. A name that ends in .svg: a moving picture alone, for slides "
                      "or a README")
      ->type_name("PAGE.html")
      ->check(named_as(Output::animation));
}

std::string check_whole_number(const std::string& text, std::uint64_t least, std::uint64_t most) {
  const bool number = !text.empty() && text.size() < 19 && text.find_first_not_of("0123456789") == std::string::npos;
  if (number && std::stoull(text) >= least && std::stoull(text) <= most) return {};
  return fmt::format("{} must be a whole number from {} to {}", text, least, most);
}

std::function<std::string(const std::string&)> check_range(const std::string& words,
                                                           const std::function<bool(double)>& is_right) {
  return [=](const std::string& text) {
    const auto value = io::parse_finite_double(text);
    if (value && is_right(*value)) return std::string();
    return text + (value ? " must be " + words : fault_of_number(text));
  };
}

void add_decimals_option(CLI::App& subcommand, io::Decimals& decimals) {
  subcommand.add_flag_callback(
      "--as-doubles", [&decimals] { decimals = io::Decimals::nearest_double; },
      "A decimal in a file of queries or claims that is no double stands for the nearest double, not for itself");
}

std::string decimals_argument(io::Decimals decimals) {
  return decimals == io::Decimals::nearest_double ? " --as-doubles" : "";
}

void add_numbers_option(CLI::App& subcommand, io::Numbers& numbers) {
  subcommand
      .add_option_function<std::string>(
          "--numbers",
          [&numbers](const std::string& name) {
            numbers = name == "hex" ? io::Numbers::hexfloats : io::Numbers::decimals;
          },
          "How doubles are written in CSV: decimal, the shortest that reads back as the same double (default), or hex, "
          "C hexfloats")
      ->type_name("FORM")
      ->check(CLI::IsMember({"decimal", "hex"}));
}

void add_query_options(CLI::App& subcommand, QueryOptions& options) {
  add_kind_option(subcommand, options.kind);
  add_decimals_option(subcommand, options.decimals);
  subcommand
      .add_option_function<std::string>(
          "--level",
          [&options](const std::string& name) { options.method = from_name<Method>(name).value_or(options.method); },
          "The code that answers; every level gives the same answer. fast: filters, and exact arithmetic where they "
          "are uncertain (default). exact: exact arithmetic alone. oracle: an independent decider over CGAL that "
          "shares no code with the others; a thousand times slower. fast-cgal: filters, and CGAL where they are "
          "uncertain")
      ->type_name("LEVEL")
      ->check(CLI::IsMember(all_names<Method>()));
  add_shorter_turn_option(subcommand, options.turns);
  add_threads_option(subcommand, options.threads);
}

void refuse_to_overwrite(const std::string& output, const std::vector<std::string>& inputs, const std::string& advice) {
  if (output.empty() || output == "-") return;
  for (const auto& named : inputs) {
    const std::string input = without_dash(named);
    std::error_code ignored;  // a missing file cannot be overwritten
    if (std::filesystem::is_regular_file(output, ignored) && std::filesystem::equivalent(output, input, ignored)) {
      const std::string reason = "is also an input; writing there would destroy it";
      io::fail(output, advice.empty() ? reason : reason + "; " + advice);
    }
  }
}

void refuse_one_file_twice(const std::vector<std::pair<std::string, std::string>>& outputs) {
  std::set<std::filesystem::path> paths;
  for (const auto& [option, output] : outputs) {
    std::error_code ignored;
    if (output.empty() || paths.insert(resolved(output)).second) continue;
    if (std::filesystem::is_character_file(output, ignored)) continue;
    throw Error(fmt::format("{} names {}, which another option names too", option,
                            output == "-" ? "standard output" : io::printable(output)));
  }
}

Answer answer_to(const io::FileQuery& query, Method method, const Separation& separation) {
  return std::visit([&](const auto& given) { return solve(given, {.separation = separation, .method = method}); },
                    query);
}

}  // namespace touchstone::cli
