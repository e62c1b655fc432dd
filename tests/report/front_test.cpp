// The methods on the front of error and run time.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "baselines/baseline.hpp"
#include "report/pictures/front.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::report;

namespace {

Result result(const std::string& name, std::size_t missed, double mean) {
  Result result;
  result.contestant.name = name;
  if (name != "touchstone") result.contestant.baseline = baselines::find_method("paper");
  result.asked = 100;
  result.contacts = 50;
  result.missed = missed;
  result.mean = mean;
  return result;
}

Result with_cgal(double mean) {
  Result with = result("touchstone_cgal", 0, mean);
  with.contestant.baseline = nullptr;
  with.contestant.method = Method::fast_cgal;
  return with;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("nobody on the front is beaten in both") {
  const std::vector<Result> results = {result("slow_and_wrong", 5, 9), result("fast_and_wrong", 7, 1),
                                       result("touchstone", 0, 2), result("right_and_slow", 0, 3)};
  const auto best = front(results);
  REQUIRE(best.size() == 2);
  CHECK(best[0]->contestant.name == "fast_and_wrong");
  CHECK(best[1]->contestant.name == "touchstone");
  const std::string sentence = front_sentence(results);
  CAPTURE(sentence);
  CHECK(contains(sentence,
                 "`fast_and_wrong` (7 % wrong, times 0 ulps off in the median, 1 us) and `touchstone` (never wrong, "
                 "times 0 ulps off in the median, 2 us)"));
  CHECK(contains(sentence, "Faster than `touchstone`, with errors: `fast_and_wrong`"));
  CHECK_FALSE(contains(sentence, "dominated"));
}

TEST_CASE("who was not asked is on no front, and equals do not beat each other") {
  std::vector<Result> results = {result("touchstone", 0, 2), result("equal", 0, 2), result("silent", 0, 0)};
  results.back().asked = 0;
  const auto best = front(results);
  CHECK(best.size() == 2);
  CHECK(contains(front_sentence(results), "`touchstone` is faster than every method that has errors"));
}

TEST_CASE("who was asked a part is on no front and beats nobody there, and the sentence names it") {
  std::vector<Result> results = {result("touchstone", 0, 2), result("subset", 0, 1)};
  results.back().asked = 99;
  CHECK(front(results).size() == 1);
  CHECK_FALSE(dominates(results.back(), results.front()));
  CHECK(contains(front_sentence(results), "Asked a part, and so not placed: `subset`."));
}

TEST_CASE("the sentence tells when touchstone is beaten") {
  const std::string sentence = front_sentence({result("touchstone", 0, 2), result("better", 0, 1)});
  CHECK(
      contains(sentence, "`touchstone` is dominated by `better` (never wrong, times 0 ulps off in the median, 1 us)"));
}

TEST_CASE("the pairing with CGAL neither beats touchstone by noise nor stands on the front") {
  const std::vector<Result> results = {with_cgal(1.9), result("touchstone", 0, 2)};
  const auto best = front(results);
  REQUIRE(best.size() == 1);
  CHECK(best[0]->contestant.name == "touchstone");
  const std::string sentence = front_sentence(results);
  CHECK_FALSE(contains(sentence, "dominated"));
  CHECK(contains(sentence, "no other but `touchstone_cgal`, which shares our filters, is"));
}

TEST_CASE("a time that is early is an error too, though the answer holds") {
  std::vector<Result> results = {result("touchstone", 0, 2), result("early", 0, 1)};
  results[1].time_error = time_error({-5});
  CHECK(front(results).size() == 2);
  const std::string sentence = front_sentence(results);
  CAPTURE(sentence);
  CHECK(contains(sentence, "Faster than `touchstone`, with errors: `early`."));
}
