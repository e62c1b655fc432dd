// SPDX-License-Identifier: MIT
#include "cli/bodies/body_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "cli/shared/animation_file.hpp"
#include "cli/shared/command_line/separation_options.hpp"
#include "cli/shared/exact_corners.hpp"
#include "cli/shared/mesh_results.hpp"
#include "exact/exact.hpp"
#include "geometry/kind_traits.hpp"
#include "io/queries/curved_rows.hpp"
#include "rigid/arc.hpp"
#include "sequence/element_names.hpp"
#include "view/pages/animation_page.hpp"
#include "view/pages/html.hpp"
#include "view/pages/story_html.hpp"
#include "view/touched_point.hpp"

namespace touchstone::cli {
namespace {

using view::Triple;

/// A body that turns has a picture for each such angle, so that straight motion between them looks like a turn: chords
/// leave an arc by 1/260 of its radius.
constexpr double kTurnOfPicture = std::numbers::pi / 18;
constexpr int kMostPictures = 36;  // of a step

view::AnimationShape shape_of(const BodyFiles& files) {
  view::AnimationShape shape;
  shape.vertex_name = "vertex";
  shape.edges_have_numbers = false;
  std::uint32_t first = 0;
  for (std::size_t b = 0; b < files.names().size(); ++b) {
    const Mesh& mesh = files.bodies().bodies[b].mesh();
    const frames::Topology& topology = files.topology(b);
    const auto count = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
    shape.groups.push_back({sequence::shown_part(files.names()[b]), static_cast<std::uint32_t>(mesh.vertex_count()),
                            count(mesh.edges()), count(mesh.faces()), topology.number_of_vertex(0)});
    for (const auto& [v, w] : mesh.edges()) shape.edges.push_back({first + v, first + w});
    for (const auto& [u, v, w] : mesh.faces()) shape.faces.push_back({first + u, first + v, first + w});
    for (const MeshIndex v : mesh.points()) shape.points.push_back(first + v);
    for (std::size_t f = 0; f < mesh.faces().size(); ++f) shape.face_numbers.push_back(topology.number_of_face(f));
    first += shape.groups.back().vertices;
  }
  return shape;
}

/// The place of a point of a body, about: for drawing.
Triple position_of(const rigid::Arc& now, const Vec3& point) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const Vec3 at = now.ends_of(point).start;
  return {std::clamp(at.x, -kMost, kMost), std::clamp(at.y, -kMost, kMost), std::clamp(at.z, -kMost, kMost)};
}
rigid::Arc arc_at(const RigidMotion& motion, double fraction) { return {motion, fraction, fraction, 0}; }

int pictures_of(const RigidMotion& motion) {
  const auto length = [](const auto& q) { return std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])); };
  const double length0 = length(motion.q0), length1 = length(motion.q1);
  double cosine = 0;
  for (std::size_t i = 0; i < 4; ++i) cosine += (motion.q0[i] / length0) * (motion.q1[i] / length1);
  const double count = std::ceil(2 * std::acos(std::clamp(cosine, -1.0, 1.0)) / kTurnOfPicture);
  return count >= 1 ? static_cast<int>(std::min<double>(count, kMostPictures)) : 1;
}

}  // namespace

BodyAnimation::BodyAnimation(BodyFiles& files, const RecordedPoses& poses)
    : files_(files),
      poses_(poses),
      animation_(shape_of(files), {{"pairs since the picture before", {{"contacts", true}, {"intersections", true}}}}) {
}

void BodyAnimation::add(const std::vector<RigidMotion>& motions, const FirstBodyContact& found) {
  const double start = poses_.times[steps_], end = poses_.times[steps_ + 1];
  add_contacts(found.at_start, start, motions);
  add_intersections(found.start_intersections, motions);
  if (steps_ == 0) add_frame(motions, 0, start);
  int pictures = 1;
  for (const RigidMotion& motion : motions) pictures = std::max(pictures, pictures_of(motion));
  std::vector<double> fractions;
  for (int i = 1; i <= pictures; ++i) fractions.push_back(static_cast<double>(i) / pictures);
  if (found.contact) fractions.push_back(found.toi);  // there the elements are seen to touch
  std::sort(fractions.begin(), fractions.end());
  bool told = !found.contact;
  double last = start;
  for (const double fraction : fractions) {
    if (!told && fraction >= found.toi) {
      add_contacts(found.earliest, poses_.time_in(steps_, found.toi), motions);
      told = true;
    }
    const double time = poses_.time_in(steps_, fraction);
    if (!(last < time && (time < end || fraction == 1))) continue;  // times are rounded
    add_frame(motions, fraction, time);
    last = time;
  }
  ++steps_;
}

void BodyAnimation::add_frame(const std::vector<RigidMotion>& motions, double fraction, double time) {
  std::vector<double> positions;
  positions.reserve(3 * animation_.shape().vertex_count());
  for (std::size_t b = 0; b < motions.size(); ++b) {
    const rigid::Arc now = arc_at(motions[b], fraction);
    for (const Vec3& point : files_.bodies().bodies[b].points()) {
      const Triple at = position_of(now, point);
      positions.insert(positions.end(), at.begin(), at.end());
    }
  }
  animation_.add_frame(time, animation_.frames_made(), positions,
                       {static_cast<double>(contacts_), static_cast<double>(intersections_)});
  contacts_ = intersections_ = 0;
}

view::AnimationElement BodyAnimation::element(MeshElement sort, const BodyElement& of) const {
  return animation_.shape().element(of.body, sort, of.element);
}

void BodyAnimation::add_contacts(const std::vector<BodyContact>& contacts, double time,
                                 const std::vector<RigidMotion>& motions) {
  contacts_ += contacts.size();
  for (const BodyContact& contact : contacts) {
    const auto& [first, second] = geometry::traits_of(contact.pair.kind);
    const CurvedQuery query = query_of(files_.bodies(), contact.pair, motions);
    const rigid::Arc now = arc_at(query.motions[0], contact.answer.toi);  // the first element's body
    Triple point{};
    for (std::size_t c = 0; c < first.corners(); ++c) {
      const Triple corner = position_of(now, query.corners[c].points[0]);
      const double weight = first.corners() == 1 ? 1 : contact.answer.weights_a[c];
      for (std::size_t k = 0; k < 3; ++k) point[k] += weight * corner[k];
    }
    const auto pair =
        animation_.pair({element(first.sort, contact.pair.first), element(second.sort, contact.pair.second)});
    animation_.add_mark({time, point, pair, view::MarkSort::contact});
    if (!animation_.has_room(view::MarkSort::contact)) continue;
    const Separation& separation = contact.separation;
    const exact::Story story =
        separation.distance > 0 ? exact::explain(query, 1, separation) : exact::explain(query, 1);
    std::string rows;
    io::append_query(rows, query, true);
    animation_.add_story(
        {time, point, pair, view::MarkSort::contact,
         fmt::format("time {:.6g}: {}", time, pair_for_person(files_.named(contact))),
         view::story_html(query.kind, true, story, 1, separation) + fmt::format("<pre>{}</pre>", rows)});
  }
}

void BodyAnimation::add_intersections(const std::vector<BodyIntersection>& found,
                                      const std::vector<RigidMotion>& motions) {
  intersections_ += found.size();
  for (const BodyIntersection& one : found) {
    std::string corners;
    const auto positions_of = [&](MeshElement sort, const BodyElement& of) {
      const Body& body = files_.bodies().bodies[of.body];
      const sequence::NamedElement named = files_.named(sort, of);
      const MeshIndex* const numbers = geometry::corners_of(sort, of.element, body.mesh().edges(), body.mesh().faces());
      std::vector<Triple> positions;
      for (std::size_t c = 0; c < named.corner_count(); ++c) {
        positions.push_back(position_of(arc_at(motions[of.body], 0), body.points()[numbers[c]]));
        const auto& [x, y, z] = positions.back();
        corners += exact_corner(fmt::format("vertex {} of {}, about", named.vertices[c], named.part), {x, y, z});
      }
      return positions;
    };
    const std::vector<Triple> first = positions_of(one.first_element, one.first);
    const Triple point = view::meeting_point(first, positions_of(one.second_element, one.second));
    const auto pair = animation_.pair({element(one.first_element, one.first), element(one.second_element, one.second)});
    const double time = poses_.times[steps_];
    animation_.add_mark({time, point, pair, view::MarkSort::crossing});
    if (!animation_.has_room(view::MarkSort::crossing)) continue;
    const sequence::RestContact named = files_.named(one);
    animation_.add_story({time, point, pair, view::MarkSort::crossing,
                          fmt::format("time {:.6g}: {} {} {}", time, element_for_person(named.first),
                                      intersection_verb(named.sort), element_for_person(named.second)),
                          fmt::format("<pre>{}</pre>", view::escaped(corners))});
  }
}

std::uint64_t BodyAnimation::write(io::OutputFile& file, const std::string& summary) const {
  const Separation& separation = files_.bodies().separation;
  const view::AnimationWords words{
      fmt::format("{} bodies, time {:.6g} to {:.6g}", files_.names().size(), poses_.times.front(), poses_.times.back()),
      (separation.distance > 0 ? "Do all bodies stay apart in each step? (" + separation_for_person(separation) + ")"
                               : std::string("Is each step between the recorded poses free of contact?")) +
          " The bodies turn from pose to pose; marks are contacts and intersections.",
      summary,
      "",
      "picture",
      "Between two pictures vertices move straight here; in the check each body turns. A step has a picture for every "
      "10 degrees, and one at its first contact.",
      "Filled marks are the pairs whose contact begins first in a step, or that are in contact at its start; crosses "
      "are intersections at the start of a step.",
      "intersection"};
  return write_animation(animation_, words, file);
}

}  // namespace touchstone::cli
