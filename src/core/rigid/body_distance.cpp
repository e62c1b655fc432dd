// The least distance of bodies at rest: pairs of elements are asked, exactly, whether they are within the least
// distance that was found before them, as far as boxes and filters leave them.
// SPDX-License-Identifier: MIT
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include <touchstone/bodies.hpp>
#include <touchstone/distance.hpp>

#include "mesh/candidates.hpp"
#include "mesh/rounded_distance.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "rigid/body_search.hpp"
#include "rigid/near_elements.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::rigid {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The pairs with the least distance of those that were told so far. Any thread may tell.
class NearestPairs {
 public:
  explicit NearestPairs(double most) : least_(most) {}

  const std::atomic<double>& least() const noexcept { return least_; }

  void tell(const BodyPair& pair, double distance) {
    const std::lock_guard<std::mutex> guard(lock_);
    if (distance > least_) return;
    if (distance < least_) pairs_.clear();
    least_ = distance;
    pairs_.push_back({pair, distance});
  }

  std::vector<mesh::Found<BodyPair>>& pairs() noexcept { return pairs_; }

 private:
  std::mutex lock_;
  std::atomic<double> least_;
  std::vector<mesh::Found<BodyPair>> pairs_;
};

/// More than the distance of a point of one body from a point of the other one: where a search may begin.
double some_distance(const BodyOnArc& a, const BodyOnArc& b) noexcept {
  const auto point_of = [](const BodyOnArc& one) {
    const Vec3& point = one.body.points[mesh::representative(one.body.mesh.impl(), 0).corners[0]];
    return one.arc.ends_of(point).start;
  };
  const Vec3 x = point_of(a), y = point_of(b);
  const double off = a.arc.deviation(a.body.reach) + b.arc.deviation(b.body.reach);
  const double distance = (std::hypot(x.x - y.x, x.y - y.y, x.z - y.z) + off) * (1 + 0x1p-40);
  return distance < kInfinity ? distance : kInfinity;
}

BodyDistance find_distance(const Bodies& bodies, const CollidingBodies& colliding, const std::vector<Pose>& poses,
                           const MeshOptions& options) {
  BodyDistance result;
  result.intersections = find_intersections(bodies, colliding, poses, options, &result);

  const std::vector<RigidMotion> motions = resting(poses);
  const std::vector<Arc> arcs = arcs_of(bodies, motions, 0, 0);
  const auto on_arc = [&](BodyIndex b) { return BodyOnArc{b, bodies.bodies[b].impl(), arcs[b]}; };
  BodyPairs asked;
  double most = kInfinity;
  for (BodyIndex b = 1; b < arcs.size(); ++b) {
    for (BodyIndex a = 0; a < b; ++a) {
      if (bodies.bodies[a].impl().tree.empty() || bodies.bodies[b].impl().tree.empty()) continue;
      if (!colliding.may_collide(a, b)) continue;
      asked.push_back({a, b});
      most = std::min(most, some_distance(on_arc(a), on_arc(b)));
    }
  }
  NearestPairs nearest(result.intersections.empty() ? most : 0);
  const Metric metric = bodies.separation.metric;
  threads::for_each_range(asked.size(), 1, options.threads, [&](std::size_t first, std::size_t last) {
    const NearConsumer take = [&](const NearElements& near) {
      mesh::check_stop(options.stop);
      const BodyPair pair = pair_of(near);
      const CurvedQuery query = query_between(bodies, pair, motions);
      const double least = nearest.least();
      if (least < kInfinity && compare_distance(query, 0, {least, metric}) > 0) return;
      nearest.tell(pair, mesh::distance_rounded_up(query, metric));
    };
    for (std::size_t i = first; i < last; ++i) {
      mesh::check_stop(options.stop);
      for_each_nearer_at_rest(on_arc(asked[i][0]), on_arc(asked[i][1]), metric, nearest.least(), take);
    }
  });
  StepOptions at_rest;
  static_cast<MeshOptions&>(at_rest) = options;
  result.distance = nearest.pairs().empty() && result.intersections.empty() ? kInfinity : nearest.least().load();
  if (result.distance == kInfinity) nearest.pairs().clear();
  result.pairs = with_answers(bodies, motions, nearest.pairs(), at_rest);
  return result;
}

}  // namespace
}  // namespace touchstone::rigid

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

BodyDistance distance(const Bodies& bodies, const std::vector<Pose>& poses, const MeshOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, rigid::resting(poses), options.threads);
  return rigid::find_distance(bodies, colliding, poses, options);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
