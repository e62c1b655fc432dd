// Every field of an answer against the third opinion, at times that are doubles: there the opinion is rational.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <touchstone/contact_times.hpp>
#include <touchstone/solve.hpp>

#include "support/answer_check.hpp"
#include "support/report.hpp"
#include "support/static_contact.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 3;

bool near(const std::array<double, 3>& weights, const std::array<mpq_class, 3>& truth) {
  const mpq_class bound(0x1p-50);
  for (std::size_t i = 0; i < 3; ++i) {
    if (abs(mpq_class(weights[i]) - truth[i]) > bound) return false;
  }
  return true;
}

// How the first contact ought to be called, at an exact time.
Nature nature_at(const Query& query, const mpq_class& time) {
  const std::vector<mpq_class> cubic = coplanarity_cubic(query);
  if (!cubic.empty()) return root_multiplicity(cubic, time) % 2 == 1 ? Nature::crossing : Nature::grazing;
  const std::vector<ContactInterval> times = contact_times(query);
  return times.front().first < times.front().last ? Nature::sustained : Nature::isolated;
}

std::string at_exact_time(const Query& query, const Answer& answer) {
  const mpq_class time(answer.toi);
  const StaticContact truth = contact_at(query.kind, corners_at(query, time));
  if (!truth.touching) return "the elements do not touch at toi";
  if (answer.feature_a != truth.feature_a || answer.feature_b != truth.feature_b) {
    return "the features are " + std::string(name_of(truth.feature_a)) + " " + std::string(name_of(truth.feature_b));
  }
  if (!near(answer.weights_a, truth.weights_a)) return "weights_a are off by more than 2^-50";
  if (!near(answer.weights_b, truth.weights_b)) return "weights_b are off by more than 2^-50";
  const Nature nature = nature_at(query, time);
  if (answer.nature != nature) return "the nature is " + std::string(name_of(nature));
  return "";
}

mpq_class value(const std::vector<mpq_class>& polynomial, const mpq_class& t) {
  mpq_class sum = 0;
  for (std::size_t i = polynomial.size(); i-- > 0;) sum = sum * t + polynomial[i];
  return sum;
}

// A time that is no double lies strictly between its bounds, and so does a root of V.
std::string between_doubles(const Query& query, const Answer& answer) {
  const mpq_class lower(answer.toi), upper(answer.toi_upper);
  if (touching_at(query, lower)) return "the elements touch at toi, before the time that is claimed";
  const std::vector<mpq_class> cubic = coplanarity_cubic(query);
  if (cubic.empty()) return "";
  const bool changes = sgn(value(cubic, lower)) * sgn(value(cubic, upper)) < 0;
  // Without a sign change over the interval a crossing would need a second root within one ulp of the first.
  if (changes && answer.nature == Nature::crossing) return "";
  if (!changes && answer.nature == Nature::grazing) return "";
  std::vector<mpq_class> derivative;
  for (std::size_t i = 1; i < cubic.size(); ++i) derivative.push_back(static_cast<int>(i) * cubic[i]);
  const bool two_roots_in_an_ulp = sgn(value(derivative, lower)) * sgn(value(derivative, upper)) <= 0;
  return two_roots_in_an_ulp ? "" : "V's signs at the bounds contradict the nature";
}

std::string refuted(const Query& query, const Answer& answer) {
  for (int k = 0; k <= 16; ++k) {
    const double t = k / 16.0;
    if (answer.contact && t >= answer.toi) break;
    if (touching_at(query, mpq_class(t))) return "the elements touch at " + hexfloat(t);
  }
  if (!answer.contact) return "";
  return answer.toi == answer.toi_upper ? at_exact_time(query, answer) : between_doubles(query, answer);
}

void check_answers(Group group, std::size_t count) {
  Report report;
  std::size_t exact_times = 0, other_times = 0;
  for_each_case(
      kSeed, count, [&](const FamilyInfo& f, Kind) { return f.group == group; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const Answer answer = solve(query, {.method = Method::fast});
        const std::string wrong = refuted(query, answer);
        report.add(id, query, wrong.empty() ? "" : wrong + "\n    " + describe(answer));
        if (answer.contact) ++(answer.toi == answer.toi_upper ? exact_times : other_times);
      });
  if (!chosen_case()) {
    std::printf("seed %llu: %zu contacts at a double, %zu between doubles, of %zu queries\n",
                static_cast<unsigned long long>(kSeed), exact_times, other_times, report.checked());
    CHECK(exact_times > 0);
    CHECK(other_times > 0);
  }
  report.finish();
}

TEST_CASE("the third opinion confirms solve: lattice") { check_answers(Group::lattice, 2000); }
TEST_CASE("the third opinion confirms solve: coplanar") { check_answers(Group::coplanar, 2000); }
TEST_CASE("the third opinion confirms solve: contact") { check_answers(Group::contact, 2000); }
TEST_CASE("the third opinion confirms solve: perturbed") { check_answers(Group::perturbed, 2000); }
TEST_CASE("the third opinion confirms solve: scale") { check_answers(Group::scale, 200); }

}  // namespace
}  // namespace touchstone::tests
