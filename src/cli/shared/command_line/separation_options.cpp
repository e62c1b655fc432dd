// SPDX-License-Identifier: MIT
#include "cli/shared/command_line/separation_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/shared/words.hpp"
#include "io/queries/separation_text.hpp"
#include "io/times.hpp"

namespace touchstone::cli {
namespace {

constexpr std::string_view kEach = "each";

/// A CLI11 check: "" for a distance, else the reason why it is none.
std::string check_distance(const std::string& text) {
  const auto value = io::parse_finite_double(text);
  if (!value) return text + fault_of_number(text);
  return *value < 0 ? text + " is negative; a separation is a distance, 0 or greater" : std::string();
}

}  // namespace

void add_separation_options(CLI::App& subcommand, SeparationOption& option, const std::string& about, EachQuery each) {
  const bool each_allowed = each == EachQuery::allowed;
  CLI::Option* const separation =
      subcommand
          .add_option_function<std::string>(
              "--separation",
              [&option](const std::string& text) {
                option.given = true;
                option.each = text == kEach;  // which the check below lets through where it is allowed
                if (option.each) {
                  option.separation.distance = 1;
                  return;
                }
                option.separation.distance = io::parse_finite_double(text).value_or(0) + 0.0;  // -0 becomes 0
              },
              about +
                  ", in the coordinates' unit of length: a decimal or a hexfloat. A decimal that is no double stands "
                  "for the nearest double, and that double is compared exactly (default: 0, touching)" +
                  (each_allowed ? "; or each, which asks each query with a distance of its own" : ""))
          ->type_name("D")
          ->check([each_allowed](const std::string& text) {
            return each_allowed && text == kEach ? std::string() : check_distance(text);
          });
  subcommand
      .add_option_function<std::string>(
          "--metric",
          [&option](const std::string& name) {
            option.separation.metric = from_name<Metric>(name).value_or(Metric::euclidean);
          },
          "How the separation is measured. euclidean: the length of the difference of two points (default). max: its "
          "largest coordinate, as Tight-Inclusion's minimum separation means it")
      ->type_name("METRIC")
      ->check(CLI::IsMember(all_names<Metric>()))
      ->needs(separation);
}

std::string separation_for_person(const Separation& separation) {
  if (separation.distance == 0) return "touching, which is separation 0";
  return fmt::format("separation {} ({}), {}", io::hexfloat(separation.distance), separation.distance,
                     name_of(separation.metric));
}

std::string each_separation_arguments(Metric metric) {
  std::string text = fmt::format(" --separation {}", kEach);
  if (metric != Metric::euclidean) text += fmt::format(" --metric {}", name_of(metric));
  return text;
}

std::string separation_arguments(const Separation& separation) {
  if (separation.distance == 0) return {};
  std::string text = " --separation " + io::hexfloat(separation.distance);
  if (separation.metric != Metric::euclidean) text += fmt::format(" --metric {}", name_of(separation.metric));
  return text;
}

}  // namespace touchstone::cli
