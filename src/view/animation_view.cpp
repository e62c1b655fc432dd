// SPDX-License-Identifier: MIT
#include "view/animation_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "view/pages/html.hpp"
#include "view/surfaces.hpp"

namespace touchstone::view {

namespace {

constexpr double kMuchLarger = 2;  // what is at rest is cut off, like a floor, if all is so many times larger
constexpr double kSubject = 20;    // where nothing moves, what is so many times larger is no floor

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

/// In all frames, of the vertices that are chosen.
Box box_of(const Animation& animation, const std::vector<char>& chosen) {
  Box box;
  for (const AnimationFrame& frame : animation.frames()) {
    for (std::size_t i = 0; i < frame.drawn.steps.size(); ++i) {
      if (chosen[i / 3] != 0) box.add(frame.drawn.coordinate(i / 3, i % 3), i % 3);
    }
  }
  if (!(box.low[0] <= box.high[0])) box.low = box.high = {};
  return box;
}

/// x from `low` to `high` as a height in a plot, from 100 down to 0.
double height_of(double x, double low, double high) {
  if (high > low) return 100 - 100 * (x - low) / (high - low);
  return x == 0 ? 100 : 50;
}

}  // namespace

Triple AnimationView::seen(const Triple& x) const noexcept {
  Triple d, turned{};
  for (std::size_t k = 0; k < 3; ++k) d[k] = (x[k] - centre[k]) / radius;
  for (std::size_t k = 0; k < 3; ++k) turned[k] = d[0] * basis[k][0] + d[1] * basis[k][1] + d[2] * basis[k][2];
  return turned;
}

AnimationView view_of(const Animation& animation) {
  const std::vector<std::uint8_t> hues = hues_of(animation);
  std::vector<char> coloured(hues.size());
  std::transform(hues.begin(), hues.end(), coloured.begin(), [](std::uint8_t hue) { return hue == 0 ? 0 : 1; });
  const std::vector<char> all(hues.size(), 1);
  const bool any = std::count(coloured.begin(), coloured.end(), 1) > 0;
  const Box of_all = box_of(animation, all), of_coloured = any ? box_of(animation, coloured) : of_all;
  const std::vector<char> moves = moving_vertices(animation);
  const bool at_rest = std::count(moves.begin(), moves.end(), 1) == 0;
  const bool whole = of_all.radius() <= kMuchLarger * of_coloured.radius() ||
                     (at_rest && of_all.radius() > kSubject * of_coloured.radius());
  const Box& box = whole ? of_all : of_coloured;
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
    for (std::size_t i = 0; i < coloured.size(); ++i) {
      if (!whole && coloured[i] == 0) continue;
      const Triple seen = view.seen(frame.drawn.position(i));
      for (std::size_t k = 0; k < 2; ++k) view.reach[k] = std::max(view.reach[k], std::abs(seen[k]));
    }
  }
  return view;
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
      double before = 0;
      for (std::size_t i = 0; i < frames.size(); ++i) {
        const double x = length > 0 ? 1000 * ((frames[i].time - start) / length) : 500;
        const double y = height_of(frames[i].values[column + s], low, high);
        // What adds up belongs to all the time since the frame before: no slope leads to it.
        if (series.adds_up && i > 0) lines += fmt::format("{:.1f},{:.2f} ", before, y);
        lines += fmt::format("{:.1f},{:.2f} ", x, y);
        before = x;
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
