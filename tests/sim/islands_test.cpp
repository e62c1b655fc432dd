// Newton's method on islands, and its linear systems, against one iteration and one matrix for the whole scene.
// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>

#include <cmath>

#include "dynamics/islands.hpp"
#include "dynamics/stepper.hpp"
#include "linear/sparse_solver.hpp"
#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;
namespace linear = touchstone::linear;

namespace {

double wave(int i) { return std::sin(12.9898 * i); }

/// A positive definite block of n rows, another one for each seed.
Eigen::MatrixXd block_of(int n, int seed) {
  Eigen::MatrixXd a(n, n);
  for (int i = 0; i < n * n; ++i) a.data()[i] = wave(seed * 1000 + i);
  return a * a.transpose();
}

/// The matrix that the solver was given, dense.
struct Twin {
  linear::SparseSolver* solver;
  Eigen::MatrixXd dense;

  void add(std::size_t number, const std::vector<int>& block, const Eigen::MatrixXd& values) {
    solver->add(number, values.data());
    for (std::size_t c = 0; c < block.size(); ++c) {
      for (std::size_t r = 0; r < block.size(); ++r) {
        if (block[c] >= 0 && block[r] >= 0)
          dense(block[r], block[c]) += values(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
      }
    }
  }
  void add_contact(std::size_t number, const linear::SparseSolver::Corners& corners, const std::array<double, 4>& omega,
                   const Eigen::Matrix3d& values) {
    solver->add_contact(number, omega, values);
    for (std::size_t c = 0; c < 12; ++c) {
      for (std::size_t r = 0; r < 12; ++r) {
        if (corners[c] >= 0 && corners[r] >= 0) {
          dense(corners[r], corners[c]) +=
              omega[r / 3] * omega[c / 3] * values(static_cast<Eigen::Index>(r % 3), static_cast<Eigen::Index>(c % 3));
        }
      }
    }
  }
};

/// Cables that are held in every way, some of them driven, too many for one part.
Scene many_cables() {
  Scene scene;
  for (int i = 0; i < 30; ++i) {
    Cable& cable = add_cable(scene, {0, 0.1 * i, 0}, {1, 0.1 * i + 0.02, 0.1}, 30);
    cable.radius = 0.005;
    cable.density = 1200;
    cable.stretch = 800;
    cable.bend = 0.005;
    cable.twist = i % 2 == 0 ? 0.004 : 0;
    cable.damping = 1e-3;
    if (i % 3 == 0) {
      cable.start.clamped = true;
      cable.start.twist_rate = 2;
    }
    const Index first = cable.particles.front();
    scene.particles[first].fixed = {true, true, true};
    if (i % 5 == 0) scene.particles[first].path = {{0, scene.particles[first].position}, {1, {0, 0.1 * i, 0.5}}};
  }
  // All of it is driven, and turns: nothing of it is solved for, but its frames are to be carried along.
  Cable& driven = add_cable(scene, {0, -1, 0}, {0.2, -1, 0}, 2);
  driven.radius = 0.005;
  driven.density = 1200;
  driven.stretch = 800;
  driven.bend = 0.005;
  for (const Index p : driven.particles) {
    const Vector3 at = scene.particles[p].position;
    scene.particles[p].path = {{0, at}, {0.05, {0, -1, at.x()}}};
  }
  return scene;
}

}  // namespace

TEST_CASE("the sparse solver solves what it was given, components side by side or not") {
  // Seven chains alike and one that is not: four beside each other, and four alone.
  constexpr int kChains = 8, kLong = 12, kSize = kChains * kLong;
  linear::Blocks blocks;
  for (int chain = 0; chain < kChains; ++chain) {
    for (int i = 0; i + 3 < kLong; i += chain == 7 ? 3 : 2) {
      const int first = kLong * chain + i;
      blocks.push_back({first, first + 1, chain == 3 && i == 0 ? -1 : first + 2, first + 3});
    }
  }
  linear::PatternCache cache;
  linear::SparseSolver solver(kSize, blocks, {}, cache);
  // One contact after both: the pattern of the two contacts does not outlast them.
  for (const std::size_t contacts : {0, 2, 1, 2, 0}) {
    CAPTURE(contacts);
    std::vector<linear::SparseSolver::Corners> corners{{0, 1, 2, 3, 4, 5, 24, 25, 26, -1, -1, -1},
                                                       {90, 91, 92, -1, 40, 41, 30, 31, 32, 33, 34, 35}};
    corners.resize(contacts);
    solver.set_contacts(corners);
    Twin twin{&solver, Eigen::MatrixXd::Zero(kSize, kSize)};
    solver.clear();
    for (int i = 0; i < kSize; ++i) {
      solver.add_diagonal(i, 1 + 0.5 * wave(i));
      twin.dense(i, i) += 1 + 0.5 * wave(i);
    }
    for (std::size_t b = 0; b < blocks.size(); ++b) twin.add(b, blocks[b], block_of(4, static_cast<int>(b)));
    for (std::size_t c = 0; c < corners.size(); ++c) {
      twin.add_contact(c, corners[c], {-0.3, -0.7, 0.6, c == 0 ? 0.0 : 0.4}, 30 * block_of(3, 77));
    }
    REQUIRE(solver.factorise());
    Eigen::VectorXd right(kSize);
    for (int i = 0; i < kSize; ++i) right[i] = wave(3 * i + 1);
    const Eigen::VectorXd expected = twin.dense.llt().solve(right);
    CHECK((solver.solve(right) - expected).norm() < 1e-11 * expected.norm());
  }
  solver.clear();
  for (int i = 0; i < kSize; ++i) solver.add_diagonal(i, i == 50 ? -1 : 1);
  CHECK_FALSE(solver.factorise());
}

TEST_CASE("a large system with contacts is solved to a hundredth, in the measure that Newton's method goes by") {
  constexpr int kSize = 600;
  linear::PatternCache cache;
  // Corners from two elements that are apart; and along a chain, whose pattern has some of their blocks and not others.
  const bool chain = GENERATE(false, true);
  // The solver's residual follows from products that it does not make: stiff blocks show whether it leaves the true
  // one.
  const double stiffness = GENERATE(1.0, 1e6, 1e12);
  CAPTURE(chain, stiffness);
  linear::Blocks blocks;
  for (int i = 0; i + 6 <= kSize; i += chain ? 3 : 6) blocks.push_back({i, i + 1, i + 2, i + 3, i + 4, i + 5});
  linear::SparseSolver solver(kSize, blocks, {}, cache);
  std::vector<linear::SparseSolver::Corners> corners;
  for (int i = 0; i + 36 < kSize; i += 6) {
    const int k = chain ? i + 6 : i + 30;
    corners.push_back({i, i + 1, i + 2, i + 3, i + 4, i + 5, k, k + 1, k + 2, k + 3, k + 4, k + 5});
  }
  solver.set_contacts(corners);
  Twin twin{&solver, Eigen::MatrixXd::Zero(kSize, kSize)};
  solver.clear();
  for (int i = 0; i < kSize; ++i) {
    solver.add_diagonal(i, 1);
    twin.dense(i, i) += 1;
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) twin.add(b, blocks[b], stiffness * block_of(6, static_cast<int>(b)));
  for (std::size_t c = 0; c < corners.size(); ++c) {
    twin.add_contact(c, corners[c], {-0.3, -0.7, 0.6, 0.4}, 30 * block_of(3, static_cast<int>(c)));
  }
  REQUIRE(solver.factorise());
  Eigen::VectorXd right(kSize);
  for (int i = 0; i < kSize; ++i) right[i] = wave(3 * i + 1);
  const Eigen::VectorXd expected = twin.dense.llt().solve(right), error = solver.solve(right) - expected;
  CHECK(error.dot(twin.dense * error) < 0.03 * 0.03 * expected.dot(twin.dense * expected));
}

TEST_CASE("Newton's method on islands ends where that on the whole scene does") {
  const Scene scene = many_cables();
  const System system(scene);
  Settings settings;
  const Energy energy(system);
  linear::PatternCache cache;
  Newton whole(system, settings, cache);
  Islands islands(system, settings);
  Stepper stepper(system, settings);
  State state = stepper.initial();
  const double h = settings.time_step;
  // Two cables that are far from each other in number, and so in different islands, lean on each other, and one leans
  // on a held particle.
  ContactTerm between, held;
  between.particles = {10, 11, 786, 787};
  between.corners = 4;
  between.omega = {-0.5, -0.5, 0.4, 0.6};
  between.normal = Vector3::UnitZ();
  between.goal = 1e-3;
  between.stiffness = 1e3;
  between.slip = 0.02;
  between.stick = 1e-4;
  held = between;
  held.particles = {100, 101, 0, 0};
  held.corners = 3;
  held.omega = {0.5, 0.5, -1, 0};
  const std::vector<ContactTerm> contacts{between, held};
  for (int step = 0; step < 3; ++step) {
    const Stage stage{
        state.q,  state.v, h, state.time + h, energy.damped(energy.strains(state.q, state.frames, state.time), h),
        contacts, 0};
    VectorX guess = state.q + h * state.v;
    for (Eigen::Index i = 0; i < guess.size(); ++i) {
      if (system.fixed[static_cast<std::size_t>(i)]) guess[i] = state.q[i];
    }
    system.prescribe(stage.time, guess);
    VectorX q = state.q, expected = state.q;
    Frames frames = state.frames, expected_frames = state.frames;
    REQUIRE(whole.minimise(stage, guess, expected, expected_frames).converged);
    REQUIRE(islands.minimise(stage, guess, q, frames).converged);
    CHECK((q - expected).lpNorm<Eigen::Infinity>() < 10 * settings.newton_tolerance * h);
    double frame_error = 0, twist_error = 0;
    for (std::size_t e = 0; e < frames.director.size(); ++e)
      frame_error = std::max(frame_error, (frames.director[e] - expected_frames.director[e]).norm());
    for (std::size_t j = 0; j < frames.reference_twist.size(); ++j)
      twist_error = std::max(twist_error, std::abs(frames.reference_twist[j] - expected_frames.reference_twist[j]));
    CHECK(frame_error < 1e-5);
    CHECK(twist_error < 1e-5);
    state.v = (expected - state.q) / h;
    state.q = expected;
    state.frames = expected_frames;
    state.time += h;
  }
}

TEST_CASE("what does not converge is named by its coordinate in the whole scene") {
  Scene scene = many_cables();
  scene.settings.gravity.setZero();
  const System system(scene);
  Stepper stepper(system, scene.settings);
  State state = stepper.initial();
  constexpr double kStep = 1e-3, kSpeed = 10;
  const Index particle = scene.cables[17].particles[15];
  const Eigen::Index z = 3 * static_cast<Eigen::Index>(particle) + 2;
  state.v[z] = kSpeed;
  // A contact with a normal longer than 1 is meaningless: it pulls the particle on, more strongly with the distance,
  // and yet its energy rises. So no step along the derivative decreases the energy.
  ContactTerm term;
  term.particles[0] = particle;
  term.corners = 1;
  term.omega[0] = 1;
  term.normal = {0, 0, 1.3};
  term.goal = -1;
  term.stick = 1;
  term.slip = 0.5 * system.mass[z] / (kStep * kStep) / 1.38;
  const VectorX near = state.q + kStep * state.v;
  const Advance advance = stepper.advance_with(state, kStep, std::vector<ContactTerm>{term}, near);
  REQUIRE_FALSE(advance.converged);
  CHECK(advance.largest_change.coordinate == z);
  CHECK(advance.largest_change.speed > 0.1 * kSpeed);
  CHECK(advance.largest_change.speed < 10 * kSpeed);
}

TEST_CASE("a contact's second derivative is exact where its pull is, and never negative elsewhere") {
  ContactTerm term;
  term.particles = {0, 1, 2, 3};
  term.corners = 4;
  term.omega = {-0.3, -0.7, 0.4, 0.6};
  term.normal = Vector3(1, 2, 2) / 3;
  term.goal = 1e-3;
  term.stiffness = 50;
  term.slip = 3;
  term.stick = 0.1;
  const VectorX x0 = VectorX::Zero(12);
  for (const double slip : {0.02, 0.09, 0.5}) {
    for (const double gap : {-0.01, 0.01}) {
      CAPTURE(slip, gap);
      const Vector3 along = Vector3(2, -2, 1) / 3, u = gap * term.normal + slip * along;
      const auto at = [&](const Vector3& motion) {
        VectorX x = x0;
        x.segment<3>(9) = motion / term.omega[3];
        return x;
      };
      const Vector3 pull = friction_pull(term, x0, at(u));
      const ContactDerivatives d = contact_derivatives(term, x0, at(u), pull);
      constexpr double kStep = 1e-6;
      for (Eigen::Index k = 0; k < 3; ++k) {
        const Vector3 shift = kStep * Vector3::Unit(k);
        const auto gradient = [&](const Vector3& motion) {
          return contact_derivatives(term, x0, at(motion), pull).gradient;
        };
        CHECK((contact_value(term, x0, at(u + shift)) - contact_value(term, x0, at(u - shift))) / (2 * kStep) ==
              Approx(d.gradient[k]).epsilon(1e-6).margin(1e-6));
        CHECK((((gradient(u + shift) - gradient(u - shift)) / (2 * kStep)) - d.hessian.col(k)).norm() < 1e-4);
      }
      // A full step to u + du from a pull that is off brings it to that of u + du, to first order.
      const Vector3 turned = Vector3(2, 1, -2) / 3, off = 0.7 * turned;
      CHECK(smallest_eigenvalue(contact_derivatives(term, x0, at(u), off).hessian) > -1e-12);
      CHECK((next_pull(term, x0, at(u), off, Vector3::Zero(), 1) - pull).norm() < 1e-12);
      const Vector3 du = 1e-5 * along;
      CHECK((next_pull(term, x0, at(u), pull, du, 1) - friction_pull(term, x0, at(u + du))).norm() < 1e-7);
      CHECK(next_pull(term, x0, at(u), off, 100 * turned, 1).norm() <= 1 + 1e-15);
    }
  }
}

TEST_CASE(
    "where contacts make a large system indefinite beside its pattern, the answer still leads down, and is not zero") {
  constexpr int kSize = 600;
  linear::PatternCache cache;
  linear::SparseSolver solver(kSize, {}, {}, cache);
  solver.set_contacts({{0, 1, 2, 30, 31, 32, -1, -1, -1, -1, -1, -1}});
  solver.clear();
  // A contact resists that its two corners come closer; that they move together, only the pattern's diagonal would.
  const auto of_contact = [](int i) { return i < 3 || (i >= 30 && i < 33); };
  for (int i = 0; i < kSize; ++i) solver.add_diagonal(i, of_contact(i) ? -1 : 1);
  solver.add_contact(0, {1, -1, 0, 0}, 10 * Eigen::Matrix3d::Identity());
  REQUIRE(solver.factorise());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(kSize);
  for (int i = 0; i < kSize; ++i) right[i] = of_contact(i) ? 1 : 0;
  CHECK(solver.solve(right).dot(right) > 0.1);
}
