// SPDX-License-Identifier: MIT
#include "view/pages/story_html.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "geometry/kind_traits.hpp"
#include "io/times.hpp"
#include "view/pages/html.hpp"

namespace touchstone::view {
namespace {

std::string number(double x) { return fmt::format("{}", x); }

std::string times(double lower, double upper) {
  if (lower == upper) return fmt::format("t = <code>{}</code> ({})", io::hexfloat(lower), number(lower));
  return fmt::format("t in [<code>{}</code>, <code>{}</code>] ({})", io::hexfloat(lower), io::hexfloat(upper),
                     number(lower));
}

std::string polynomial(const std::string& name, std::vector<std::string> coefficients) {
  while (coefficients.size() > 1 && coefficients.back() == "0") coefficients.pop_back();
  std::string text = "<h3>" + escaped(name) + "</h3>\n<table class=\"polynomial\">\n";
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const std::string power = i == 0 ? "1" : i == 1 ? "t" : fmt::format("t<sup>{}</sup>", i);
    text +=
        fmt::format("<tr><th scope=\"row\">{}</th><td><code>{}</code></td></tr>\n", power, escaped(coefficients[i]));
  }
  return text + "</table>\n";
}

std::string sign(int sign) {
  return sign < 0   ? "<span class=\"sign minus\">&minus; negative</span>"
         : sign > 0 ? "<span class=\"sign plus\">+ positive</span>"
                    : "<span class=\"sign zero\">0 zero</span>";
}

std::string weights(Kind kind, Feature feature, const std::array<double, 3>& weights, std::size_t first,
                    std::size_t count) {
  std::string text = fmt::format("<dt>{}</dt><dd>", name_of(feature));
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("{}{} {}", i == 0 ? "" : " + ", number(weights[i]), corner_name(kind, first + i));
  }
  return text + "</dd>\n";
}

std::string answer_html(Kind kind, const Answer& answer, double t_max, const Separation& separation) {
  std::string text = "<section class=\"answer\">\n<h2>Answer</h2>\n";
  if (!answer.contact) {
    return text + fmt::format("<p><strong>No contact</strong> for t in [0, {}].</p>\n</section>\n", number(t_max));
  }
  const std::size_t first = geometry::corners_of_first(kind);
  text += fmt::format("<p><strong>Contact</strong>, {}, first at<br>{}.</p>\n<dl>\n", name_of(answer.nature),
                      times(answer.toi, answer.toi_upper));
  text += weights(kind, answer.feature_a, answer.weights_a, 0, first);
  text += weights(kind, answer.feature_b, answer.weights_b, first, corner_count(kind) - first);
  text += "</dl>\n";
  if (separation.distance > 0) {
    text += fmt::format("<p>Contact means: within the distance <code>{}</code> ({}).</p>\n",
                        io::hexfloat(separation.distance), number(separation.distance));
  }
  return text + "</section>\n";
}

}  // namespace

std::string answer_sentence(Kind kind, const Answer& answer, double t_max, const Separation& separation) {
  const std::string_view words = name_of(kind);  // "vertex-face"
  const std::size_t between = words.find('-');
  std::string pair =
      fmt::format("{} {} and {} {}", words.substr(0, between), corner_name(kind, 0).front(), words.substr(between + 1),
                  corner_name(kind, geometry::corners_of_first(kind)).front());
  pair.front() = static_cast<char>(pair.front() - 'a' + 'A');
  const std::string distance = separation.distance > 0 ? number(separation.distance) : std::string();
  if (!answer.contact) {
    return fmt::format("{} {} for t in [0, {}]; the marks are where they come closest.", pair,
                       distance.empty() ? "do not touch" : "stay farther apart than " + distance, number(t_max));
  }
  return fmt::format("{} {} first at t {} {}.", pair, distance.empty() ? "touch" : "come within " + distance,
                     answer.toi == answer.toi_upper ? "=" : "just above", number(answer.toi));
}

std::string story_html(Kind kind, bool curved, const exact::Story& story, double t_max, const Separation& separation) {
  std::string text = answer_html(kind, story.answer, t_max, separation);
  text += "<section>\n<h2>Exact polynomials</h2>\n";
  if (story.has_cubic) {
    text += polynomial(
        curved ? "V(t), times a positive function of t" : "The coplanarity cubic V(t), times a positive number",
        story.coefficients);
  }
  for (const auto& p : story.polynomials) text += polynomial(p.name, p.coefficients);
  text += "<p>" + escaped(story.why) + "</p>\n</section>\n";
  text += fmt::format("<section>\n<h2>Candidate times: {}</h2>\n", story.candidates.size());
  if (!story.candidates.empty()) text += "<ol class=\"candidates\">\n";
  for (const exact::CandidateStory& candidate : story.candidates) {
    text += "<li>" + times(candidate.lower, candidate.upper);
    if (candidate.multiplicity > 0) {
      text += fmt::format(", a root of {}", candidate.polynomial.empty() ? "V" : escaped(candidate.polynomial));
      if (candidate.multiplicity > 1) text += fmt::format(" ({}-fold)", candidate.multiplicity);
    }
    text += "<br><small>exactly " + escaped(candidate.time) + "</small>\n<table class=\"signs\">\n";
    for (const auto& condition : candidate.conditions) {
      text += "<tr><th scope=\"row\"><code>" + escaped(condition.name) + "</code></th><td>" + sign(condition.sign) +
              "</td></tr>\n";
    }
    const char* const verdict = separation.distance > 0
                                    ? (candidate.touching ? "within the distance" : "this shows no contact")
                                    : (candidate.touching ? "they touch" : "they do not touch");
    text += fmt::format("</table>\n<span class=\"verdict {}\">{}</span></li>\n", candidate.touching ? "yes" : "no",
                        verdict);
  }
  if (!story.candidates.empty()) text += "</ol>\n";
  return text + "</section>\n";
}

}  // namespace touchstone::view
