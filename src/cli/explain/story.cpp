// SPDX-License-Identifier: MIT
#include "cli/explain/story.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "cli/shared/separation.hpp"
#include "cli/shared/words.hpp"
#include "io/times.hpp"
#include "numbers/fraction.hpp"

namespace touchstone::cli {
namespace {

constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};

std::string as_double(const Fraction& coordinate) {
  const auto value = numbers::exact_double(coordinate.numerator, coordinate.denominator);
  return value ? io::hexfloat(*value) : "no double";
}

std::string as_text(const Fraction& coordinate) {
  return coordinate.denominator == "1" ? coordinate.numerator : coordinate.numerator + "/" + coordinate.denominator;
}

std::string sign_for_person(int sign) { return sign < 0 ? "negative" : sign > 0 ? "positive" : "zero"; }

std::string enclosure(double lower, double upper) {
  if (lower == upper) return "= " + time_for_person(lower);
  return fmt::format("in [{}, {}] ({})", io::hexfloat(lower), io::hexfloat(upper), lower);
}

std::string candidate_for_person(std::size_t number, const exact::CandidateStory& candidate, bool apart) {
  constexpr std::array<const char*, 4> kMultiplicities = {"", "a simple", "a double", "a triple"};
  std::string root;
  if (candidate.multiplicity > 0) {
    const auto multiplicity = static_cast<std::size_t>(candidate.multiplicity);
    const std::string words =
        multiplicity < kMultiplicities.size() ? kMultiplicities[multiplicity] : fmt::format("a {}-fold", multiplicity);
    root = fmt::format(", {} root of {}", words, candidate.polynomial.empty() ? "V" : candidate.polynomial);
  }
  std::string text = fmt::format("  {}. t {}{}\n", number, enclosure(candidate.lower, candidate.upper), root);
  text += fmt::format("     exactly {}\n", candidate.time);
  std::size_t width = 0;
  for (const auto& condition : candidate.conditions) width = std::max(width, condition.name.size());
  for (const auto& condition : candidate.conditions) {
    text += fmt::format("       {:<{}}  {}\n", condition.name, width, sign_for_person(condition.sign));
  }
  if (apart) {
    const char* const farther = candidate.multiplicity == 0 ? "they are farther apart than d" : "this shows no contact";
    return text + fmt::format("     {}\n", candidate.touching ? "they are within d" : farther);
  }
  return text + (candidate.touching ? "     they touch\n" : "     they do not touch\n");
}

std::string coefficients_for_person(const std::vector<std::string>& coefficients) {
  std::string text;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const std::string power = i == 0 ? "1" : i == 1 ? "t" : fmt::format("t^{}", i);
    text += fmt::format("  {:<4}  {}\n", power, coefficients[i]);
  }
  return text;
}

std::string cubic_for_person(const exact::Story& story) {
  return "\nthe coplanarity cubic V(t), exactly\n" + coefficients_for_person(story.coefficients);
}

/// The polynomials of the distance that have roots, and a line about the others.
std::string polynomials_for_person(const exact::Story& story, double t_max) {
  std::string text;
  for (const auto& polynomial : story.polynomials) {
    text += fmt::format("\nthe polynomial of {}, exactly\n", polynomial.name);
    text += coefficients_for_person(polynomial.coefficients);
  }
  constexpr std::size_t kListed = 9;  // all pairs of features
  const std::vector<std::string>& others = story.without_root;
  if (others.empty()) return text;
  text += fmt::format("\nwithout a root in [0, {}]: ", t_max);
  if (others.size() > kListed) return text + counted(others.size(), "polynomial") + "\n";
  for (std::size_t i = 0; i < others.size(); ++i) text += (i == 0 ? "" : ", ") + others[i];
  return text + "\n";
}

/// "a0 a1" with weights "0.25, 0.75": the corners that a feature's weights belong to.
std::string touched(Kind kind, Feature feature, const std::array<double, 3>& weights, std::size_t first,
                    std::size_t count) {
  std::string text = fmt::format("  {:<8} at ", feature_name(feature));
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("{}{} {}", i == 0 ? "" : " + ", weights[i], corner_name(kind, first + i));
  }
  return text + "\n";
}

std::string answer_for_person(Kind kind, const Answer& answer, double t_max) {
  const std::string range = t_max == 1 ? "" : fmt::format(" for t in [0, {}]", t_max);
  if (!answer.contact) return fmt::format("\nanswer: no contact{}\n", range);
  const std::size_t first_count = kind == Kind::edge_edge ? 2 : 1;
  std::string course;
  if (answer.trend != Trend::none) {
    course = fmt::format("  {}the distance then {}\n", answer.starts_within ? "they start within d; " : "",
                         answer.trend == Trend::approaching ? "falls"
                         : answer.trend == Trend::leaving   ? "rises"
                                                            : "stays as it is");
  }
  return fmt::format("\nanswer: {} contact{}, first at t {}\n", nature_name(answer.nature), range,
                     enclosure(answer.toi, answer.toi_upper)) +
         course + touched(kind, answer.feature_a, answer.weights_a, 0, first_count) +
         touched(kind, answer.feature_b, answer.weights_b, first_count, corner_count(kind) - first_count);
}

}  // namespace

std::string corners_for_person(const std::variant<Query, RationalQuery>& query, const RationalQuery& as_given) {
  std::string text = std::holds_alternative<Query>(query)
                         ? "corners, as given and as doubles\n"
                         : "corners, as given and as doubles where they are (so this query is solved as rationals)\n";
  std::size_t width = 0;
  for (std::size_t i = 0; i < corner_count(as_given.kind); ++i) {
    for (const auto* corner : {&as_given.start[i], &as_given.end[i]}) {
      for (const auto& coordinate : *corner) width = std::max(width, as_text(coordinate).size());
    }
  }
  width = std::min<std::size_t>(width, 40);
  for (std::size_t i = 0; i < corner_count(as_given.kind); ++i) {
    for (const bool start : {true, false}) {
      const auto& corner = start ? as_given.start[i] : as_given.end[i];
      for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
        const std::string heading =
            axis == 0 ? fmt::format("{} at {}", corner_name(as_given.kind, i), start ? 0 : 1) : std::string();
        text += fmt::format("  {:<8}{}  {:<{}}  {}\n", heading, kAxes[axis], as_text(corner[axis]), width,
                            as_double(corner[axis]));
      }
    }
  }
  return text;
}

std::string story_for_person(Kind kind, const exact::Story& story, double t_max, const Separation& separation,
                             const std::optional<std::array<double, 3>>& normal) {
  const bool apart = separation.distance > 0;
  std::string text;
  if (apart) text += fmt::format("\n{}: d below\n", separation_for_person(separation));
  if (story.has_cubic) text += cubic_for_person(story);
  text += polynomials_for_person(story, t_max);
  text += fmt::format("\n{}\n", story.why);
  text += fmt::format("\ncandidate times in [0, {}]: {}\n", t_max, story.candidates.size());
  for (std::size_t i = 0; i < story.candidates.size(); ++i)
    text += candidate_for_person(i + 1, story.candidates[i], apart);
  text += answer_for_person(kind, story.answer, t_max);
  if (normal) text += fmt::format("  normal      {}, {}, {}\n", (*normal)[0], (*normal)[1], (*normal)[2]);
  return text;
}

}  // namespace touchstone::cli
