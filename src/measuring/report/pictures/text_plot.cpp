// SPDX-License-Identifier: MIT
#include "report/pictures/text_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

namespace touchstone::report {
namespace {

constexpr int kColumns = 72;
constexpr int kLabelWidth = 8;
constexpr int kStep = 3;  // decades of error a row
constexpr int kRows = 8;  // "none", then 10^0 to 10^18 ulps and more

struct Point {
  char letter;
  double microseconds;
  double error;  // ulps
};

/// The first letter of its name, but for methods whose name begins as another's does.
char capital_of(const std::string& method) {
  if (method == "conservative_advancement" || method == "thick_advancement") return 'A';
  if (method == "thick_polynomial") return 'P';
  if (method == "touchstone_cgal") return 'G';
  return static_cast<char>(std::toupper(method.front()));
}

char letter_of(const Result& result) {
  const char capital = capital_of(result.contestant.name);
  return result.wrong() > 0 ? static_cast<char>(std::tolower(capital)) : capital;
}

std::vector<Point> points_of(const SetResults& set) {
  std::vector<Point> points;
  for (const Result& result : set.results) {
    if (result.asked == 0 || !result.time_error || result.mean <= 0) continue;
    points.push_back({letter_of(result), result.mean, static_cast<double>(result.time_error->greatest_size)});
  }
  return points;
}

/// Rows from the top: the greatest errors first, none last.
int row_of(double error) {
  if (error < 1) return kRows - 1;
  return std::max(0, kRows - 2 - static_cast<int>(std::log10(error)) / kStep);
}

std::string row_label(int row) { return row == kRows - 1 ? "none" : fmt::format("1e{}", kStep * (kRows - 2 - row)); }

}  // namespace

std::string text_plot(const SetResults& set) {
  std::vector<Point> points = points_of(set);
  if (points.empty()) return {};
  const auto faster = [](const Point& a, const Point& b) { return a.microseconds < b.microseconds; };
  std::stable_sort(points.begin(), points.end(), faster);
  const double first = std::floor(2 * std::log10(points.front().microseconds)) / 2;
  const double last = std::ceil(2 * std::log10(points.back().microseconds)) / 2 + 0.25;
  const auto column_of = [&](double log) { return static_cast<int>((log - first) / (last - first) * (kColumns - 1)); };

  std::vector<std::string> rows(kRows, std::string(kColumns, ' '));
  for (const Point& point : points) {
    std::string& row = rows[static_cast<std::size_t>(row_of(point.error))];
    std::size_t column = static_cast<std::size_t>(column_of(std::log10(point.microseconds)));
    while (column < row.size() && row[column] != ' ') ++column;  // beside the points that are there
    if (column < row.size()) row[column] = point.letter;
  }
  std::string text = "greatest time error [ulps]\n";
  for (int i = 0; i < kRows; ++i) {
    std::string& row = rows[static_cast<std::size_t>(i)];
    row.erase(row.find_last_not_of(' ') + 1);
    text += fmt::format("{:>{}} |{}{}\n", row_label(i), kLabelWidth - 2, row.empty() ? "" : " ", row);
  }
  std::string axis(kColumns + 1, '-'), labels(kColumns + 8, ' ');
  for (double log = std::ceil(first); log <= last; log += 1) {
    const std::size_t column = static_cast<std::size_t>(column_of(log)) + 1;
    axis[column] = '+';
    const std::string label = fmt::format("{:g}", std::pow(10, log));
    labels.replace(column, label.size(), label);
  }
  labels.erase(labels.find_last_not_of(' ') + 1);
  text += fmt::format("{:>{}} +{}\n{:>{}}  {}  us a query\n", "", kLabelWidth - 2, axis, "", kLabelWidth - 2, labels);
  std::string legend;
  std::string previous;
  for (const Result& result : set.results) {
    if (result.asked == 0 || !result.time_error || result.contestant.name == previous) continue;
    previous = result.contestant.name;
    legend += fmt::format("{}{} {}", legend.empty() ? "" : ", ", capital_of(previous), previous);
  }
  return text + legend + "\nin lower case: some contact missed, invented or late\n";
}

}  // namespace touchstone::report
