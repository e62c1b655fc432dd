// The longest step whose stored, rounded end is reached without contact.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/solve.hpp>

#include "mesh/contacts.hpp"
#include "mesh/obstacles.hpp"
#include "mesh/pair_distance.hpp"
#include "numbers/doubles/between.hpp"
#include "numbers/doubles/decimal_text.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/doubles/nearest_float.hpp"
#include "solver/cascade.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::mesh {
namespace {

/// The double between x0 and x1 after a length, rounded to the nearest float, for x0 and x1 that are floats: so it is
/// between them, too.
double float_at(double x0, double x1, double length) noexcept {
  return numbers::nearest_float(numbers::between(x0, x1, length));
}

Vec3 position_at(const MovingVertex& vertex, double length, bool float32) noexcept {
  const auto at = float32 ? float_at : numbers::between;
  return {at(vertex.start.x, vertex.end.x, length), at(vertex.start.y, vertex.end.y, length),
          at(vertex.start.z, vertex.end.z, length)};
}

bool equal(const Vec3& a, const Vec3& b) noexcept { return a.x == b.x && a.y == b.y && a.z == b.z; }

std::vector<double> packed(const Motion& motion, int dimension, bool at_end) {
  std::vector<double> positions;
  positions.reserve(motion.size() * static_cast<std::size_t>(dimension));
  for (const MovingVertex& vertex : motion) {
    const Vec3& at = at_end ? vertex.end : vertex.start;
    positions.push_back(at.x);
    positions.push_back(at.y);
    if (dimension == 3) positions.push_back(at.z);
  }
  return positions;
}

/// The motion to the rounded positions after this length.
Motion path_of(const Motion& step, double length, const FreeStepOptions& options) {
  Motion path(step.size());
  constexpr std::size_t kVerticesAtATime = 4096;
  threads::for_each_range(step.size(), kVerticesAtATime, options.threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      path[v] = {step[v].start, position_at(step[v], length, options.float32)};
    }
  });
  return path;
}

/// Rounds the end of a step to floats.
void round_to_floats(Motion& step) {
  constexpr double Vec3::*kAxes[3] = {&Vec3::x, &Vec3::y, &Vec3::z};
  for (std::size_t v = 0; v < step.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double start = step[v].start.*kAxes[k];
      double& end = step[v].end.*kAxes[k];
      if (numbers::nearest_float(start) != start) {
        refuse_coordinate(v, k, start, kAtStart,
                          ", which is no float32 number; with float32 a step starts at such numbers");
      }
      const double rounded = numbers::nearest_float(end);
      if (!std::isfinite(rounded)) {
        refuse_coordinate(v, k, end, kAtEnd, ", which is beyond the largest float32 number, 3.4e38");
      }
      end = rounded;
    }
  }
}

/// Whether some pair at the start is within its separation, and not merely within the distance that it is to keep,
/// which is rounded up.
bool is_in_contact(const Mesh::Impl& mesh, const Motion& step, const std::vector<MeshContact>& at_start) {
  return std::any_of(at_start.begin(), at_start.end(), [&](const MeshContact& contact) {
    const auto corners = corners_of(mesh, contact.pair);
    const Separation separation{separation_of(mesh, contact.pair, corners), mesh.separation.metric};
    return compare_distance(query_of(step, contact.pair.kind, corners), 0, separation) <= 0;
  });
}

/// Whether the boxes of a step that keeps this fraction reach far beyond their elements.
bool reaches_far(const Mesh::Impl& mesh, const Motion& step, double fraction) {
  constexpr double kMuchOfEdge = 0.125;
  if (fraction == 0 || mesh.edges.empty()) return false;
  const double reach = fraction / (1 - fraction) * usual_length_beside_usual_way(step);
  return reach > kMuchOfEdge * usual_edge_length(mesh, step);
}

TOUCHSTONE_BEHIND_GUARD FreeStep find_step(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1,
                                           const FreeStepOptions& options, StepMemory& memory) {
  set_motion(memory.motion, mesh, x0, x1, options.threads);
  if (options.float32) round_to_floats(memory.motion);
  const Motion& step = memory.motion;
  const ContactSearch search{
      1, options.threads, options.kept_fraction, options.stop, options.check_start, memory.candidates()};
  FreeStep result;
  ContactSearch first = search;
  // Elements come as near as they are to keep before they touch. If they touch soon, boxes reach less far until then.
  const bool has_lists = memory.kept && memory.kept->has_lists_for(step, options.kept_fraction);
  if (!has_lists && reaches_far(mesh, step, options.kept_fraction)) first.known_by = first_time(mesh, step, search);
  result.first_contact = find_first(mesh, step, first);
  result.proofs = 1;
  if (!result.first_contact.at_start.empty() || !result.first_contact.start_intersections.empty()) {
    result.outcome = is_in_contact(mesh, step, result.first_contact.at_start) ? StepOutcome::contact_at_start
                     : !result.first_contact.start_intersections.empty()      ? StepOutcome::intersects_at_start
                                                                              : StepOutcome::no_room;
    result.length = 0;
    result.positions = packed(step, mesh.dimension, false);
    return result;
  }
  if (!result.first_contact.contact) {
    result.positions = packed(step, mesh.dimension, true);
    return result;
  }
  const auto path_of_pair = [&](Query path, double length) {
    for (std::size_t c = 0; c < corner_count(path.kind); ++c) {
      path.end[c] = position_at({path.start[c], path.end[c]}, length, options.float32);
    }
    return path;
  };
  Obstacles<Query, decltype(path_of_pair)> obstacles(path_of_pair);
  const auto add = [&](const std::vector<MeshContact>& contacts) {
    for (const MeshContact& contact : contacts) {
      obstacles.add(query_of(step, contact.pair.kind, corners_of(mesh, contact.pair)), contact.separation);
    }
  };
  add(result.first_contact.earliest);
  Motion path;
  const auto attempt = [&](double length) {
    check_stop(options.stop);
    path = path_of(step, length, options);
    const bool moves =
        std::any_of(path.begin(), path.end(), [](const MovingVertex& v) { return !equal(v.start, v.end); });
    if (!moves || length == 0) return Tried::no_room;
    const std::vector<MeshContact> met = find_all(mesh, path, search);
    ++result.proofs;
    add(met);
    return met.empty() ? Tried::free : Tried::blocked;
  };
  Tried tried;
  result.length = shortened(obstacles, result.first_contact, attempt, tried);
  const bool is_free = tried == Tried::free;
  result.outcome = is_free ? StepOutcome::shortened : StepOutcome::no_room;
  result.positions = is_free ? packed(path, mesh.dimension, true) : packed(step, mesh.dimension, false);
  return result;
}

void check_fraction(double fraction) {
  if (fraction >= 0 && fraction < 1) return;
  throw InvalidQuery("the fraction of the distance to keep is " + numbers::decimal_text(fraction) +
                     "; it must be in [0, 1)");
}

}  // namespace

FreeStep free_step(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1, const FreeStepOptions& options,
                   StepMemory& memory) {
  const numbers::DefaultFloatEnvironment environment;
  check_fraction(options.kept_fraction);
  return find_step(mesh, x0, x1, options, memory);
}

}  // namespace touchstone::mesh
