// SPDX-License-Identifier: MIT
#include "rods/system.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rods/joint.hpp"
#include "scene/features.hpp"

namespace touchstone::sim {
namespace {

Vector3 position_at(const std::vector<Waypoint>& path, double time) {
  const auto after = std::find_if(path.begin(), path.end(), [time](const Waypoint& p) { return p.time > time; });
  if (after == path.begin()) return path.front().position;
  if (after == path.end()) return path.back().position;
  const Waypoint& before = *(after - 1);
  const double fraction = (time - before.time) / (after->time - before.time);
  return before.position + fraction * (after->position - before.position);
}

Vector3 tangent(const VectorX& q, const RodEdge& edge) {
  return (position(q, edge.b) - position(q, edge.a)).normalized();
}

}  // namespace

System::System(const Scene& scene) : particle_count_(scene.particles.size()) {
  for (Index i = 0; i < scene.particles.size(); ++i) {
    const Particle& p = scene.particles[i];
    placed_.push_back(p.path.empty() ? p.position : position_at(p.path, 0));
    particle_mass_.push_back(p.mass);
    if (!p.path.empty()) paths_.emplace_back(i, p.path);
  }
  for (const Spring& s : scene.springs)
    stretch_elements.push_back({s.a, s.b, s.stiffness, s.damping, s.rest_length, false});
  for (const Cable& cable : scene.cables) add_cable(cable);
  for (std::size_t i = 0; kCloth && i < scene.surfaces.size(); ++i)
    append_elements(scene.surfaces[i], placed_, particle_mass_, cloth);
  std::erase_if(followers_, [&](const Follower& f) { return scene.particles[f.leader].path.empty(); });

  particle_count_ = placed_.size();
  const auto n = static_cast<Eigen::Index>(3 * particle_count_);
  mass = VectorX::Zero(size());
  force = VectorX::Zero(size());
  initial_position = VectorX::Zero(size());
  initial_velocity = VectorX::Zero(size());
  fixed.assign(static_cast<std::size_t>(size()), 0);
  for (std::size_t i = 0; i < particle_count_; ++i) {
    const auto at = static_cast<Eigen::Index>(3 * i);
    const bool ghost = i >= scene.particles.size();
    mass.segment<3>(at).setConstant(particle_mass_[i]);
    initial_position.segment<3>(at) = placed_[i];
    if (ghost) {
      std::fill_n(fixed.begin() + at, 3, char{1});
      continue;
    }
    const Particle& p = scene.particles[i];
    force.segment<3>(at) = particle_mass_[i] * scene.settings.gravity + p.force;
    for (Eigen::Index k = 0; k < 3; ++k) {
      fixed[static_cast<std::size_t>(at + k)] = !p.path.empty() || p.fixed[static_cast<std::size_t>(k)];
      if (!fixed[static_cast<std::size_t>(at + k)]) initial_velocity[at + k] = p.velocity[k];
    }
  }
  for (std::size_t j = 0; j < edges.size(); ++j) {
    mass[n + static_cast<Eigen::Index>(j)] = inertia_[j];
    if (!edges[j].twists) fixed[static_cast<std::size_t>(n) + j] = 1;
  }
  for (const DrivenAngle& driven : driven_angles) fixed[static_cast<std::size_t>(angle(driven.edge))] = 1;
  const Frames frames = initial_frames(initial_position);
  for (const Index j : bent_) {
    const JointStrain strain = joint_strain(joints[j], initial_position, frames, 0);
    joints[j].rest = {strain.kappa1(), strain.kappa2()};
  }
  placed_ = {};
  particle_mass_ = inertia_ = length_ = {};
  stretch_elements.shrink_to_fit();
  edges.shrink_to_fit();
  joints.shrink_to_fit();
  cloth.membranes.shrink_to_fit();
  cloth.hinges.shrink_to_fit();
}

System System::subset(const SystemSubset& members, const std::vector<Index>& local_particle,
                      const std::vector<Index>& local_edge) const {
  System own;
  own.particle_count_ = members.particles.size();
  own.edges.reserve(members.edges.size());
  for (const Index e : members.edges) {
    own.edges.push_back({local_particle[edges[e].a], local_particle[edges[e].b], edges[e].twists});
  }
  own.stretch_elements.reserve(members.stretch_elements.size());
  for (const Index l : members.stretch_elements) {
    own.stretch_elements.push_back(stretch_elements[l]);
    own.stretch_elements.back().a = local_particle[stretch_elements[l].a];
    own.stretch_elements.back().b = local_particle[stretch_elements[l].b];
  }
  own.joints.reserve(members.joints.size());
  for (const Index j : members.joints) {
    own.joints.push_back(joints[j]);
    Joint& joint = own.joints.back();
    for (Index& p : joint.p) p = local_particle[p];
    joint.e = local_edge[joint.e];
    joint.f = local_edge[joint.f];
  }
  for (const Index m : members.membranes) {
    own.cloth.membranes.push_back(cloth.membranes[m]);
    for (Index& p : own.cloth.membranes.back().p) p = local_particle[p];
  }
  for (const Index h : members.hinges) {
    own.cloth.hinges.push_back(cloth.hinges[h]);
    for (Index& p : own.cloth.hinges.back().p) p = local_particle[p];
  }
  own.mass.resize(own.size());
  own.force.resize(own.size());
  own.fixed.reserve(static_cast<std::size_t>(own.size()));
  const auto take = [&](Eigen::Index from) {
    const auto to = static_cast<Eigen::Index>(own.fixed.size());
    own.mass[to] = mass[from];
    own.force[to] = force[from];
    own.fixed.push_back(fixed[static_cast<std::size_t>(from)]);
  };
  for (const Index p : members.particles) {
    for (Eigen::Index k = 0; k < 3; ++k) take(3 * static_cast<Eigen::Index>(p) + k);
  }
  for (const Index e : members.edges) take(angle(e));
  return own;
}

JointStrain System::joint_strain(const Joint& joint, const VectorX& q, const Frames& frames, double time) const {
  const auto number = static_cast<std::size_t>(&joint - joints.data());
  if (!edges[joint.e].twists) {
    return {position(q, joint.p[0]), position(q, joint.p[1]), position(q, joint.p[2]), frames.director[joint.e]};
  }
  const double inserted = joint.closing_rate * std::min(time, joint.closing_until);
  return {position(q, joint.p[0]),      position(q, joint.p[1]),       position(q, joint.p[2]),
          frames.director[joint.e],     frames.director[joint.f],      q[angle(joint.e)],
          q[angle(joint.f)] + inserted, frames.reference_twist[number]};
}

void System::add_cable(const Cable& cable) {
  const auto first_joint = static_cast<Index>(joints.size());
  const auto first_edge = static_cast<Index>(edges.size());
  const std::size_t count = cable.particles.size();
  const bool twists = cable.twist > 0 && cable.bend > 0;
  const double section = std::numbers::pi * cable.radius * cable.radius;
  // A cable that does not bend has stretch elements and mass only.
  const bool is_rod = cable.bend > 0;
  for (std::size_t j = 0; j < cable.edge_count(); ++j) {
    const Index a = cable.particles[j], b = cable.particles[(j + 1) % count];
    const double length = cable.length_scale * (placed_[b] - placed_[a]).norm();
    stretch_elements.push_back({a, b, cable.stretch / length, cable.damping * cable.stretch / length, length, true});
    const double half = 0.5 * cable.density * section * length;
    particle_mass_[a] += half;
    particle_mass_[b] += half;
    if (!is_rod) continue;
    edges.push_back({a, b, twists});
    length_.push_back(length);
    inertia_.push_back(cable.density * section * 0.5 * cable.radius * cable.radius * length);
  }
  if (!is_rod) return;
  const auto edge_count = static_cast<Index>(cable.edge_count());
  for (Index j = 0; j + 1 < edge_count; ++j) add_joint(cable, first_edge + j, first_edge + j + 1, 1);
  if (cable.closed) {
    add_joint(cable, first_edge + edge_count - 1, first_edge, 1);
    joints.back().closing_rate = cable.closing_twist_rate;
    joints.back().closing_until = cable.closing_twist_until;
  } else {
    if (cable.start.clamped) add_clamp(cable, cable.start, true, first_edge);
    if (cable.end.clamped) add_clamp(cable, cable.end, false, first_edge + edge_count - 1);
  }
  runs_.emplace_back(first_joint, static_cast<Index>(joints.size()));
}

void System::add_clamp(const Cable& cable, const CableEnd& end, bool at_start, Index edge) {
  // The clamp holds an edge of its own beyond the end, so that the joint at the end stands for half a segment. The
  // error of a cantilever is then of second order; a clamped first segment would make it shorter by half a segment.
  const RodEdge inner = edges[edge];
  const Index at = at_start ? inner.a : inner.b;
  const Index other = at_start ? inner.b : inner.a;
  const auto ghost = static_cast<Index>(placed_.size());
  placed_.push_back(2 * placed_[at] - placed_[other]);
  particle_mass_.push_back(0);
  followers_.push_back({ghost, at, placed_[ghost] - placed_[at]});
  ghosts.push_back(ghost);
  const auto own = static_cast<Index>(edges.size());
  edges.push_back(at_start ? RodEdge{ghost, at, inner.twists} : RodEdge{at, ghost, inner.twists});
  length_.push_back(length_[edge]);
  inertia_.push_back(inertia_[edge]);
  if (at_start) {
    add_joint(cable, own, edge, 0.5);
  } else {
    add_joint(cable, edge, own, 0.5);
  }
  driven_angles.push_back({own, end.twist_rate, end.twist_until});
}

void System::add_joint(const Cable& cable, Index e, Index f, double fraction) {
  Joint joint;
  joint.p = {edges[e].a, edges[e].b, edges[f].b};
  joint.e = e;
  joint.f = f;
  const double length = fraction * 0.5 * (length_[e] + length_[f]);
  joint.bend = cable.bend / length;
  joint.twist = edges[e].twists ? cable.twist / length : 0;
  joint.damping = cable.damping;
  joint.rest = {cable.natural_curvature[0] * length, cable.natural_curvature[1] * length};
  if (cable.rest_is_bent) bent_.push_back(static_cast<Index>(joints.size()));
  joints.push_back(joint);
}

void System::prescribe(double time, VectorX& q) const {
  for (const auto& [particle, path] : paths_)
    q.segment<3>(3 * static_cast<Eigen::Index>(particle)) = position_at(path, time);
  for (const Follower& f : followers_)
    q.segment<3>(3 * static_cast<Eigen::Index>(f.ghost)) = position(q, f.leader) + f.offset;
  for (const DrivenAngle& driven : driven_angles) q[angle(driven.edge)] = driven.rate * std::min(time, driven.until);
}

Frames System::initial_frames(const VectorX& q) const {
  Frames frames;
  frames.director.assign(edges.size(), Vector3::Zero());
  frames.reference_twist.assign(joints.size(), 0);
  std::vector<char> known(edges.size(), 0);
  for (const auto& [first, last] : runs_) {
    // Joints are in the order of the cable, and those of clamps come last. So each has an edge whose frame is known.
    for (Index j = first; j < last; ++j) {
      const Joint& joint = joints[j];
      const Vector3 te = tangent(q, edges[joint.e]), tf = tangent(q, edges[joint.f]);
      if (!known[joint.e] && !known[joint.f]) {
        frames.director[joint.e] = any_perpendicular(te);
        known[joint.e] = 1;
      }
      if (!known[joint.f]) {
        frames.director[joint.f] = unit_perpendicular(parallel_transport(frames.director[joint.e], te, tf), tf);
        known[joint.f] = 1;
      } else if (!known[joint.e]) {
        frames.director[joint.e] = unit_perpendicular(parallel_transport(frames.director[joint.f], tf, te), te);
        known[joint.e] = 1;
      } else {
        frames.reference_twist[j] =
            signed_angle(parallel_transport(frames.director[joint.e], te, tf), frames.director[joint.f], tf);
      }
    }
  }
  for (std::size_t j = 0; j < edges.size(); ++j) {
    if (!known[j]) frames.director[j] = any_perpendicular(tangent(q, edges[j]));
  }
  return frames;
}

Frames System::transported(const Frames& frames, const VectorX& from, const VectorX& to) const {
  Frames carried;
  carried.director.resize(edges.size());
  carried.reference_twist.resize(joints.size());
  std::vector<Vector3> tangents(edges.size());
  for (std::size_t j = 0; kRods && j < edges.size(); ++j) {
    tangents[j] = tangent(to, edges[j]);
    carried.director[j] =
        unit_perpendicular(parallel_transport(frames.director[j], tangent(from, edges[j]), tangents[j]), tangents[j]);
  }
  for (std::size_t j = 0; kRods && j < joints.size(); ++j) {
    const Vector3 &te = tangents[joints[j].e], &tf = tangents[joints[j].f];
    const double before = frames.reference_twist[j];
    const Vector3 over =
        turned(unit_perpendicular(parallel_transport(carried.director[joints[j].e], te, tf), tf), tf, before);
    carried.reference_twist[j] = before + signed_angle(over, carried.director[joints[j].f], tf);
  }
  return carried;
}

}  // namespace touchstone::sim
