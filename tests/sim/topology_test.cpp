// Linked cables stay linked and others stay apart, however violently they move.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "scene/parts.hpp"
#include "sim/linking.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// A scene of closed loops, and the linking number of each with each that comes after it: of three 01, 02, 12.
struct Links {
  Scene scene;
  std::vector<Loop> loops;
  std::vector<int> numbers;

  Links() {
    scene.settings.gravity.setZero();
    scene.settings.contact.restitution = 0.5;
  }
};

using Curve = std::function<Vector3(double)>;  // closed, of [0, 2 pi)

Curve circle(const Vector3& centre, const Vector3& u, const Vector3& w, double radius) {
  return [=](double phi) -> Vector3 { return centre + radius * (std::cos(phi) * u + std::sin(phi) * w); };
}

Loop add_corners(Links& links, const Curve& curve, int count, const Vector3& velocity, double mass) {
  Loop loop;
  for (int i = 0; i < count; ++i) {
    loop.push_back(add_particle(links.scene, curve(2 * std::numbers::pi * i / count), mass));
    links.scene.particles.back().velocity = velocity;
  }
  links.loops.push_back(loop);
  return loop;
}

/// A ring of rope: `bends` makes a rod of it, that resists bending and twist.
Loop add_rope(Links& links, const Curve& curve, int count, const Vector3& velocity, double young, bool bends = false) {
  Cable cable;
  cable.particles = add_corners(links, curve, count, velocity, 0);
  cable.closed = true;
  set_material(cable, young, 0.4, 0.004, 1100);
  if (!bends) cable.bend = cable.twist = 0;
  cable.damping = 1e-3;
  links.scene.cables.push_back(cable);
  return links.loops.back();
}

Loop add_springs(Links& links, const Curve& curve, int count, const Vector3& velocity, double stiffness) {
  const Loop loop = add_corners(links, curve, count, velocity, 0.005);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    add_spring(links.scene, loop[i], loop[(i + 1) % loop.size()], stiffness, 0.01, true);
  }
  return loop;
}

const Vector3 kX = Vector3::UnitX(), kY = Vector3::UnitY(), kZ = Vector3::UnitZ();

struct Case {
  std::string name;
  std::function<Links()> make;
  bool comes_through = true;  // without contacts the linking number would change
};

std::vector<Case> cases() {
  return {
      {"two ropes, linked, torn apart at 40 m/s",
       [] {
         Links links;
         add_rope(links, circle({0, 0, 0}, kX, kY, 0.2), 20, {-20, 3, 1}, 1e6);
         add_rope(links, circle({0.2, 0.01, 0.02}, kX, kZ, 0.2), 20, {20, -2, 0}, 1e6);
         links.numbers = {-1};
         return links;
       }},
      {"two ropes, not linked, thrown together at 40 m/s",
       [] {
         Links links;
         add_rope(links, circle({0, 0, 0}, kX, kY, 0.2), 20, {20, 3, 1}, 1e6);
         add_rope(links, circle({0.5, 0.01, 0.02}, kX, kZ, 0.2), 20, {-20, -2, 0}, 1e6);
         links.numbers = {0};
         return links;
       }},
      {"stiff rods that bend and twist, tilted, with friction, linked",
       [] {
         Links links;
         links.scene.settings.contact.friction = 0.6;
         links.scene.settings.contact.restitution = 0;
         const Vector3 u = Vector3(1, 0.3, 0.2).normalized(), w = u.cross(Vector3(0.1, 1, 0.4)).normalized();
         add_rope(links, circle({0, 0, 0}, kX, kY, 0.2), 24, {-10, -5, 2}, 5e7, true);
         add_rope(links, circle({0.17, 0.03, -0.02}, u, w, 0.15), 18, {10, 4, 0}, 5e7, true);
         links.numbers = {-1};
         return links;
       }},
      {"soft springs that stretch to many times their length, linked, torn apart at 100 m/s",
       [] {
         Links links;
         add_springs(links, circle({0, 0, 0}, kX, kY, 0.2), 16, {-50, 0, 5}, 60);
         add_springs(links, circle({0.2, 0, 0.03}, kX, kZ, 0.2), 16, {50, 10, 0}, 60);
         links.numbers = {-1};
         return links;
       }},
      {"a small ring on a large one, which is jerked to and fro",
       [] {
         Links links;
         links.scene.settings.contact.friction = 0.3;
         const Loop large = add_rope(links, circle({0, 0, 0}, kX, kY, 0.4), 30, Vector3::Zero(), 1e7);
         add_rope(links, circle({0.4, 0.001, 0.02}, kX, kZ, 0.06), 10, {0, 15, 0}, 1e6);
         auto& path = links.scene.particles[large[15]].path;
         for (int i = 0; i < 12; ++i) path.push_back({0.1 * i, Vector3(i % 2 == 0 ? -0.4 : 1.6, 0.5 * (i % 3), 0)});
         links.numbers = {-1};
         return links;
       }},
      {"a chain of three, its ends torn apart at 60 m/s",
       [] {
         Links links;
         add_rope(links, circle({0, 0, 0}, kX, kY, 0.2), 20, {-30, 0, 0}, 1e6);
         add_rope(links, circle({0.3, 0.01, 0.02}, kX, kZ, 0.2), 20, {0, 5, 10}, 1e6);
         add_rope(links, circle({0.6, 0.02, 0}, kX, kY, 0.2), 20, {30, 0, 0}, 1e6);
         links.numbers = {-1, 0, 1};
         return links;
       }},
      {"a ring of springs in one of rope, linked",
       [] {
         Links links;
         add_springs(links, circle({0, 0, 0}, kX, kY, 0.2), 14, {-15, 0, 10}, 2e3);
         add_rope(links, circle({0.25, 0.02, 0.01}, kX, kZ, 0.15), 22, {25, -5, 0}, 1e7);
         links.numbers = {-1};
         return links;
       }},
      {"linked twice, as on a torus, torn apart at 50 m/s",
       [] {
         Links links;
         const auto wound = [](double start) -> Curve {
           return [start](double phi) -> Vector3 {
             const double about = 2 * phi + start, r = 0.25 + 0.06 * std::cos(about);
             return {r * std::cos(phi), r * std::sin(phi), 0.06 * std::sin(about)};
           };
         };
         add_rope(links, wound(0.1), 40, {0, 0, -25}, 1e6);
         add_rope(links, wound(0.1 + std::numbers::pi), 40, {3, 0, 25}, 1e6);
         links.numbers = {-2};
         return links;
       }},
      {"rings that swing about each other under gravity, one of them pinned",
       [] {
         Links links;
         links.scene.settings.gravity = {0, 0, -9.81};
         links.scene.settings.contact.friction = 0.2;
         const Loop held = add_rope(links, circle({0, 0, 0}, kX, kZ, 0.1), 12, Vector3::Zero(), 1e6);
         for (const Index p : held) links.scene.particles[p].fixed = {true, true, true};
         add_rope(links, circle({0.003, 0.005, -0.2}, kY, kZ, 0.15), 16, {30, 0, 0}, 1e6);
         links.numbers = {1};
         return links;
       }},
      {"two ropes, one above the other, not linked, that fall on each other at 16 m/s",
       [] {
         Links links;
         links.scene.settings.contact.friction = 0.4;
         add_rope(links, circle({0, 0, 0}, kX, kY, 0.2), 20, {0, 0, 8}, 1e6);
         add_rope(links, circle({0.21, 0.05, 0.4}, kX, Vector3(0, 1, 1).normalized(), 0.2), 20, {0, 0, -8}, 1e6);
         links.numbers = {0};
         return links;
       }},
      {"the same at 160 m/s, at which each would be past the other within one step",
       [] {
         Links links;
         add_rope(links, circle({0, 0, 0}, kX, kY, 0.2), 20, {0, 0, 80}, 1e6);
         add_rope(links, circle({0.21, 0.05, 0.4}, kX, Vector3(0, 1, 1).normalized(), 0.2), 20, {0, 0, -80}, 1e6);
         links.numbers = {0};
         return links;
       },
       false},
  };
}

std::vector<int> linking_numbers(const VectorX& q, const std::vector<Loop>& loops) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t j = i + 1; j < loops.size(); ++j) numbers.push_back(linking_number(q, loops[i], loops[j]));
  }
  return numbers;
}

constexpr int kSteps = 60;

/// Whether the linking numbers change when nothing collides.
bool comes_through(const Links& links) {
  const System system(links.scene);
  Stepper stepper(system, links.scene.settings);
  State state = stepper.initial();
  for (int i = 0; i < kSteps; ++i) {
    Advance advance = stepper.advance(state, links.scene.settings.time_step);
    if (!advance.converged) break;
    state = std::move(advance.state);
    if (linking_numbers(state.q, links.loops) != links.numbers) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("the linking number of polygons that are known, counted and by Gauss's integral") {
  Links links;
  const auto torus = [](double start, int turns) -> Curve {
    return [=](double phi) -> Vector3 {
      const double about = turns * phi + start, r = 1 + 0.4 * std::cos(about);
      return {r * std::cos(phi), r * std::sin(phi), 0.4 * std::sin(about)};
    };
  };
  const Loop core = add_corners(links, circle({0, 0, 0}, kX, kY, 1), 40, Vector3::Zero(), 1);
  const Loop once = add_corners(links, torus(0.3, 1), 60, Vector3::Zero(), 1);
  const Loop thrice = add_corners(links, torus(0.9, -3), 90, Vector3::Zero(), 1);
  const Loop apart = add_corners(links, circle({0, 0, 3e-7}, kX, kY, 1.7), 9, Vector3::Zero(), 1);
  const VectorX q = System(links.scene).initial_position;
  const auto check = [&](const Loop& a, const Loop& b, int number) {
    CHECK(linking_number(q, a, b) == number);
    CHECK(linking_number(q, b, a) == number);
    CHECK(linking_number(q, Loop(a.rbegin(), a.rend()), b) == -number);
    CHECK(gauss_integral(q, a, b) == Approx(number).margin(1e-9));
  };
  check(core, once, -1);  // from outwards to upwards is left-handed about the core
  check(core, thrice, 3);
  check(core, apart, 0);
  check(once, apart, 0);
}

TEST_CASE("linked rings stay linked and separate ones separate, through violent motion") {
  const auto all = cases();
  const auto number = GENERATE_COPY(range(std::size_t{0}, all.size()));
  const Case& one = all[number];
  CAPTURE(one.name);
  const Links links = one.make();
  Simulation simulation(links.scene, {});
  REQUIRE(linking_numbers(simulation.state().q, links.loops) == links.numbers);
  std::uint64_t contacts = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (const auto& record : simulation.step()) contacts += record.response.contacts;
    CAPTURE(i);
    REQUIRE(simulation.state().q.allFinite());
    REQUIRE(linking_numbers(simulation.state().q, links.loops) == links.numbers);
  }
  CHECK(contacts > 0);
  CHECK(simulation.crossings().empty());
  CHECK(comes_through(links) == one.comes_through);
}
