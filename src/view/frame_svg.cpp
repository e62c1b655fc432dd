// SPDX-License-Identifier: MIT
#include "view/frame_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "view/flip_book.hpp"
#include "view/pages/html.hpp"
#include "view/surfaces.hpp"

namespace touchstone::view {
namespace {

constexpr std::size_t kMostDrawn = 5000;        // elements of a frame
constexpr std::size_t kMostInMotion = 400'000;  // elements of all frames of a moving picture
constexpr std::size_t kMostFrames = 32;
constexpr int kWide = 1280, kTall = 800;  // units of the picture: coordinates are rounded to them

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

/// Draws frames from back to front: what is nearer to the reader hides what is behind it.
class Painter {
 public:
  Painter(const Animation& animation, const AnimationView& view)
      : animation_(animation),
        view_(view),
        hues_(hues_of(animation)),
        bare_(animation.shape().edges_without_face()),
        scale_(0.92 *
               std::min(kWide / 2.0 / std::max(view.reach[0], 0.1), kTall / 2.0 / std::max(view.reach[1], 0.1))) {}

  std::size_t elements() const noexcept {
    return std::min(animation_.shape().faces.size(), kMostDrawn) + std::min(bare_.size(), kMostDrawn) +
           std::min(animation_.shape().points.size(), kMostDrawn);
  }

  std::string frame(std::size_t number) {
    const AnimationFrame& frame = animation_.frames()[number];
    const AnimationShape& shape = animation_.shape();
    seen_.resize(shape.vertex_count());
    for (std::size_t v = 0; v < seen_.size(); ++v) {
      seen_[v] = view_.seen(frame.drawn.position(v));
    }
    std::vector<Drawn> all;
    const auto every = [](std::size_t count) { return count / kMostDrawn + 1; };
    for (std::size_t i = 0; i < shape.faces.size(); i += every(shape.faces.size())) all.push_back(face(shape.faces[i]));
    // A line or a dot lies before the faces that it is in.
    for (std::size_t i = 0; i < bare_.size(); i += every(bare_.size())) {
      const auto& [a, b] = shape.edges[bare_[i]];
      add_line(all, a, b, "l", 4);
    }
    for (std::size_t i = 0; i < shape.points.size(); i += every(shape.points.size())) {
      add_line(all, shape.points[i], shape.points[i], "p", 12);
    }
    std::stable_sort(all.begin(), all.end(), [](const Drawn& a, const Drawn& b) { return a.height < b.height; });
    // Neighbours that look alike are one path.
    std::string text;
    const std::string* look = nullptr;
    for (const Drawn& one : all) {
      if (look == nullptr || *look != one.look) text += fmt::format("{}<path {} d=\"", look ? "\"/>\n" : "", one.look);
      look = &one.look;
      text += one.path;
    }
    if (look != nullptr) text += "\"/>\n";
    return text + marks(number);
  }

 private:
  struct Drawn {
    double height;           // towards the reader
    std::string look, path;  // attributes; what is drawn
  };

  static std::string name(const Colour& c) { return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]); }
  static Colour lit(const Colour& c, double light) {
    const auto channel = [&](std::uint8_t x) { return static_cast<std::uint8_t>(std::lround(x * light)); };
    return {channel(c[0]), channel(c[1]), channel(c[2])};
  }

  std::array<long, 2> on_page(const Triple& seen) const {
    static constexpr double kFar = 1e6;  // what is cut off may be as far away as doubles go
    const auto unit = [](double x) { return std::isnan(x) ? 0L : std::lround(std::clamp(x, -kFar, kFar)); };
    return {unit(kWide / 2.0 + scale_ * seen[0]), unit(kTall / 2.0 - scale_ * seen[1])};
  }
  /// From one vertex by others, in units of the picture.
  template <class... Vertices>
  std::string path_of(std::uint32_t first, Vertices... others) const {
    auto at = on_page(seen_[first]);
    std::string text = fmt::format("M{} {}", at[0], at[1]);
    for (const std::uint32_t v : {others...}) {
      const auto next = on_page(seen_[v]);
      text += fmt::format("l{} {}", next[0] - at[0], next[1] - at[1]);
      at = next;
    }
    return text;
  }

  /// A line, or a dot whose ends are equal: as thick as its radius, or `least` where that is less. A thick one has a
  /// rim, so that strands that cross are told apart; the rim ends with the line, which other lines go on from.
  void add_line(std::vector<Drawn>& all, std::uint32_t a, std::uint32_t b, const char* look, long least) const {
    const double height = std::max(seen_[a][2], seen_[b][2]);
    const Colour& hue = kHues[hues_[a]];
    const long width = std::lround(2 * scale_ / view_.radius * animation_.shape().radius(a, b));
    const std::string path = path_of(a, b);
    if (width <= least) {
      all.push_back({height, fmt::format("class=\"{}\" stroke=\"{}\"", look, name(lit(hue, 0.8))), path});
      return;
    }
    const std::string style = fmt::format("class=\"{}\" style=\"stroke-width:", look);
    const char* const cap = a == b ? "" : ";stroke-linecap:butt";
    all.push_back({height, fmt::format("{}{}{}\" stroke=\"{}\"", style, width + 2, cap, name(lit(hue, 0.55))), path});
    all.push_back({height, fmt::format("{}{}\" stroke=\"{}\"", style, width, name(lit(hue, 0.95))), path});
  }

  /// Lit as the page's script does it.
  Drawn face(const std::array<std::uint32_t, 3>& corners) const {
    const Triple &a = seen_[corners[0]], &b = seen_[corners[1]], &c = seen_[corners[2]];
    const Triple u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    Triple n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double size = std::max(std::hypot(n[0], n[1], n[2]), std::numeric_limits<double>::min());
    const double side = n[2] < 0 ? -1 / size : 1 / size;
    const double light = std::min(
        1.0, 0.65 + side * (0.1 * (view_.basis[0][2] * n[0] + view_.basis[1][2] * n[1] + view_.basis[2][2] * n[2])) +
                 0.35 * std::max(0.0, side * (-0.3 * n[0] + 0.5 * n[1] + 0.81 * n[2])));
    // A floor is large, and lies behind what is on it: what is at rest counts by its farthest corner.
    const std::uint8_t hue = hues_[corners[0]];
    const std::string fill = fmt::format("fill=\"{}\"", name(lit(kHues[hue], light)));
    const std::string path = path_of(corners[0], corners[1], corners[2]) + "z";
    if (hue != 0) return {(a[2] + b[2] + c[2]) / 3, fill, path};
    return {std::min({a[2], b[2], c[2]}), fmt::format("{} class=\"r\" style=\"--light:{:.2f}\"", fill, light), path};
  }

  /// Of the pairs that are listed, and meet after the frame before.
  std::string marks(std::size_t number) const {
    const auto& frames = animation_.frames();
    const double before = number == 0 ? -std::numeric_limits<double>::infinity() : frames[number - 1].time;
    std::string text;
    std::size_t drawn = 0;
    for (const AnimationStory& story : animation_.stories()) {
      if (!(story.time > before && story.time <= frames[number].time) || ++drawn > kMostDrawn) continue;
      const auto [x, y] = on_page(view_.seen(story.point));
      text += fmt::format("<path class=\"m\" d=\"M{} {}h0\"/>\n", x, y);
    }
    return text;
  }

  const Animation& animation_;
  const AnimationView& view_;
  std::vector<std::uint8_t> hues_;
  std::vector<std::uint32_t> bare_;
  double scale_;
  std::vector<Triple> seen_;
};

}  // namespace

std::string still_of(const Animation& animation, const AnimationView& view) {
  const std::size_t shown = frame_of_still(animation);
  return fmt::format(
      "<svg class=\"still frame\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"A still picture of frame {}\">\n"
      "{}</svg>\n",
      kWide, kTall, animation.frames()[shown].number, Painter(animation, view).frame(shown));
}

std::string moving_svg(const Animation& animation, const std::string& title, const std::string& about,
                       const std::string& unit) {
  const AnimationView view = view_of(animation);
  Painter painter(animation, view);
  const std::size_t frames = animation.frames().size(), still = frame_of_still(animation);
  std::size_t stride = 1;
  while ((frames - 1) / stride + 1 > kMostFrames || ((frames - 1) / stride + 1) * painter.elements() > kMostInMotion) {
    stride *= 2;
    if (stride >= frames) break;
  }
  const std::size_t shown = (frames - 1) / stride + 1;
  FlipBook book;
  book.width = kWide;
  book.height = kTall;
  book.title = title;
  book.about = about;
  book.attributes = " class=\"frame\"";
  book.style = page_file("colours.css") + page_file("frame.css");
  book.still = still / stride;
  // Neighbours differ in what is written, also where times are far from 0, as those of a clock.
  const double first = animation.frames().front().time, last = animation.frames().back().time;
  const double ratio = std::max(std::abs(first), std::abs(last)) / (last - first);
  const int digits = 4 + (std::isfinite(ratio) && ratio > 1 ? std::min(13, static_cast<int>(std::log10(ratio))) : 0);
  for (std::size_t k = 0; k < shown; ++k) {
    const double time = animation.frames()[k * stride].time;
    const std::string at = fmt::format("{:.{}g}", time, digits);
    const std::string told = unit.empty() ? "t = " + at : at + " " + unit;
    book.frames.push_back(painter.frame(k * stride) +
                          fmt::format("<text x=\"24\" y=\"{}\">{}</text>\n", kTall - 24, escaped(told)));
  }
  return svg_file(book);
}

}  // namespace touchstone::view
