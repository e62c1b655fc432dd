// SPDX-License-Identifier: MIT
#include "cli/simulate/simulation_animation.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "cli/shared/animation_file.hpp"
#include "cli/shared/exact_corners.hpp"
#include "exact/exact.hpp"
#include "geometry/kind_traits.hpp"
#include "sim/output_text.hpp"
#include "view/pages/story_html.hpp"

namespace touchstone::cli {
namespace {

using geometry::traits_of;
using view::AnimationElement;

view::Triple triple(const sim::Vector3& x) { return {x.x(), x.y(), x.z()}; }

/// The particles, and then each body.
view::AnimationShape shape_of(const sim::Simulation& simulation) {
  view::AnimationShape shape;
  shape.vertex_name = std::string(simulation.scene().particles.empty() ? "vertex" : "particle");
  const sim::Colliders& colliders = simulation.colliders();
  const auto count = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
  shape.groups.push_back({"", count(simulation.scene().particles), count(colliders.edges()), count(colliders.faces())});
  shape.edges = colliders.edges();
  shape.faces = colliders.faces();
  shape.points = colliders.points();
  if (simulation.bodies() == nullptr) return shape;
  const auto& bodies = simulation.bodies()->system().bodies();
  std::uint32_t first = shape.groups.front().vertices;
  for (sim::Index b = 0; b < bodies.size(); ++b) {
    const sim::ElementSet& surface = simulation.bodies()->colliders().surface(b);
    shape.groups.push_back(
        {fmt::format("body {}", b), count(bodies[b].points), count(surface.edges), count(surface.faces)});
    for (const sim::Edge& edge : surface.edges) shape.edges.push_back({first + edge[0], first + edge[1]});
    for (const sim::Face& face : surface.faces) {
      shape.faces.push_back({first + face[0], first + face[1], first + face[2]});
    }
    first += shape.groups.back().vertices;
  }
  return shape;
}

std::vector<view::AnimationPlot> plots() {
  return {{"energy [J]", {{"total"}, {"kinetic"}, {"stretch"}, {"bend"}, {"twist"}, {"load"}}},
          {"pairs since the frame before", {{"close", true}, {"contacts", true}, {"crossings", true}}}};
}

std::vector<view::AnimationGroup> offsets_of(const view::AnimationShape& shape) {
  std::vector<view::AnimationGroup> offsets;
  view::AnimationGroup sum;
  for (const view::AnimationGroup& group : shape.groups) {
    offsets.push_back(sum);
    sum.vertices += group.vertices;
    sum.edges += group.edges;
    sum.faces += group.faces;
  }
  return offsets;
}

}  // namespace

SimulationAnimation::SimulationAnimation(const sim::Simulation& simulation)
    : simulation_(&simulation), offsets_(offsets_of(shape_of(simulation))), animation_(shape_of(simulation), plots()) {
  add_frame({});
}

void SimulationAnimation::step(const std::vector<sim::SubstepRecord>& records) {
  const auto& crossings = simulation_->crossings();
  for (const sim::SubstepRecord& record : records) add_contacts(record);
  for (; crossings_ < crossings.size(); ++crossings_) add_crossing(crossings[crossings_]);
  add_frame(records);
}

std::vector<double> SimulationAnimation::positions() const {
  std::vector<double> all;
  const auto add = [&all](const sim::Vector3& x) { all.insert(all.end(), {x.x(), x.y(), x.z()}); };
  for (sim::Index p = 0; p < simulation_->scene().particles.size(); ++p) {
    add(sim::position(simulation_->state().q, p));
  }
  if (simulation_->bodies() == nullptr) return all;
  const auto& bodies = simulation_->bodies()->system().bodies();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const sim::Pose& pose = simulation_->bodies()->state().bodies[b].pose;
    const sim::Matrix3 turn = sim::matrix_of(pose.q);
    for (const sim::Vector3& x : bodies[b].points) add(pose.p + turn * x);
  }
  return all;
}

void SimulationAnimation::add_frame(const std::vector<sim::SubstepRecord>& records) {
  const sim::Energies e = simulation_->energies();
  std::uint64_t close = 0, contacts = 0, crossings = 0;
  for (const sim::SubstepRecord& record : records) {
    close += record.response.close + record.bodies.close;
    contacts += record.response.contacts + record.bodies.contacts;
    crossings += record.proof.crossings;
  }
  animation_.add_frame(simulation_->state().time, simulation_->steps(), positions(),
                       {e.total(), e.kinetic, e.stretch, e.bend, e.twist, e.load, static_cast<double>(close),
                        static_cast<double>(contacts), static_cast<double>(crossings)});
}

view::AnimationPair SimulationAnimation::elements(const sim::Pair& pair) const {
  return {{traits_of(pair.kind).first.sort, pair.i}, {traits_of(pair.kind).second.sort, pair.j}};
}

view::AnimationPair SimulationAnimation::elements(const sim::BodyPair& pair) const {
  const auto element = [&](MeshElement sort, const sim::OfBody& of) {
    const view::AnimationGroup& first = offsets_[of.body == sim::kParticles ? 0 : of.body + 1];
    const std::uint32_t offset = sort == MeshElement::edge   ? first.edges
                                 : sort == MeshElement::face ? first.faces
                                                             : first.vertices;
    return AnimationElement{sort, offset + of.number};
  };
  return {element(traits_of(pair.kind).first.sort, pair.a), element(traits_of(pair.kind).second.sort, pair.b)};
}

void SimulationAnimation::add_contacts(const sim::SubstepRecord& record) {
  for (const sim::ContactMark& mark : record.contacts) {
    const auto pair = animation_.pair(std::visit([this](const auto& of_sort) { return elements(of_sort); }, mark.pair));
    const double time = record.time - record.length * (1 - (mark.touches ? mark.time : 1));
    const view::MarkSort sort = mark.touches ? view::MarkSort::contact : view::MarkSort::close;
    animation_.add_mark({time, triple(mark.point), pair, sort});
    if (!mark.touches || !animation_.has_room(sort)) continue;
    if (told_.size() <= pair) told_.resize(pair + 1, 0);
    if (std::exchange(told_[pair], 1)) continue;
    const auto [names, corners] = std::visit([this](const auto& of_sort) { return words_of(of_sort); }, mark.pair);
    animation_.add_story(
        {time, triple(mark.point), pair, sort, fmt::format("step {}, {:.6g} s: {}", record.step, time, names),
         "<p>Without an answer the pair would have touched here. The response moved it apart, and the step was taken "
         "only with the proof that it stays apart. At the end of the step:</p><pre>" +
             corners + "</pre>"});
  }
}

SimulationAnimation::Words SimulationAnimation::words_of(const sim::Pair& pair) const {
  Words words{simulation_->colliders().describe(pair), {}};
  const auto corners = simulation_->colliders().corners(pair);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    const Vec3 x = sim::corner_of(simulation_->state().q, corners[c]);
    words.corners += exact_corner(fmt::format("particle {}", corners[c]), x);
  }
  return words;
}

SimulationAnimation::Words SimulationAnimation::words_of(const sim::BodyPair& pair) const {
  const sim::BodyColliders& colliders = simulation_->bodies()->colliders();
  Words words{colliders.describe(pair), {}};
  const auto corners = colliders.corners(pair);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    const sim::OfBody& corner = corners[c];
    const sim::Vector3 x = colliders.at(corner, simulation_->bodies()->state().bodies, simulation_->state().q);
    const std::string name = corner.body == sim::kParticles
                                 ? fmt::format("particle {}", corner.number)
                                 : fmt::format("vertex {} of body {}", corner.number, corner.body);
    words.corners += exact_corner(name, {x.x(), x.y(), x.z()});
  }
  return words;
}

void SimulationAnimation::add_crossing(const sim::Crossing& crossing) {
  const auto pair = animation_.pair(elements(crossing.pair));
  const view::Triple point = triple(crossing.point);
  animation_.add_mark({crossing.time, point, pair, view::MarkSort::crossing});
  if (!animation_.has_room(view::MarkSort::crossing)) return;
  const exact::Story story = exact::explain(crossing.query, 1);
  animation_.add_story({crossing.time, point, pair, view::MarkSort::crossing,
                        "crossing: " + sim::crossing_for_person(*simulation_, crossing),
                        view::story_html(crossing.query.kind, false, story, 1, {}) +
                            fmt::format("<pre>{}</pre>", exact_corners(crossing.query))});
}

std::uint64_t SimulationAnimation::write(io::OutputFile& file, const std::string& title,
                                         const std::string& summary) const {
  const view::AnimationWords words{
      title,
      simulation_->scene().name,
      summary,
      "s",
      "step",
      "Between frames the picture moves straight.",
      "Filled marks are pairs that would have touched if nothing had answered them, rings are pairs closer than the "
      "thickness, crosses are crossings."};
  return write_animation(animation_, words, file);
}

}  // namespace touchstone::cli
