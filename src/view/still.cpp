// SPDX-License-Identifier: MIT
#include "view/still.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "view/basis.hpp"

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
    const double w = polynomial_at(picture_["denominator"], s);
    Double3 position = vector_at(picture_["carrier"], s);
    const Double3 offset = vector_at(picture_["corners"][i], s), gap = vector_at(picture_["gap"], s);
    const bool second = i >= picture_["first"].get<std::size_t>();
    for (std::size_t k = 0; k < 3; ++k) position[k] = (position[k] + offset[k] + (second ? gap[k] : 0)) / w;
    return {dot_product(position, axes_[0]), -dot_product(position, axes_[1])};
  }

 private:
  const nlohmann::json& picture_;
  std::array<Double3, 2> axes_{};
};

/// Lengths of the picture to units of the SVG: 640 by 400.
struct Frame {
  double scale, x, y;
  Point operator()(const Point& p) const { return {320 + (p.x - x) * scale, 200 + (p.y - y) * scale}; }
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

std::string dot(const Point& p, double radius, const char* element, const char* state) {
  return fmt::format("<circle class=\"{} {}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n", element, state, p.x, p.y,
                     radius);
}

}  // namespace

std::string still_of(const nlohmann::json& picture) {
  const Projected projected(picture);
  const std::size_t count = picture["corners"].size(), first = picture["first"].get<std::size_t>();
  const double end = picture["marks"].back()["s"].get<double>(), start = picture["marks"].front()["s"].get<double>();
  std::vector<Point> all;
  for (const double s : {start, 0.0, end}) {
    for (std::size_t i = 0; i < count; ++i) all.push_back(projected.corner(i, s));
  }
  const Frame frame = frame_of(all);

  std::string paths, elements, names;
  for (std::size_t i = 0; i < count; ++i) {
    constexpr int kSteps = 24;
    paths += "<polyline class=\"path\" points=\"";
    for (int step = 0; step <= kSteps; ++step) {
      const Point p = frame(projected.corner(i, start + (end - start) * step / kSteps));
      paths += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
    }
    paths += "\"/>\n";
  }
  for (const auto& [s, state] : {std::pair{start, "then"}, std::pair{end, "then"}, std::pair{0.0, "now"}}) {
    for (const bool second : {false, true}) {
      const char* const element = second ? "b" : "a";
      std::vector<Point> corners;
      for (std::size_t i = second ? first : 0; i < (second ? count : first); ++i) {
        corners.push_back(frame(projected.corner(i, s)));
      }
      if (corners.size() > 1) elements += polygon(corners, element, state);
      for (const Point& p : corners) elements += dot(p, s == 0.0 ? 4 : 2.5, element, state);
    }
  }
  Point meeting{0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = frame(projected.corner(i, 0));
    const double weight = picture["weights"][i].get<double>();
    if (i < first) meeting = {meeting.x + weight * p.x, meeting.y + weight * p.y};
    names += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", i < first ? "a" : "b",
                         std::clamp(p.x + 9, 4.0, 610.0), std::clamp(p.y - 9, 14.0, 392.0),
                         picture["names"][i].get<std::string>());
  }
  return "<svg class=\"still\" viewBox=\"0 0 640 400\" role=\"img\" aria-label=\"The two elements at the start, at the "
         "end, and where they meet or come closest\">\n" +
         paths + elements + dot(meeting, 7, "meeting", "now") + names + "</svg>\n";
}

}  // namespace touchstone::view
