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
#include "mesh/pair_distance.hpp"
#include "numbers/doubles/decimal_text.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::mesh {
namespace {

double next_below(double x) noexcept { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

/// x0 + length (x1 - x0), within the error that FreeStep::positions states, and between x0 and x1; exactly x1 for the
/// length 1.
double coordinate_at(double x0, double x1, double length) noexcept {
  if (x0 == x1 || length == 1) return x1;
  const double difference = x1 - x0;
  if (!std::isfinite(difference)) return 2 * coordinate_at(x0 / 2, x1 / 2, length);
  // The errors of the difference, of the product and of the sum are known, and are added to the sum: so it is rounded
  // once, but for terms of second order.
  const double x0_virtual = x1 - difference;
  const double difference_error = (x0_virtual - x0) + (x1 - (difference + x0_virtual));
  const double product = length * difference;
  const double product_error = std::fma(length, difference, -product) + length * difference_error;
  const double sum = x0 + product;
  const double product_virtual = sum - x0;
  const double sum_error = (x0 - (sum - product_virtual)) + (product - product_virtual);
  const double at = sum + (sum_error + product_error);
  return std::clamp(at, std::min(x0, x1), std::max(x0, x1));
}

/// The same, rounded to the nearest float, for x0 and x1 that are floats: so it is between them, too.
double float_at(double x0, double x1, double length) noexcept {
  return static_cast<double>(static_cast<float>(coordinate_at(x0, x1, length)));
}

Vec3 position_at(const MovingVertex& vertex, double length, bool float32) noexcept {
  const auto at = float32 ? float_at : coordinate_at;
  return {at(vertex.start.x, vertex.end.x, length), at(vertex.start.y, vertex.end.y, length),
          at(vertex.start.z, vertex.end.z, length)};
}

bool equal(const Vec3& a, const Vec3& b) noexcept { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// The pairs that stand in the way of a step.
class Obstacles {
 public:
  Obstacles(const Mesh::Impl& mesh, const Motion& step, bool float32) : mesh_(mesh), step_(step), float32_(float32) {}

  void add(const std::vector<MeshContact>& contacts) {
    for (const MeshContact& contact : contacts) {
      Obstacle obstacle;
      obstacle.query = query_of(step_, contact.pair.kind, corners_of(mesh_, contact.pair));
      obstacle.separation = contact.separation;
      obstacles_.push_back(obstacle);
    }
  }

  /// Whether no obstacle is met on the path to the rounded positions after this length. The last obstacle that was met
  /// is asked about first: it is often met again.
  bool let_pass(double length) {
    for (std::size_t i = 0; i < obstacles_.size(); ++i) {
      if (!is_met(obstacles_[i], length)) continue;
      std::swap(obstacles_[0], obstacles_[i]);
      return false;
    }
    return true;
  }

 private:
  struct Obstacle {
    Query query;  ///< the whole step
    Separation separation;
  };

  bool is_met(const Obstacle& obstacle, double length) const {
    Query path = obstacle.query;
    for (std::size_t c = 0; c < corner_count(path.kind); ++c) {
      path.end[c] = position_at({path.start[c], path.end[c]}, length, float32_);
    }
    return solve(path, {.separation = obstacle.separation, .wanted = Wanted::contact}).contact;
  }

  const Mesh::Impl& mesh_;
  const Motion& step_;
  bool float32_;
  std::vector<Obstacle> obstacles_;
};

/// A length <= `longest` that the obstacles let pass, and such that the next longer length that was tried is not let
/// pass. The greatest length of this sort is not sought: rounding lets lengths pass, and stops others, in no order.
double length_that_passes(Obstacles& obstacles, double longest) {
  if (obstacles.let_pass(longest)) return longest;
  double blocked = longest, step = longest - next_below(longest), free = 0;
  while (true) {  // it ends: at the latest where the rounded positions are those of the start
    const double length = step < blocked / 2 ? blocked - step : blocked / 2;
    if (length == 0) return 0;
    if (obstacles.let_pass(length)) {
      free = length;
      break;
    }
    blocked = length;
    step *= 2;
  }
  while (true) {
    const double middle = free + (blocked - free) / 2;
    if (middle <= free || middle >= blocked) return free;
    (obstacles.let_pass(middle) ? free : blocked) = middle;
  }
}

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
      if (static_cast<double>(static_cast<float>(start)) != start) {
        refuse_coordinate(v, k, start, 0, ", which is no float32 number; with float32 a step starts at such numbers");
      }
      const auto rounded = static_cast<double>(static_cast<float>(end));
      if (!std::isfinite(rounded)) {
        refuse_coordinate(v, k, end, 1, ", which is beyond the largest float32 number, 3.4e38");
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
  Obstacles obstacles(mesh, step, options.float32);
  obstacles.add(result.first_contact.earliest);
  const FirstContact& contact = result.first_contact;
  const double before = contact.toi < contact.toi_upper ? contact.toi : next_below(contact.toi);
  double longest = before;
  while (true) {
    check_stop(options.stop);
    result.length = length_that_passes(obstacles, longest);
    const Motion path = path_of(step, result.length, options);
    const bool moves =
        std::any_of(path.begin(), path.end(), [](const MovingVertex& v) { return !equal(v.start, v.end); });
    if (!moves || result.length == 0) {
      result.outcome = StepOutcome::no_room;
      result.positions = packed(step, mesh.dimension, false);
      return result;
    }
    const std::vector<MeshContact> met = find_all(mesh, path, search);
    ++result.proofs;
    if (met.empty()) {
      result.outcome = StepOutcome::shortened;
      result.positions = packed(path, mesh.dimension, true);
      return result;
    }
    obstacles.add(met);
    longest = result.length;
    constexpr int kPatience = 6;  // proofs, before more is given away at a time
    if (result.proofs > kPatience) longest = std::max(longest / 2, before - 2 * (before - longest));
  }
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
