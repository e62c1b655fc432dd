// Every method gives the answers that the construction of the bundled queries gives.
// SPDX-License-Identifier: MIT
#include <touchstone/curved.hpp>
#include <touchstone/solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "bundled/expected_query.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

struct NamedMethod {
  Method method;
  const char* name;
};
constexpr NamedMethod kMethods[] = {
    {Method::fast, "fast"}, {Method::exact, "exact"}, {Method::oracle, "oracle"}, {Method::fast_cgal, "fast-cgal"}};

/// The field of an answer as an expectation writes it.
std::string field_of(const Answer& answer, const std::string& field) {
  if (field == "contact") return answer.contact ? "1" : "0";
  if (field == "toi") return hexfloat(answer.toi);
  if (field == "toi_upper") return hexfloat(answer.toi_upper);
  if (field == "nature") return std::string(name_of(answer.nature));
  if (field == "trend") return std::string(name_of(answer.trend));
  if (field == "starts_within") return answer.starts_within ? "1" : "0";
  if (field == "feature_a") return std::string(name_of(answer.feature_a));
  return std::string(name_of(answer.feature_b));
}

void check_answer(const ExpectedQuery& expected, const Answer& answer, const char* method) {
  INFO(method << ": " << describe(answer));
  for (const auto& [field, value] : expected.expect) {
    INFO(field);
    CHECK(field_of(answer, field) == value);
  }
  CHECK(malformation(expected.query.kind, answer, 1.0) == "");
}

void check_level(const Answer& answer, Method method) {
  if (method == Method::exact) CHECK(answer.level == Level::exact);
  if (method == Method::oracle) CHECK(answer.level == Level::oracle);
  if (method == Method::fast) CHECK(answer.level != Level::oracle);
  if (method == Method::fast_cgal) CHECK(answer.level != Level::exact);
}

/// @param query  the expected one, in any of its types
template <class AQuery>
void check_methods(const ExpectedQuery& expected, const AQuery& query) {
  INFO(expected.name());
  for (const auto& [method, name] : kMethods) {
    const Answer answer = solve(query, {.separation = expected.separation, .method = method});
    check_answer(expected, answer, name);
    if (expected.separation.distance == 0) {  // the question without a separation is the same one
      CHECK(bit_difference(answer, solve(query, {.method = method}), true) == "");
    }
    check_level(answer, method);
  }
}

}  // namespace

TEST_CASE("the truth column and the expectations say the same, and times are doubles as printed") {
  REQUIRE(!expected_queries().empty());
  for (const auto& expected : expected_queries()) {
    INFO(expected.name());
    const auto& expect = expected.expect;
    CHECK(expect.at("contact") == (expected.truth ? "1" : "0"));
    CHECK((expected.truth || expect.size() == 1));
    for (const auto* field : {"toi", "toi_upper"}) {
      const auto found = expect.find(field);
      if (found == expect.end()) continue;
      const double time = std::strtod(found->second.c_str(), nullptr);
      CHECK((time >= 0.0 && time <= 1.0));
      CHECK(hexfloat(time) == found->second);
    }
    if (expect.count("toi") != 0 && expect.count("toi_upper") != 0) {
      const double lower = std::strtod(expect.at("toi").c_str(), nullptr);
      const double upper = std::strtod(expect.at("toi_upper").c_str(), nullptr);
      CHECK((lower == upper || std::nextafter(lower, 2.0) == upper));
    }
  }
}

TEST_CASE("every method answers the bundled queries as constructed") {
  REQUIRE(!expected_queries().empty());
  for (const auto& expected : expected_queries()) {
    expected.curved ? check_methods(expected, *expected.curved) : check_methods(expected, expected.query);
  }
}

TEST_CASE("every method answers the bundled queries as constructed, given as doubles") {
  std::size_t checked = 0;
  for (const auto& expected : expected_queries()) {
    if (expected.curved) continue;
    const auto query = in_doubles(expected.query);
    if (!query) continue;
    check_methods(expected, *query);
    ++checked;
  }
  CHECK(checked >= 300);
  const auto& all = expected_queries();
  const auto straight = std::count_if(all.begin(), all.end(), [](const auto& query) { return !query.curved; });
  CHECK(checked < static_cast<std::size_t>(straight));  // some coordinates are no doubles
}
