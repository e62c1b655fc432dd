// The balance of energy: what each force gives and takes in a step, and what is left for the integrator, against known
// values.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <complex>
#include <numbers>

#include "scene/parts.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

constexpr double kG = 9.81;
constexpr Integrator kAll[] = {Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint,
                               Integrator::symplectic_euler};

struct Balance {
  EnergyFlows flows;
  double numerical = 0, gained = 0;  // J

  void add(const std::vector<SubstepRecord>& records) {
    for (const SubstepRecord& record : records) {
      flows += record.flows;
      numerical += record.numerical;
    }
  }
};

/// A run whose flows are measured.
class Measured {
 public:
  explicit Measured(const Scene& scene) : simulation_(scene, options()), first_(energy()) {}

  Simulation& operator*() { return simulation_; }
  Simulation* operator->() { return &simulation_; }
  double energy() const { return simulation_.energies().total(); }

  /// Of one step.
  Balance step() {
    Balance one;
    const double before = energy();
    const auto records = simulation_.step();
    one.add(records);
    sum_.add(records);
    one.gained = energy() - before;
    return one;
  }

  /// Of all steps so far.
  Balance steps(int count) {
    for (int i = 0; i < count; ++i) step();
    sum_.gained = energy() - first_;
    CHECK(sum_.flows.total() + sum_.numerical == Approx(sum_.gained).epsilon(1e-9).margin(1e-12));
    return sum_;
  }

 private:
  static SimulationOptions options() {
    SimulationOptions options;
    options.measure_flows = true;
    return options;
  }

  Simulation simulation_;
  double first_;
  Balance sum_;
};

/// A mass on a spring along x, stretched by 0.1 m.
Scene flow_oscillator(Integrator integrator, double step, double stiffness, double mass, double damping = 0) {
  Scene scene;
  scene.settings.integrator = integrator;
  scene.settings.time_step = step;
  scene.settings.gravity.setZero();
  scene.settings.newton_tolerance = 1e-12;
  add_pinned(scene, {0, 0, 0});
  add_particle(scene, {1.1, 0, 0}, mass);
  scene.springs.push_back({0, 1, stiffness, damping, 1.0, true});
  return scene;
}

/// What a step of h multiplies the energy of an oscillator by, z = h omega; not of the explicit method.
double amplification(Integrator integrator, double z) {
  const std::complex<double> i(0, 1), one(1);
  if (integrator == Integrator::implicit_euler) return std::norm(one / (one - i * z));
  if (integrator == Integrator::implicit_midpoint) return 1;
  const double d = 1 - std::sqrt(0.5), w = std::sqrt(2.0) / 4;
  const std::complex<double> middle = (one + i * d * z) / (one - i * d * z);
  return std::norm((one + i * w * z * (one + middle)) / (one - i * d * z));
}

/// A floor on which a particle lies, or slides along x.
Scene on_floor(double speed, double friction) {
  Scene scene;
  scene.settings.time_step = 1e-3;
  scene.settings.contact.friction = friction;
  scene.settings.contact.restitution = 0;
  scene.settings.contact.thickness = 1e-3;
  add_floor(scene, 3);
  const Index p = add_particle(scene, {0.1, 0.2, 1e-3}, 0.5);
  scene.particles[p].velocity = {speed, 0, 0};
  return scene;
}

}  // namespace

TEST_CASE("free fall: second-order methods keep the energy, first-order ones lose m g^2 h^2 / 2 a step") {
  for (const Integrator integrator : kAll) {
    Scene scene;
    scene.settings.integrator = integrator;
    scene.settings.time_step = 0.02;
    scene.settings.newton_tolerance = 1e-12;
    const Index stone = add_particle(scene, {1, 2, 3}, 3);
    scene.particles[stone].velocity = {2, -1, 5};
    Measured run(scene);
    const bool first_order = integrator == Integrator::implicit_euler || integrator == Integrator::symplectic_euler;
    const double lost = first_order ? 0.5 * 3 * kG * kG * 0.02 * 0.02 : 0;
    CAPTURE(integrator_name(integrator));
    for (int i = 0; i < 50; ++i) {
      const Balance balance = run.step();
      CHECK(balance.flows.total() == 0);
      CHECK(balance.numerical == Approx(-lost).epsilon(1e-8).margin(1e-10));
    }
  }
}

TEST_CASE("the loss of an undamped oscillator is that of each method's amplification factor, step by step") {
  for (const Integrator integrator : {Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint}) {
    for (const double z : {0.01, 0.1, 1.0}) {
      Measured run(flow_oscillator(integrator, z / 3, 18, 2));
      CAPTURE(integrator_name(integrator), z);
      for (int i = 0; i < 20; ++i) {
        const double before = run.energy();
        const Balance balance = run.step();
        CHECK(balance.flows.total() == 0);
        CHECK(balance.numerical == Approx((amplification(integrator, z) - 1) * before).epsilon(1e-6).margin(1e-13));
      }
    }
  }
}

TEST_CASE("symplectic Euler gains and loses h^2 omega^2 m (v^2 - omega^2 x^2) / 2, of the new velocity and old place") {
  const double omega = 3, mass = 2, h = 0.05;
  Measured run(flow_oscillator(Integrator::symplectic_euler, h, omega * omega * mass, mass));
  double most = 0;
  for (int i = 0; i < 60; ++i) {
    const double x = run->state().q[3] - 1;
    const Balance balance = run.step();
    const double v = run->state().v[3];
    CHECK(balance.flows.total() == 0);
    const double gain = 0.5 * mass * h * h * omega * omega * (v * v - omega * omega * x * x);
    CHECK(balance.numerical == Approx(gain).epsilon(1e-9).margin(1e-14));
    most = std::max(most, gain);
  }
  CHECK(most > 1e-4);  // it gains, too
}

TEST_CASE("implicit Euler: a damper takes c dx^2 / h, drag takes d m dx^2 / h, and the method the squares of changes") {
  const double mass = 2, stiffness = 18, damping = 0.7, drag = 0.3, h = 0.05;
  Scene scene = flow_oscillator(Integrator::implicit_euler, h, stiffness, mass, damping);
  scene.settings.drag = drag;
  Measured run(scene);
  for (int i = 0; i < 40; ++i) {
    const State before = run->state();
    const Balance balance = run.step();
    const double dx = run->state().q[3] - before.q[3], dv = run->state().v[3] - before.v[3];
    CHECK(balance.flows.damping == Approx(-damping * dx * dx / h).epsilon(1e-9));
    CHECK(balance.flows.drag == Approx(-drag * mass * dx * dx / h).epsilon(1e-9));
    CHECK(balance.numerical == Approx(-0.5 * mass * dv * dv - 0.5 * stiffness * dx * dx).epsilon(1e-6).margin(1e-14));
  }
}

TEST_CASE("damping and drag take what theory says, the nearer the shorter the steps, and little is left over") {
  // m x'' + c x' + d m x' + k x = 0: amplitude e^(-b t) with b = (c / m + d) / 2.
  const double mass = 2, stiffness = 18, time = 2;
  const auto error = [&](Integrator integrator, double damping, double drag, int steps) {
    Scene scene = flow_oscillator(integrator, time / steps, stiffness, mass, damping);
    scene.settings.drag = drag;
    Measured run(scene);
    const Balance balance = run.steps(steps);
    const double b = 0.5 * (damping / mass + drag), w = std::sqrt(stiffness / mass - b * b),
                 decay = std::exp(-b * time);
    const double x = 0.1 * decay * (std::cos(w * time) + b / w * std::sin(w * time));
    const double v = -0.1 * decay * (b * b / w + w) * std::sin(w * time);
    const double lost = 0.5 * stiffness * 0.01 - 0.5 * stiffness * x * x - 0.5 * mass * v * v;
    CHECK((damping > 0 ? balance.flows.drag : balance.flows.damping) == 0);
    CHECK(lost > 0.05);
    return std::abs(balance.flows.total() + lost) / lost;
  };
  for (const double damping : {0.0, 1.6}) {
    const double drag = damping > 0 ? 0 : 0.8;
    CAPTURE(damping, drag);
    for (const Integrator integrator : kAll) {
      const bool second = integrator == Integrator::tr_bdf2 || integrator == Integrator::implicit_midpoint;
      const double coarse = error(integrator, damping, drag, 400), fine = error(integrator, damping, drag, 800);
      CAPTURE(integrator_name(integrator), coarse, fine);
      CHECK(fine < (second ? 1e-4 : 4e-2));
      CHECK(std::abs(std::log2(coarse / fine) - (second ? 2 : 1)) < 0.2);
    }
  }
}

TEST_CASE("an impact of two particles takes (1 - e^2) / 2 of the reduced mass times the square of their approach") {
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const Integrator integrator : kAll) {
      Scene scene;
      scene.settings.integrator = integrator;
      scene.settings.gravity.setZero();
      scene.settings.contact.restitution = e;
      scene.settings.contact.thickness = 1e-6;
      scene.settings.newton_tolerance = 1e-12;
      const Index a = add_particle(scene, {0, 0, 0}, 2), b = add_particle(scene, {0.3, 0, 0}, 3);
      scene.particles[a].velocity = {1, 0, 0};
      scene.particles[b].velocity = {-2, 0, 0};
      Measured run(scene);
      const Balance balance = run.steps(12);
      CAPTURE(e, integrator_name(integrator));
      const double lost = 0.5 * (2.0 * 3 / (2 + 3)) * (1 - e * e) * 9;
      CHECK(balance.flows.impacts == Approx(-lost).margin(1e-9));
      CHECK(balance.gained == Approx(-lost).margin(1e-9));
      CHECK(balance.numerical == Approx(0).margin(1e-9));
      CHECK(balance.flows.friction == 0);
    }
  }
}

TEST_CASE("friction takes its coefficient times the weight times the way") {
  const double mu = 0.2, mass = 0.5;
  Measured run(on_floor(1, mu));
  const double start = run->state().q[12];
  const Balance slides = run.steps(300);
  const double way = run->state().q[12] - start, work = -mu * mass * kG * way;
  CHECK(way > 0.2);
  CHECK(slides.flows.friction == Approx(work).epsilon(2e-3));
  CHECK(std::abs(slides.flows.impacts) < 1e-3 * std::abs(work));
  CHECK(std::abs(slides.numerical) < 1e-3 * std::abs(work));
  // To rest: all that it had.
  const Balance rests = run.steps(400);
  CHECK(rests.flows.friction == Approx(-0.5 * mass).epsilon(1e-3));
  CHECK(std::abs(run->state().v[12]) < 1e-9);
}

TEST_CASE("a particle at rest on a floor takes and gives nothing") {
  Measured run(on_floor(0, 0.3));
  run.steps(20);  // it lands
  for (int i = 0; i < 100; ++i) {
    const Balance balance = run.step();
    for (const double flow :
         {balance.flows.friction, balance.flows.impacts, balance.flows.corrections, balance.numerical}) {
      CHECK(std::abs(flow) < 1e-12);
    }
  }
}

TEST_CASE("friction with contacts in the potential takes the same") {
  // The spring is so stiff that impulses on its ends alone would add energy.
  const double mu = 0.2, mass = 0.5;
  Scene scene = on_floor(1, mu);
  const Index other = add_particle(scene, {0.1, 0.4, 1e-3}, mass);
  scene.particles[other].velocity = {1, 0, 0};
  add_spring(scene, other - 1, other, 1e7, 0, true);
  Measured run(scene);
  const double start = run->state().q[12];
  const Balance slides = run.steps(100);
  const double way = run->state().q[12] - start, work = -mu * 2 * mass * kG * way;
  CHECK(way > 0.08);
  CHECK(slides.flows.friction == Approx(work).epsilon(2e-2));
  CHECK(std::abs(slides.numerical) < 2e-2 * std::abs(work));
}

TEST_CASE("a belt gives twice what a particle on it gains, and friction takes the rest") {
  Scene scene;
  scene.settings.time_step = 1e-3;
  scene.settings.contact.friction = 0.5;
  scene.settings.contact.restitution = 0;
  scene.settings.contact.thickness = 1e-3;
  add_floor(scene, 3);
  for (Particle& p : scene.particles) {
    p.path = {{0, p.position}, {10, p.position + Vector3(10, 0, 0)}};
    p.fixed = {};
  }
  add_particle(scene, {0.1, 0.2, 1e-3}, 0.5);
  Measured run(scene);
  const Balance balance = run.steps(400);
  CHECK(run->state().v[12] == Approx(1).epsilon(1e-6));
  CHECK(balance.flows.driven == Approx(0.5).epsilon(5e-3));
  CHECK(balance.flows.friction == Approx(-0.25).epsilon(5e-3));
  CHECK(std::abs(balance.numerical) < 2e-3);
}

TEST_CASE("a driven end gives what stretches a spring and moves its mass, a turned end what twists a cable") {
  // Pulled and turned slowly: 1/2 k d^2, and 1/2 G J / L angle^2.
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.time_step = 5e-3;
  scene.settings.drag = 20;
  scene.settings.integrator = GENERATE(Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint);
  CAPTURE(integrator_name(scene.settings.integrator));
  add_pinned(scene, {0, 1, 0});
  const Index middle = add_particle(scene, {0.5, 1, 0}, 0.01);
  const Index end = add_particle(scene, {1, 1, 0}, 0.01);
  scene.particles[end].path = {{0, {1, 1, 0}}, {2, {1.2, 1, 0}}};
  add_spring(scene, 0, middle, 40, 0, true);
  add_spring(scene, middle, end, 40, 0, true);
  Cable& cable = add_cable(scene, {0, 0, 0}, {1, 0, 0}, 12);
  set_material(cable, 1e7, 0.4, 0.005, 1200);
  cable.start.clamped = cable.end.clamped = true;
  cable.end.twist_rate = 0.5;
  cable.end.twist_until = 2;
  cable.damping = 0.02;
  for (const Index p : {cable.particles.front(), cable.particles.back()}) scene.particles[p].fixed = {true, true, true};
  const double torsion = cable.twist / 1.0;
  Measured run(scene);
  const Balance balance = run.steps(600);
  const double stretched = 0.5 * 20 * 0.2 * 0.2;
  const Energies stored = run->energies();
  CHECK(stored.stretch == Approx(stretched).epsilon(1e-3));
  // All of the cable twists but the two halves of segments at its ends.
  CHECK(stored.twist == Approx(0.5 * torsion).epsilon(0.15));
  CHECK(balance.flows.driven == Approx(stored.stretch + stored.twist).epsilon(1.5e-2));
  CHECK(std::abs(balance.numerical) < 1e-2 * stretched);
}

TEST_CASE("the twist that is inserted into a ring is work of its own, and little is left for the integrator") {
  const auto left_over = [](double step) {
    Scene scene;
    scene.settings.gravity.setZero();
    scene.settings.time_step = step;
    scene.settings.integrator = Integrator::tr_bdf2;
    Cable ring;
    for (int i = 0; i < 24; ++i) {
      const double phi = 2 * std::numbers::pi * i / 24;
      ring.particles.push_back(add_particle(scene, {0.2 * std::cos(phi), 0.2 * std::sin(phi), 0}, 0));
    }
    ring.closed = true;
    set_material(ring, 2e6, 0.5, 0.003, 1100);
    ring.damping = 0.02;
    ring.closing_twist_rate = 10;
    scene.cables.push_back(ring);
    Measured run(scene);
    const Balance balance = run.steps(static_cast<int>(std::lround(0.4 / step)));
    CHECK(balance.flows.driven > 5e-4);
    CHECK(balance.flows.damping < 0);
    return std::abs(balance.numerical / balance.flows.driven);
  };
  const double coarse = left_over(4e-3), fine = left_over(1e-3);
  CAPTURE(coarse, fine);
  CHECK(fine < 2e-3);
  CHECK(fine < 0.2 * coarse);
}
