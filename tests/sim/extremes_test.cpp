// Stiff, light, tiny and far-away scenes: no NaN, no crossing, and no gain of energy.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

using namespace touchstone::sim;

namespace {

constexpr double kRounding = 1e-11;  // of energies

/// A run whose substeps are compared with the report of the response. `before` is the energy before a substep, and
/// `without` the energy after it without contacts. Contacts add no energy to them, except for lifting weight by the
/// thickness and 0.2 % of the kinetic and stored energy.
class ExtremeCourse {
 public:
  explicit ExtremeCourse(const Scene& scene)
      : simulation_(scene, {NarrowPhase::exact, 1, [this] { note_start(); }}),
        alone_(simulation_.system(), scene.settings),
        lifted_(simulation_.system().force.cwiseAbs().sum() * simulation_.thickness()) {
    ready_ = true;
  }

  void run(int steps) {
    for (int i = 0; i < steps; ++i) {
      CAPTURE(i);
      starts_.clear();
      const double before = simulation_.energies().total();
      const auto records = simulation_.step();
      ends_.assign(starts_.begin() + 1, starts_.end());
      ends_.push_back(simulation_.state());
      REQUIRE(records.size() == starts_.size());
      check_lengths(records);
      for (std::size_t part = 0; part < records.size(); ++part) check(records[part], starts_[part], ends_[part]);
      const double gain = simulation_.energies().total() - before;
      gained += std::max(gain, 0.0);
      most_gain = std::max(most_gain, gain);
      REQUIRE(simulation_.state().q.allFinite());
      REQUIRE(simulation_.state().v.allFinite());
    }
    CHECK(simulation_.crossings().empty());
  }

  Energies energies() const { return simulation_.energies(); }
  double lifted() const { return lifted_; }  // J, by the thickness

  std::uint64_t contacts = 0, taken_all_the_same = 0, grown = 0;
  double gained = 0, most_gain = -1e300;  // J, from step to step

 private:
  void note_start() {
    if (!ready_) return;  // the simulation is being made
    // Every check of a substep sees the state at its start, and so do those of a substep that is tried again.
    if (starts_.empty() || starts_.back().time != simulation_.state().time) starts_.push_back(simulation_.state());
  }

  /// Parts are shares 2^-k of the step that begin at multiples of themselves; after one that was cut they grow again.
  void check_lengths(const std::vector<SubstepRecord>& records) {
    double done = 0;
    for (std::size_t part = 0; part < records.size(); ++part) {
      const double share = records[part].length / simulation_.scene().settings.time_step;
      CHECK(std::abs(std::log2(share) - std::round(std::log2(share))) < 1e-6);
      CHECK(std::abs(done / share - std::round(done / share)) < 1e-6);
      CHECK(records[part].time == ends_[part].time);
      done += share;
      grown += part > 0 && records[part].length > 1.5 * records[part - 1].length;
    }
    CHECK(done == Approx(1));
  }

  void check(const SubstepRecord& record, const State& start, const State& end) {
    const std::uint64_t touched = record.response.contacts + record.response.close;
    contacts += touched;
    taken_all_the_same += static_cast<std::uint64_t>(record.gained_energy);
    if (touched == 0 || record.gained_energy != 0) return;
    const System& system = simulation_.system();
    const Energies before = touchstone::sim::energies(system, start), after = touchstone::sim::energies(system, end);
    // Implicit Euler by itself only loses energy; the others may gain some where forces are not linear.
    Energies without = before;
    if (simulation_.scene().settings.integrator != Integrator::implicit_euler) {
      const Advance advance = alone_.advance(start, record.length);
      REQUIRE(advance.converged);
      without = touchstone::sim::energies(system, advance.state);
    }
    const double inner = std::max(before.total() - before.load, without.total() - without.load);
    const double rounding = kRounding * (std::abs(before.load) + inner);
    const double gain = after.total() - std::max(before.total(), without.total());
    CAPTURE(gain, inner, lifted_);
    CHECK(gain <= 2e-3 * inner + lifted_ + rounding);
  }

  bool ready_ = false;                // declared before the simulation, whose constructor calls note_start
  std::vector<State> starts_, ends_;  // of the parts of a step
  Simulation simulation_;
  Stepper alone_;
  double lifted_;
};

/// A cable that falls across a pinned wire, in the middle of it.
Scene cable_on_wire(const Vector3& origin, double young, double density, double radius) {
  Scene scene;
  scene.settings.contact.restitution = 0;
  scene.settings.contact.friction = 0.5;
  scene.settings.contact.thickness = 1e-3;
  const Index a = add_pinned(scene, origin + Vector3(0.013, -0.5, 0)),
              b = add_pinned(scene, origin + Vector3(0.01, 0.5, 0.001));
  scene.wires.push_back({a, b});
  Cable& cable = add_cable(scene, origin + Vector3(-0.5, 0.01, 0.05), origin + Vector3(0.51, -0.01, 0.05), 40);
  set_material(cable, young, 0.3, radius, density);
  cable.twist = 0;
  cable.damping = 1e-4;
  return scene;
}

/// A chain whose every other link is a million times softer, across a wire.
Scene stiffness_jump() {
  Scene scene;
  for (int i = 0; i <= 10; ++i) add_particle(scene, {0.1 * i, 0.01 * std::sin(2.0 * i), 0}, 0.01);
  scene.particles[0].fixed = {true, true, true};
  for (Index i = 0; i < 10; ++i) add_spring(scene, i, i + 1, i % 2 == 0 ? 1e7 : 10, 0, true);
  const Index a = add_pinned(scene, {0.33, -0.5, -0.2}), b = add_pinned(scene, {0.3, 0.5, -0.21});
  scene.wires.push_back({a, b});
  return scene;
}

/// Edges of 10 N/m and of 1e7 N/m are thrown at one another.
Scene soft_meets_stiff() {
  Scene scene;
  scene.settings.contact.friction = 0.3;
  for (int i = 0; i < 6; ++i) {
    const bool stiff = i % 2 == 0;
    const double side = 0.15 * (i / 2), up = stiff ? 0 : 0.08;
    const Index a = add_particle(scene, stiff ? Vector3(-0.2, side, up) : Vector3(0.01, side - 0.2, up + 0.01), 0.02);
    const Index b = add_particle(scene, stiff ? Vector3(0.2, side + 0.01, up) : Vector3(0, side + 0.2, up), 0.02);
    add_spring(scene, a, b, stiff ? 1e7 : 10, 0, true);
    for (const Index p : {a, b}) scene.particles[p].velocity = {0, 0.2 * i, stiff ? 2.0 : -3.0};
  }
  return scene;
}

/// An edge falls on a cord that is held at both ends, and each of whose particles is ten thousand times lighter.
Scene heavy_on_light() {
  Scene scene;
  scene.settings.contact.friction = 0.3;
  Cable& cord = add_cable(scene, {-0.5, 0, 0}, {0.5, 0.01, 0}, 20);
  set_material(cord, 1e9, 0.4, 0.002, 1000);
  cord.bend = cord.twist = 0;
  for (const Index p : {0, 20}) scene.particles[p].fixed = {true, true, true};
  const double light = 1000 * 3.141592653589793 * 0.002 * 0.002 * 0.05;
  const Index a = add_particle(scene, {0.03, -0.2, 0.05}, 1e4 * light),
              b = add_particle(scene, {0.01, 0.21, 0.06}, 1e4 * light);
  add_spring(scene, a, b, 1e6, 0, true);
  return scene;
}

/// The cable's segments grow geometrically from one end to the other.
Scene short_and_long_segments() {
  Scene scene = cable_on_wire(Vector3::Zero(), 1e8, 1200, 2e-3);
  const Cable& cable = scene.cables[0];
  const std::size_t count = cable.particles.size();
  const double ratio = std::pow(1000.0, 1.0 / static_cast<double>(count - 2));
  double at = 0, length = 1;
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i, at += length, length *= ratio) places.push_back(at);
  for (std::size_t i = 0; i < count; ++i) {
    scene.particles[cable.particles[i]].position = {-0.5 + places[i] / places.back(), 0.01, 0.05};
  }
  scene.settings.contact.thickness = 5e-5;
  return scene;
}

/// Steel, r = 1 mm, that bends and twists, thrown at the wire.
Scene thrown_steel() {
  Scene scene = cable_on_wire(Vector3::Zero(), 2e11, 7800, 1e-3);
  set_material(scene.cables[0], 2e11, 0.3, 1e-3, 7800);
  scene.settings.contact.restitution = 0.5;
  for (const Index p : scene.cables[0].particles) scene.particles[p].velocity = {1, 0, -5};
  return scene;
}

struct Extreme {
  const char* name;
  std::function<Scene()> make;
  int steps;
  bool loses = true;         // energy in each step of implicit Euler: not even lifting by the thickness shows
  bool second_order = true;  // methods of second order take it; where it is so stiff and turns so far, they gain energy
                             // by themselves, TR-BDF2 up to where no step can be taken
};

/// Far longer steps than those of the scene.
Scene in_long_steps(const char* name, Index size) {
  Scene scene = make_shipped_scene(name, size);
  scene.settings.time_step = 1.0 / 60;
  return scene;
}

std::vector<Extreme> extremes() {
  return {
      {"a steel cable of radius 1 mm", [] { return cable_on_wire(Vector3::Zero(), 2e11, 7800, 1e-3); }, 90},
      {"a steel cable that twists, at 5 m/s", thrown_steel, 60, true, false},
      {"everything shifted by 1e6 m",
       [] {
         return cable_on_wire({1e6, -1e6, 1e6}, 2e8, 2000, 2e-3);
       },
       60},
      {"a mass ratio of 1e4 along a chain", [] { return in_long_steps("chain", 20); }, 120},
      {"a mass ratio of 1e4 in a contact", heavy_on_light, 90, false},
      {"a stiffness jump of 1e6 along a chain", stiffness_jump, 120},
      {"a stiffness jump of 1e6 in contacts", soft_meets_stiff, 60},
      {"segment lengths from 1 to 1000", short_and_long_segments, 60},
      {"a whip at 100 m/s", [] { return in_long_steps("whip", 30); }, 20, true, false},
  };
}

}  // namespace

TEST_CASE("what is stiff, light, tiny or far away: no NaN, no crossing, and no energy out of contacts", "[slow]") {
  const auto all = extremes();
  const auto number = GENERATE_COPY(range(std::size_t{0}, all.size()));
  const auto integrator = GENERATE(Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint);
  const Extreme& extreme = all[number];
  CAPTURE(extreme.name, integrator_name(integrator));
  if (integrator != Integrator::implicit_euler && !extreme.second_order) return;
  Scene scene = extreme.make();
  scene.settings.integrator = integrator;
  ExtremeCourse course(scene);
  const Energies first = course.energies();
  course.run(extreme.steps);
  CHECK(course.contacts > 0);
  CHECK(course.taken_all_the_same == 0);
  if (integrator != Integrator::implicit_euler) return;
  CHECK(course.energies().total() < first.total());
  if (!extreme.loses) CHECK(course.grown > 0);  // the heavy edge needs shorter parts, but not to a step's end
  if (extreme.loses) CHECK(course.most_gain <= kRounding * (std::abs(first.load) + first.total() - first.load));
}

TEST_CASE("a pile of cables rests, step after step") {
  ExtremeCourse course(make_shipped_scene("cable-drop", 60));
  course.run(1500);
  CHECK(course.contacts > 1000);
  CHECK(course.taken_all_the_same == 0);
  CHECK(course.gained < 1e-6 * course.lifted());
}

TEST_CASE("a small pile of crossed cables rests for 100,000 steps", "[heavy]") {
  // Two cables across two on the floor.
  Scene scene;
  scene.settings.contact.restitution = 0.1;
  scene.settings.contact.friction = 0.4;
  scene.settings.contact.thickness = 2e-3;
  for (int i = 0; i < 4; ++i) {
    const bool crosswise = i / 2 == 1;
    const double side = i % 2 == 0 ? -0.06 : 0.07, up = 0.01 + 0.01 * (i / 2) + 0.001 * i;
    const Vector3 from = crosswise ? Vector3(side, -0.11, up) : Vector3(-0.10, side, up);
    const Vector3 to = crosswise ? Vector3(side + 0.004, 0.10, up) : Vector3(0.11, side - 0.003, up);
    Cable& cable = add_cable(scene, from, to, 2);
    set_material(cable, 1e7, 0.4, 0.003, 1200);
    cable.twist = 0;
    cable.damping = 2e-3;
  }
  add_floor(scene, 1);
  ExtremeCourse course(scene);
  course.run(600);
  const double settled = course.energies().total();
  course.contacts = 0;
  const auto steps = static_cast<int>(touchstone::tests::effort(100'000));
  if (steps < 100'000) WARN(steps << " steps only: this build is slow, or TOUCHSTONE_EFFORT asks for fewer");
  course.run(steps);
  CHECK(course.contacts > static_cast<std::uint64_t>(steps));
  CHECK(course.taken_all_the_same == 0);
  // Friction at rest creeps, so the scene sinks. It never rises: a step lifts it by less than a hundredth of the
  // thickness, and all of them together by less than the thickness.
  CAPTURE(settled, course.lifted());
  CHECK(course.energies().total() <= settled);
  CHECK(course.most_gain < 0.01 * course.lifted());
  CHECK(course.gained < course.lifted());
  CHECK(course.energies().kinetic < 1.5e-10);  // its 29 g are slower than a tenth of a millimetre a second
}

TEST_CASE("springs that buckle gain no energy under implicit Euler: such steps are cut") {
  // In one whole step, the tenth or so, the energy would grow by a tenth.
  const Scene scene = scene_from_json(R"({"touchstone_scene": 1, "settings": {"gravity": [0, 0, 0]}, "particles": [
    {"position": [0.03380567411930085, -0.016452007142755434, 0.03137296873732822], "mass": 0.05780806913584719,
     "velocity": [-3.5258898668367533, -8.030296147393665, 2.72419494754083], "collides": false},
    {"position": [-0.035805044714408686, -0.01918041089215705, 0.0676345479636377], "mass": 0.034387397238030186,
     "velocity": [1.041467811302843, 7.226896091463589, -4.3480208805241745], "collides": false},
    {"position": [-0.027149415617360576, -0.03216159389903446, 0.06232191035501769], "mass": 0.0964670123165479,
     "velocity": [8.776360721756618, -0.7530555756433821, -3.629337165165105], "collides": false}], "springs": [
    {"particles": [0, 1], "stiffness": 75.94211801370206, "collides": false, "rest_length": 0.08134004623053277},
    {"particles": [1, 2], "stiffness": 23.641451522761912, "collides": false, "rest_length": 0.198079435139439},
    {"particles": [0, 2], "stiffness": 13.891580946707101, "collides": false, "rest_length": 0.18020272203194643}]})");
  Simulation simulation(scene, {});
  double before = simulation.energies().total();
  for (int step = 0; step < 60; ++step) {
    const std::size_t parts = simulation.step().size();
    const double now = simulation.energies().total();
    CAPTURE(step);
    CHECK(now <= before * (1 + 2e-3 * static_cast<double>(parts)));
    before = now;
  }
  CHECK(simulation.refused(Cause::gained_energy) > 0);
}

TEST_CASE("what begins far nearer than the thickness is pushed apart at a metre a second at most") {
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.time_step = 1e-4;
  scene.settings.contact.thickness = 0.05;
  set_material(add_cable(scene, {-0.5, 0, 0}, {0.5, 0, 0}, 10), 2e11, 0.3, 1e-3, 7800);
  set_material(add_cable(scene, {0.03, -0.5, 1e-4}, {0.03, 0.5, 1e-4}, 10), 2e11, 0.3, 1e-3, 7800);
  Simulation simulation(scene, {});
  const auto coordinates = static_cast<Eigen::Index>(3 * simulation.system().particle_count());
  const double mass = simulation.system().mass.head(coordinates).sum() / 3;
  for (int step = 0; step < 50; ++step) {
    simulation.step();
    CHECK(simulation.energies().total() < 0.5 * mass);  // all of it at 1 m/s
  }
  CHECK(simulation.crossings().empty());
}
