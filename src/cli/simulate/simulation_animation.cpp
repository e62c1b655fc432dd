// SPDX-License-Identifier: MIT
#include "cli/simulate/simulation_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/shared/animation_file.hpp"
#include "cli/shared/exact_corners.hpp"
#include "cli/simulate/energies_picture.hpp"
#include "exact/exact.hpp"
#include "geometry/kind_traits.hpp"
#include "sim/output_text.hpp"
#include "view/pages/story_html.hpp"

namespace touchstone::cli {
namespace {

using geometry::traits_of;

view::Triple triple(const sim::Vector3& x) { return {x.x(), x.y(), x.z()}; }

/// The particles, and then each body.
view::AnimationShape shape_of(const sim::Simulation& simulation) {
  view::AnimationShape shape;
  shape.vertex_name = std::string(simulation.scene().particles.empty() ? "vertex" : "particle");
  const sim::Colliders& colliders = simulation.colliders();
  for (sim::Index group = 0; group < colliders.group_count(); ++group) {
    const sim::Colliders::Counts &first = colliders.before(group), &end = colliders.before(group + 1);
    shape.groups.push_back({group == sim::kParticles ? "" : fmt::format("body {}", group - 1),
                            end.vertices - first.vertices, end.edges - first.edges, end.faces - first.faces});
  }
  shape.edges = colliders.edges();
  shape.faces = colliders.faces();
  shape.points = colliders.points();
  for (sim::Index v = 0; v < colliders.before(colliders.group_count()).vertices; ++v) {
    shape.radii.push_back(static_cast<float>(colliders.radius_of(MeshElement::vertex, v)));
  }
  for (const sim::Cable& cable : simulation.scene().cables) {  // contacts keep the radius of solid ones only
    for (const sim::Index p : cable.particles)
      shape.radii[p] = std::max(shape.radii[p], static_cast<float>(cable.radius));
  }
  return shape;
}

std::vector<view::AnimationPlot> plots() {
  view::AnimationPlot energies{"energy [J]", {}}, counts{"pairs since the frame before", {}};
  for (const char* name : kEnergyNames) energies.series.push_back({name});
  for (const char* name : kCountNames) counts.series.push_back({name, true});
  return {energies, counts};
}

}  // namespace

SimulationAnimation::SimulationAnimation(const sim::Simulation& simulation)
    : simulation_(&simulation), animation_(shape_of(simulation), plots()) {
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
  const sim::Colliders& colliders = simulation_->colliders();
  for (sim::Index v = 0; v < colliders.before(colliders.group_count()).vertices; ++v) {
    const sim::Vector3 x = simulation_->position_of(v);
    all.insert(all.end(), {x.x(), x.y(), x.z()});
  }
  return all;
}

void SimulationAnimation::add_frame(const std::vector<sim::SubstepRecord>& records) {
  const StepValues values = step_values(*simulation_, records);
  animation_.add_frame(simulation_->state().time, simulation_->steps(), positions(), {values.begin(), values.end()});
}

view::AnimationPair SimulationAnimation::elements(const sim::Pair& pair) const {
  return {{traits_of(pair.kind).first.sort, pair.i}, {traits_of(pair.kind).second.sort, pair.j}};
}

void SimulationAnimation::add_contacts(const sim::SubstepRecord& record) {
  for (const sim::ContactMark& mark : record.contacts) {
    const auto pair = animation_.pair(elements(mark.pair));
    const double time = record.time - record.length * (1 - (mark.touches ? mark.time : 1));
    const view::MarkSort sort = mark.touches ? view::MarkSort::contact : view::MarkSort::close;
    animation_.add_mark({time, triple(mark.point), pair, sort});
    if (!mark.touches || !animation_.has_room(sort)) continue;
    if (told_.size() <= pair) told_.resize(pair + 1, 0);
    if (std::exchange(told_[pair], 1)) continue;
    const auto [names, corners] = words_of(mark.pair);
    animation_.add_story(
        {time, triple(mark.point), pair, sort, fmt::format("step {}, {:.6g} s: {}", record.step, time, names),
         "<p>Without an answer the pair would have touched here. The response moved it apart, and the step was taken "
         "only with the proof that it stays apart. At the end of the step:</p><pre>" +
             corners + "</pre>"});
  }
}

SimulationAnimation::Words SimulationAnimation::words_of(const sim::Pair& pair) const {
  const sim::Colliders& colliders = simulation_->colliders();
  Words words{colliders.describe(pair), {}};
  const auto corners = colliders.corners(pair);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    const sim::Vector3 x = simulation_->position_of(corners[c]);
    words.corners += exact_corner(colliders.describe(MeshElement::vertex, &corners[c]), {x.x(), x.y(), x.z()});
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
      fmt::format("The scene {} moves from {:.6g} s to {:.6g} s; marks are contacts and crossings.",
                  simulation_->scene().name, animation_.frames().front().time, animation_.frames().back().time),
      summary,
      "s",
      "step",
      "Between frames the picture moves straight.",
      "Filled marks are pairs that would have touched if nothing had answered them, rings are pairs closer than the "
      "thickness, crosses are crossings."};
  return write_animation(animation_, words, file);
}

}  // namespace touchstone::cli
