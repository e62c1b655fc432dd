// The names of kinds, corners, natures, trends, metrics, features and levels, as files and people write them. A value
// that is none of the enumerators has the empty name.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <iterator>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {

std::string_view kind_name(Kind kind) noexcept {
  switch (kind) {
    case Kind::edge_edge: return "edge-edge";
    case Kind::vertex_face: return "vertex-face";
    case Kind::point_edge: return "point-edge";
    case Kind::point_point: return "point-point";
  }
  return "";
}

std::string_view corner_name(Kind kind, std::size_t index) noexcept {
  static constexpr std::string_view names[4][4] = {
      {"a0", "a1", "b0", "b1"}, {"v", "f0", "f1", "f2"}, {"p", "e0", "e1", ""}, {"p", "q", "", ""}};
  const auto row = static_cast<std::size_t>(kind);
  return row < std::size(names) && index < corner_count(kind) ? names[row][index] : std::string_view{};
}

std::string_view nature_name(Nature nature) noexcept {
  switch (nature) {
    case Nature::none: return "";
    case Nature::crossing: return "crossing";
    case Nature::grazing: return "grazing";
    case Nature::sustained: return "sustained";
    case Nature::isolated: return "isolated";
    case Nature::entering: return "entering";
  }
  return "";
}

std::string_view trend_name(Trend trend) noexcept {
  switch (trend) {
    case Trend::none: return "";
    case Trend::approaching: return "approaching";
    case Trend::constant: return "constant";
    case Trend::leaving: return "leaving";
  }
  return "";
}

std::string_view metric_name(Metric metric) noexcept {
  switch (metric) {
    case Metric::euclidean: return "euclidean";
    case Metric::max: return "max";
  }
  return "";
}

std::string_view feature_name(Feature feature) noexcept {
  static constexpr std::string_view names[] = {"",    "a0",  "a1",  "a", "b0", "b1", "b",  "v", "f0", "f1",     "f2",
                                               "f01", "f12", "f20", "f", "p",  "e0", "e1", "e", "q",  "overlap"};
  const auto index = static_cast<std::size_t>(feature);
  return index < std::size(names) ? names[index] : std::string_view{};
}

std::string_view level_name(Level level) noexcept {
  switch (level) {
    case Level::filter: return "filter";
    case Level::bracket: return "bracket";
    case Level::exact: return "exact";
    case Level::oracle: return "oracle";
  }
  return "";
}

}  // namespace touchstone
