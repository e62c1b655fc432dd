// Cloth at rest against known solutions.
// SPDX-License-Identifier: MIT
#include <Eigen/Dense>

#include <cmath>

#include "cloth/cloth_scenes.hpp"
#include "dynamics/energy_budget.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;
using touchstone::seeded::Rng;

namespace {

constexpr double kG = 9.81;

/// The stretch at which a strip without lateral contraction carries `load` newtons a metre: the material has
/// load = stiffness lambda (lambda^2 - 1) / 2.
double stretch_under(double load, double stiffness) {
  double low = 1, high = 10;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * stiffness * middle * (middle * middle - 1) < load ? low : high) = middle;
  }
  return low;
}

/// How far the lower end of a hanging sheet of length 1 comes down, by Simpson's rule on its stretch.
double hanging_sag(double density, double stiffness) {
  constexpr int kParts = 1000;
  double sum = 0;
  for (int i = 0; i <= kParts; ++i) {
    const double weight = i == 0 || i == kParts ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * (stretch_under(density * kG * i / kParts, stiffness) - 1);
  }
  return sum / (3 * kParts);
}

double sag_of_mesh(Index columns, double stiffness) {
  SheetScene sheet = sheet_scene(0.5, 1, columns);
  sheet.scene.settings.gravity = {0, -kG, 0};
  sheet.surface().stretch = stiffness;
  sheet.surface().poisson = 0;
  for (const Index p : sheet.mesh.rows.back()) sheet.scene.particles[p].fixed = {true, true, true};
  // In its plane: a membrane under tension needs no bending, and cannot leave the plane without a push.
  const State state = at_rest(sheet.scene);
  double lowest = 0;
  for (const Index p : sheet.mesh.rows.front()) lowest -= position(state.q, p).y();
  return lowest / static_cast<double>(sheet.mesh.rows.front().size());
}

/// The deflection of the free end of a horizontal sheet of length 1 that is clamped at the other end, under its weight,
/// in the middle of its width of 2 sqrt(3), with which the triangles are equilateral: far from its free sides the sheet
/// bends to a cylinder, with the stiffness D.
/// @param load  weight per area times length^3 over D
double tip_of_mesh(Index columns, double load) {
  SheetScene sheet = sheet_scene(2 * std::sqrt(3.0), 1, columns);
  sheet.scene.settings.gravity = {0, 0, -kG};
  sheet.scene.settings.newton_tolerance = 1e-9;
  // The clamp holds two rows. The hinges at the second one stand for the bend of half a row before it and of half a row
  // behind it, so that the free length begins halfway between the two.
  const auto& rows = sheet.mesh.rows;
  const double length = 1 - 0.5 / static_cast<double>(rows.size() - 1);
  for (const Index r : {0u, 1u}) {
    for (const Index p : rows[r]) sheet.scene.particles[p].fixed = {true, true, true};
  }
  Surface& surface = sheet.surface();
  surface.stretch = 2e4;
  surface.bend = 0.01;
  surface.areal_density = load * surface.bend / (kG * length * length * length);
  const State state = at_rest(sheet.scene);
  return -position(state.q, rows.back()[rows.back().size() / 2]).z() / length;
}

/// The heavy elastica: theta'' = -load (1 - s) cos theta with theta(0) = 0 and theta'(1) = 0, by shooting with Runge
/// and Kutta's method. @returns how far the tip is down, for the length 1
double elastica_tip(double load) {
  constexpr int kSteps = 2000;
  constexpr double kStep = 1.0 / kSteps;
  double tip = 0;
  const auto end_slope = [&](double slope) {
    Eigen::Vector3d y(0, slope, 0);  // theta, theta', depth
    const auto rate = [&](double s, const Eigen::Vector3d& at) {
      return Eigen::Vector3d(at[1], -load * (1 - s) * std::cos(at[0]), std::sin(at[0]));
    };
    for (int i = 0; i < kSteps; ++i) {
      const double s = i * kStep;
      const Eigen::Vector3d k1 = rate(s, y), k2 = rate(s + kStep / 2, y + kStep / 2 * k1);
      const Eigen::Vector3d k3 = rate(s + kStep / 2, y + kStep / 2 * k2), k4 = rate(s + kStep, y + kStep * k3);
      y += kStep / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    tip = y[2];
    return y[1];
  };
  double low = 0, high = load;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (end_slope(middle) < 0 ? low : high) = middle;
  }
  return tip;
}

/// How far down the last corner of a square of side 1 hangs that is held wherever `held` says so of its places at rest.
template <class Held>
double corner_of_square(Index columns, double bend, const Held& held) {
  SheetScene sheet = sheet_scene(1, 1, columns);
  sheet.scene.settings.gravity = {0, 0, -kG};
  sheet.surface().bend = bend;
  for (Particle& p : sheet.scene.particles) {
    if (held(p.position.x(), p.position.y())) p.fixed = {true, true, true};
  }
  const State state = at_rest(sheet.scene);
  return -position(state.q, sheet.mesh.rows.back().back()).z();
}

/// Halving the triangles at least halves the change of the drape, nearly: the shapes have a limit.
template <class Held>
void check_limit(double bend, const Held& held) {
  double drop = 0, change = 0;
  for (const Index columns : {8u, 16u, 32u}) {
    const double now = corner_of_square(columns, bend, held), moved = std::abs(now - drop);
    CAPTURE(bend, columns, now, moved, change);
    if (columns > 8) CHECK(moved < 0.2 * now);
    if (columns > 16) CHECK(moved < 0.6 * change);
    drop = now;
    change = moved;
  }
  CHECK(drop > 0.3);
}

}  // namespace

TEST_CASE("patch test: an irregular mesh reproduces a uniform strain exactly") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Rng random(seed);
    SheetScene sheet = sheet_scene(1, 0.8, 5);
    make_irregular(sheet, 0.05, random);
    sheet.surface().poisson = 0.3;
    sheet.scene.settings.newton_tolerance = 1e-12;
    Eigen::Matrix2d f;  // stretch in both directions and shear
    f << 1.15 + 0.05 * random.symmetric(), 0.2 * random.symmetric(), 0.2 * random.symmetric(), 1.1;
    const auto mapped = [&](const Vector3& x) {
      const Eigen::Vector2d y = f * x.head<2>();
      return Vector3(y.x(), y.y(), 0);
    };
    const std::vector<char> border = border_of(sheet);
    for (std::size_t i = 0; i < border.size(); ++i) {
      Particle& p = sheet.scene.particles[i];
      if (border[i]) p.path = {{0, p.position}, {0.2, mapped(p.position)}};
    }
    const State state = at_rest(sheet.scene);
    double error = 0;
    std::size_t inside = 0;
    for (Index i = 0; i < border.size(); ++i) {
      if (border[i]) continue;
      ++inside;
      error = std::max(error, (position(state.q, i) - mapped(sheet.scene.particles[i].position)).norm());
    }
    CAPTURE(seed);
    CHECK(inside >= 10);
    CHECK(error < 1e-9);
    // The energy of the material at that strain, from its definition.
    const Eigen::Matrix2d e = 0.5 * (f.transpose() * f - Eigen::Matrix2d::Identity());
    const double nu = 0.3, lambda = 100 * nu / (1 - nu * nu), mu = 100 / (2 * (1 + nu));
    const double density = 0.5 * lambda * e.trace() * e.trace() + mu * (e * e).trace();
    CHECK(energies(System(sheet.scene), state).stretch == Approx(0.8 * density).epsilon(1e-9));
  }
}

TEST_CASE("a hanging sheet stretches as the closed form says, and better with a finer mesh") {
  // Small: rho g L^2 / (2 E), and the whole curve for a soft one, which is half as long again.
  const double density = 0.2;
  CHECK(hanging_sag(density, 1e5) == Approx(density * kG / 2e5).epsilon(1e-4));
  CHECK(sag_of_mesh(4, 1e5) == Approx(density * kG / 2e5).epsilon(2e-3));
  const double soft = 2, known = hanging_sag(density, soft);
  REQUIRE(known > 0.25);
  double before = 1;
  for (const Index columns : {2u, 4u, 8u}) {
    const double error = std::abs(sag_of_mesh(columns, soft) / known - 1);
    CAPTURE(columns, error, before);
    CHECK(error < 0.4 * before);
    before = error;
  }
  CHECK(before < 1e-3);
}

TEST_CASE("a sheet on a cylinder has the energy of its curvature, whatever the cylinder's direction") {
  const double height = 1.25 * std::sqrt(0.75);  // the triangles are equilateral
  for (const double direction : {0.0, 0.3, 0.7853981633974483, 1.2, 1.5707963267948966}) {
    double before = 1, coarse = 0, fine = 0;
    for (const Index columns : {8u, 16u, 32u}) {
      const SheetScene sheet = sheet_scene(1, height, columns);
      const System system(sheet.scene);
      State state = Stepper(system, sheet.scene.settings).initial();
      const double c = std::cos(direction), s = std::sin(direction), radius = 0.7;
      for (Index i = 0; i < system.particle_count(); ++i) {
        const Vector3 x = position(state.q, i);
        const double along = c * x.x() + s * x.y(), across = -s * x.x() + c * x.y();
        const double u = radius * std::sin(along / radius), w = radius * std::cos(along / radius);
        state.q.segment<3>(3 * static_cast<Eigen::Index>(i)) = Vector3(c * u - s * across, s * u + c * across, w);
      }
      coarse = fine;
      fine = energies(system, state).bend / (0.5 * 1e-3 / (radius * radius) * height) - 1;
      const double error = std::abs(fine);
      CAPTURE(direction, columns, error, before);
      CHECK(error < 0.6 * before);  // hinges that the border lacks: first order
      before = error;
    }
    CHECK(std::abs(2 * fine - coarse) < 4e-3);
  }
}

TEST_CASE("a clamped sheet bends as a cantilever, and better with a finer mesh") {
  // Small deflection: w L^4 / (8 D). Far: the elastica.
  CHECK(elastica_tip(0.01) == Approx(0.01 / 8).epsilon(1e-4));
  for (const double load : {0.01, 8.0}) {
    const double known = elastica_tip(load);
    if (load > 1) REQUIRE(known > 0.5);
    double before = 1, coarse = 0, fine = 0;
    for (const Index columns : {12u, 24u, 48u}) {
      coarse = fine;
      fine = tip_of_mesh(columns, load) / known;
      const double error = std::abs(fine - 1);
      CAPTURE(load, columns, error, before);
      CHECK(error < 0.4 * before);
      before = error;
    }
    CHECK(before < 0.01);
    CHECK(std::abs(limit_of_second_order(coarse, fine) - 1) < 2e-3);
  }
}

TEST_CASE("a square drapes to one shape as its mesh gets finer") {
  SECTION("from two of its sides") {
    check_limit(1e-3, [](double x, double y) { return x == 0 || y == 0; });
  }
  SECTION("over a round table") {
    check_limit(1e-2, [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) <= 0.25; });
  }
}
