// The contacts that a run keeps for its page: they change nothing, and are those that it counts.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <vector>

#include "scene/shipped_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;

namespace {

SimulationOptions keeping(bool contacts) {
  SimulationOptions options;
  options.keep_contacts = contacts;
  return options;
}

/// Checks the contacts of a substep against its counts. @returns how many there are
std::size_t check_contacts(const SubstepRecord& record, const Colliders& colliders) {
  std::set<Pair> known;
  std::size_t touching = 0, close = 0, of_bodies = 0;
  double last = 0;
  for (const ContactMark& mark : record.contacts) {
    CHECK(known.insert(mark.pair).second);
    CHECK((mark.time >= last && mark.time <= 1));
    CHECK(mark.point.allFinite());
    last = mark.time;
    if (!colliders.is_of_particles(mark.pair)) {
      ++of_bodies;
      continue;
    }
    ++(mark.touches ? touching : close);
    CHECK((mark.time > 0) == mark.touches);
  }
  // Over several passes a pair is counted again, and may be close and then touch.
  const ResponseCounts& counts = record.response;
  CHECK(touching <= counts.contacts);
  CHECK((touching > 0) == (counts.contacts > 0));
  CHECK(close <= counts.close);
  CHECK(close + touching >= counts.close);
  CHECK(of_bodies <= record.bodies.close + record.bodies.contacts);
  return record.contacts.size();
}

/// Runs a scene twice. @returns how many contacts were kept
std::size_t marks_of_run(const char* scene, int steps) {
  Simulation without(make_shipped_scene(scene, {}), keeping(false)), with(make_shipped_scene(scene, {}), keeping(true));
  std::size_t kept = 0;
  for (int i = 0; i < steps; ++i) {
    for (const SubstepRecord& record : without.step()) CHECK(record.contacts.empty());
    for (const SubstepRecord& record : with.step()) kept += check_contacts(record, with.colliders());
  }
  CHECK(without.state().q == with.state().q);
  CHECK(without.state().v == with.state().v);
  if (with.bodies() != nullptr) CHECK(without.bodies()->state() == with.bodies()->state());
  return kept;
}

}  // namespace

TEST_CASE("contacts that are kept for a page are those that are counted, and change nothing") {
  CHECK(marks_of_run("two-edges", 60) > 0);
  CHECK(marks_of_run("hoop", 32) > 100);
  CHECK(marks_of_run("stack", 8) > 0);
}

TEST_CASE("the mark of a touch lies on its first element") {
  Simulation simulation(make_shipped_scene("two-edges", {}), keeping(true));
  std::size_t marks = 0;
  for (int i = 0; i < 60; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      for (const ContactMark& mark : record.contacts) {
        const auto corners = simulation.colliders().corners(mark.pair);
        const Vector3 a = position(simulation.state().q, corners[0]), b = position(simulation.state().q, corners[1]);
        const double along = (mark.point - a).dot(b - a) / (b - a).squaredNorm();
        CHECK((along > -1e-9 && along < 1 + 1e-9));
        CHECK((a + along * (b - a) - mark.point).norm() < 1e-9);
        ++marks;
      }
    }
  }
  CHECK(marks > 0);
}
