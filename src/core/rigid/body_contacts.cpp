// A step of bodies is cut into pieces of equal duration. In each, boxes around the elements' arcs are compared, and the
// pairs whose boxes meet are asked about the whole step, once, by the exact solver for curved queries.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <iterator>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include <touchstone/bodies.hpp>
#include <touchstone/contact_times.hpp>
#include <touchstone/curved.hpp>

#include "broad_phase/box_tree.hpp"
#include "mesh/candidates.hpp"
#include "mesh/earliest.hpp"
#include "mesh/pair_distance.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "rigid/arc.hpp"
#include "rigid/body_search.hpp"
#include "rigid/near_elements.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::rigid {
namespace {

/// Arcs leave straight motion by no more than this part of a body's width.
constexpr double kLittle = 1.0 / 256;

/// Into how many pieces a step is cut.
int pieces_for(const Bodies& bodies, const std::vector<RigidMotion>& motions, const BodyPairs& near) {
  std::vector<char> asked(motions.size(), 0);
  for (const auto& [a, b] : near) asked[a] = asked[b] = 1;
  int count = 1;
  for (std::size_t b = 0; b < motions.size(); ++b) {
    if (asked[b] == 0) continue;
    const Body::Impl& body = bodies.bodies[b].impl();
    double width = 0;
    for (std::size_t k = 0; k < 3; ++k) width = std::max(width, body.box.high[k] - body.box.low[k]);
    count = std::max(count, arcs_for(motions[b], body.reach, kLittle * width));
  }
  return count;
}

BodyPair pair_of(const NearElements& near) noexcept {
  const Kind kind = near.first_sort == MeshElement::edge    ? Kind::edge_edge
                    : near.second_sort == MeshElement::face ? Kind::vertex_face
                    : near.second_sort == MeshElement::edge ? Kind::point_edge
                                                            : Kind::point_point;
  return {kind, near.first, near.second};
}

/// Asks about all pairs that may be in contact by a time that may fall meanwhile.
/// @param tell  tell(pair, distance, answer) for those in contact. Several threads may call it at the same time
template <class Tell>
void for_each_contact(const Bodies& bodies, const CollidingBodies& colliding, const std::vector<RigidMotion>& motions,
                      const MeshOptions& options, const std::atomic<double>& until, Wanted wanted, const Tell& tell) {
  const BodyPairs near = near_bodies(bodies, colliding, arcs_of(bodies, motions, 0, 1));
  const int pieces = pieces_for(bodies, motions, near);
  Candidates candidates(bodies, near, options);
  for (int piece = 0; piece < pieces; ++piece) {
    const double from = static_cast<double>(piece) / pieces, to = static_cast<double>(piece + 1) / pieces;
    if (piece > 0 && from >= until) return;
    const std::vector<BodyPair> pairs = candidates.on(arcs_of(bodies, motions, from, to));
    threads::for_each_range(
        pairs.size(), mesh::kContactsAtATime, options.threads, [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            mesh::check_stop(options.stop);
            const double distance = separation_between(bodies, pairs[i]);
            const Answer answer = solver::answer(query_between(bodies, pairs[i], motions),
                                                 {distance, bodies.separation.metric}, Method::fast, until, wanted);
            if (answer.contact) tell(pairs[i], distance, answer);
          }
        });
  }
}

/// The whole answers for pairs, in ascending order.
std::vector<BodyContact> with_answers(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                      std::vector<mesh::Found<BodyPair>>& found, const StepOptions& options) {
  std::sort(found.begin(), found.end());
  std::vector<BodyContact> contacts(found.size());
  threads::for_each_range(
      found.size(), mesh::kContactsAtATime, options.threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
          mesh::check_stop(options.stop);
          const Separation separation{found[i].distance, bodies.separation.metric};
          const CurvedQuery query = query_between(bodies, found[i].pair, motions);
          contacts[i] = {found[i].pair, separation, solver::answer(query, separation, Method::fast, options.t_max)};
        }
      });
  return contacts;
}

}  // namespace

std::vector<Arc> arcs_of(const Bodies& bodies, const std::vector<RigidMotion>& motions, double from, double to) {
  std::vector<Arc> arcs;
  arcs.reserve(motions.size());
  for (std::size_t b = 0; b < motions.size(); ++b) {
    arcs.emplace_back(motions[b], from, to, bodies.bodies[b].impl().reach);
  }
  return arcs;
}

BodyPairs near_bodies(const Bodies& bodies, const CollidingBodies& colliding, const std::vector<Arc>& whole) {
  std::vector<BoundsByAxis> boxes;
  std::vector<BodyIndex> numbers;
  for (BodyIndex b = 0; b < whole.size(); ++b) {
    const Body::Impl& body = bodies.bodies[b].impl();
    if (body.tree.empty()) continue;
    const double margin = mesh::with_room(bodies.separation.distance / 2 + body.radius);
    boxes.push_back(whole[b].around(body.box, body.reach, margin));
    numbers.push_back(b);
  }
  BodyPairs near;
  broad_phase::for_each_pair_block<BoundsByAxis>(
      boxes.size(), [&](std::uint32_t n) { return boxes[n]; }, {},
      [&](const broad_phase::Pair* pairs, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
          const auto [first, second] = std::minmax(pairs[i][0], pairs[i][1]);
          const BodyIndex a = numbers[first], b = numbers[second];
          if (colliding.may_collide(a, b)) near.push_back({a, b});
        }
      });
  std::sort(near.begin(), near.end());
  return near;
}

std::vector<BodyPair> Candidates::on(const std::vector<Arc>& arcs) {
  std::vector<BodyPair> found;
  std::mutex lock;
  threads::for_each_range(near_.size(), 1, options_.threads, [&](std::size_t first, std::size_t last) {
    std::vector<BodyPair> some;
    const NearConsumer take = [&some](const NearElements& near) { some.push_back(pair_of(near)); };
    for (std::size_t i = first; i < last; ++i) {
      mesh::check_stop(options_.stop);
      const auto [a, b] = near_[i];
      for_each_near_in_motion(bodies_, {a, bodies_.bodies[a].impl(), arcs[a]}, {b, bodies_.bodies[b].impl(), arcs[b]},
                              take);
    }
    const std::lock_guard<std::mutex> guard(lock);
    found.insert(found.end(), some.begin(), some.end());
  });
  std::sort(found.begin(), found.end());
  std::vector<BodyPair> fresh, all;
  std::set_difference(found.begin(), found.end(), known_.begin(), known_.end(), std::back_inserter(fresh));
  std::set_union(known_.begin(), known_.end(), fresh.begin(), fresh.end(), std::back_inserter(all));
  known_ = std::move(all);
  return fresh;
}

std::vector<Pose> starts_of(const std::vector<RigidMotion>& motions) {
  std::vector<Pose> poses;
  for (const RigidMotion& motion : motions) poses.push_back({motion.q0, motion.p0});
  return poses;
}

std::vector<RigidMotion> resting(const std::vector<Pose>& poses) {
  std::vector<RigidMotion> motions;
  for (const Pose& pose : poses) motions.push_back({pose.orientation, pose.orientation, pose.position, pose.position});
  return motions;
}

std::vector<BodyContact> find_all(const Bodies& bodies, const CollidingBodies& colliding,
                                  const std::vector<RigidMotion>& motions, const StepOptions& options) {
  std::mutex lock;
  std::vector<BodyContact> contacts;
  const std::atomic<double> until{options.t_max};
  for_each_contact(bodies, colliding, motions, options, until, Wanted::all,
                   [&](const BodyPair& pair, double distance, const Answer& answer) {
                     const std::lock_guard<std::mutex> guard(lock);
                     contacts.push_back({pair, {distance, bodies.separation.metric}, answer});
                   });
  std::sort(contacts.begin(), contacts.end(), [](const BodyContact& a, const BodyContact& b) {
    return std::tie(a.answer.toi, a.answer.toi_upper, a.pair) < std::tie(b.answer.toi, b.answer.toi_upper, b.pair);
  });
  return contacts;
}

FirstBodyContact find_first(const Bodies& bodies, const CollidingBodies& colliding,
                            const std::vector<RigidMotion>& motions, const BodyStepOptions& options) {
  mesh::Earliest<BodyPair> earliest(options.t_max);
  for_each_contact(
      bodies, colliding, motions, options, earliest.until(), Wanted::time,
      [&](const BodyPair& pair, double distance, const Answer& answer) { earliest.tell(pair, distance, answer); });
  FirstBodyContact result;
  result.contact = !earliest.first().empty();
  result.toi = earliest.toi();
  result.toi_upper = earliest.toi_upper();
  result.earliest = with_answers(bodies, motions, earliest.first(), options);
  mesh::keep_exactly_first(result.earliest, options.threads, [&](const BodyContact& contact) {
    const CurvedQuery query = query_between(bodies, contact.pair, motions);
    return contact_times(query, contact.separation, contact.answer.toi_upper).front().first;
  });
  result.at_start = with_answers(bodies, motions, earliest.at_start(), options);
  result.start_checked = options.check_start;
  if (options.check_start) {
    Unclear unclear;
    result.start_intersections = find_intersections(bodies, colliding, starts_of(motions), options, &unclear);
    result.in_open = unclear.in_open;
    result.cancelled = unclear.cancelled;
  }
  result.excluded = colliding.excluded();
  return result;
}

}  // namespace touchstone::rigid

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

FirstBodyContact first_contact(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                               const BodyStepOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, motions);
  solver::validate_t_max(options.t_max);
  return rigid::find_first(bodies, colliding, motions, options);
}

std::vector<BodyContact> all_contacts(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                      const StepOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, motions);
  solver::validate_t_max(options.t_max);
  return rigid::find_all(bodies, colliding, motions, options);
}

std::vector<BodyPair> candidates(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                 const MeshOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, motions);
  const auto near = rigid::near_bodies(bodies, colliding, rigid::arcs_of(bodies, motions, 0, 1));
  const int pieces = rigid::pieces_for(bodies, motions, near);
  rigid::Candidates candidates(bodies, near, options);
  std::vector<BodyPair> all;
  for (int piece = 0; piece < pieces; ++piece) {
    const double from = static_cast<double>(piece) / pieces, to = static_cast<double>(piece + 1) / pieces;
    const std::vector<BodyPair> some = candidates.on(rigid::arcs_of(bodies, motions, from, to));
    all.insert(all.end(), some.begin(), some.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
