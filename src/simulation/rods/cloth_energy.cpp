// SPDX-License-Identifier: MIT
#include "rods/cloth_energy.hpp"

#include <cmath>

namespace touchstone::sim {
namespace {

MembraneStrain strain_of(const Membrane& membrane, const VectorX& q) {
  return {membrane, position(q, membrane.p[0]), position(q, membrane.p[1]), position(q, membrane.p[2])};
}

HingeStrain strain_of(const Hinge& hinge, const VectorX& q) {
  return {position(q, hinge.p[0]), position(q, hinge.p[1]), position(q, hinge.p[2]), position(q, hinge.p[3])};
}

template <std::size_t N>
Eigen::Matrix<double, 3 * static_cast<int>(N), 1> gathered(const std::array<Index, N>& particles, const VectorX& v) {
  Eigen::Matrix<double, 3 * static_cast<int>(N), 1> local;
  for (std::size_t c = 0; c < N; ++c)
    local.template segment<3>(3 * static_cast<Eigen::Index>(c)) = position(v, particles[c]);
  return local;
}

template <std::size_t N>
void scatter(const std::array<Index, N>& particles, const Eigen::Matrix<double, 3 * static_cast<int>(N), 1>& local,
             VectorX& v) {
  for (std::size_t c = 0; c < N; ++c) {
    v.segment<3>(3 * static_cast<Eigen::Index>(particles[c])) +=
        local.template segment<3>(3 * static_cast<Eigen::Index>(c));
  }
}

void membrane_derivatives(const System& system, const VectorX& q, const Strains& strains, Hessian hessian,
                          VectorX& gradient, BlockSink* sink) {
  for (std::size_t m = 0; m < system.cloth.membranes.size(); ++m) {
    const Membrane& membrane = system.cloth.membranes[m];
    const auto row = static_cast<Eigen::Index>(system.membrane_row(m));
    const MembraneStrain strain = strain_of(membrane, q);
    const Vector3 s = strain.strains(), k = strains.stiffness.segment<3>(row);
    Vector3 stress = k.cwiseProduct(s - strains.rest.segment<3>(row));
    Eigen::Matrix3d stiffness = k.asDiagonal();
    if (membrane.limit > 0 && strains.with_limits) {
      const LimitDerivatives limit = limit_derivatives(membrane, s);
      stress += limit.gradient;
      stiffness += limit.hessian;
    }
    const Eigen::Matrix<double, 9, 3> gradients = strain.gradients();
    scatter(membrane.p, gradients * stress, gradient);
    if (sink == nullptr) continue;
    MembraneMatrix block = gradients * stiffness * gradients.transpose();
    strain.add_hessians(stress, hessian == Hessian::projected, block);
    sink->membrane(m, block);
  }
}

}  // namespace

void measure_cloth(const System& system, const VectorX& q, VectorX& strains) {
  for (std::size_t m = 0; m < system.cloth.membranes.size(); ++m) {
    strains.segment<3>(static_cast<Eigen::Index>(system.membrane_row(m))) =
        strain_of(system.cloth.membranes[m], q).strains();
  }
  for (std::size_t h = 0; h < system.cloth.hinges.size(); ++h) {
    strains[static_cast<Eigen::Index>(system.hinge_row(h))] = strain_of(system.cloth.hinges[h], q).bend();
  }
}

void measure_cloth_rates(const System& system, const VectorX& q, const VectorX& v, VectorX& rates) {
  for (std::size_t m = 0; m < system.cloth.membranes.size(); ++m) {
    const Membrane& membrane = system.cloth.membranes[m];
    rates.segment<3>(static_cast<Eigen::Index>(system.membrane_row(m))) =
        strain_of(membrane, q).gradients().transpose() * gathered(membrane.p, v);
  }
  for (std::size_t h = 0; h < system.cloth.hinges.size(); ++h) {
    const Hinge& hinge = system.cloth.hinges[h];
    rates[static_cast<Eigen::Index>(system.hinge_row(h))] = strain_of(hinge, q).gradient().dot(gathered(hinge.p, v));
  }
}

double stretch_limit_energy(const System& system, const VectorX& strains) {
  double sum = 0;
  for (std::size_t m = 0; m < system.cloth.membranes.size(); ++m) {
    const Membrane& membrane = system.cloth.membranes[m];
    if (membrane.limit > 0)
      sum += limit_energy(membrane, strains.segment<3>(static_cast<Eigen::Index>(system.membrane_row(m))));
  }
  return sum;
}

void cloth_derivatives(const System& system, const VectorX& q, const Strains& strains, Hessian hessian,
                       VectorX& gradient, BlockSink* sink) {
  membrane_derivatives(system, q, strains, hessian, gradient, sink);
  for (std::size_t h = 0; h < system.cloth.hinges.size(); ++h) {
    const Hinge& hinge = system.cloth.hinges[h];
    const auto row = static_cast<Eigen::Index>(system.hinge_row(h));
    const HingeStrain strain = strain_of(hinge, q);
    const double k = strains.stiffness[row], stress = k * (strain.bend() - strains.rest[row]);
    const HingeVector own = strain.gradient();
    scatter(hinge.p, HingeVector(stress * own), gradient);
    if (sink == nullptr) continue;
    HingeMatrix block = k * own * own.transpose();
    if (hessian == Hessian::exact) strain.add_hessian(stress, block);
    sink->hinge(h, block);
  }
}

bool within_stretch_limits(const System& system, const VectorX& q) {
  for (const Membrane& membrane : system.cloth.membranes) {
    if (membrane.limit > 0 && !(largest_square_stretch(strain_of(membrane, q).strains()) < membrane.limit))
      return false;
  }
  return true;
}

}  // namespace touchstone::sim
