// Energies against finite differences of themselves, and under rigid motion.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <cmath>

#include "rods/energy.hpp"
#include "seeded/rng.hpp"
#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;
using touchstone::seeded::Rng;

namespace {

/// A crumpled, twisted, naturally curved cable and two springs.
Scene crumpled(Rng& random, bool closed, bool twists) {
  Scene scene;
  Cable cable;
  constexpr Index kCount = 6;
  for (Index i = 0; i < kCount; ++i) {
    Particle p;
    const double phi = 2 * 3.141592653589793 * i / kCount;
    p.position = {std::cos(phi) + 0.2 * random.symmetric(), std::sin(phi) + 0.2 * random.symmetric(),
                  0.3 * random.symmetric()};
    scene.particles.push_back(p);
    cable.particles.push_back(i);
  }
  cable.closed = closed;
  cable.radius = 0.1;
  cable.density = 10;
  cable.stretch = 3;
  cable.bend = 2;
  cable.twist = 1.5;
  cable.natural_curvature = {0.3, -0.2};
  cable.length_scale = 1.1;
  if (!twists) {
    cable.twist = 0;
    cable.natural_curvature = {};
  }
  scene.cables.push_back(cable);
  scene.springs.push_back({0, 3, 2.5, 0, 0.7, true});
  scene.springs.push_back({1, 4, 0.5, 0, 3.0, true});
  return scene;
}

struct Place {
  System system;
  VectorX q;
  Frames frames;
};

Place random_place(std::uint64_t seed, bool closed, bool twists = true) {
  Rng random(seed);
  Place place{System(crumpled(random, closed, twists)), {}, {}};
  place.q = place.system.initial_position;
  place.frames = place.system.initial_frames(place.q);
  for (std::size_t j = 0; j < place.system.edges.size(); ++j) {
    if (twists) place.q[place.system.angle(static_cast<Index>(j))] = 2 * random.symmetric();
  }
  return place;
}

}  // namespace

TEST_CASE("the gradient is that of the energy, by central differences") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Place place = random_place(seed, seed % 2 == 0, seed <= 6);
    CAPTURE(seed);
    const Energy energy(place.system);
    const Strains strains = energy.elastic();
    VectorX gradient = VectorX::Zero(place.q.size());
    energy.derivatives(place.q, place.frames, 0, strains, Hessian::exact, gradient, nullptr);
    const double step = 1e-5;
    for (Eigen::Index i = 0; i < place.q.size(); ++i) {
      const auto at = [&](double by) {
        VectorX q = place.q;
        q[i] += by;
        return energy.value(q, place.system.transported(place.frames, place.q, q), 0, strains);
      };
      const double difference = (at(step) - at(-step)) / (2 * step);
      CAPTURE(i, difference, gradient[i]);
      CHECK(std::abs(difference - gradient[i]) < 1e-7 * (1 + gradient.lpNorm<Eigen::Infinity>()));
    }
  }
}

TEST_CASE("the Hessian is that of the energy, by second differences") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Place place = random_place(seed, seed % 2 == 0, seed <= 4);
    CAPTURE(seed);
    const Energy energy(place.system);
    const Strains strains = energy.elastic();
    VectorX gradient = VectorX::Zero(place.q.size());
    DenseSink sink(place.system);
    energy.derivatives(place.q, place.frames, 0, strains, Hessian::exact, gradient, &sink);
    const double step = 1e-4;
    for (Eigen::Index i = 0; i < place.q.size(); ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        const auto at = [&](double a, double b) {
          VectorX q = place.q;
          q[i] += a;
          q[j] += b;
          return energy.value(q, place.system.transported(place.frames, place.q, q), 0, strains);
        };
        const double difference =
            (at(step, step) - at(step, -step) - at(-step, step) + at(-step, -step)) / (4 * step * step);
        CAPTURE(i, j, difference, sink.matrix(i, j));
        CHECK(std::abs(difference - sink.matrix(i, j)) < 1e-5 * (1 + sink.matrix.lpNorm<Eigen::Infinity>()));
        CHECK(sink.matrix(i, j) == Approx(sink.matrix(j, i)).margin(1e-12));
      }
    }
  }
}

TEST_CASE("without twist, bending is that of the centreline alone, however far the frames have been carried") {
  Place place = random_place(5, false, false);
  const Energy energy(place.system);
  const double before = energy.value(place.q, place.frames, 0, energy.elastic());
  for (std::size_t j = 0; j < place.frames.director.size(); ++j) {
    const RodEdge& edge = place.system.edges[j];
    const Vector3 t = (position(place.q, edge.b) - position(place.q, edge.a)).normalized();
    place.frames.director[j] = turned(place.frames.director[j], t, 1.3 * static_cast<double>(j));
  }
  CHECK(energy.value(place.q, place.frames, 0, energy.elastic()) == Approx(before).epsilon(1e-12));
}

TEST_CASE("the projected Hessian has no negative eigenvalue, the exact one does") {
  const Place place = random_place(3, false);
  const Energy energy(place.system);
  VectorX gradient = VectorX::Zero(place.q.size());
  DenseSink exact(place.system), projected(place.system);
  energy.derivatives(place.q, place.frames, 0, energy.elastic(), Hessian::exact, gradient, &exact);
  energy.derivatives(place.q, place.frames, 0, energy.elastic(), Hessian::projected, gradient, &projected);
  CHECK(smallest_eigenvalue(projected.matrix) > -1e-9);
  CHECK(smallest_eigenvalue(exact.matrix) < -1e-3);
}

TEST_CASE("rigid motion leaves every strain as it is") {
  Rng random(7);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Place place = random_place(seed, seed % 2 == 0);
    const Energy energy(place.system);
    VectorX q = place.q;
    Frames frames = place.frames;
    const VectorX before = energy.strains(q, frames, 0);
    // In steps of a tenth of a radian, as a simulation carries its frames; each segment's frame turns about its
    // tangent as it is carried round, and the angles follow to keep the body rigid.
    const Vector3 axis = Vector3(random.symmetric(), random.symmetric(), random.symmetric()).normalized();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.1, axis).toRotationMatrix();
    for (int step = 0; step < 40; ++step) {
      VectorX next = q;
      for (std::size_t i = 0; i < place.system.particle_count(); ++i) {
        const auto at = static_cast<Eigen::Index>(3 * i);
        next.segment<3>(at) = turn * q.segment<3>(at) + Vector3(0.3, -0.1, 0.2);
      }
      const Frames carried = place.system.transported(frames, q, next);
      for (std::size_t j = 0; j < place.system.edges.size(); ++j) {
        const RodEdge& edge = place.system.edges[j];
        const Vector3 t = (position(next, edge.b) - position(next, edge.a)).normalized();
        next[place.system.angle(static_cast<Index>(j))] +=
            signed_angle(carried.director[j], turn * frames.director[j], t);
      }
      q = next;
      frames = carried;
    }
    CHECK((energy.strains(q, frames, 0) - before).lpNorm<Eigen::Infinity>() < 1e-10);
  }
}
