// The energies of cloth against finite differences of themselves, and under rigid motion.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "cloth/cloth_scenes.hpp"
#include "rods/cloth_energy.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;
using touchstone::seeded::Rng;

namespace {

struct Place {
  Scene scene;
  System system;
  VectorX q;
};

/// An irregular sheet, crumpled: stretched and sheared by up to some tenths, with folds of up to 2 radians.
Place crumpled(std::uint64_t seed, bool limited) {
  Rng random(seed);
  SheetScene sheet = sheet_scene(1, 0.9, 3);
  make_irregular(sheet, 0.06, random);
  for (Particle& p : sheet.scene.particles) p.position.z() += 0.1 * random.symmetric();
  sheet.surface().rest_is_bent = seed % 2 == 0;
  sheet.surface().bend = 0.5;
  sheet.surface().poisson = 0.1 * static_cast<double>(seed % 5);
  sheet.surface().strain_limit = limited ? 0.12 : 0;
  Place place{sheet.scene, System(sheet.scene), {}};
  place.q = place.system.initial_position;
  VectorX moved = place.q;
  for (Eigen::Index i = 0; i < moved.size(); ++i) moved[i] += 0.15 * random.symmetric();
  if (limited) {
    // As far as leads to a stretch near the limit, but with none where its energy begins: the third derivative jumps
    // there, which finite differences across it show.
    const double begins = 1 + 0.75 * sheet.surface().strain_limit;
    const auto at_jump = [begins](double stretch) { return std::abs(stretch - begins) < 1e-3; };
    double low = 0, high = 1;
    for (int halving = 0; halving < 50; ++halving) {
      const double part = 0.5 * (low + high);
      (largest_stretch(place.scene, place.q + part * (moved - place.q)) < 1.1 ? low : high) = part;
    }
    const VectorX way = moved - place.q;
    const auto stretches = [&] { return principal_stretches(place.scene, place.q + low * way); };
    for (auto all = stretches(); std::any_of(all.begin(), all.end(), at_jump); all = stretches()) low *= 0.999;
    moved = place.q + low * way;
  }
  place.q = moved;
  return place;
}

VectorX gradient_at(const Place& place, const VectorX& q) {
  const Energy energy(place.system);
  VectorX gradient = VectorX::Zero(q.size());
  energy.derivatives(q, {}, 0, energy.elastic(), Hessian::exact, gradient, nullptr);
  return gradient;
}

}  // namespace

TEST_CASE("the forces of cloth are the gradient of its energy, with a limit of stretch and without") {
  double near_limit = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Place place = crumpled(seed, seed > 4);
    CAPTURE(seed);
    const Energy energy(place.system);
    const Strains strains = energy.elastic();
    near_limit = std::max(near_limit, stretch_limit_energy(place.system, energy.strains(place.q, {}, 0)));
    const VectorX gradient = gradient_at(place, place.q);
    for (Eigen::Index i = 0; i < place.q.size(); ++i) {
      const auto at = [&](double by) {
        VectorX q = place.q;
        q[i] += by;
        return energy.value(q, {}, 0, strains);
      };
      // Five points, so that the fourth derivatives of the sharper folds do not show.
      const double step = 3e-5;
      const double difference = (8 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12 * step);
      CAPTURE(i, difference, gradient[i]);
      CHECK(std::abs(difference - gradient[i]) < 1e-7 * (1 + gradient.lpNorm<Eigen::Infinity>()));
    }
  }
  CHECK(std::isfinite(near_limit));
  CHECK(near_limit > 1e-3);  // the limit has a say in some of these places
}

TEST_CASE("the second derivatives of cloth are those of its forces") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Place place = crumpled(seed, seed > 4);
    CAPTURE(seed);
    const Energy energy(place.system);
    VectorX gradient = VectorX::Zero(place.q.size());
    DenseSink sink(place.system);
    energy.derivatives(place.q, {}, 0, energy.elastic(), Hessian::exact, gradient, &sink);
    const double size = sink.matrix.lpNorm<Eigen::Infinity>();
    CHECK((sink.matrix - sink.matrix.transpose()).lpNorm<Eigen::Infinity>() < 1e-13 * size);
    for (Eigen::Index i = 0; i < place.q.size(); ++i) {
      const double step = 3e-5;
      const auto at = [&](double by) {
        VectorX q = place.q;
        q[i] += by;
        return gradient_at(place, q);
      };
      const VectorX difference = (8 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12 * step);
      CAPTURE(i);
      CHECK((difference - sink.matrix.col(i)).lpNorm<Eigen::Infinity>() < 1e-7 * (1 + size));
    }
  }
}

TEST_CASE("the projected second derivatives of cloth have no negative eigenvalue, the exact ones do") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Place place = crumpled(seed, seed > 3);
    const Energy energy(place.system);
    VectorX gradient = VectorX::Zero(place.q.size());
    DenseSink exact(place.system), projected(place.system);
    energy.derivatives(place.q, {}, 0, energy.elastic(), Hessian::exact, gradient, &exact);
    energy.derivatives(place.q, {}, 0, energy.elastic(), Hessian::projected, gradient, &projected);
    CAPTURE(seed);
    CHECK(smallest_eigenvalue(projected.matrix) > -1e-12 * projected.matrix.lpNorm<Eigen::Infinity>());
    if (seed <= 3) CHECK(smallest_eigenvalue(exact.matrix) < -1e-3);  // the others are stretched everywhere
  }
}

TEST_CASE("rigid motion leaves the strains of cloth as they are, and its forces have no sum and no moment") {
  Rng random(11);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Place place = crumpled(seed, seed > 3);
    const Energy energy(place.system);
    const Vector3 axis = Vector3(random.symmetric(), random.symmetric(), random.symmetric()).normalized();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(3 * random.symmetric(), axis).toRotationMatrix();
    VectorX q = place.q;
    const VectorX gradient = gradient_at(place, place.q);
    Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
    for (Eigen::Index at = 0; at < q.size(); at += 3) {
      q.segment<3>(at) = turn * place.q.segment<3>(at) + Vector3(0.3, -0.1, 0.2);
      const Vector3 force = gradient.segment<3>(at), arm = place.q.segment<3>(at);
      sum += force;
      moment += arm.cross(force);
    }
    CAPTURE(seed);
    CHECK((energy.strains(q, {}, 0) - energy.strains(place.q, {}, 0)).lpNorm<Eigen::Infinity>() < 1e-12);
    CHECK(sum.norm() < 1e-12 * gradient.lpNorm<1>());
    CHECK(moment.norm() < 1e-12 * gradient.lpNorm<1>());
  }
}

TEST_CASE("the derivatives of the limit of stretch hold where both principal stretches are equal, and beside it") {
  Membrane membrane;
  membrane.limit = 1.21;
  membrane.limit_width = 0.06;
  membrane.limit_stiffness = 2.5;
  const double step = 1e-5;
  Rng random(3);
  for (const double shear : {0.0, 1e-12, 1e-10, 1e-7, 1e-3, 0.02, 0.05}) {
    const Vector3 s(0.2 - shear, shear * 0.6, shear * 0.8);
    REQUIRE(std::isfinite(limit_energy(membrane, s)));
    REQUIRE(limit_energy(membrane, s) > 0);
    const LimitDerivatives derivatives = limit_derivatives(membrane, s);
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector3 less = s, more = s;
      less[i] -= step;
      more[i] += step;
      const double slope = (limit_energy(membrane, more) - limit_energy(membrane, less)) / (2 * step);
      const Vector3 bend =
          (limit_derivatives(membrane, more).gradient - limit_derivatives(membrane, less).gradient) / (2 * step);
      CAPTURE(shear, i);
      CHECK(std::abs(slope - derivatives.gradient[i]) < 1e-4 * (1 + derivatives.gradient.norm()));
      CHECK((bend - derivatives.hessian.col(i)).norm() < 1e-4 * (1 + derivatives.hessian.norm()));
    }
    CHECK(smallest_eigenvalue(derivatives.hessian) > -1e-9);
  }
  CHECK(limit_energy(membrane, {0.21, 0, 0}) == std::numeric_limits<double>::infinity());
  CHECK(limit_energy(membrane, {0.1, 0.066, 0.088}) == std::numeric_limits<double>::infinity());
  CHECK(limit_energy(membrane, {0.05, 0, 0}) == 0);
}
