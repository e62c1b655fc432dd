// SPDX-License-Identifier: MIT
#include "cli/explain/story.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <variant>
#include <vector>

#include "cli/shared/command_line/separation_options.hpp"
#include "cli/shared/words.hpp"
#include "geometry/kind_traits.hpp"
#include "io/times.hpp"
#include "numbers/fraction.hpp"
#include "solver/ladder.hpp"

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

/// "degree 2" and the coefficients up to that degree.
std::string degree_for_person(std::vector<std::string> coefficients) {
  while (coefficients.size() > 1 && coefficients.back() == "0") coefficients.pop_back();
  const bool zero = coefficients.size() == 1 && coefficients.front() == "0";
  return (zero ? "zero" : fmt::format("degree {}", coefficients.size() - 1)) + "\n" +
         coefficients_for_person(coefficients);
}

std::string coplanarity_for_person(const exact::Story& story, bool curved) {
  if (!curved)
    return "\nthe coplanarity cubic V(t), times a positive number, exactly\n" +
           coefficients_for_person(story.coefficients);
  return "\nthe coplanarity V(t), times a positive function of t that makes it a polynomial, exactly: " +
         degree_for_person(story.coefficients);
}

std::string numbers_for_person(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
  return text;
}

std::string vector_for_person(const Vec3& x) { return fmt::format("({})", numbers_for_person({x.x, x.y, x.z})); }

/// The turn from q0 to q1, by the quaternion product of q1 and q0 reversed, in a person's digits.
std::string turn_for_person(const RigidMotion& motion) {
  const auto scaled = [](const std::array<double, 4>& q) {
    double most = 0;
    for (const double c : q) most = std::max(most, std::abs(c));
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < 4; ++i) result[i] = q[i] / most;
    return result;
  };
  const std::array<double, 4> a = scaled(motion.q0), b = scaled(motion.q1);
  const double w = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const double x = a[0] * b[1] - a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  const double y = a[0] * b[2] - a[2] * b[0] + a[3] * b[1] - a[1] * b[3];
  const double z = a[0] * b[3] - a[3] * b[0] + a[1] * b[2] - a[2] * b[1];
  const double sine = std::hypot(x, y, z);
  if (sine <= 1e-15 * std::abs(w)) return "does not turn";
  constexpr double kDegrees = 57.29577951308232;
  return fmt::format("turns by about {:.6g} degrees, about the axis ({:.6g}, {:.6g}, {:.6g})",
                     2 * std::atan2(sine, w) * kDegrees, x / sine + 0.0, y / sine + 0.0, z / sine + 0.0);
}

/// The polynomials of the distance that have roots, and a line about the others.
std::string polynomials_for_person(const exact::Story& story, bool curved, double t_max) {
  std::string text;
  for (const auto& polynomial : story.polynomials) {
    text += fmt::format("\nthe polynomial of {}, ", polynomial.name);
    text += curved ? "times a positive function of t, exactly: " + degree_for_person(polynomial.coefficients)
                   : "times a positive number, exactly\n" + coefficients_for_person(polynomial.coefficients);
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
  std::string text = fmt::format("  {:<8} at ", name_of(feature));
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("{}{} {}", i == 0 ? "" : " + ", weights[i], corner_name(kind, first + i));
  }
  return text + "\n";
}

std::string answer_for_person(Kind kind, const Answer& answer, double t_max) {
  const std::string range = t_max == 1 ? "" : fmt::format(" for t in [0, {}]", t_max);
  if (!answer.contact) return fmt::format("\nanswer: no contact{}\n", range);
  const std::size_t first_count = geometry::corners_of_first(kind);
  std::string course;
  if (answer.trend != Trend::none) {
    course = fmt::format("  {}the distance then {}\n", answer.starts_within ? "they start within d; " : "",
                         answer.trend == Trend::approaching ? "falls"
                         : answer.trend == Trend::leaving   ? "rises"
                                                            : "stays as it is");
  }
  return fmt::format("\nanswer: {} contact{}, first at t {}\n", name_of(answer.nature), range,
                     enclosure(answer.toi, answer.toi_upper)) +
         course + touched(kind, answer.feature_a, answer.weights_a, 0, first_count) +
         touched(kind, answer.feature_b, answer.weights_b, first_count, corner_count(kind) - first_count);
}

}  // namespace

std::string corners_for_person(const io::FileQuery& query, const RationalQuery& as_given) {
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

std::string curves_for_person(const CurvedQuery& query) {
  std::array<bool, 4> used{};
  std::string corners = "corners\n";
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    corners += fmt::format("  {:<8}  ", corner_name(query.kind, i));
    if (corner.motion != CurvedCorner::kOnCurve) {
      used[static_cast<std::size_t>(corner.motion)] = true;
      corners += fmt::format("on motion {}, at {} of its body\n", corner.motion, vector_for_person(corner.points[0]));
      continue;
    }
    corners += corner.control_points == 1 ? "at rest at " : "on the curve of the control points ";
    for (int k = 0; k < corner.control_points; ++k) {
      corners += fmt::format("{}{}", k == 0 ? "" : ", ", vector_for_person(corner.points[static_cast<std::size_t>(k)]));
    }
    corners += '\n';
  }
  std::string motions;
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    const RigidMotion& motion = query.motions[m];
    const auto pose = [&](const std::array<double, 4>& q, const Vec3& p) {
      return fmt::format("q = ({}), p = {}\n", numbers_for_person({q[0], q[1], q[2], q[3]}), vector_for_person(p));
    };
    motions += fmt::format("  {} at 0    {}", m, pose(motion.q0, motion.p0));
    motions += fmt::format("    at 1    {}", pose(motion.q1, motion.p1));
    motions += fmt::format("            {}\n", turn_for_person(motion));
  }
  return (motions.empty() ? "" : "motions, of the orientation q = (w, x, y, z) and the position p\n" + motions) +
         corners;
}

std::string rung_for_person(std::size_t rung) {
  return fmt::format("\nsolve decides it at rung {} of {}: {}\n", rung + 1, solver::kLadder.size(),
                     solver::kLadder[rung].name);
}

std::string times_for_person(const std::vector<ContactInterval>& times) {
  if (times.empty()) return "contact times: none\n";
  constexpr std::size_t kShown = 12;
  std::string text = "contact times\n";
  for (std::size_t i = 0; i < std::min(times.size(), kShown); ++i) {
    const ExactTime &first = times[i].first, &last = times[i].last;
    text += fmt::format("  t {}", enclosure(first.lower(), first.upper()));
    text += first.compare(last) == 0 ? "\n" : fmt::format(" to t {}\n", enclosure(last.lower(), last.upper()));
  }
  if (times.size() > kShown) text += fmt::format("  and {} more\n", times.size() - kShown);
  return text;
}

std::string story_for_person(Kind kind, bool curved, const exact::Story& story, double t_max,
                             const Separation& separation, const std::optional<std::array<double, 3>>& normal) {
  const bool apart = separation.distance > 0;
  std::string text;
  if (apart) text += fmt::format("\n{}: d below\n", separation_for_person(separation));
  if (story.has_cubic) text += coplanarity_for_person(story, curved);
  text += polynomials_for_person(story, curved, t_max);
  text += fmt::format("\n{}\n", story.why);
  text += fmt::format("\ncandidate times in [0, {}]: {}\n", t_max, story.candidates.size());
  for (std::size_t i = 0; i < story.candidates.size(); ++i)
    text += candidate_for_person(i + 1, story.candidates[i], apart);
  text += answer_for_person(kind, story.answer, t_max);
  if (normal) text += fmt::format("  normal      {}, {}, {}\n", (*normal)[0], (*normal)[1], (*normal)[2]);
  return text;
}

}  // namespace touchstone::cli
