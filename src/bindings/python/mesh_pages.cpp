// A step of a mesh as a page to look at, where the module was built with the view layer.
// SPDX-License-Identifier: MIT
#include <touchstone/mesh.hpp>
#include <touchstone/solve.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "exact/exact.hpp"
#include "fuzz/judging/finding_text.hpp"
#include "geometry/kind_traits.hpp"
#include "python/arguments.hpp"
#include "python/background.hpp"
#include "python/define.hpp"
#include "python/step_arguments.hpp"
#include "view/pages/animation_page.hpp"
#include "view/pages/html.hpp"
#include "view/pages/story_html.hpp"
#include "view/touched_point.hpp"

namespace touchstone::python {
namespace {

using view::AnimationElement;
using view::MarkSort;
using view::Triple;

Vec3 vertex_at(const Positions& x, std::size_t vertex) {
  const auto coordinate = [&](std::ptrdiff_t k) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(vertex) * x.vertex_stride + k * x.coordinate_stride;
    return x.data != nullptr ? x.data[at] : static_cast<double>(x.floats[at]);
  };
  return {coordinate(0), coordinate(1), x.dimension == 3 ? coordinate(2) : 0};
}

std::vector<double> coordinates(const Positions& x) {
  std::vector<double> all;
  all.reserve(3 * x.count);
  for (std::size_t v = 0; v < x.count; ++v) {
    const Vec3 at = vertex_at(x, v);
    all.insert(all.end(), {at.x, at.y, at.z});
  }
  return all;
}

view::AnimationShape shape_of(const Mesh& mesh) {
  const auto count = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
  view::AnimationShape shape;
  shape.groups.push_back(
      {std::string(), static_cast<std::uint32_t>(mesh.vertex_count()), count(mesh.edges()), count(mesh.faces())});
  shape.edges = mesh.edges();
  shape.faces = mesh.faces();
  shape.points = mesh.points();
  shape.vertex_name = "vertex";
  return shape;
}

/// The sorts of a pair's elements by its kind.
view::AnimationPair elements_of(const MeshPair& pair) {
  const auto& [first, second] = geometry::traits_of(pair.kind);
  return {{first.sort, pair.first}, {second.sort, pair.second}};
}

/// One step: its animation, and marks of the first contact and of the intersections at both ends.
class StepPage {
 public:
  StepPage(const Mesh& mesh, const Positions& x0, const Positions& x1, const FirstContactOptions& options)
      : mesh_(mesh), x0_(x0), x1_(x1), options_(options), animation_(shape_of(mesh), {}) {}

  std::string text() {
    animation_.add_frame(0, 0, coordinates(x0_), {});
    animation_.add_frame(1, 1, coordinates(x1_), {});
    const FirstContact found = first_contact(mesh_, x0_, x1_, options_);
    for (const MeshContact& contact : found.at_start) add(contact);
    for (const MeshContact& contact : found.earliest) add(contact);
    const std::size_t before = add_intersections(x0_, 0), after = add_intersections(x1_, 1);
    const std::string summary = (found.free() ? std::string("The step is free of contact.")
                                              : std::to_string(found.at_start.size()) +
                                                    " pairs are in contact at the start, and the contact of " +
                                                    std::to_string(found.earliest.size()) + " begins first.") +
                                "\nThere are " + std::to_string(before) + " intersections at t = 0, and " +
                                std::to_string(after) + " at t = 1.";
    const view::AnimationWords words{
        "a step of a mesh",
        "A mesh of " + std::to_string(mesh_.vertex_count()) + " vertices, " + std::to_string(mesh_.edges().size()) +
            " edges and " + std::to_string(mesh_.faces().size()) +
            " faces moves; marks are contacts and intersections.",
        summary,
        "",
        "frame",
        "Each vertex moves on a straight line.",
        "Filled marks are the pairs whose contact begins first, or that are in contact at the start; crosses are "
        "intersections at the ends of the step.",
        "intersection"};
    std::string page;
    view::write_animation_page(animation_, words, [&](std::string_view bytes) { page += bytes; });
    return page;
  }

 private:
  void add(const MeshContact& contact) {
    Query query;
    query.kind = contact.pair.kind;
    const auto corners = mesh_.corners(contact.pair);
    for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
      query.start[c] = vertex_at(x0_, corners[c]);
      query.end[c] = vertex_at(x1_, corners[c]);
    }
    const Triple point = view::touched_point(query, contact.answer);
    const std::uint32_t pair = animation_.pair(elements_of(contact.pair));
    animation_.add_mark({contact.answer.toi, point, pair, MarkSort::contact});
    if (!animation_.has_room(MarkSort::contact)) return;
    const exact::Story story = contact.separation.distance > 0
                                   ? exact::explain(query, options_.t_max, contact.separation)
                                   : exact::explain(query, options_.t_max);
    animation_.add_story({contact.answer.toi, point, pair, MarkSort::contact, mesh_.describe(contact.pair),
                          view::story_html(query.kind, false, story, options_.t_max, contact.separation) + "<pre>" +
                              view::escaped(fuzz::corners_text(query, "")) + "</pre>"});
  }

  /// @returns their number
  std::size_t add_intersections(const Positions& x, double time) {
    const std::vector<Intersection> all = intersections(mesh_, x, options_);
    for (const Intersection& one : all) {
      Triple point{};
      const auto add_corner = [&](std::size_t vertex, double weight) {
        const Vec3 at = vertex_at(x, vertex);
        point = {point[0] + weight * at.x, point[1] + weight * at.y, point[2] + weight * at.z};
      };
      if (one.first_element == MeshElement::vertex) {
        add_corner(one.first, 1);
      } else {
        const auto& edge = mesh_.edges()[one.first];
        for (std::size_t c = 0; c < 2; ++c) add_corner(edge[c], one.weights_first[c]);
      }
      const AnimationElement first{one.first_element, one.first};
      const AnimationElement second{one.second_element, one.second};
      const std::uint32_t pair = animation_.pair({first, second});
      animation_.add_mark({time, point, pair, MarkSort::crossing});
      if (!animation_.has_room(MarkSort::crossing)) continue;
      animation_.add_story(
          {time, point, pair, MarkSort::crossing,
           animation_.name(first) + " " + std::string(intersection_verb(one.sort)) + " " + animation_.name(second),
           ""});
    }
    return all.size();
  }

  const Mesh& mesh_;
  const Positions &x0_, &x1_;
  const FirstContactOptions& options_;
  view::Animation animation_;
};

std::string mesh_page(const Mesh& mesh, py::handle x0, py::handle x1, py::handle t_max, py::handle threads) {
  const PositionArray start(x0, mesh, "x0"), end(x1, mesh, "x1");
  FirstContactOptions options = options_of(t_max, threads);
  return in_background(mesh.vertex_count(), [&](const std::atomic<bool>& stop) {
    options.stop = &stop;
    return StepPage(mesh, start.view(), end.view(), options).text();
  });
}

}  // namespace

void define_mesh_pages(py::module_& module) { module.def("mesh_page", &mesh_page); }

}  // namespace touchstone::python
