// The data of animations: rounding to the lattice, base64, frames that are left out, and text that stays text.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "view/animation.hpp"
#include "view/animation_view.hpp"
#include "view/frame_svg.hpp"
#include "view/lattice.hpp"
#include "view/pages/animation_page.hpp"
#include "view/pages/base64.hpp"
#include "view/surfaces.hpp"

using namespace touchstone::view;
using touchstone::MeshElement;

namespace {

/// One triangle and one edge.
AnimationShape small_shape() {
  AnimationShape shape;
  shape.groups = {{"", 3, 0, 1}, {"<b>\"body\"</b>", 2, 1, 0}};
  shape.faces = {{0, 1, 2}};
  shape.edges = {{3, 4}};
  shape.vertex_name = "particle";
  return shape;
}

std::vector<AnimationPlot> small_plots() { return {{"<i>energy</i>", {{"total"}, {"contacts", true}}}}; }

std::vector<double> positions(double height) { return {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, height, 1, 1, height}; }

}  // namespace

TEST_CASE("base64 of numbers, as the standard's own examples") {
  const std::string text = "foobar";
  const std::vector<std::string> encoded = {"",         "Zg==",     "Zm8=",    "Zm9v",
                                            "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};  // RFC 4648
  for (std::size_t n = 0; n <= text.size(); ++n) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(n));
    CHECK(base64_of(bytes.data(), n) == encoded[n]);
  }
  const std::vector<std::uint16_t> pair = {0x6f66, 0x626f};  // "foob", the low byte first
  CHECK(base64_of(pair.data(), 2) == "Zm9vYg==");
  const double one = 1;
  CHECK(base64_of(&one, 1) == "AAAAAAAA8D8=");
}

TEST_CASE("drawn coordinates are within half a step of the true ones, whatever the size and the place") {
  std::mt19937_64 random(20261123);
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    std::uniform_real_distribution<double> unit(-1, 1), power(-1000, 1000);
    const double size = std::exp2(power(random)), place = round % 3 == 0 ? 0 : std::exp2(power(random));
    std::vector<double> all;
    for (int i = 0; i < 30; ++i) all.push_back((i % 3 == 0 ? place : 0.0) + size * unit(random));
    const int least = round % 2 == 0 ? kAnyExponent : std::ilogb(size) - 10;
    const LatticePositions rounded = on_lattice(all, least);
    CHECK(rounded.exponent >= least);
    REQUIRE(rounded.steps.size() == all.size());
    const double step = std::ldexp(1.0, rounded.exponent);
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      double low = all[k], high = all[k];
      for (std::size_t i = k; i < all.size(); i += 3) {
        low = std::min(low, all[i]);
        high = std::max(high, all[i]);
        const double drawn = rounded.origin[k] + step * rounded.steps[i];
        // An ulp more, as the sum is rounded here.
        CHECK(std::abs(drawn - all[i]) <= 0.5 * step + std::abs(all[i]) * 0x1p-52);
      }
      extent = std::max(extent, high - low);
    }
    // The finest lattice that fits, unless a coarser one is asked for.
    if (least == kAnyExponent && place == 0) CHECK(extent > step * 32766);
  }
}

TEST_CASE("the largest doubles are drawn where sums and lengths do not overflow") {
  const double most = std::numeric_limits<double>::max();
  const LatticePositions rounded = on_lattice({-most, 0, 1, most, most, -1}, kAnyExponent);
  double squares = 0;
  for (std::size_t i = 0; i < rounded.steps.size(); ++i) {
    const double drawn = rounded.origin[i % 3] + std::ldexp(rounded.steps[i], rounded.exponent);
    REQUIRE(std::isfinite(drawn));
    squares = std::hypot(squares, drawn);
  }
  CHECK(std::isfinite(squares));
}

TEST_CASE("a vertex at rest keeps its drawn place while others move away") {
  int exponent = kAnyExponent;
  double before = 0;
  for (int i = 0; i < 20; ++i) {
    const LatticePositions rounded = on_lattice({0.1, 0, 0, 1 + 0.01 * i, 0, -0.003 * i}, exponent);
    const double drawn = rounded.origin[0] + std::ldexp(1.0, rounded.exponent) * rounded.steps[0];
    if (i > 0 && rounded.exponent == exponent) CHECK(drawn == before);
    exponent = rounded.exponent;
    before = drawn;
  }
  const LatticePositions still = on_lattice({5, 5, 5}, kAnyExponent);
  CHECK(still.origin[1] == 5);
  CHECK(still.steps == std::vector<std::uint16_t>{0, 0, 0});
}

TEST_CASE("of more frames than fit, every second one goes, the first and the last stay, and counts add up") {
  AnimationLimits limits;
  limits.frames = 10;
  for (const std::uint64_t frames : {1U, 2U, 9U, 10U, 11U, 12U, 37U, 160U, 161U}) {
    CAPTURE(frames);
    Animation animation(small_shape(), small_plots(), limits);
    for (std::uint64_t i = 0; i < frames; ++i) {
      animation.add_frame(0.5 * static_cast<double>(i), i, positions(static_cast<double>(i)),
                          {static_cast<double>(i), 1});
    }
    const auto& kept = animation.frames();
    CHECK(animation.frames_made() == frames);
    CHECK(kept.size() <= 10);
    CHECK(kept.size() >= std::min<std::size_t>(frames, 5));
    CHECK(kept.front().number == 0);
    CHECK(kept.back().number == frames - 1);
    double sum = 0;
    for (const AnimationFrame& frame : kept) {
      CHECK(frame.time == 0.5 * static_cast<double>(frame.number));
      CHECK(frame.exact == positions(static_cast<double>(frame.number)));
      CHECK(frame.values[0] == static_cast<double>(frame.number));
      sum += frame.values[1];
    }
    CHECK(sum == static_cast<double>(frames));
    for (std::size_t i = 2; i + 1 < kept.size(); ++i) {
      CHECK(kept[i].number - kept[i - 1].number == kept[1].number - kept[0].number);
    }
  }
}

TEST_CASE("what does not fit into a page is left out, and the page says so, what cannot fit is refused") {
  AnimationLimits limits;
  limits.exact_bytes = 5 * 24 * 3;
  limits.marks = 2;
  Animation animation(small_shape(), small_plots(), limits);
  for (std::uint64_t i = 0; i < 3; ++i) animation.add_frame(static_cast<double>(i), i, positions(1), {0, 0});
  CHECK(animation.has_exact());
  animation.add_frame(3, 3, positions(1), {0, 0});
  CHECK(!animation.has_exact());
  const auto pair = animation.pair({{MeshElement::edge, 0}, {MeshElement::face, 0}});
  for (int i = 0; i < 5; ++i) animation.add_mark({1.0, {0, 0, 0}, pair, MarkSort::contact});
  CHECK(animation.marks().size() == 2);
  CHECK(animation.marks_left_out() == 3);
  std::string text;
  write_animation_page(animation, {}, [&](std::string_view bytes) { text += bytes; });
  CHECK(text.find("3 marks are left out") != std::string::npos);
  CHECK(text.find("the page has those of the listed pairs") != std::string::npos);
  CHECK(text.find("exact-0") == std::string::npos);
  limits.frame_bytes = 5 * 6 * 2 - 1;
  CHECK_THROWS_AS(Animation(small_shape(), small_plots(), limits), touchstone::Error);
}

TEST_CASE("names of an animation are text, and elements are named by their part") {
  Animation animation(small_shape(), small_plots());
  animation.add_frame(0, 0, positions(1), {1, 0});
  animation.add_frame(1, 1, positions(2), {2, 1});
  CHECK(animation.name({MeshElement::vertex, 2}) == "particle 2");
  CHECK(animation.name({MeshElement::vertex, 4}) == "particle 1 of <b>\"body\"</b>");
  CHECK(animation.name({MeshElement::edge, 0}) == "edge 0 of <b>\"body\"</b>");
  const auto pair = animation.pair({{MeshElement::edge, 0}, {MeshElement::face, 0}});
  CHECK(pair == animation.pair({{MeshElement::edge, 0}, {MeshElement::face, 0}}));
  animation.add_story({1, {0, 0, 1}, pair, MarkSort::crossing, "<script>alert(1)</script>", "<p>html</p>"});
  std::string text;
  AnimationWords words;
  words.title = words.subtitle = words.summary = "</script><script>alert(2)</script>";
  write_animation_page(animation, words, [&](std::string_view bytes) { text += bytes; });
  CHECK(text.find("<script>alert") == std::string::npos);
  CHECK(text.find("<b>\"body\"") == std::string::npos);
  CHECK(text.find("<i>energy") == std::string::npos);
  CHECK(text.find("&lt;script&gt;alert(1)") != std::string::npos);
  CHECK(text.find("<p>html</p>") != std::string::npos);
  // The still picture has the triangle, the edge and the mark.
  CHECK(text.find("<path class=\"m\"") != std::string::npos);
  const std::string alone = moving_svg(animation, words.title, words.subtitle);
  CHECK(alone.find("<script>") == std::string::npos);
}

TEST_CASE("each surface and each named group has its hue, and what is at rest is pale") {
  AnimationShape shape;
  shape.groups = {{"", 9, 0, 2}, {"body", 4, 0, 0}};
  shape.faces = {{0, 1, 2}, {3, 4, 5}};
  shape.edges = {{6, 7}, {9, 10}, {11, 12}};
  std::vector<double> start(39, 0), end(39, 0);
  for (std::size_t v = 0; v < 13; ++v) start[3 * v] = end[3 * v] = static_cast<double>(v);
  for (const std::size_t v : {4U, 6U, 8U, 9U}) end[3 * v + 2] = 1;
  Animation animation(shape, {});
  animation.add_frame(0, 0, start, {});
  animation.add_frame(1, 1, end, {});
  // Vertex 8 is in no element, and takes no hue.
  CHECK(hues_of(animation) == std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1, 2, 2, 0, 3, 3, 3, 3});
  CHECK(shape.edges_without_face() == std::vector<std::uint32_t>{0, 1, 2});
  Animation at_rest(shape, {});
  at_rest.add_frame(0, 0, start, {});
  CHECK(hues_of(at_rest) == std::vector<std::uint8_t>{1, 1, 1, 2, 2, 2, 3, 3, 0, 4, 4, 4, 4});
  // A floor: more than twice as large as all else.
  start[0] = -20;
  Animation on_floor(shape, {});
  on_floor.add_frame(0, 0, start, {});
  CHECK(hues_of(on_floor) == std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1, 2, 2, 0, 3, 3, 3, 3});
}

TEST_CASE("a moving picture shows each frame once, from back to front, and only so many") {
  AnimationShape shape;
  shape.groups = {{"", 6, 0, 2}};
  shape.faces = {{3, 4, 5}, {0, 1, 2}};  // the second one is behind
  Animation animation(shape, {});
  for (std::uint64_t i = 0; i < 130; ++i) {
    const auto t = static_cast<double>(i);
    animation.add_frame(t, i, {-1, 0, 0, 1, 0, 0, 0, 0, 1, -1, -1, 0, 1, -1, 0, 0, -1, 1 + 0.01 * t}, {});
  }
  const std::string text = moving_svg(animation, "a & b", "");
  std::size_t frames = 0;
  for (std::size_t at = text.find("<g class=\"f"); at != std::string::npos; at = text.find("<g class=\"f", at + 1)) {
    ++frames;
  }
  CHECK(frames == 17);  // every eighth of 130
  CHECK(text.find("<title>a &amp; b</title>") != std::string::npos);
  CHECK(text.find("class=\"f s\"") == text.rfind("class=\"f s\""));  // the still one
  // Of each frame the face at y = 0 comes first: it moves not, and has the same text in all frames.
  const auto first = text.find("<path fill"), second = text.find("<path fill", first + 1);
  const std::string behind = text.substr(first, second - first);
  CHECK(behind.find('z') != std::string::npos);
  std::size_t same = 0;
  for (std::size_t at = text.find(behind); at != std::string::npos; at = text.find(behind, at + 1)) ++same;
  CHECK(same == frames);
}

TEST_CASE("lines and dots are as thick as their radii, to scale, and never thinner than others") {
  const auto widths = [](float radius) {
    AnimationShape shape;
    shape.groups = {{"", 3, 1, 0}};
    shape.edges = {{0, 1}};
    shape.points = {2};
    shape.radii = {radius, 2 * radius, radius};
    Animation animation(shape, {});
    animation.add_frame(0, 0, {-1, 0, 0, 1, 0, 0, 0, 0, 1}, {});
    const std::string text = moving_svg(animation, "", "");
    std::vector<long> found;
    const std::string start = "style=\"stroke-width:";
    for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
      found.push_back(std::stol(text.substr(at + start.size())));
    }
    return found;
  };
  CHECK(widths(0).empty());
  CHECK(widths(1e-4F).empty());
  const std::vector<long> thick = widths(0.05F), thicker = widths(0.1F);
  REQUIRE(thick.size() == 4);  // each with its rim
  REQUIRE(thicker.size() == 4);
  // The line is 2 long and holds the width of the picture; its lesser radius counts.
  CHECK(std::abs(static_cast<double>(thick[1]) - 0.05 * 0.92 * 1280) < 8);
  for (std::size_t i = 1; i < 4; i += 2) {
    CHECK(std::abs(thicker[i] - 2 * thick[i]) <= 1);
    CHECK(thick[i - 1] == thick[i] + 2);
  }
}

TEST_CASE("a moving picture says its times, and neighbours differ") {
  const auto said = [](double first, double last, const std::string& unit) {
    Animation animation(small_shape(), {});
    animation.add_frame(first, 0, positions(0), {});
    animation.add_frame(last, 1, positions(3), {});
    return moving_svg(animation, "", "", unit);
  };
  CHECK(said(0, 0.25, "s").find(">0.25 s</text>") != std::string::npos);
  CHECK(said(0, 1, "").find(">t = 1</text>") != std::string::npos);
  CHECK(said(1700000000.1, 1700000000.2, "").find(">t = 1700000000.2</text>") != std::string::npos);
  CHECK(said(5, 5, "").find(">t = 5</text>") != std::string::npos);
}

TEST_CASE("a picture in a plane is seen from above, and every first view is a rotation") {
  Animation flat(small_shape(), small_plots()), high(small_shape(), small_plots());
  flat.add_frame(0, 0, positions(0), {0, 0});
  high.add_frame(0, 0, positions(3), {0, 0});
  CHECK(view_of(flat).planar);
  CHECK(!view_of(high).planar);
  for (const AnimationView& view : {view_of(flat), view_of(high)}) {
    const auto& [r, u, t] = view.basis;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += view.basis[i][k] * view.basis[j][k];
        CHECK(std::abs(sum - (i == j ? 1 : 0)) < 1e-12);
      }
    }
    CHECK(std::abs(r[1] * u[2] - r[2] * u[1] - t[0]) < 1e-12);
  }
  CHECK(view_of(high).centre == Triple{0.5, 0.5, 1.5});
}
