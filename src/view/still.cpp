// SPDX-License-Identifier: MIT
#include "view/still.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "view/basis.hpp"
#include "view/flip_book.hpp"
#include "view/pages/html.hpp"

namespace touchstone::view {
namespace {

struct Point {
  double x, y;
};

/// The corners of the picture at some time, seen from the first view.
class Projected {
 public:
  explicit Projected(const nlohmann::json& picture) : picture_(picture) {
    for (std::size_t row = 0; row < 2; ++row) {
      for (std::size_t k = 0; k < 3; ++k) axes_[row][k] = picture["basis"][row][k].get<double>();
    }
  }

  Point corner(std::size_t i, double s) const {
    return at(s, i >= picture_["first"].get<std::size_t>(), vector_at(picture_["corners"][i], s));
  }

  /// The point of an element that is closest to the other one at s = 0.
  Point marked(bool second, double s) const { return at(s, second, {}); }

 private:
  Point at(double s, bool second, const Double3& offset) const {
    const double w = polynomial_at(picture_["denominator"], s);
    Double3 position = vector_at(picture_["carrier"], s);
    const Double3 gap = vector_at(picture_["gap"], s);
    for (std::size_t k = 0; k < 3; ++k) position[k] = (position[k] + offset[k] + (second ? gap[k] : 0)) / w;
    return {dot_product(position, axes_[0]), -dot_product(position, axes_[1])};
  }

  const nlohmann::json& picture_;
  std::array<Double3, 2> axes_{};
};

constexpr int kWidth = 640, kHeight = 400;
constexpr int kSteps = 30;  // of a path, and of a moving picture
constexpr double kSecondsOfMeeting = 1.5;

/// Lengths of the picture to units of the SVG.
struct Frame {
  double scale, x, y;
  Point operator()(const Point& p) const {
    return {kWidth / 2.0 + (p.x - x) * scale, kHeight / 2.0 + (p.y - y) * scale};
  }
};

Frame frame_of(const std::vector<Point>& points) {
  Point low = points.front(), high = points.front();
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double wide = std::max(high.x - low.x, 1e-9), tall = std::max(high.y - low.y, 1e-9);
  return {std::min(540 / wide, 310 / tall), (low.x + high.x) / 2, (low.y + high.y) / 2};
}

std::string polygon(const std::vector<Point>& points, const char* element, const char* state) {
  std::string text = fmt::format("<polygon class=\"{} {}\" points=\"", element, state);
  for (const Point& p : points) text += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  return text + "\"/>\n";
}

std::string dot(const Point& p, double radius, const char* look) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n", look, p.x, p.y, radius);
}

/// Draws the elements of a picture at its times.
class Drawing {
 public:
  explicit Drawing(const nlohmann::json& picture)
      : picture_(picture),
        projected_(picture),
        count_(picture["corners"].size()),
        first_(picture["first"].get<std::size_t>()),
        start_(picture["marks"].front()["s"].get<double>()),
        end_(picture["marks"].back()["s"].get<double>()) {
    std::vector<Point> all;
    for (const double s : times()) {
      for (std::size_t i = 0; i < count_; ++i) all.push_back(projected_.corner(i, s));
    }
    frame_ = frame_of(all);
  }

  /// From the start to the end, with the time where the elements meet.
  std::vector<double> times() const {
    std::vector<double> all{0};
    for (int step = 0; step <= kSteps; ++step) all.push_back(start_ + (end_ - start_) * step / kSteps);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  /// The paths of the corners, and the elements at both ends.
  std::string whole_step() const {
    std::string text;
    for (std::size_t i = 0; i < count_; ++i) {
      text += "<polyline class=\"path\" points=\"";
      for (const double s : times()) {
        const Point p = frame_(projected_.corner(i, s));
        text += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
      }
      text += "\"/>\n";
    }
    return text + elements(start_, "then") + elements(end_, "then");
  }

  std::string now(double s) const {
    const Point a = frame_(projected_.marked(false, s)), b = frame_(projected_.marked(true, s));
    std::string text = elements(s, "now");
    text += fmt::format("<path class=\"gap\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", a.x, a.y, b.x, b.y);
    for (const auto& [p, look] : {std::pair{a, "a marked"}, std::pair{b, "b marked"}}) text += dot(p, 4, look);
    if (s == 0) text += dot(a, 9, "meeting");
    return text + names(s);
  }

 private:
  std::vector<Point> corners(bool second, double s) const {
    std::vector<Point> all;
    for (std::size_t i = second ? first_ : 0; i < (second ? count_ : first_); ++i) {
      all.push_back(frame_(projected_.corner(i, s)));
    }
    return all;
  }

  std::string elements(double s, const char* state) const {
    std::string text;
    for (const bool second : {false, true}) {
      const char* const element = second ? "b" : "a";
      const std::vector<Point> all = corners(second, s);
      if (all.size() > 1) text += polygon(all, element, state);
      for (const Point& p : all) text += dot(p, 3.5, fmt::format("{} {}", element, state).c_str());
    }
    return text;
  }

  /// The names stand outside of their elements, and not on each other.
  std::string names(double s) const {
    std::string text;
    std::vector<Point> shown;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::vector<Point> own = corners(i >= first_, s);
      const Point p = own[i < first_ ? i : i - first_];
      Point out{0, 0};
      for (const Point& q : own) out = {out.x + p.x - q.x, out.y + p.y - q.y};
      const double size = std::hypot(out.x, out.y);
      out = size > 1e-3 ? Point{out.x / size, out.y / size} : Point{0.6, i < first_ ? -0.8 : 0.8};
      Point at{std::clamp(p.x + 23 * out.x, 14.0, kWidth - 14.0), std::clamp(p.y + 21 * out.y, 14.0, kHeight - 14.0)};
      const auto is_near = [&at](const Point& q) { return std::abs(q.x - at.x) < 22 && std::abs(q.y - at.y) < 15; };
      while (std::any_of(shown.begin(), shown.end(), is_near)) at.y += 15;
      shown.push_back(at);
      text += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", i < first_ ? "a" : "b", at.x,
                          at.y + 5, picture_["names"][i].get<std::string>());
    }
    return text;
  }

  const nlohmann::json& picture_;
  Projected projected_;
  std::size_t count_, first_;
  double start_, end_;
  Frame frame_{};
};

}  // namespace

std::string still_of(const nlohmann::json& picture) {
  const Drawing drawing(picture);
  return fmt::format(
      "<svg class=\"still\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"The two elements at the start, at the "
      "end, and where they meet or come closest\">\n{}{}</svg>\n",
      kWidth, kHeight, drawing.whole_step(), drawing.now(0));
}

std::string moving_svg(const nlohmann::json& picture, const std::string& title, const std::string& about) {
  const Drawing drawing(picture);
  FlipBook book;
  book.width = kWidth;
  book.height = kHeight;
  book.title = title;
  book.about = about;
  book.attributes = " class=\"still\"";
  book.style = page_file("colours.css") + page_file("still.css");
  book.background =
      fmt::format("<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", kWidth, kHeight) + drawing.whole_step();
  book.seconds_of_still = kSecondsOfMeeting;
  for (const double s : drawing.times()) {
    if (s == 0) book.still = book.frames.size();
    book.frames.push_back(drawing.now(s));
  }
  return svg_file(book);
}

}  // namespace touchstone::view
