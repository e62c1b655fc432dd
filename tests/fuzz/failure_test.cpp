// The class of failure of a reply.
// SPDX-License-Identifier: MIT
#include "fuzz/judging/failure.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "support/catch.hpp"

using namespace touchstone;
using fuzz::FailureClass;
using fuzz::Reply;

namespace {

Answer contact_at(double toi, double toi_upper) {
  Answer answer;
  answer.contact = true;
  answer.toi = toi;
  answer.toi_upper = toi_upper;
  return answer;
}

Reply says(bool contact, std::optional<double> toi = std::nullopt) {
  Reply reply;
  reply.contact = contact;
  reply.toi = toi;
  return reply;
}

std::string class_of(const Reply& reply, const Answer& truth, const certify::TimeLimit& early = {}) {
  const auto failure = fuzz::failure_of(Query(), reply, truth, early);  // times are doubles: the query says no more
  return failure ? std::string(name_of(failure->failure)) : "right";
}

}  // namespace

TEST_CASE("every reply has one class") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const double below = std::nextafter(0.5, 0.0);
  const Answer none, at_double = contact_at(0.5, 0.5), between = contact_at(below, 0.5), at_zero = contact_at(0, 0);
  CHECK(class_of(says(false), none) == "right");
  CHECK(class_of(says(false, kNaN), none) == "right");
  CHECK(class_of(says(false), at_double) == "missed");
  CHECK(class_of(says(false, 0.5), at_double) == "missed");
  CHECK(class_of(says(true), none) == "phantom");
  CHECK(class_of(says(true, 0.5), none) == "phantom");
  CHECK(class_of(says(true, kNaN), none) == "nan");
  CHECK(class_of(says(true, kNaN), at_double) == "nan");
  CHECK(class_of(says(true), at_double) == "right");
  CHECK(class_of(says(true, 0.5), at_double) == "right");
  CHECK(class_of(says(true, below), between) == "right");
  CHECK(class_of(says(true, 0.5), between) == "late");
  CHECK(class_of(says(true, 7), at_double) == "late");
  CHECK(class_of(says(true, kInfinity), at_double) == "late");
  CHECK(class_of(says(true, 0x1p-1074), at_zero) == "late");
  CHECK(class_of(says(true, -0.0), at_zero) == "right");
  CHECK(class_of(says(true, 0), at_double) == "right");
  CHECK(class_of(says(true, -0x1p-1074), at_double) == "malformed");
  CHECK(class_of(says(true, -kInfinity), at_double) == "malformed");
}

TEST_CASE("how early is too early is the caller's choice, in ulps or as a share") {
  const Answer truth = contact_at(0.5, 0.5);
  const double early = 0.5 - 4 * 0x1p-54;
  certify::TimeLimit limit;
  limit.ulps = 4;
  CHECK(class_of(says(true, early), truth, limit) == "right");
  CHECK(class_of(says(true, std::nextafter(early, 0.0)), truth, limit) == "early");
  limit = {};
  limit.fraction = 0.125;
  CHECK(class_of(says(true, 0.375), truth, limit) == "right");
  CHECK(class_of(says(true, std::nextafter(0.375, 0.0)), truth, limit) == "early");
  CHECK(class_of(says(true), truth, limit) == "right");
}

TEST_CASE("a reply that is no answer is of its state's class, and keeps the detail") {
  Reply reply = says(true, 0.5);
  reply.detail = "signal 11";
  reply.state = Reply::State::crashed;
  CHECK(class_of(reply, contact_at(0.5, 0.5)) == "crash");
  CHECK(fuzz::failure_of(Query(), reply, Answer(), {})->detail == "signal 11");
  reply.state = Reply::State::hung;
  CHECK(class_of(reply, Answer()) == "hang");
  reply.state = Reply::State::malformed;
  CHECK(class_of(reply, Answer()) == "malformed");
}

TEST_CASE("every class has a name of its own") {
  std::set<std::string_view> names;
  for (const FailureClass failure : fuzz::kEveryFailure) {
    names.insert(name_of(failure));
    CHECK(from_name<FailureClass>(name_of(failure)) == failure);
  }
  CHECK(names.size() == fuzz::kFailureClasses);
  CHECK(names.count("") == 0);
}
