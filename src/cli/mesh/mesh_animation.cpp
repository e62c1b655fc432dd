// SPDX-License-Identifier: MIT
#include "cli/mesh/mesh_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "cli/shared/animation_file.hpp"
#include "cli/shared/exact_corners.hpp"
#include "cli/shared/mesh_results.hpp"
#include "exact/exact.hpp"
#include "sequence/checks.hpp"
#include "sequence/element_names.hpp"
#include "view/pages/html.hpp"
#include "view/pages/story_html.hpp"
#include "view/touched_point.hpp"

namespace touchstone::cli {
namespace {

using view::Triple;

view::AnimationShape shape_of(const Mesh& mesh, const frames::Topology& topology) {
  view::AnimationShape shape;
  const auto count = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
  shape.edges = mesh.edges();
  if (topology.vertex_parts.empty()) {
    shape.groups.push_back({std::string(), static_cast<std::uint32_t>(topology.vertex_count), count(mesh.edges()),
                            count(topology.faces), topology.first_number});
  } else {
    const auto part_of = [&](const auto& corners) { return topology.vertex_parts[corners[0]]; };
    std::stable_sort(shape.edges.begin(), shape.edges.end(),
                     [&](const auto& a, const auto& b) { return part_of(a) < part_of(b); });
    for (const std::string& name : topology.parts) shape.groups.push_back({sequence::shown_part(name)});
    for (std::size_t v = 0; v < topology.vertex_count; ++v) {
      view::AnimationGroup& group = shape.groups[topology.vertex_parts[v]];
      if (group.vertices++ == 0) group.first_number = topology.number_of_vertex(v);
    }
    for (const auto& edge : shape.edges) ++shape.groups[part_of(edge)].edges;
    for (const auto& face : topology.faces) ++shape.groups[part_of(face)].faces;
  }
  shape.faces = topology.faces;
  shape.points = mesh.points();
  shape.vertex_name = std::string("vertex");
  shape.face_numbers.assign(topology.face_numbers.begin(), topology.face_numbers.end());
  shape.edges_have_numbers = false;
  return shape;
}

template <class Elements>
std::map<std::vector<std::uint32_t>, std::uint32_t> by_corners(const Elements& elements) {
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    std::vector<std::uint32_t> corners(elements[i].begin(), elements[i].end());
    std::sort(corners.begin(), corners.end());
    numbers.emplace(std::move(corners), static_cast<std::uint32_t>(i));
  }
  return numbers;
}

Triple at(const frames::Frame& frame, std::uint64_t vertex) {
  const auto dimension = static_cast<std::size_t>(frame.topology->dimension);
  const double* const x = &frame.positions[dimension * vertex];
  return {x[0], x[1], dimension == 3 ? x[2] : 0};
}

}  // namespace

MeshAnimation::MeshAnimation(const Mesh& mesh, std::shared_ptr<const frames::Topology> topology,
                             const Separation& separation)
    : topology_(std::move(topology)),
      separation_(separation),
      animation_(shape_of(mesh, *topology_),
                 {{"pairs since the frame before", {{"contacts", true}, {"intersections", true}}}}) {}

MeshIndex MeshAnimation::vertex(const sequence::NamedElement& named, std::size_t corner) const {
  if (const auto found = sequence::vertex_named(*topology_, named, corner)) return *found;
  throw Error("an earlier run names " + element_for_person(named) + ", which the mesh does not have");
}

view::AnimationElement MeshAnimation::element(const sequence::NamedElement& named) const {
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < named.corner_count(); ++i) {
    corners.push_back(vertex(named, i));
  }
  if (named.element == MeshElement::vertex) return {named.element, corners.front()};
  std::sort(corners.begin(), corners.end());
  const bool is_edge = named.element == MeshElement::edge;
  return {named.element, (is_edge ? edges_ : faces_).at(corners)};
}

void MeshAnimation::add_result(const sequence::Result& result, const frames::Frame& before,
                               const frames::Frame& after) {
  if (result.free()) return;
  if (edges_.empty()) edges_ = by_corners(animation_.shape().edges);
  if (faces_.empty()) faces_ = by_corners(animation_.shape().faces);
  const auto start = static_cast<double>(result.frame);
  add_contacts(result.at_start, start, result, before, after);
  add_contacts(result.first, start + result.toi, result, before, after);
  add_intersections(result.intersections, result.frame + (result.step ? 1 : 0), after);
}

void MeshAnimation::add_contacts(const std::vector<sequence::PairContact>& pairs, double time,
                                 const sequence::Result& result, const frames::Frame& before,
                                 const frames::Frame& after) {
  contacts_ += pairs.size();
  for (const sequence::PairContact& contact : pairs) {
    const Query query = sequence::query_of(contact, before, after);
    // Neighbours along a wire, and those of --self, are asked about touching alone. An answer about a separation has
    // a trend.
    const Separation separation = contact.trend == Trend::none ? Separation() : separation_;
    const Answer answer = solve(query, {.separation = separation});
    const Triple point = view::touched_point(query, answer);
    const auto pair = animation_.pair({element(contact.first), element(contact.second)});
    animation_.add_mark({time, point, pair, view::MarkSort::contact});
    if (!animation_.has_room(view::MarkSort::contact)) continue;
    const exact::Story story =
        separation.distance > 0 ? exact::explain(query, 1, separation) : exact::explain(query, 1);
    animation_.add_story(
        {time, point, pair, view::MarkSort::contact,
         fmt::format("step {} to {}, t = {:.6g}: {} and {}", result.frame, result.frame + 1, answer.toi,
                     element_for_person(contact.first), element_for_person(contact.second)),
         view::story_html(query.kind, false, story, 1, separation) +
             fmt::format("<pre>{}</pre>", exact_corners(query))});
  }
}

void MeshAnimation::add_intersections(const std::vector<sequence::RestContact>& found, std::size_t number,
                                      const frames::Frame& frame) {
  intersections_ += found.size();
  for (const sequence::RestContact& contact : found) {
    std::vector<Triple> first, second;
    std::string corners;
    for (const auto& [named, points] : {std::pair{&contact.first, &first}, std::pair{&contact.second, &second}}) {
      for (std::size_t i = 0; i < named->corner_count(); ++i) {
        const Triple x = at(frame, vertex(*named, i));
        points->push_back(x);
        corners += exact_corner(fmt::format("vertex {}", named->vertices[i]), {x[0], x[1], x[2]});
      }
    }
    const Triple point = view::meeting_point(first, second);
    const auto pair = animation_.pair({element(contact.first), element(contact.second)});
    const auto time = static_cast<double>(number);
    animation_.add_mark({time, point, pair, view::MarkSort::crossing});
    if (!animation_.has_room(view::MarkSort::crossing)) continue;
    animation_.add_story({time, point, pair, view::MarkSort::crossing,
                          fmt::format("frame {}: {} {} {}", number, element_for_person(contact.first),
                                      intersection_verb(contact.sort), element_for_person(contact.second)),
                          fmt::format("<pre>{}</pre>", corners)});
  }
}

void MeshAnimation::add_frame(std::size_t number, const std::string& label, const frames::Frame& frame) {
  const frames::Topology& topology = *frame.topology;
  if (&topology != topology_.get() &&
      (topology.vertex_count != topology_->vertex_count || topology.faces != topology_->faces ||
       topology.edges != topology_->edges || topology.dimension != topology_->dimension)) {
    throw Error(label + ": --html shows frames with the same vertices and elements, and this one has others than " +
                first_label_);
  }
  std::vector<double> positions;
  positions.reserve(3 * topology.vertex_count);
  for (std::size_t v = 0; v < topology.vertex_count; ++v) {
    const Triple x = at(frame, v);
    positions.insert(positions.end(), x.begin(), x.end());
  }
  animation_.add_frame(static_cast<double>(number), number, positions,
                       {static_cast<double>(contacts_), static_cast<double>(intersections_)}, label);
  contacts_ = intersections_ = 0;
  if (first_label_.empty()) first_label_ = label;
  last_label_ = label;
}

std::uint64_t MeshAnimation::write(io::OutputFile& file, const std::string& question,
                                   const std::string& summary) const {
  const view::AnimationWords words{
      fmt::format("{} to {}", first_label_, last_label_),
      question + " Frames move one after the other; marks are contacts and intersections.",
      summary,
      "",
      "frame",
      "Between two frames in the page the picture moves straight; a step between neighbouring frames was checked so.",
      "Filled marks are the pairs whose contact begins first in a step, or that are in contact at its start; crosses "
      "are intersections.",
      "intersection"};
  return write_animation(animation_, words, file);
}

}  // namespace touchstone::cli
