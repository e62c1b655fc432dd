// A step of bodies is cut into pieces. In each, boxes around the elements' arcs are compared, and the pairs whose boxes
// meet are asked about the whole step, once, by the exact solver for curved queries.
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

// A piece of a step is halved while arcs in it leave straight motion by too much beside bodies that are near each other
// in it. By default that is a small part of a body's width, in pieces that are longer than kShort. A body may turn
// about an origin far from it: then its arcs leave straight motion by as much as its width, and all of its elements
// seem to be near. Such pieces are halved further. Mostly there are few: the body crosses the width of the other one in
// little time. Bodies that turn about one far origin together stay near. They are seen from a frame that turns with
// them; where their turns differ too much for that, but not enough to part them, only so many pieces are halved.
constexpr double kLittle = 1.0 / 256, kMuch = 1.0 / 16;
constexpr double kShort = 0x1p-8;
constexpr double kShortest = 0x1p-20;  // as Arc asks
constexpr int kMostHalved = 1024;      // of the pieces that are no longer than kShort

double width_of(const Body::Impl& body) noexcept {
  double width = 0;
  for (std::size_t k = 0; k < 3; ++k) width = std::max(width, body.box.high[k] - body.box.low[k]);
  return width;
}

constexpr double kFar = 8;  // times its width: an origin that is far from a body

/// The arcs of two bodies, which are about their own origins or, if that is much narrower, seen from a frame that turns
/// with both.
PairOnArcs on_narrow_arcs(const Bodies& bodies, const std::vector<RigidMotion>& motions, const std::vector<Arc>& arcs,
                          const std::array<BodyIndex, 2>& pair, double from, double to) {
  const auto [a, b] = pair;
  const Body::Impl &of_a = bodies.bodies[a].impl(), &of_b = bodies.bodies[b].impl();
  PairOnArcs plain{pair, {arcs[a], arcs[b]}};
  if (of_a.reach <= kFar * width_of(of_a) || of_b.reach <= kFar * width_of(of_b)) return plain;
  const auto together = turn_together(motions[a], of_a.box, motions[b], of_b.box, from, to);
  const auto bulge = [](const std::array<Arc, 2>& both) { return both[0].bulge() + both[1].bulge(); };
  return together && bulge(*together) < bulge(plain.arcs) / 2 ? PairOnArcs{pair, *together} : plain;
}

/// Whether a piece of this duration is to be halved.
bool is_too_long(const Bodies& bodies, const std::vector<PairOnArcs>& near, double duration) {
  return duration > kShortest && std::any_of(near.begin(), near.end(), [&](const PairOnArcs& pair) {
           std::array<double, 2> width, bulge;
           for (std::size_t i = 0; i < 2; ++i) {
             width[i] = width_of(bodies.bodies[pair.bodies[i]].impl());
             bulge[i] = pair.arcs[i].bulge();
             if (duration > kShort && bulge[i] > kLittle * width[i]) return true;
           }
           return std::max(bulge[0], bulge[1]) > kMuch * std::max(width[0], width[1]);
         });
}

BoundsByAxis box_on(const Bodies& bodies, BodyIndex number, const Arc& arc) noexcept {
  const Body::Impl& body = bodies.bodies[number].impl();
  return arc.around(body.box, body.reach, mesh::with_room(bodies.separation.distance / 2 + body.radius));
}

/// Calls ask(near) for pieces that follow one another and make up a step, with the pairs of bodies that are near each
/// other in the piece, if there are any. Pieces that begin after `until` are left out.
template <class Ask>
void for_each_piece(const Bodies& bodies, const std::vector<RigidMotion>& motions, const BodyPairs& may_be_near,
                    const std::atomic<double>& until, double from, double to, int& halved, const Ask& ask) {
  if (from > 0 && from >= until) return;
  const std::vector<Arc> arcs = arcs_of(bodies, motions, from, to);
  BodyPairs near;
  std::vector<PairOnArcs> near_on_arcs;
  for (const std::array<BodyIndex, 2>& pair : may_be_near) {
    const PairOnArcs now = on_narrow_arcs(bodies, motions, arcs, pair, from, to);
    if (!broad_phase::meet(box_on(bodies, pair[0], now.arcs[0]), box_on(bodies, pair[1], now.arcs[1]))) continue;
    near.push_back(pair);
    near_on_arcs.push_back(now);
  }
  if (near.empty()) return;
  const bool is_short = to - from <= kShort;
  if ((is_short && halved >= kMostHalved) || !is_too_long(bodies, near_on_arcs, to - from)) return ask(near_on_arcs);
  if (is_short) ++halved;
  const double middle = from / 2 + to / 2;
  for_each_piece(bodies, motions, near, until, from, middle, halved, ask);
  for_each_piece(bodies, motions, near, until, middle, to, halved, ask);
}

/// Asks about all pairs that may be in contact by a time that may fall meanwhile.
/// @param tell  tell(pair, distance, answer) for those in contact. Several threads may call it at the same time
template <class Tell>
void for_each_contact(const Bodies& bodies, const CollidingBodies& colliding, const std::vector<RigidMotion>& motions,
                      const MeshOptions& options, const std::atomic<double>& until, Wanted wanted, const Tell& tell) {
  const BodyPairs near = near_bodies(bodies, colliding, arcs_of(bodies, motions, 0, 1));
  Candidates candidates(bodies, options);
  int halved = 0;
  for_each_piece(bodies, motions, near, until, 0, 1, halved, [&](const std::vector<PairOnArcs>& now) {
    const std::vector<BodyPair> pairs = candidates.on(now);
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
  });
}

}  // namespace

BodyPair pair_of(const NearElements& near) noexcept {
  const Kind kind = near.first_sort == MeshElement::edge    ? Kind::edge_edge
                    : near.second_sort == MeshElement::face ? Kind::vertex_face
                    : near.second_sort == MeshElement::edge ? Kind::point_edge
                                                            : Kind::point_point;
  return {kind, near.first, near.second};
}

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
    if (bodies.bodies[b].impl().tree.empty()) continue;
    boxes.push_back(box_on(bodies, b, whole[b]));
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

std::vector<PairOnArcs> on_arcs(const BodyPairs& pairs, const std::vector<Arc>& arcs) {
  std::vector<PairOnArcs> all;
  all.reserve(pairs.size());
  for (const auto& [a, b] : pairs) all.push_back({{a, b}, {arcs[a], arcs[b]}});
  return all;
}

std::vector<BodyPair> Candidates::on(const std::vector<PairOnArcs>& near) {
  std::vector<BodyPair> found;
  std::mutex lock;
  threads::for_each_range(near.size(), 1, options_.threads, [&](std::size_t first, std::size_t last) {
    std::vector<BodyPair> some;
    const NearConsumer take = [&some](const NearElements& elements) { some.push_back(pair_of(elements)); };
    for (std::size_t i = first; i < last; ++i) {
      mesh::check_stop(options_.stop);
      const auto& [pair, arcs] = near[i];
      const auto [a, b] = pair;
      for_each_near_in_motion(bodies_, {a, bodies_.bodies[a].impl(), arcs[0]}, {b, bodies_.bodies[b].impl(), arcs[1]},
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
    result.start_intersections = find_intersections(bodies, colliding, starts_of(motions), options, &result);
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
  rigid::validate(bodies, motions, options.threads);
  solver::validate_t_max(options.t_max);
  return rigid::find_first(bodies, colliding, motions, options);
}

std::vector<BodyContact> all_contacts(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                      const StepOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, motions, options.threads);
  solver::validate_t_max(options.t_max);
  return rigid::find_all(bodies, colliding, motions, options);
}

std::vector<BodyPair> candidates(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                 const MeshOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, motions, options.threads);
  const auto near = rigid::near_bodies(bodies, colliding, rigid::arcs_of(bodies, motions, 0, 1));
  rigid::Candidates candidates(bodies, options);
  std::vector<BodyPair> all;
  const std::atomic<double> until{1};
  int halved = 0;
  rigid::for_each_piece(bodies, motions, near, until, 0, 1, halved, [&](const std::vector<rigid::PairOnArcs>& now) {
    const std::vector<BodyPair> some = candidates.on(now);
    all.insert(all.end(), some.begin(), some.end());
  });
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
