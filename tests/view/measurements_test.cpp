// The page of a comparison: every point is in the picture, and text stays text.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "view/pages/measurements_page.hpp"
#include "view/scatter.hpp"

using namespace touchstone::view;

namespace {

std::size_t occurrences_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The numbers after `name` of all circles.
std::vector<double> numbers_after(const std::string& svg, const std::string& name) {
  std::vector<double> all;
  const std::string key = " " + name + "=\"";
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) {
    all.push_back(std::stod(svg.substr(svg.find(key, at) + key.size())));
  }
  return all;
}

}  // namespace

TEST_CASE("points stand in the order of their numbers, inside the picture, and no error is the lowest of all") {
  const std::string svg = scatter_svg({{0.05, 0, "a", "", "r0", false},
                                       {0.5, 1e-4, "b", "", "r1", false},
                                       {5, 3, "c", "", "r2", false},
                                       {5000, 4.5e15, "d", "", "r3", true}},
                                      {"title", "x", "y"});
  const auto x = numbers_after(svg, "cx"), y = numbers_after(svg, "cy");
  REQUIRE(x.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK((x[i] > 0 && x[i] < 560 && y[i] > 0 && y[i] < 320));
    if (i > 0) CHECK((x[i] > x[i - 1] && y[i] < y[i - 1]));
  }
  // Equal factors are equal ways.
  CHECK(std::abs((x[2] - x[1]) - (x[1] - x[0])) < 0.2);
  CHECK(occurrences_of(svg, "class=\"dot own\"") == 1);
  CHECK(occurrences_of(scatter_svg({}, {"title", "x", "y"}), "<circle") == 0);
  CHECK(numbers_after(scatter_svg({{1, 0, "a", "", "", false}}, {"t", "x", "y"}), "cy").size() == 1);
}

TEST_CASE("our own point has its label, and lies over the others") {
  std::vector<ScatterPoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({1 + 0.001 * i, 0, "other", "", "", false});
  points.insert(points.begin() + 4, {1.0005, 0, "a long name of our own", "", "", true});
  points.push_back({100, 1, "other", "", "", false});
  const std::string svg = scatter_svg(points, {"title", "x", "y"});
  CHECK(occurrences_of(svg, ">a long name of our own</text>") == 1);
  CHECK(svg.rfind("<circle") == svg.find("<circle class=\"dot own\""));
}

TEST_CASE("labels that would lie on one another are left out, and all points stay") {
  std::vector<ScatterPoint> points;
  for (int i = 0; i < 20; ++i) points.push_back({1 + 0.001 * i, 1, "label", "", "", false});
  points.push_back({1000, 1000, "label", "", "", false});
  const std::string svg = scatter_svg(points, {"title", "x", "y"});
  CHECK(occurrences_of(svg, "<circle") == 21);
  CHECK(occurrences_of(svg, ">label</text>") >= 1);
  CHECK(occurrences_of(svg, ">label</text>") <= 3);
}

TEST_CASE("a page of measurements shows names as text, and numbers to sort by") {
  const std::string name = "<script>alert(1)</script>\"'&";
  Measurements all;
  all.title = all.subtitle = all.summary = all.how_to_read = all.time_axis = name;
  all.panels = {{name, name}};
  all.columns = {name};
  MeasuredSet set;
  set.name = set.about = name;
  set.methods.push_back({name, true, 2, {0.0}, {{name, 3.5}}});
  set.methods.push_back({"other", false, 2, {std::nullopt}, {{name, std::nullopt}}});
  all.sets.push_back(set);
  const std::string text = page_text(measurements_page(all));
  CHECK(occurrences_of(text, "<script>alert") == 0);
  CHECK(occurrences_of(text, "data-value=\"3.5\"") == 1);
  CHECK(occurrences_of(text, "<circle") == 1);  // the other one has no error to show
  CHECK(occurrences_of(text, "id=\"row-0-1\"") == 1);
}
