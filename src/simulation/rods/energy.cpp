// SPDX-License-Identifier: MIT
#include "rods/energy.hpp"

#include <algorithm>
#include <cmath>

#include "rods/cloth_energy.hpp"
#include "scene/features.hpp"

namespace touchstone::sim {
namespace {

Eigen::Index joint_row(const System& system, std::size_t j) {
  return static_cast<Eigen::Index>(system.stretch_elements.size() + 3 * j);
}

/// The joint's eleven coordinates of a vector.
JointVector gather(const System& system, const Joint& joint, const VectorX& v) {
  JointVector local;
  local << position(v, joint.p[0]), v[system.angle(joint.e)], position(v, joint.p[1]), v[system.angle(joint.f)],
      position(v, joint.p[2]);
  return local;
}

void scatter(const System& system, const Joint& joint, const JointVector& local, VectorX& v) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    v.segment<3>(3 * static_cast<Eigen::Index>(joint.p[static_cast<std::size_t>(k)])) += local.segment<3>(4 * k);
  }
  v[system.angle(joint.e)] += local[3];
  v[system.angle(joint.f)] += local[7];
}

}  // namespace

VectorX Energy::elastic_stiffness() const {
  VectorX stiffness(static_cast<Eigen::Index>(system_->strain_count()));
  for (std::size_t i = 0; i < system_->stretch_elements.size(); ++i) {
    stiffness[static_cast<Eigen::Index>(i)] = system_->stretch_elements[i].stiffness;
  }
  for (std::size_t j = 0; kRods && j < system_->joints.size(); ++j) {
    const Joint& joint = system_->joints[j];
    stiffness.segment<3>(joint_row(*system_, j)) << joint.bend, joint.bend, joint.twist;
  }
  if (kCloth) {
    for_each_cloth_strain(*system_, [&](Eigen::Index row, double k, double, double) { stiffness[row] = k; });
  }
  return stiffness;
}

Strains Energy::elastic() const {
  Strains s{elastic_stiffness(), VectorX::Zero(static_cast<Eigen::Index>(system_->strain_count()))};
  for (std::size_t i = 0; i < system_->stretch_elements.size(); ++i) {
    s.rest[static_cast<Eigen::Index>(i)] = system_->stretch_elements[i].rest;
  }
  for (std::size_t j = 0; kRods && j < system_->joints.size(); ++j) {
    const auto& rest = system_->joints[j].rest;
    s.rest.segment<3>(joint_row(*system_, j)) << rest[0], rest[1], 0;
  }
  if (kCloth) {
    for_each_cloth_strain(*system_, [&](Eigen::Index row, double, double rest, double) { s.rest[row] = rest; });
  }
  return s;
}

Strains Energy::damped(const VectorX& base, double span) const {
  Strains s = elastic();
  const auto damp = [&](Eigen::Index row, double damping) {
    if (damping == 0) return;
    const double extra = damping / span, sum = s.stiffness[row] + extra;
    s.rest[row] = (s.stiffness[row] * s.rest[row] + extra * base[row]) / sum;
    s.stiffness[row] = sum;
  };
  for (std::size_t i = 0; i < system_->stretch_elements.size(); ++i) {
    damp(static_cast<Eigen::Index>(i), system_->stretch_elements[i].damping);
  }
  for (std::size_t j = 0; kRods && j < system_->joints.size(); ++j) {
    const Joint& joint = system_->joints[j];
    const Eigen::Index row = joint_row(*system_, j);
    damp(row, joint.damping * joint.bend);
    damp(row + 1, joint.damping * joint.bend);
    damp(row + 2, joint.damping * joint.twist);
  }
  if (kCloth) {
    for_each_cloth_strain(*system_, [&](Eigen::Index row, double k, double, double time) { damp(row, time * k); });
  }
  return s;
}

VectorX Energy::damping() const {
  VectorX c = VectorX::Zero(static_cast<Eigen::Index>(system_->strain_count()));
  for (std::size_t i = 0; i < system_->stretch_elements.size(); ++i) {
    c[static_cast<Eigen::Index>(i)] = system_->stretch_elements[i].damping;
  }
  for (std::size_t j = 0; kRods && j < system_->joints.size(); ++j) {
    const Joint& joint = system_->joints[j];
    c.segment<3>(joint_row(*system_, j)) = joint.damping * Vector3(joint.bend, joint.bend, joint.twist);
  }
  if (kCloth) {
    for_each_cloth_strain(*system_, [&](Eigen::Index row, double k, double, double time) { c[row] = time * k; });
  }
  return c;
}

VectorX Energy::strains(const VectorX& q, const Frames& frames, double time) const {
  VectorX s(static_cast<Eigen::Index>(system_->strain_count()));
  for (std::size_t i = 0; i < system_->stretch_elements.size(); ++i) {
    const StretchElement& element = system_->stretch_elements[i];
    s[static_cast<Eigen::Index>(i)] = (position(q, element.b) - position(q, element.a)).norm();
  }
  for (std::size_t j = 0; kRods && j < system_->joints.size(); ++j) {
    const JointStrain strain = system_->joint_strain(system_->joints[j], q, frames, time);
    s.segment<3>(joint_row(*system_, j)) << strain.kappa1(), strain.kappa2(), strain.twist();
  }
  if (kCloth) measure_cloth(*system_, q, s);
  return s;
}

VectorX Energy::strain_rates(const VectorX& q, const VectorX& v, const Frames& frames, double time) const {
  VectorX rates(static_cast<Eigen::Index>(system_->strain_count()));
  for (std::size_t i = 0; i < system_->stretch_elements.size(); ++i) {
    const StretchElement& element = system_->stretch_elements[i];
    const Vector3 along = (position(q, element.b) - position(q, element.a)).normalized();
    rates[static_cast<Eigen::Index>(i)] = along.dot(position(v, element.b) - position(v, element.a));
  }
  for (std::size_t j = 0; kRods && j < system_->joints.size(); ++j) {
    const Joint& joint = system_->joints[j];
    JointVector k1, k2, m;
    system_->joint_strain(joint, q, frames, time).gradients(k1, k2, m);
    JointVector local = gather(*system_, joint, v);
    local[7] += time < joint.closing_until ? joint.closing_rate : 0;  // its frame turns by itself
    rates.segment<3>(joint_row(*system_, j)) << k1.dot(local), k2.dot(local), m.dot(local);
  }
  if (kCloth) measure_cloth_rates(*system_, q, v, rates);
  return rates;
}

VectorX Energy::tensions_after(const VectorX& q, const Strains& strains, const VectorX& step) const {
  VectorX tensions(static_cast<Eigen::Index>(system_->stretch_elements.size()));
  for (std::size_t i = 0; i < system_->stretch_elements.size(); ++i) {
    const StretchElement& element = system_->stretch_elements[i];
    const auto row = static_cast<Eigen::Index>(i);
    const Vector3 between = position(q, element.b) - position(q, element.a);
    const double longer = between.normalized().dot(position(step, element.b) - position(step, element.a));
    tensions[row] = strains.stiffness[row] * (between.norm() + longer - strains.rest[row]);
  }
  return tensions;
}

double Energy::value(const VectorX& q, const Frames& frames, double time, const Strains& strains) const {
  const VectorX s = this->strains(q, frames, time);
  const double parabolas = 0.5 * (strains.stiffness.array() * (s - strains.rest).array().square()).sum();
  return kCloth && strains.with_limits ? parabolas + stretch_limit_energy(*system_, s) : parabolas;
}

void Energy::derivatives(const VectorX& q, const Frames& frames, double time, const Strains& strains, Hessian hessian,
                         VectorX& gradient, BlockSink* sink, const VectorX* tensions) const {
  for (std::size_t i = 0; i < system_->stretch_elements.size(); ++i) {
    const StretchElement& element = system_->stretch_elements[i];
    const auto row = static_cast<Eigen::Index>(i);
    const Vector3 between = position(q, element.b) - position(q, element.a);
    const double length = between.norm();
    const Vector3 along = between / length;
    const double k = strains.stiffness[row], stress = k * (length - strains.rest[row]);
    const Vector3 pull = stress * along;
    gradient.segment<3>(3 * static_cast<Eigen::Index>(element.a)) -= pull;
    gradient.segment<3>(3 * static_cast<Eigen::Index>(element.b)) += pull;
    if (sink == nullptr) continue;
    const double turning = (tensions != nullptr ? (*tensions)[row] : stress) / length;
    const double across = hessian == Hessian::projected ? std::max(turning, 0.0) : turning;
    const Eigen::Matrix3d projection = along * along.transpose();
    sink->stretch(i, k * projection + across * (Eigen::Matrix3d::Identity() - projection));
  }
  for (std::size_t j = 0; kRods && j < system_->joints.size(); ++j) {
    const Joint& joint = system_->joints[j];
    const JointStrain strain = system_->joint_strain(joint, q, frames, time);
    const Eigen::Index row = joint_row(*system_, j);
    const Vector3 k = strains.stiffness.segment<3>(row);
    const Vector3 stress =
        k.cwiseProduct(Vector3(strain.kappa1(), strain.kappa2(), strain.twist()) - strains.rest.segment<3>(row));
    JointVector k1, k2, m;
    strain.gradients(k1, k2, m);
    scatter(*system_, joint, stress[0] * k1 + stress[1] * k2 + stress[2] * m, gradient);
    if (sink == nullptr) continue;
    JointMatrix block = k[0] * k1 * k1.transpose() + k[1] * k2 * k2.transpose() + k[2] * m * m.transpose();
    if (hessian == Hessian::exact) strain.add_hessians(stress[0], stress[1], stress[2], block);
    sink->joint(j, block);
  }
  if (kCloth) cloth_derivatives(*system_, q, strains, hessian, gradient, sink);
}

}  // namespace touchstone::sim
