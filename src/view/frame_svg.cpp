// SPDX-License-Identifier: MIT
#include "view/frame_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "view/pages/html.hpp"
#include "view/surfaces.hpp"

namespace touchstone::view {
namespace {

constexpr std::size_t kMostDrawn = 5000;        // elements of a frame
constexpr std::size_t kMostInMotion = 400'000;  // elements of all frames of a moving picture
constexpr std::size_t kMostFrames = 32;
constexpr double kWide = 1280, kTall = 800;  // units of the picture: coordinates are rounded to them
constexpr double kSecondsPerFrame = 0.1;

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
        scale_(0.92 * std::min(kWide / 2 / std::max(view.reach[0], 0.1), kTall / 2 / std::max(view.reach[1], 0.1))) {}

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
      all.push_back({std::max(seen_[a][2], seen_[b][2]),
                     fmt::format("class=\"l\" stroke=\"{}\"", name(lit(kHues[hues_[a]], 0.8))), path_of(a, b)});
    }
    for (std::size_t i = 0; i < shape.points.size(); i += every(shape.points.size())) {
      const std::uint32_t v = shape.points[i];
      all.push_back(
          {seen_[v][2], fmt::format("class=\"p\" stroke=\"{}\"", name(lit(kHues[hues_[v]], 0.8))), path_of(v, v)});
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
    return {unit(kWide / 2 + scale_ * seen[0]), unit(kTall / 2 - scale_ * seen[1])};
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

  /// Lit from above, as the page's script does.
  Drawn face(const std::array<std::uint32_t, 3>& corners) const {
    const Triple &a = seen_[corners[0]], &b = seen_[corners[1]], &c = seen_[corners[2]];
    const Triple u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    Triple n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double size = std::max(std::hypot(n[0], n[1], n[2]), std::numeric_limits<double>::min());
    const double side = n[2] < 0 ? -1 / size : 1 / size;
    const double light = 0.45 + 0.55 * std::max(0.0, side * (-0.3 * n[0] + 0.5 * n[1] + 0.81 * n[2]));
    // A floor is large, and lies behind what is on it: what is at rest counts by its farthest corner.
    const std::uint8_t hue = hues_[corners[0]];
    return {hue == 0 ? std::min({a[2], b[2], c[2]}) : (a[2] + b[2] + c[2]) / 3,
            fmt::format("fill=\"{}\"", name(lit(kHues[hue], std::min(light, 1.0)))),
            path_of(corners[0], corners[1], corners[2]) + "z"};
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
      "<svg class=\"still\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"A still picture of frame {}\">\n"
      "{}</svg>\n",
      kWide, kTall, animation.frames()[shown].number, Painter(animation, view).frame(shown));
}

std::string moving_svg(const Animation& animation, const std::string& title) {
  const AnimationView view = view_of(animation);
  Painter painter(animation, view);
  const std::size_t frames = animation.frames().size(), still = frame_of_still(animation);
  std::size_t stride = 1;
  while ((frames - 1) / stride + 1 > kMostFrames || ((frames - 1) / stride + 1) * painter.elements() > kMostInMotion) {
    stride *= 2;
    if (stride >= frames) break;
  }
  const std::size_t shown = (frames - 1) / stride + 1;
  const double length = kSecondsPerFrame * static_cast<double>(shown);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\">\n<title>{}</title>\n"
      "<style>path{{stroke-linejoin:round;stroke-linecap:round}}path[fill]{{stroke:#0003}}.l{{fill:none;stroke-width:4}"
      "}\n"
      ".p{{stroke-width:12}}.m{{stroke:#a8487f;stroke-width:14}}\n"
      ".f{{visibility:hidden;animation:show {:.2f}s steps(1) infinite}}.s{{visibility:visible}}\n"
      "@keyframes show{{0%{{visibility:visible}}{:.4f}%{{visibility:hidden}}100%{{visibility:hidden}}}}\n"
      "@media(prefers-reduced-motion:reduce){{.f{{animation:none}}}}</style>\n",
      kWide, kTall, escaped(title), length, 100 / static_cast<double>(shown));
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t number = k * stride;
    text += fmt::format("<g class=\"f{}\" style=\"animation-delay:{:.2f}s\">\n{}</g>\n",
                        number == still / stride * stride ? " s" : "",
                        kSecondsPerFrame * static_cast<double>(k) - length, painter.frame(number));
  }
  return text + "</svg>\n";
}

}  // namespace touchstone::view
