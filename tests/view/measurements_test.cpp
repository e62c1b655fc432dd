// The page of a comparison: every point is in the picture, and text stays text.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "view/chart.hpp"
#include "view/pages/measurements_page.hpp"

using namespace touchstone::view;

namespace {

std::size_t occurrences_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The middles of all points, which have no own look but a circle of radius 5.5.
std::vector<std::pair<double, double>> middles(const std::string& svg) {
  std::vector<std::pair<double, double>> all;
  const std::string key = " d=\"M";
  for (std::size_t at = svg.find("class=\"dot"); at != std::string::npos; at = svg.find("class=\"dot", at + 1)) {
    const std::string path = svg.substr(svg.find(key, at) + key.size(), 40);
    all.emplace_back(std::stod(path) + 5.5, std::stod(path.substr(path.find(',') + 1)));
  }
  return all;
}

ChartSeries series_of(const std::vector<ChartPoint>& points, const std::string& name = "a") {
  ChartSeries series;
  series.name = name;
  series.points = points;
  return series;
}

Chart error_chart(const std::vector<ChartSeries>& series) { return {"title", {"x", true}, {"y", true}, series}; }

}  // namespace

TEST_CASE("points stand in the order of their numbers, inside the picture, and no error is the lowest of all") {
  const auto points = middles(chart_svg(error_chart({series_of({{0.05, 0}, {0.5, 1e-4}, {5, 3}, {5000, 4.5e15}})})));
  REQUIRE(points.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [x, y] = points[i];
    CHECK((x > 0 && x < 560 && y > 0 && y < 320));
    if (i > 0) CHECK((x > points[i - 1].first && y < points[i - 1].second));
  }
  // Equal factors are equal ways.
  CHECK(std::abs((points[2].first - points[1].first) - (points[1].first - points[0].first)) < 0.2);
  CHECK(middles(chart_svg(error_chart({}))).empty());
  CHECK(middles(chart_svg(error_chart({series_of({{1, 0}})}))).size() == 1);
}

TEST_CASE("equal steps are equal ways on an axis of numbers, and names stand under their points") {
  Chart chart{"title", {"x"}, {"y"}, {series_of({{-300, -3}, {0, 0}, {300, 3}, {900, 9}})}};
  const auto points = middles(chart_svg(chart));
  REQUIRE(points.size() == 4);
  CHECK(std::abs((points[2].first - points[1].first) - (points[1].first - points[0].first)) < 0.2);
  CHECK(std::abs((points[3].first - points[2].first) - 2 * (points[1].first - points[0].first)) < 0.3);
  CHECK(std::abs((points[0].second - points[1].second) - (points[1].second - points[2].second)) < 0.2);
  chart = {"title", {"x"}, {"y", true}, {series_of({{0, 1}, {1, 10}})}};
  chart.x.names = {"half", "all"};
  const std::string svg = chart_svg(chart);
  for (const auto& [x, y] : middles(svg)) {
    CHECK(occurrences_of(svg, "<text x=\"" + std::to_string(static_cast<int>(x)) + ".") >= 1);
  }
  CHECK(occurrences_of(svg, ">half</text>") == 1);
}

TEST_CASE("values that are equal but for their rounding, none, and those at the ends of all doubles have an axis") {
  const auto axis_of = [](const std::vector<ChartPoint>& points) {
    const std::string svg = chart_svg({"title", {"x"}, {"y"}, {series_of(points)}});
    CHECK(occurrences_of(svg, "nan") + occurrences_of(svg, "inf") == 0);
    return occurrences_of(svg, "class=\"grid\" d=\"M62 ");  // the lines of the upright axis
  };
  for (const double y : {1.0, -3e15, 0.0, 5e-324, 1e300}) {
    CAPTURE(y);
    const std::size_t lines = axis_of({{0, y}, {1, std::nextafter(y, 2 * y + 1)}});
    CHECK((lines > 1 && lines < 20));
  }
  for (const double y : {1.7e308, std::numeric_limits<double>::infinity(), std::nan("")}) {
    CAPTURE(y);
    const std::size_t lines = axis_of({{0, -y}, {1, y}});
    CHECK((lines > 1 && lines < 20));
  }
  // Where all is 0, so are the numbers of the axis, up to 1.
  const std::string zeros = chart_svg({"title", {"x"}, {"y"}, {series_of({{0, 0}, {1, 0}})}});
  CHECK(occurrences_of(zeros, ">0.2</text>") >= 1);
  CHECK(occurrences_of(zeros, "e-") == 0);
}

TEST_CASE("a line goes from point to point, and is broken where a value is missing") {
  const std::string svg =
      chart_svg({"title", {"x"}, {"y"}, {series_of({{0, 1}, {1, 2}, {2, std::nullopt}, {3, 1}, {4, 5}})}});
  const std::string line = svg.substr(svg.find("class=\"line"));
  const std::string path = line.substr(0, line.find("/>"));
  CHECK(occurrences_of(path, "M") == 2);
  CHECK(occurrences_of(path, "L") == 2);
  CHECK(middles(svg).size() == 4);
}

TEST_CASE("our own point has its label, and lies over the others") {
  std::vector<ChartPoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({1 + 0.001 * i, 0, "other"});
  points.push_back({100, 1, "other"});
  ChartSeries own = series_of({{1.0005, 0, "a long name of our own"}}, "own");
  own.own = true;
  const std::string svg = chart_svg(error_chart({own, series_of(points)}));
  CHECK(occurrences_of(svg, ">a long name of our own</text>") == 1);
  CHECK(svg.rfind("class=\"dot") == svg.find("class=\"dot k0 own\""));
}

TEST_CASE("our own label stands beside its point where another point is above it, and is never left out") {
  ChartSeries own = series_of({{10, 10, "own name"}}, "own");
  own.own = true;
  const auto label_among = [&](std::vector<ChartPoint> points) {
    points.insert(points.end(), {{1, 1}, {100, 100}});
    const std::string svg = chart_svg(error_chart({own, series_of(points)}));
    REQUIRE(occurrences_of(svg, ">own name</text>") == 1);
    return std::stod(svg.substr(svg.rfind("<text x=\"", svg.find(">own name</text>")) + 9));
  };
  const double over = label_among({});
  const double right = label_among({{10, 11.8}});
  CHECK(right > over + 30);
  CHECK(label_among({{10, 11.8}, {13, 10}}) < over - 30);
  CHECK(label_among({{10, 11.8}, {13, 10}, {7.5, 10}}) == over);
}

TEST_CASE("labels that would lie on one another are left out, and all points stay") {
  std::vector<ChartPoint> points;
  for (int i = 0; i < 20; ++i) points.push_back({1 + 0.001 * i, 1, "label"});
  points.push_back({1000, 1000, "label"});
  const std::string svg = chart_svg(error_chart({series_of(points)}));
  CHECK(middles(svg).size() == 21);
  CHECK(occurrences_of(svg, ">label</text>") >= 1);
  CHECK(occurrences_of(svg, ">label</text>") <= 3);
}

TEST_CASE("a chart on a page names its series where it has several, and shows which points are not to be compared") {
  ChartPoint faint{2, 2};
  faint.faint = true;
  const Chart chart = error_chart({series_of({{1, 1}, faint}, "first"), series_of({{1, 3}}, "second")});
  const std::string svg = chart_svg(chart);
  CHECK(occurrences_of(svg, ">first</text>") == 1);
  CHECK(occurrences_of(svg, ">second</text>") == 1);
  CHECK(occurrences_of(svg, "class=\"key k0\"") == 2);
  CHECK(occurrences_of(svg, "class=\"dot faint k0\"") == 1);
  CHECK(middles(svg).size() == 3);
  CHECK(occurrences_of(chart_svg(error_chart({series_of({{1, 1}}, "alone")})), ">alone</text>") == 0);
}

TEST_CASE("the last number of an axis lies within the picture") {
  const std::string svg = chart_svg(error_chart({series_of({{1, 1}, {9000, 2}})}));
  const std::size_t at = svg.rfind("<text x=\"", svg.find(">10000</text>"));
  const double middle = std::stod(svg.substr(at + 9));
  CHECK((middle > 400 && middle + 2.5 * 9 <= 560));  // five digits, none of them wider than 9
}

TEST_CASE("a file of charts names each series once, as text, and has colours for light and for dark") {
  const std::string name = "<script>&";
  const Chart one = error_chart({series_of({{1, 1}, {2, 2}}, name), series_of({{1, 3}}, "other")});
  const std::string svg = chart_file(name, name, {one, one, one});
  CHECK(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\"", 0) == 0);
  CHECK(occurrences_of(svg, "<script>") == 0);
  CHECK(occurrences_of(svg, ">other</text>") == 1);
  CHECK(occurrences_of(chart_file("t", "", {one, error_chart({series_of({{1, 1}}, "new")})}), ">title:</text>") == 2);
  CHECK(occurrences_of(svg, "<g transform") == 3);
  CHECK(occurrences_of(svg, "prefers-color-scheme: dark") == 1);
  CHECK(occurrences_of(svg, "href") == 0);
}

TEST_CASE("a page of measurements shows names as text, and numbers to sort by") {
  const std::string name = "<script>alert(1)</script>\"'&";
  Measurements all;
  all.title = all.subtitle = all.summary = all.how_to_read = all.time_axis = name;
  all.panels = {{name, name}};
  all.columns = {name};
  MeasuredSet set;
  set.name = set.about = name;
  set.methods.push_back({name, series_of({}, name), 2, {0.0}, {{name, 3.5}}});
  set.methods.push_back({"other", series_of({}), 2, {std::nullopt}, {{name, std::nullopt}}});
  all.sets.push_back(set);
  const std::string text = page_text(measurements_page(all));
  CHECK(occurrences_of(text, "<script>alert") == 0);
  CHECK(occurrences_of(text, "data-value=\"3.5\"") == 1);
  CHECK(occurrences_of(text, "class=\"dot") == 1);  // the other one has no error to show
  CHECK(occurrences_of(text, "id=\"row-0-1\"") == 1);
}
