// SPDX-License-Identifier: MIT
#include "view/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "view/pages/html.hpp"

namespace touchstone::view {
namespace {

constexpr double kLeft = 62, kRight = 548, kTop = 34, kBottom = 268;  // of the area for points, in an SVG of 560 x 320

/// Whole decades around some values, as an axis from one end to another in the picture.
class Axis {
 public:
  Axis(double least, double most, double from, double to)
      : low_(static_cast<int>(std::floor(std::log10(least)))),
        high_(std::max(static_cast<int>(std::ceil(std::log10(most))), low_ + 1)),
        from_(from),
        to_(to) {}

  double at(double x) const { return from_ + (std::log10(x) - low_) / (high_ - low_) * (to_ - from_); }
  int low() const { return low_; }
  int high() const { return high_; }
  int step() const { return (high_ - low_ + 7) / 8; }  ///< decades from one label to the next

 private:
  int low_, high_;
  double from_, to_;
};

std::string power(int exponent) {
  if (exponent >= -3 && exponent <= 4) return fmt::format("{:g}", std::pow(10.0, exponent));
  return fmt::format("1e{}", exponent);
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, text);
}

}  // namespace

std::string scatter_svg(const std::vector<ScatterPoint>& points, const ScatterAxes& axes) {
  double fastest = 1, slowest = 1, least = 0, most = 0;
  for (const ScatterPoint& p : points) {
    const bool first = &p == &points.front();
    fastest = first ? p.x : std::min(fastest, p.x);
    slowest = first ? p.x : std::max(slowest, p.x);
    if (p.y > 0) least = least == 0 ? p.y : std::min(least, p.y);
    most = std::max(most, p.y);
  }
  if (most == 0) least = most = 1;
  const double zero = kBottom - 12;  // the line of no error
  const Axis across(fastest / 1.3, slowest * 1.6, kLeft, kRight), up(least, most, kBottom - 40, kTop);
  std::string grid, dots, own_dots, labels;
  for (int e = across.low(); e <= across.high(); e += across.step()) {
    const double x = across.at(std::pow(10.0, e));
    grid += fmt::format("<path class=\"grid\" d=\"M{:.1f} {}V{}\"/>\n", x, kTop, kBottom);
    grid += text_at(x, kBottom + 16, "middle", power(e));
  }
  for (int e = up.low(); e <= up.high(); e += up.step()) {
    const double y = up.at(std::pow(10.0, e));
    grid += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, y, kRight);
    grid += text_at(kLeft - 6, y + 4, "end", power(e));
  }
  grid += fmt::format("<path class=\"grid none\" d=\"M{} {}H{}\"/>\n", kLeft, zero, kRight);
  grid += text_at(kLeft - 6, zero + 4, "end", "0");
  std::vector<std::pair<double, double>> taken;
  for (const ScatterPoint& p : points) taken.emplace_back(across.at(p.x), p.y > 0 ? up.at(p.y) : zero);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Labels that find no room are left out: our own point comes first.
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return points[i].own; });
  for (const std::size_t i : order) {
    const ScatterPoint& p = points[i];
    const auto [x, y] = taken[i];
    (p.own ? own_dots : dots) += fmt::format(
        "<circle class=\"dot{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" tabindex=\"0\" data-row=\"{}\">"
        "<title>{}</title></circle>\n",
        p.own ? " own" : "", x, y, p.own ? 7 : 5.5, escaped(p.row), escaped(p.told));
    const double width = 6.2 * static_cast<double>(p.label.size());
    const double left = std::max(kLeft + 4, std::min(kRight - width - 4, x - width / 2)), above = y - 10;
    const bool free = std::none_of(taken.begin(), taken.end(), [&, x = x, y = y](const auto& other) {
      const bool same = other.first == x && other.second == y;
      return !same && other.first > left - 8 && other.first < left + width + 8 &&
             std::abs(other.second - above + 4) < 14;
    });
    if (!free) continue;
    labels += text_at(left + width / 2, above, "middle", escaped(p.label));
    taken.emplace_back(left + 4, above - 4);
    taken.emplace_back(left + width / 2, above - 4);
    taken.emplace_back(left + width - 4, above - 4);
  }
  return fmt::format("<svg class=\"scatter\" viewBox=\"0 0 560 320\" role=\"img\" aria-label=\"{} against {}\">\n",
                     escaped(axes.title), escaped(axes.x)) +
         text_at(kLeft, 16, "start", escaped(axes.title + " [" + axes.y + "]")) + grid + dots + own_dots + labels +
         text_at((kLeft + kRight) / 2, 312, "middle", escaped(axes.x)) + "</svg>\n";
}

}  // namespace touchstone::view
