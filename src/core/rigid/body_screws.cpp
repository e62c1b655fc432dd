// Bodies that turn at constant rates. Their motions are cut into rational arcs, with a bound on how far all points of a
// body are from where the arcs have them; boxes that are wider by it find the pairs that solve_screw is asked about.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <mutex>
#include <tuple>
#include <vector>

#include <touchstone/bodies.hpp>
#include <touchstone/screw.hpp>

#include "mesh/candidates.hpp"
#include "mesh/earliest.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "rigid/body_search.hpp"
#include "solver/screw_arcs.hpp"
#include "solver/validate.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::rigid {
namespace {

using solver::ScrewArcs;

constexpr int kArcs = 64;  // for the boxes

/// The rational arcs of each body, by a point of it that is farthest from its origin.
std::vector<ScrewArcs> screws_of(const Bodies& bodies, const std::vector<RigidMotion>& motions) {
  std::vector<ScrewArcs> screws;
  screws.reserve(motions.size());
  for (std::size_t b = 0; b < motions.size(); ++b) {
    CurvedQuery farthest;
    farthest.kind = Kind::point_point;
    farthest.motions[0] = motions[b];
    farthest.corners[0] = CurvedCorner::on_body(0, {bodies.bodies[b].impl().reach, 0, 0});
    screws.emplace_back(farthest, kArcs);
  }
  return screws;
}

std::vector<Arc> arcs_of_piece(const Bodies& bodies, const std::vector<ScrewArcs>& screws, int piece) {
  std::vector<Arc> arcs;
  arcs.reserve(screws.size());
  for (std::size_t b = 0; b < screws.size(); ++b) {
    arcs.emplace_back(screws[b].arc(piece).motions[0], 0, 1, bodies.bodies[b].impl().reach, screws[b].deviation(0));
  }
  return arcs;
}

/// All positions, and all orientations in between.
std::vector<Arc> balls_of(const Bodies& bodies, const std::vector<RigidMotion>& motions) {
  std::vector<Arc> balls;
  balls.reserve(motions.size());
  for (std::size_t b = 0; b < motions.size(); ++b) {
    const RigidMotion straight = {{1, 0, 0, 0}, {1, 0, 0, 0}, motions[b].p0, motions[b].p1};
    const double reach = bodies.bodies[b].impl().reach;
    balls.emplace_back(straight, 0, 1, reach, solver::rounded_up(2 * reach + solver::sag_of(motions[b], 1)));
  }
  return balls;
}

/// Asks about pairs, and adds those that are not free.
void ask(const Bodies& bodies, const std::vector<RigidMotion>& motions, const BodyScrewOptions& options,
         const std::vector<BodyPair>& pairs, std::vector<BodyScrewContact>& open) {
  std::mutex lock;
  const auto ask_some = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      mesh::check_stop(options.stop);
      ScrewOptions one;
      one.t_max = options.t_max;
      one.separation = {separation_between(bodies, pairs[i]), bodies.separation.metric};
      one.arcs = options.arcs;
      one.most_arcs = options.most_arcs;
      const ScrewAnswer answer = touchstone::solve_screw(query_between(bodies, pairs[i], motions), one);
      if (answer.verdict == ScrewVerdict::free) continue;
      const std::lock_guard<std::mutex> guard(lock);
      open.push_back({pairs[i], answer});
    }
  };
  threads::for_each_range(pairs.size(), mesh::kContactsAtATime, options.threads, ask_some);
}

BodyScrewAnswer decide(const Bodies& bodies, const CollidingBodies& colliding, const std::vector<RigidMotion>& motions,
                       const BodyScrewOptions& options) {
  BodyScrewAnswer result;
  result.free_until = result.contact_by = options.t_max;
  result.excluded = colliding.excluded();
  result.start_checked = options.check_start;
  if (options.check_start) {
    result.start_intersections = find_intersections(bodies, colliding, starts_of(motions), options, &result);
  }
  const BodyPairs near = near_bodies(bodies, colliding, balls_of(bodies, motions));
  if (near.empty()) return result;
  const std::vector<ScrewArcs> screws = screws_of(bodies, motions);
  Candidates candidates(bodies, options);
  for (int piece = 0; piece < kArcs && static_cast<double>(piece) / kArcs <= result.contact_by; ++piece) {
    ask(bodies, motions, options, candidates.on(on_arcs(near, arcs_of_piece(bodies, screws, piece))), result.pairs);
    for (const BodyScrewContact& one : result.pairs) {
      if (one.answer.verdict != ScrewVerdict::contact) continue;
      result.verdict = ScrewVerdict::contact;
      result.contact_by = std::min(result.contact_by, one.answer.contact_by);
    }
  }
  const auto is_later = [&](const BodyScrewContact& one) { return one.answer.free_until > result.contact_by; };
  result.pairs.erase(std::remove_if(result.pairs.begin(), result.pairs.end(), is_later), result.pairs.end());
  std::sort(result.pairs.begin(), result.pairs.end(), [](const BodyScrewContact& a, const BodyScrewContact& b) {
    return std::tie(a.answer.free_until, a.pair) < std::tie(b.answer.free_until, b.pair);
  });
  if (!result.pairs.empty()) {
    result.free_until = result.pairs.front().answer.free_until;
    if (result.verdict == ScrewVerdict::free) result.verdict = ScrewVerdict::within_bound;
  }
  return result;
}

}  // namespace
}  // namespace touchstone::rigid

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

BodyScrewAnswer solve_screw(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                            const BodyScrewOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, motions, options.threads, solver::OriginPath::curved);
  solver::validate_t_max(options.t_max);
  solver::validate_arcs(options.arcs, options.most_arcs);
  return rigid::decide(bodies, colliding, motions, options);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
