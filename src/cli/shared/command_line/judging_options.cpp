// SPDX-License-Identifier: MIT
#include "cli/shared/command_line/judging_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/shared/command_line/common_options.hpp"
#include "io/times.hpp"

namespace touchstone::cli {
namespace {

std::optional<certify::TimeLimit> time_limit(const std::string& text) {
  certify::TimeLimit limit;
  if (const std::size_t unit = text.find("ulp");
      unit != std::string::npos && (text.ends_with("ulp") || text.ends_with("ulps"))) {
    const std::string number = text.substr(0, unit);
    if (!check_whole_number(number, 0).empty()) return std::nullopt;
    limit.ulps = std::stoull(number);
    return limit;
  }
  limit.fraction = io::parse_finite_double(text);
  if (!limit.fraction || *limit.fraction < 0 || *limit.fraction > 1) return std::nullopt;
  return limit;
}

}  // namespace

std::string time_limit_text(const certify::TimeLimit& limit) {
  return limit.ulps ? fmt::format("{}ulps", *limit.ulps) : fmt::format("{}", limit.fraction.value_or(1));
}

void add_time_limit(CLI::App& subcommand, const std::string& name, const std::string& about,
                    const std::function<void(const certify::TimeLimit&)>& take) {
  subcommand
      .add_option_function<std::string>(
          name, [take](const std::string& text) { take(*time_limit(text)); },
          about + ": 16ulps, or 1e-6 for that fraction of the step")
      ->type_name("LIMIT")
      ->check([](const std::string& text) {
        return time_limit(text) ? std::string()
                                : text + " must be a number of ulps, 16ulps, or a fraction of the step in [0, 1]";
      });
}

void add_class_option(CLI::App& subcommand, const std::vector<std::string>& names, const std::string& about,
                      const std::function<void(const std::string&)>& take) {
  subcommand
      .add_option_function<std::vector<std::string>>(
          "--class",
          [take](const std::vector<std::string>& given) {
            for (const std::string& name : given) take(name);
          },
          about)
      ->type_name("NAMES")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(names));
}

}  // namespace touchstone::cli
