// SPDX-License-Identifier: MIT
#include "dynamics/islands.hpp"

#include <algorithm>
#include <utility>

#include "linear/union_find.hpp"

namespace touchstone::sim {
namespace {

constexpr Index kLeastUnknowns = 1000;  // smaller parts are solved together: each has a price beside its size

VectorX gathered(const VectorX& v, const SystemPart& part, const System& system) {
  VectorX own(static_cast<Eigen::Index>(3 * part.particles.size() + part.edges.size()));
  Eigen::Index at = 0;
  for (const Index p : part.particles) {
    own.segment<3>(at) = position(v, p);
    at += 3;
  }
  for (const Index e : part.edges) own[at++] = v[system.angle(e)];
  return own;
}

VectorX gathered_strains(const VectorX& v, const SystemPart& part, const System& system) {
  VectorX own(static_cast<Eigen::Index>(part.lengths.size() + 3 * part.joints.size()));
  Eigen::Index at = 0;
  for (const Index l : part.lengths) own[at++] = v[static_cast<Eigen::Index>(l)];
  for (const Index j : part.joints) {
    own.segment<3>(at) = v.segment<3>(static_cast<Eigen::Index>(system.lengths.size() + 3 * std::size_t{j}));
    at += 3;
  }
  return own;
}

/// Of the whole system; -1 stays.
Eigen::Index coordinate_of(const SystemPart& part, Eigen::Index own, const System& system) {
  if (own < 0) return own;
  const auto particle = static_cast<std::size_t>(own) / 3;
  if (particle < part.particles.size()) return 3 * static_cast<Eigen::Index>(part.particles[particle]) + own % 3;
  return system.angle(part.edges[static_cast<std::size_t>(own) - 3 * part.particles.size()]);
}

}  // namespace

Islands::Islands(const System& system, const Settings& settings)
    : system_(&system), settings_(settings), components_(system) {
  local_particle_.assign(system.particle_count(), kNone);
  local_edge_.assign(system.edges.size(), kNone);
}

std::vector<Islands::Part> Islands::parts_of(std::span<const ContactTerm> contacts, std::vector<Index>& part_of) const {
  linear::UnionFind tied(components_.unknowns.size());
  for (const ContactTerm& term : contacts) {
    Index before = kNone;
    for (std::size_t c = 0; c < term.corners; ++c) {
      const Index own = components_.of_particle[term.particles[c]];
      if (own == kNone) continue;
      if (before != kNone) tied.join(before, own);
      before = own;
    }
  }
  part_of.assign(components_.unknowns.size(), kNone);
  std::vector<Index> island_unknowns(components_.unknowns.size(), 0);
  for (Index c = 0; c < components_.unknowns.size(); ++c) island_unknowns[tied.root(c)] += components_.unknowns[c];
  std::vector<Part> parts;
  Index open = kNone, in_open = 0;  // a part that small islands still join
  for (Index c = 0; c < components_.unknowns.size(); ++c) {
    const Index root = tied.root(c);
    if (root == c) {
      const bool small = island_unknowns[c] < kLeastUnknowns;
      if (!small || open == kNone) {
        parts.emplace_back();
        part_of[c] = static_cast<Index>(parts.size() - 1);
        if (small) {
          open = part_of[c];
          in_open = 0;
        }
      } else {
        part_of[c] = open;
      }
      if (small && (in_open += island_unknowns[c]) >= kLeastUnknowns) open = kNone;
    }
    part_of[c] = part_of[root];
    parts[part_of[c]].push_back(c);
  }
  return parts;
}

SystemPart Islands::members_of(const Part& part, bool with_loose, const std::vector<Index>& contacts,
                               const Stage& stage) {
  SystemPart own;
  for (const Index c : part) {
    components_.particles.append(c, own.particles);
    components_.edges.append(c, own.edges);
    components_.lengths.append(c, own.lengths);
    components_.joints.append(c, own.joints);
  }
  if (with_loose) own.edges.insert(own.edges.end(), components_.loose_edges.begin(), components_.loose_edges.end());
  // What is held comes along wherever something leans on it.
  for (Index i = 0; i < own.edges.size(); ++i) local_edge_[own.edges[i]] = i;
  for (Index i = 0; i < own.particles.size(); ++i) local_particle_[own.particles[i]] = i;
  const auto need_edge = [&](Index e) {
    if (local_edge_[e] != kNone) return;
    local_edge_[e] = static_cast<Index>(own.edges.size());
    own.edges.push_back(e);
  };
  const auto need = [&](Index p) {
    if (local_particle_[p] != kNone) return;
    local_particle_[p] = static_cast<Index>(own.particles.size());
    own.particles.push_back(p);
  };
  for (const Index j : own.joints) {
    need_edge(system_->joints[j].e);
    need_edge(system_->joints[j].f);
    for (const Index p : system_->joints[j].p) need(p);
  }
  for (const Index e : own.edges) {
    need(system_->edges[e].a);
    need(system_->edges[e].b);
  }
  for (const Index l : own.lengths) {
    need(system_->lengths[l].a);
    need(system_->lengths[l].b);
  }
  for (const Index i : contacts) {
    for (std::size_t c = 0; c < stage.contacts[i].corners; ++c) need(stage.contacts[i].particles[c]);
  }
  return own;
}

NewtonResult Islands::minimise_part(const Part& part, bool with_loose, const std::vector<Index>& contacts,
                                    const Begin& begin, VectorX& q, Frames& frames) {
  const Stage& stage = *begin.stage;
  const SystemPart own = members_of(part, with_loose, contacts, stage);
  const System system = system_->part(own, local_particle_, local_edge_);
  Stage own_stage;
  own_stage.base = gathered(stage.base, own, *system_);
  own_stage.base_velocity = gathered(stage.base_velocity, own, *system_);
  own_stage.span = stage.span;
  own_stage.time = stage.time;
  own_stage.tolerance = stage.tolerance;
  own_stage.strains.stiffness = gathered_strains(stage.strains.stiffness, own, *system_);
  own_stage.strains.rest = gathered_strains(stage.strains.rest, own, *system_);
  std::vector<ContactTerm> terms;
  terms.reserve(contacts.size());
  for (const Index i : contacts) {
    terms.push_back(stage.contacts[i]);
    ContactTerm& term = terms.back();
    for (std::size_t c = 0; c < term.corners; ++c) term.particles[c] = local_particle_[term.particles[c]];
  }
  own_stage.contacts = terms;
  for (const Index p : own.particles) local_particle_[p] = kNone;
  for (const Index e : own.edges) local_edge_[e] = kNone;

  VectorX own_q = gathered(*begin.q, own, *system_);
  Frames own_frames;
  for (const Index e : own.edges) own_frames.director.push_back(begin.frames->director[e]);
  for (const Index j : own.joints) own_frames.reference_twist.push_back(begin.frames->reference_twist[j]);
  NewtonResult result;
  {
    Newton newton(system, settings_, patterns_);
    result = newton.minimise(own_stage, gathered(*begin.guess, own, *system_), own_q, own_frames);
  }
  if (!result.converged) {
    result.mover.coordinate = coordinate_of(own, result.mover.coordinate, *system_);
    return result;
  }
  Eigen::Index at = 0;
  for (const Index p : own.particles) {
    q.segment<3>(3 * static_cast<Eigen::Index>(p)) = own_q.segment<3>(at);
    at += 3;
  }
  for (const Index e : own.edges) q[system_->angle(e)] = own_q[at++];
  for (std::size_t i = 0; i < own.edges.size(); ++i) frames.director[own.edges[i]] = own_frames.director[i];
  for (std::size_t i = 0; i < own.joints.size(); ++i) {
    frames.reference_twist[own.joints[i]] = own_frames.reference_twist[i];
  }
  return result;
}

NewtonResult Islands::minimise(const Stage& stage, const VectorX& guess, VectorX& q, Frames& frames) {
  std::vector<Index> part_of;
  const std::vector<Part> parts = parts_of(stage.contacts, part_of);
  if (parts.size() < 2) {
    if (whole_ == nullptr) whole_ = std::make_unique<Newton>(*system_, settings_, patterns_);
    return whole_->minimise(stage, guess, q, frames);
  }
  std::vector<std::vector<Index>> contacts(parts.size());
  for (Index i = 0; i < stage.contacts.size(); ++i) {
    const ContactTerm& term = stage.contacts[i];
    for (std::size_t c = 0; c < term.corners; ++c) {
      const Index component = components_.of_particle[term.particles[c]];
      if (component == kNone) continue;
      contacts[part_of[component]].push_back(i);
      break;
    }
  }
  // Parts share what is held: each begins where it was, whatever the others have written.
  const VectorX q_before = q;
  const Frames frames_before = frames;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (system_->fixed[static_cast<std::size_t>(i)]) q[i] = guess[i];
  }
  NewtonResult all;
  all.converged = true;
  for (Index p = 0; p < parts.size(); ++p) {
    const Begin begin{&stage, &guess, &q_before, &frames_before};
    const NewtonResult own = minimise_part(parts[p], p == 0, contacts[p], begin, q, frames);
    all.iterations = std::max(all.iterations, own.iterations);
    all.convex = std::max(all.convex, own.convex);
    all.last_step = std::max(all.last_step, own.last_step);
    if (own.converged) continue;
    all.converged = false;
    all.mover = own.mover;
    return all;
  }
  return all;
}

}  // namespace touchstone::sim
