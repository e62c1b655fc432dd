// SPDX-License-Identifier: MIT
#include "view/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "view/pages/html.hpp"

namespace touchstone::view {
namespace {

constexpr double kChartWidth = 560, kChartHeight = 320;  // of one chart

// Of the area for points. A label finds room above it, and half a number of the axis on its right.
constexpr double kLeft = 62, kRight = 530, kTop = 46, kBottom = 268;

constexpr double kTitleHeight = 64, kLegendRow = 24;  // the title of a file, and one row of the legend
constexpr double kLetter = 8;                         // no letter of chart.css is wider, in the mean over a name

/// Values on a line, from one end to another in the picture, and where labels stand.
class Scale {
 public:
  using Ticks = std::vector<std::pair<double, std::string>>;

  /// A scale with its ticks. @param least, most  the values; least > most: there are none
  static Scale of(const ChartAxis& axis, double least, double most, double from, double to) {
    if (!axis.names.empty()) {
      Scale scale(-0.5, static_cast<double>(axis.names.size()) - 0.5, from, to, false);
      for (std::size_t i = 0; i < axis.names.size(); ++i) scale.tick(static_cast<double>(i), axis.names[i]);
      return scale;
    }
    if (least > most) least = most = 1;
    return axis.logarithmic ? decades(least, most, from, to) : even_steps(least, most, from, to);
  }

  double at(double value) const {
    const double x = logarithmic_ ? std::log10(value) : std::clamp(value, low_, high_);
    return from_ + (x - low_) / (high_ - low_) * (to_ - from_);
  }
  const Ticks& ticks() const { return ticks_; }

 private:
  Scale(double low, double high, double from, double to, bool logarithmic)
      : low_(low), high_(high), from_(from), to_(to), logarithmic_(logarithmic) {}

  void tick(double value, const std::string& text) { ticks_.emplace_back(at(value), text); }

  /// Whole decades around the values.
  static Scale decades(double least, double most, double from, double to) {
    const int low = static_cast<int>(std::floor(std::log10(least)));
    const int high = std::max(static_cast<int>(std::ceil(std::log10(most))), low + 1);
    Scale scale(low, high, from, to, true);
    for (int e = low; e <= high; e += (high - low + 7) / 8) {
      scale.ticks_.emplace_back(from + (e - low) * (to - from) / (high - low),
                                e >= -3 && e <= 4 ? fmt::format("{:g}", std::pow(10.0, e)) : fmt::format("1e{}", e));
    }
    return scale;
  }

  /// Steps of 1, 2 or 5 times a power of ten, about six of them.
  static Scale even_steps(double least, double most, double from, double to) {
    // So few steps from 0 that each has another number, also where all values are equal but for their rounding.
    constexpr double kLargest = 3e307;  // the difference of two ends, a step farther out, is a double
    least = std::clamp(least, -kLargest, kLargest), most = std::clamp(most, -kLargest, kLargest);
    const double largest = std::max(std::abs(least), std::abs(most));
    const double size = largest > 0 ? std::max(largest, 1e-290) : 1;
    if (!(most - least > 1e-9 * size)) most = least + size;
    const double power = std::pow(10.0, std::floor(std::log10((most - least) / 3)));
    const double step = power * ((most - least) / power > 15 ? 5 : (most - least) / power > 6 ? 2 : 1);
    const double low = std::floor(least / step), high = std::ceil(most / step);
    Scale scale(low * step, high * step, from, to, false);
    for (double k = low; k <= high; k += 1) scale.tick(k * step, fmt::format("{:.6g}", k * step + 0.0));
    return scale;
  }

  double low_, high_, from_, to_;
  bool logarithmic_;
  Ticks ticks_;
};

std::string text_at(double x, double y, const char* anchor, const std::string& text, const char* sort = "") {
  return fmt::format("<text{} x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", sort, x, y, anchor,
                     escaped(text));
}

/// The look of a series as the path of one point.
std::string shape_at(const ChartSeries& series, double x, double y) {
  const double r = series.own ? 7 : 5.5;
  const auto path = [&](const std::vector<std::pair<double, double>>& corners) {
    std::string text;
    for (const auto& [a, b] : corners) {
      text += fmt::format("{}{:.1f},{:.1f}", text.empty() ? "M" : "L", x + a * r, y + b * r);
    }
    return text + "z";
  };
  switch (series.shape) {
    case 1: return path({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case 2: return path({{-1.1, 0.8}, {1.1, 0.8}, {0, -1.1}});
    case 3: return path({{-1.2, 0}, {0, -1.2}, {1.2, 0}, {0, 1.2}});
    case 4: return path({{-1.1, -0.8}, {1.1, -0.8}, {0, 1.1}});
    default: return fmt::format("M{0:.1f},{1:.1f}a{2},{2} 0 1,0 {3},0a{2},{2} 0 1,0 -{3},0z", x - r, y, r, 2 * r);
  }
}

/// An element's class for the look of a series.
std::string look_of(const ChartSeries& series, const char* sort) {
  return fmt::format("class=\"{} k{}{}{}\"", sort, series.colour, series.hollow ? " hollow" : "",
                     series.own ? " own" : "");
}

/// The points of a chart in the picture.
class ChartPainter {
 public:
  explicit ChartPainter(const Chart& chart)
      : chart_(chart), zero_(has_zero() ? kBottom - 12 : kBottom), across_(scale_across()), up_(scale_up()) {}

  std::string grid() const {
    std::string text;
    for (const auto& [x, name] : across_.ticks()) {
      text += fmt::format("<path class=\"grid\" d=\"M{:.1f} {}V{}\"/>\n", x, kTop, kBottom);
      text += text_at(x, kBottom + 16, "middle", name);
    }
    for (const auto& [y, name] : up_.ticks()) {
      text += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, y, kRight);
      text += text_at(kLeft - 6, y + 4, "end", name);
    }
    if (!has_zero()) return text;
    return text + fmt::format("<path class=\"grid none\" d=\"M{} {}H{}\"/>\n", kLeft, zero_, kRight) +
           text_at(kLeft - 6, zero_ + 4, "end", "0");
  }

  std::string lines() const {
    std::string text;
    for (const ChartSeries& series : chart_.series) {
      if (!series.line) continue;
      std::string path;
      bool broken = true;
      for (const ChartPoint& point : series.points) {
        if (is_drawn(point)) {
          // A way of no length, so that a point alone is seen.
          path += fmt::format("{0}{1:.1f} {2:.1f}{3}", broken ? "M" : "L", across_.at(point.x), height_of(point),
                              broken ? "h0" : "");
        }
        broken = !is_drawn(point);
      }
      text += fmt::format("<path {} d=\"{}\"/>\n", look_of(series, "line"), path);
    }
    return text;
  }

  std::string dots(bool own) const {
    std::string text;
    for (const ChartSeries& series : chart_.series) {
      if (!series.marks || series.own != own) continue;
      for (const ChartPoint& point : series.points) {
        if (!is_drawn(point)) continue;
        text += fmt::format("<path {} d=\"{}\"", look_of(series, point.faint ? "dot faint" : "dot"),
                            shape_at(series, across_.at(point.x), height_of(point)));
        if (!point.row.empty()) text += fmt::format(" tabindex=\"0\" data-row=\"{}\"", escaped(point.row));
        text += point.told.empty() ? "/>\n" : fmt::format("><title>{}</title></path>\n", escaped(point.told));
      }
    }
    return text;
  }

  /// Labels of others that find no room are left out.
  std::string labels() const {
    std::vector<Taken> taken;
    for (const ChartSeries& series : chart_.series) {
      for (const ChartPoint& point : series.points) {
        const double x = across_.at(point.x);
        if (series.marks && is_drawn(point)) taken.push_back({x - 4, x + 4, height_of(point), &point});
      }
    }
    std::string text;
    for (const bool own : {true, false}) {
      for (const ChartSeries& series : chart_.series) {
        for (const ChartPoint& point : series.points) {
          if (series.own == own && is_drawn(point) && !point.label.empty()) text += label_of(point, own, taken);
        }
      }
    }
    return text;
  }

 private:
  /// What a point or a label covers.
  struct Taken {
    double left, right, middle;
    const ChartPoint* point;  ///< null: a label
  };

  static bool is_drawn(const ChartPoint& point) { return point.y && std::isfinite(*point.y); }

  bool has_zero() const {
    return chart_.y.logarithmic &&
           std::any_of(chart_.series.begin(), chart_.series.end(), [](const ChartSeries& series) {
             return std::any_of(series.points.begin(), series.points.end(),
                                [](const ChartPoint& p) { return p.y == 0; });
           });
  }

  Scale scale_across() const {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const ChartSeries& series : chart_.series) {
      for (const ChartPoint& point : series.points) {
        least = std::min(least, point.x);
        most = std::max(most, point.x);
      }
    }
    // A point that lies on the edge of the picture would be cut.
    const double less = chart_.x.logarithmic ? least / 1.3 : least, more = chart_.x.logarithmic ? most * 1.6 : most;
    return Scale::of(chart_.x, less, more, kLeft, kRight);
  }

  Scale scale_up() const {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const ChartSeries& series : chart_.series) {
      for (const ChartPoint& point : series.points) {
        if (!is_drawn(point) || (chart_.y.logarithmic && *point.y == 0)) continue;
        least = std::min(least, *point.y);
        most = std::max(most, *point.y);
      }
    }
    return Scale::of(chart_.y, least, most, has_zero() ? kBottom - 40 : kBottom, kTop);
  }

  double height_of(const ChartPoint& point) const {
    return chart_.y.logarithmic && *point.y == 0 ? zero_ : up_.at(*point.y);
  }

  /// Above the point. Our own label may stand beside its point, and where no room is left it lies over the others.
  std::string label_of(const ChartPoint& point, bool own, std::vector<Taken>& taken) const {
    const double half = kLetter * static_cast<double>(point.label.size()) / 2;
    const double x = across_.at(point.x), y = height_of(point);
    const double above = std::max(kLeft + 4, std::min(kRight - 2 * half - 4, x - half)) + half;
    const std::array<std::array<double, 2>, 3> middles{{{above, y - 14}, {x + half + 12, y}, {x - half - 12, y}}};
    for (std::size_t i = 0; i < (own ? middles.size() : 1); ++i) {
      const auto [across, height] = middles[i];
      const Taken room{across - half, across + half, height, nullptr};
      const bool fits = i == 0 || (room.left > kLeft && room.right < kRight);
      const bool free = fits && std::none_of(taken.begin(), taken.end(), [&](const Taken& other) {
                          return other.point != &point && other.right > room.left && other.left < room.right &&
                                 std::abs(other.middle - room.middle) < 14;
                        });
      if (!free) continue;
      taken.push_back(room);
      return text_at(across, height + 4, "middle", point.label);
    }
    return own ? text_at(above, y - 10, "middle", point.label) : std::string();
  }

  const Chart& chart_;
  double zero_;  ///< the height of the line of y = 0 on a logarithmic axis
  Scale across_, up_;
};

std::string content_of(const Chart& chart) {
  const ChartPainter painter(chart);
  const std::string title = chart.y.label.empty() ? chart.title : chart.title + " [" + chart.y.label + "]";
  return text_at(kLeft, 16, "start", title) + painter.grid() + painter.lines() + painter.dots(false) +
         painter.dots(true) + painter.labels() + text_at((kLeft + kRight) / 2, 308, "middle", chart.x.label);
}

/// Whether the first chart has every series by name: one legend is that of all.
bool first_has_all_series(const std::vector<Chart>& charts) {
  const auto is_first = [&](const ChartSeries& series) {
    return std::any_of(charts[0].series.begin(), charts[0].series.end(),
                       [&](const ChartSeries& other) { return other.name == series.name; });
  };
  return std::all_of(charts.begin(), charts.end(), [&](const Chart& chart) {
    return std::all_of(chart.series.begin(), chart.series.end(), is_first);
  });
}

/// The names of the series in rows: those of the first chart, or of each chart by itself. Adds the height of the rows
/// to `height`.
std::string legend_of(const std::vector<Chart>& charts, double width, double& height) {
  constexpr double kMargin = 20;
  std::string text;
  const bool shared = first_has_all_series(charts);
  for (std::size_t i = 0; i < (shared ? 1 : charts.size()); ++i) {
    double left = kMargin;
    height += kLegendRow;
    if (!shared) {
      text += text_at(left, height - kLegendRow / 2 + 4, "start", charts[i].title + ":");
      left += kLetter * static_cast<double>(charts[i].title.size()) + kMargin;
    }
    for (const ChartSeries& series : charts[i].series) {
      const double wide = 50 + kLetter * static_cast<double>(series.name.size());
      if (left + wide > width && left > kMargin) {
        left = kMargin;
        height += kLegendRow;
      }
      const double y = height - kLegendRow / 2;
      if (series.line) text += fmt::format("<path {} d=\"M{} {}h28\"/>\n", look_of(series, "line"), left, y);
      if (series.marks)
        text += fmt::format("<path {} d=\"{}\"/>\n", look_of(series, "key"), shape_at(series, left + 14, y));
      text += text_at(left + 36, y + 4, "start", series.name);
      left += wide;
    }
  }
  return text;
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  double height = kChartHeight;
  const std::string legend = chart.series.size() > 1 ? legend_of({chart}, kChartWidth, height) : "";
  return fmt::format("<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} against {}\">\n",
                     kChartWidth, height, escaped(chart.title), escaped(chart.x.label)) +
         content_of(chart) + legend + "</svg>\n";
}

std::string chart_file(const std::string& title, const std::string& subtitle, const std::vector<Chart>& charts) {
  const std::size_t columns = charts.size() > 1 ? 2 : 1;
  const double width = kChartWidth * static_cast<double>(columns);
  double height =
      kTitleHeight + kChartHeight * std::ceil(static_cast<double>(charts.size()) / static_cast<double>(columns));
  std::string body = text_at(kLeft, 26, "start", title, " class=\"title\"") + text_at(kLeft, 46, "start", subtitle);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    body += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", kChartWidth * static_cast<double>(i % columns),
                        kTitleHeight + kChartHeight * static_cast<double>(i / columns), content_of(charts[i]));
  }
  body += legend_of(charts, width, height);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart file\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
             "height=\"{1}\" role=\"img\">\n<title>{2}</title>\n<style>\n",
             width, height + 8, escaped(title)) +
         page_file("colours.css") + page_file("chart.css") +
         "</style>\n<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n" + body + "</svg>\n";
}

}  // namespace touchstone::view
