// SPDX-License-Identifier: MIT
#include "view/pages/animation_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <type_traits>

#include "view/animation_view.hpp"
#include "view/frame_svg.hpp"
#include "view/pages/base64.hpp"
#include "view/surfaces.hpp"

namespace touchstone::view {
namespace {

std::string bytes_for_person(double bytes) {
  if (bytes < 1 << 20) return fmt::format("{:.0f} KiB", bytes / 1024);
  return fmt::format("{:.1f} MiB", bytes / (1 << 20));
}

/// A script element that holds numbers.
template <class Number>
void write_numbers(const Sink& sink, const std::string& id, const Number* numbers, std::size_t count) {
  sink("<script type=\"text/plain\" id=\"" + id + "\">");
  sink(base64_of(numbers, count));
  sink("</script>\n");
}
template <class Number>
void write_numbers(const Sink& sink, const std::string& id, const std::vector<Number>& numbers) {
  write_numbers(sink, id, numbers.data(), numbers.size());
}

const char* sort_name(MarkSort sort) {
  switch (sort) {
    case MarkSort::close: return "close";
    case MarkSort::contact: return "contact";
    case MarkSort::crossing: break;
  }
  return "crossing";
}

nlohmann::json data_of(const Animation& animation, const AnimationWords& words, const AnimationView& view) {
  nlohmann::json data;
  data["vertexName"] = animation.shape().vertex_name;
  data["edgesHaveNumbers"] = animation.shape().edges_have_numbers;
  data["facesHaveNumbers"] = !animation.shape().face_numbers.empty();
  data["crossing"] = words.crossing;
  data["unit"] = words.time_unit;
  data["number"] = words.number;
  data["centre"] = view.centre;
  data["radius"] = view.radius;
  data["reach"] = view.reach;
  data["planar"] = view.planar;
  data["basis"] = view.basis;
  data["hues"] = kHues;
  data["exact"] = animation.has_exact();
  data["vertices"] = animation.shape().vertex_count();
  data["parts"] = nlohmann::json::array();
  for (const AnimationGroup& group : animation.shape().groups) {
    data["parts"].push_back({{"name", group.name},
                             {"vertices", group.vertices},
                             {"edges", group.edges},
                             {"faces", group.faces},
                             {"firstNumber", group.first_number}});
  }
  for (const char* key : {"times", "numbers", "labels", "exponents", "origins", "plots", "stories"}) {
    data[key] = nlohmann::json::array();
  }
  for (const AnimationFrame& frame : animation.frames()) {
    data["times"].push_back(frame.time);
    data["numbers"].push_back(frame.number);
    data["labels"].push_back(frame.label);
    data["exponents"].push_back(frame.drawn.exponent);
    data["origins"].push_back(frame.drawn.origin);
  }
  std::size_t column = 0;
  for (const AnimationPlot& plot : animation.plots()) {
    nlohmann::json series = nlohmann::json::array();
    for (std::size_t s = 0; s < plot.series.size(); ++s, ++column) {
      nlohmann::json values = nlohmann::json::array();
      for (const AnimationFrame& frame : animation.frames()) values.push_back(frame.values[column]);
      series.push_back(std::move(values));
    }
    data["plots"].push_back(std::move(series));
  }
  for (const AnimationStory& story : animation.stories()) {
    data["stories"].push_back({{"time", story.time},
                               {"point", story.point},
                               {"pair", story.pair},
                               {"sort", sort_name(story.sort)},
                               {"heading", story.heading}});
  }
  return data;
}

/// What the reader may know of the page's data.
std::string about(const Animation& animation, const AnimationWords& words) {
  const auto& frames = animation.frames();
  const std::size_t vertices = animation.shape().vertex_count();
  std::string text = words.mark_names + "\n";
  text += fmt::format("{} of {} frames", frames.size(), animation.frames_made());
  if (frames.size() < animation.frames_made()) {
    text += fmt::format(", as a page holds at most {} frames and {} of positions", animation.limits().frames,
                        bytes_for_person(static_cast<double>(animation.limits().frame_bytes)));
  }
  const int exponent = frames.back().drawn.exponent;
  text += fmt::format(
      ". {}\nFor drawing, coordinates are rounded to multiples of 2^{} ({:.2g}), 16 bits each: {} vertices, {} a "
      "frame, "
      "{} in all.\n",
      words.between, exponent, std::ldexp(1.0, exponent), vertices,
      bytes_for_person(6.0 * static_cast<double>(vertices)),
      bytes_for_person(6.0 * static_cast<double>(vertices) * static_cast<double>(frames.size())));
  text += animation.has_exact()
              ? "The exact coordinates of all vertices are in the page too, and are shown for what you click.\n"
              : fmt::format(
                    "The exact coordinates of all vertices would need more than {}: the page has those of the "
                    "listed pairs, and says where it shows rounded ones.\n",
                    bytes_for_person(static_cast<double>(animation.limits().exact_bytes)));
  if (animation.marks_left_out() > 0) {
    text += fmt::format("{} marks are left out: a page holds {}. The plots count them all.\n",
                        animation.marks_left_out(), animation.limits().marks);
  }
  return text;
}

/// The text of the result, whose first words stand out: what the program's line says before it says of what.
std::string result_html(const std::string& summary) {
  const std::size_t end = std::min({summary.find(" ("), summary.find(';'), summary.find('\n'), summary.size()});
  const std::size_t rest = std::min(summary.find_first_not_of("; \n", end), summary.size());
  return "<pre class=\"wrapped\"><strong>" + escaped(summary.substr(0, end)) + "</strong>" +
         escaped(summary.substr(rest)) + "</pre>";
}

std::string list_of_stories(const Animation& animation) {
  if (animation.stories().empty()) return "<p>No pair is listed.</p>\n";
  std::string html = "<ol class=\"events\">\n";
  for (std::size_t i = 0; i < animation.stories().size(); ++i) {
    const AnimationStory& story = animation.stories()[i];
    html += fmt::format("<li class=\"{}\"><button type=\"button\" data-story=\"{}\">{}</button>", sort_name(story.sort),
                        i, escaped(story.heading));
    html += "<details><summary>more</summary>" + story.html + "</details></li>\n";
  }
  return html + "</ol>\n";
}

void write_data(const Animation& animation, const Sink& sink) {
  const AnimationShape& shape = animation.shape();
  const auto flat = [](const auto& elements) {
    std::vector<std::uint32_t> numbers;
    for (const auto& element : elements) numbers.insert(numbers.end(), element.begin(), element.end());
    return numbers;
  };
  write_numbers(sink, "faces", flat(shape.faces));
  write_numbers(sink, "edges", flat(shape.edges));
  write_numbers(sink, "bare", shape.edges_without_face());
  write_numbers(sink, "hues", hues_of(animation));
  write_numbers(sink, "radii", shape.radii);
  write_numbers(sink, "points", shape.points);
  write_numbers(sink, "face-numbers", shape.face_numbers);
  std::vector<std::uint32_t> pairs;
  for (const auto& [a, b] : animation.pairs()) {
    for (const AnimationElement& e : {a, b}) pairs.insert(pairs.end(), {static_cast<std::uint32_t>(e.sort), e.number});
  }
  write_numbers(sink, "pairs", pairs);
  std::vector<double> times, points;
  std::vector<std::uint32_t> pair_of;
  std::vector<std::uint8_t> sorts;
  for (const AnimationMark& mark : animation.marks()) {
    times.push_back(mark.time);
    points.insert(points.end(), mark.point.begin(), mark.point.end());
    pair_of.push_back(mark.pair);
    sorts.push_back(static_cast<std::uint8_t>(mark.sort));
  }
  write_numbers(sink, "mark-times", times);
  write_numbers(sink, "mark-points", points);
  write_numbers(sink, "mark-pairs", pair_of);
  write_numbers(sink, "mark-sorts", sorts);
  for (std::size_t i = 0; i < animation.frames().size(); ++i) {
    write_numbers(sink, "frame-" + std::to_string(i), animation.frames()[i].drawn.steps);
    if (animation.has_exact()) write_numbers(sink, "exact-" + std::to_string(i), animation.frames()[i].exact);
  }
}

}  // namespace

std::uint64_t write_animation_page(const Animation& animation, const AnimationWords& words, const Sink& sink) {
  const AnimationView view = view_of(animation);
  Page page;
  page.title = words.title;
  page.subtitle = words.subtitle;
  page.command = words.command;
  page.sort = "animation beside";
  page.styles = {"animation.css", "frame.css"};
  page.body = "<main>\n<div class=\"viewer\"><div class=\"stage\">\n" + still_of(animation, view) + "</div>\n" +
              plots_html(animation) + "</div>\n<aside>\n<section><h2>Result</h2>\n" + result_html(words.summary) +
              "</section>\n<section class=\"picked\" aria-live=\"polite\" hidden></section>\n"
              "<section><h2>Pairs</h2>\n" +
              list_of_stories(animation) + "</section>\n<section><h2>The picture</h2>\n<p class=\"about\">" +
              escaped(about(animation, words)) + "</p></section>\n</aside>\n</main>\n";
  page.data.emplace_back("animation", json_for_script(data_of(animation, words, view)));
  page.scripts = {"numbers.js",     "canvas.js", "camera.js", "page_state.js", "timeline.js",      "frames.js",
                  "mesh_canvas.js", "pick.js",   "marks.js",  "plots.js",      "element_panel.js", "animation.js"};
  std::uint64_t size = 0;
  const auto counted = [&](std::string_view bytes) {
    sink(bytes);
    size += bytes.size();
  };
  write_page(page, counted, [&](const Sink& out) { write_data(animation, out); });
  return size;
}

}  // namespace touchstone::view
