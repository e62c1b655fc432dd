// The picture in plain characters: every point in its row, none lost.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "report/pictures/text_plot.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using report::Contestant;
using report::Result;
using report::SetResults;

namespace {

Result result(const std::string& name, double mean, std::int64_t error, std::size_t missed) {
  Result r;
  r.contestant.name = name;
  r.asked = 100;
  r.contacts = 10;
  r.missed = missed;
  r.mean = mean;
  r.time_error = report::time_error({-error});
  return r;
}

std::vector<std::string> drawn_lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("the text plot has a letter for each point, in the row of its error and in order of time") {
  SetResults set;
  set.results = {result("paper", 0.1, 5, 3),
                 result("closed_form", 0.12, 0, 0),
                 result("newton", 0.13, 1'000'000, 0),
                 result("newton", 0.13, 2'000'000, 0),
                 result("conservative_advancement", 40, INT64_MAX, 0),
                 result("touchstone", 0.05, 0, 0)};
  const auto lines = drawn_lines(report::text_plot(set));
  REQUIRE(lines.size() == 1 + 8 + 4);
  const auto row = [&](const std::string& label) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.find(label + " |") != std::string::npos;
    });
    REQUIRE(found != lines.end());
    std::string letters = found->substr(found->find('|') + 1);
    letters.erase(std::remove(letters.begin(), letters.end(), ' '), letters.end());
    return letters;
  };
  CHECK(row("none") == "TC");
  CHECK(row("1e0") == "p");  // it missed some
  CHECK(row("1e3") == "");
  CHECK(row("1e6") == "NN");
  CHECK(row("1e18") == "A");
  for (const std::string& line : lines) CHECK(line.size() <= 110);
  CHECK(lines[lines.size() - 2] == "P paper, C closed_form, N newton, A conservative_advancement, T touchstone");
  CHECK(lines.back() == "in lower case: some contact missed, invented or late");
}

TEST_CASE("a set in which nobody claims a time has no text plot") {
  SetResults set;
  set.results = {result("paper", 0.1, 5, 3)};
  set.results[0].time_error.reset();
  CHECK(report::text_plot(set) == "");
  set.results.clear();
  CHECK(report::text_plot(set) == "");
}
