// SPDX-License-Identifier: MIT
#include "view/animation_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "view/pages/html.hpp"

namespace touchstone::view {

double drawn_coordinate(const AnimationFrame& frame, std::size_t vertex, std::size_t axis) noexcept {
  return frame.drawn.origin[axis] +
         std::ldexp(static_cast<double>(frame.drawn.steps[3 * vertex + axis]), frame.drawn.exponent);
}

namespace {

constexpr std::size_t kMostDrawn = 5000;  // elements of the still picture
constexpr double kMuchLarger = 3;         // what is at rest is cut off, like a floor, if all is so many times larger

struct Box {
  Triple low, high;
  Box() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  void add(double x, std::size_t axis) {
    low[axis] = std::min(low[axis], x);
    high[axis] = std::max(high[axis], x);
  }
  Triple centre() const { return {low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2, low[2] / 2 + high[2] / 2}; }
  double radius() const {
    return std::hypot(high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2, high[2] / 2 - low[2] / 2);
  }
};

double product(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The frame that the still picture shows.
std::size_t frame_of_still(const Animation& animation) {
  const auto& frames = animation.frames();
  if (animation.stories().empty()) return frames.size() - 1;
  const double time = animation.stories().front().time;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].time >= time) return i;
  }
  return frames.size() - 1;
}

Triple drawn_position(const AnimationFrame& frame, std::size_t vertex) {
  return {drawn_coordinate(frame, vertex, 0), drawn_coordinate(frame, vertex, 1), drawn_coordinate(frame, vertex, 2)};
}

/// In all frames, of the vertices that are chosen.
Box box_of(const Animation& animation, const std::vector<char>& chosen) {
  Box box;
  for (const AnimationFrame& frame : animation.frames()) {
    for (std::size_t i = 0; i < frame.drawn.steps.size(); ++i) {
      if (chosen[i / 3] != 0) box.add(drawn_coordinate(frame, i / 3, i % 3), i % 3);
    }
  }
  if (!(box.low[0] <= box.high[0])) box.low = box.high = {};
  return box;
}

/// In units of the view's radius.
Triple from_centre(const AnimationView& view, const Triple& x) {
  Triple d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = (x[k] - view.centre[k]) / view.radius;
  return d;
}

/// By vertex: whether it leaves its first place by more than the rounding.
std::vector<char> moving_vertices(const Animation& animation) {
  std::vector<char> moves(animation.shape().vertex_count(), 0);
  const AnimationFrame& first = animation.frames().front();
  for (const AnimationFrame& frame : animation.frames()) {
    const double rounding = std::ldexp(1.0, frame.drawn.exponent);  // no frame before has a larger one
    for (std::size_t i = 0; i < frame.drawn.steps.size(); ++i) {
      const double way = drawn_coordinate(frame, i / 3, i % 3) - drawn_coordinate(first, i / 3, i % 3);
      if (std::abs(way) > rounding) moves[i / 3] = 1;
    }
  }
  return moves;
}

/// x from `low` to `high` as a height in a plot, from 100 down to 0.
double height_of(double x, double low, double high) { return high > low ? 100 - 100 * (x - low) / (high - low) : 50; }

}  // namespace

AnimationView view_of(const Animation& animation) {
  const std::vector<char> moves = moving_vertices(animation);
  const std::vector<char> all(moves.size(), 1);
  const bool any = std::count(moves.begin(), moves.end(), 1) > 0;
  const Box of_all = box_of(animation, all), of_moving = any ? box_of(animation, moves) : of_all;
  const bool whole = of_all.radius() <= kMuchLarger * of_moving.radius();
  const Box& box = whole ? of_all : of_moving;
  AnimationView view;
  view.centre = box.centre();
  view.radius = box.radius();
  if (!(view.radius > 0)) view.radius = 1;
  view.planar = !(of_all.low[2] < of_all.high[2]);
  if (view.planar) {
    view.basis = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  } else {
    // From the front, a little from the right and from above; z points up.
    const double right = 0.35, above = 0.4;
    view.basis[0] = {std::cos(right), std::sin(right), 0};
    view.basis[2] = {std::cos(above) * std::sin(right), -std::cos(above) * std::cos(right), std::sin(above)};
    view.basis[1] = {-std::sin(above) * std::sin(right), std::sin(above) * std::cos(right), std::cos(above)};
  }
  for (const AnimationFrame& frame : animation.frames()) {
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (!whole && moves[i] == 0) continue;
      const Triple d = from_centre(view, drawn_position(frame, i));
      for (std::size_t k = 0; k < 2; ++k) view.reach[k] = std::max(view.reach[k], std::abs(product(d, view.basis[k])));
    }
  }
  return view;
}

std::string still_of(const Animation& animation, const AnimationView& view) {
  const std::size_t shown = frame_of_still(animation);
  const AnimationFrame& frame = animation.frames()[shown];
  const double scale = 0.92 * std::min(320 / std::max(view.reach[0], 0.1), 200 / std::max(view.reach[1], 0.1));
  const auto on_page = [&](const Triple& x) {
    const Triple d = from_centre(view, x);
    return fmt::format("{:.1f} {:.1f}", 320 + scale * product(d, view.basis[0]),
                       200 - scale * product(d, view.basis[1]));
  };
  const AnimationShape& shape = animation.shape();
  std::string path;
  const auto draw = [&](const auto& corners, const char* end) {
    const char* command = "M";
    for (const std::uint32_t vertex : corners) {
      path += fmt::format("{}{}", command, on_page(drawn_position(frame, vertex)));
      command = "L";
    }
    path += end;
  };
  const auto every = [](std::size_t count) { return count / kMostDrawn + 1; };
  const std::size_t faces = shape.faces.size(), edges = shape.edges.size(), points = shape.points.size();
  for (std::size_t i = 0; i < faces; i += every(faces)) draw(shape.faces[i], "Z");
  if (faces == 0 || edges <= kMostDrawn) {
    for (std::size_t i = 0; i < edges; i += every(edges)) draw(shape.edges[i], "");
  }
  for (std::size_t i = 0; i < points; i += every(points)) draw(std::array{shape.points[i]}, "h1");
  std::string marks;
  std::size_t drawn = 0;
  const double before = shown == 0 ? -std::numeric_limits<double>::infinity() : animation.frames()[shown - 1].time;
  for (const AnimationStory& story : animation.stories()) {
    if (!(story.time > before && story.time <= frame.time) || ++drawn > kMostDrawn) continue;
    const std::string at = on_page(story.point);
    const auto space = at.find(' ');
    marks += fmt::format("<circle class=\"meeting\" cx=\"{}\" cy=\"{}\" r=\"5\"/>\n", at.substr(0, space),
                         at.substr(space + 1));
  }
  return "<svg class=\"still\" viewBox=\"0 0 640 400\" role=\"img\" aria-label=\"A still picture of frame " +
         std::to_string(frame.number) + "\">\n<path class=\"mesh\" d=\"" + path + "\"/>\n" + marks + "</svg>\n";
}

std::string plots_html(const Animation& animation) {
  const auto& frames = animation.frames();
  const double start = frames.front().time, length = frames.back().time - start;
  std::string html = "<div class=\"plots\">\n";
  std::size_t column = 0;
  for (std::size_t p = 0; p < animation.plots().size(); ++p) {
    const AnimationPlot& plot = animation.plots()[p];
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const AnimationFrame& frame : frames) {
      for (std::size_t s = 0; s < plot.series.size(); ++s) {
        low = std::min(low, frame.values[column + s]);
        high = std::max(high, frame.values[column + s]);
      }
    }
    html += fmt::format("<figure class=\"plotbox\" data-plot=\"{}\"><figcaption><span>{}, {:.4g} to {:.4g}</span>", p,
                        escaped(plot.title), low, high);
    std::string lines;
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
      const PlotSeries& series = plot.series[s];
      html += fmt::format("<span class=\"key series-{}\">{} <output></output></span>", s, escaped(series.name));
      lines += fmt::format("<polyline class=\"line series-{}\" vector-effect=\"non-scaling-stroke\" points=\"", s);
      for (const AnimationFrame& frame : frames) {
        const double x = length > 0 ? 1000 * ((frame.time - start) / length) : 500;
        lines += fmt::format("{:.1f},{:.2f} ", x, height_of(frame.values[column + s], low, high));
      }
      lines += "\"/>\n";
    }
    html += "</figcaption>\n<svg class=\"plot\" viewBox=\"0 -3 1000 106\" preserveAspectRatio=\"none\">\n" + lines +
            "</svg></figure>\n";
    column += plot.series.size();
  }
  return html + "</div>\n";
}

}  // namespace touchstone::view
