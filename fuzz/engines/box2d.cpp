// Box2D: time of impact in the plane.
// SPDX-License-Identifier: MIT
#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include "engine.hpp"

namespace {

using engine::Answer;
using engine::Query;

b2Vec2 vector(const engine::Point& p) { return {static_cast<float>(p[0]), static_cast<float>(p[1])}; }

/// The sweep of a body whose centre is the element's first corner.
b2Sweep sweep(const Query& q, std::size_t corner) {
  b2Sweep s{};
  s.localCenter.SetZero();  // its own constructor leaves it as it is
  s.c0 = vector(q.start[corner]);
  s.c = vector(q.end[corner]);
  return s;
}

/// Two points or segments without a radius: the target distance then is b2_linearSlop.
Answer toi(const Query& q) {
  b2Vec2 a[2], b[2];
  const std::size_t first = q.first(), second = q.start.size() - first;
  for (std::size_t i = 0; i < first; ++i) a[i] = vector(q.start[i]) - vector(q.start[0]);
  for (std::size_t i = 0; i < second; ++i) b[i] = vector(q.start[first + i]) - vector(q.start[first]);
  b2TOIInput input;
  input.proxyA.Set(a, static_cast<int32>(first), 0);
  input.proxyB.Set(b, static_cast<int32>(second), 0);
  input.sweepA = sweep(q, 0);
  input.sweepB = sweep(q, first);
  input.tMax = 1;
  b2TOIOutput output;
  b2TimeOfImpact(&output, &input);
  switch (output.state) {
    case b2TOIOutput::e_overlapped:
    case b2TOIOutput::e_touching: return engine::contact_at(static_cast<double>(output.t));
    case b2TOIOutput::e_separated: return engine::no_contact();
    default: return engine::failed();
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string version = "engine Box2D " + std::to_string(b2_version.major) + "." +
                              std::to_string(b2_version.minor) + "." + std::to_string(b2_version.revision) + "\n";
  return engine::serve(argc, argv,
                       {{"toi",
                         version + "asks b2TimeOfImpact of points and segments without a radius\n"
                                   "kinds edge-edge point-edge point-point\n"
                                   "motion translations\n"
                                   "space 2\n"
                                   "numbers float\n"
                                   "elements 0.001\n"
                                   "sizes 0.1 10\n"
                                   "separation 0.005\n"
                                   "tolerance-length 0.00125\n"
                                   "tolerance-relative 1e-6\n"
                                   "note its target is the distance b2_linearSlop, 0.005, within a quarter of it\n"
                                   "note it says that it may miss some intermediate, non-tunneling collisions\n",
                         toi}});
}
