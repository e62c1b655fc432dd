// SPDX-License-Identifier: MIT
#include "dynamics/islands.hpp"

#include <algorithm>
#include <utility>

#include "geometry/union_find.hpp"

namespace touchstone::sim {
namespace {

// Unknowns: smaller islands are solved together, as each solve has a cost beside its size.
constexpr Index kLeastUnknowns = 1000;

VectorX gathered(const VectorX& v, const SystemSubset& subset, const System& system) {
  VectorX own(static_cast<Eigen::Index>(3 * subset.particles.size() + subset.edges.size()));
  Eigen::Index at = 0;
  for (const Index p : subset.particles) {
    own.segment<3>(at) = position(v, p);
    at += 3;
  }
  for (const Index e : subset.edges) own[at++] = v[system.angle(e)];
  return own;
}

VectorX gathered_strains(const VectorX& v, const SystemSubset& subset, const System& system) {
  VectorX own(static_cast<Eigen::Index>(subset.stretch_elements.size() + 3 * subset.joints.size() +
                                        3 * subset.membranes.size() + subset.hinges.size()));
  Eigen::Index at = 0;
  for (const Index l : subset.stretch_elements) own[at++] = v[static_cast<Eigen::Index>(l)];
  for (const Index j : subset.joints) {
    own.segment<3>(at) = v.segment<3>(static_cast<Eigen::Index>(system.joint_row(j)));
    at += 3;
  }
  for (const Index m : subset.membranes) {
    own.segment<3>(at) = v.segment<3>(static_cast<Eigen::Index>(system.membrane_row(m)));
    at += 3;
  }
  for (const Index h : subset.hinges) own[at++] = v[static_cast<Eigen::Index>(system.hinge_row(h))];
  return own;
}

/// The coordinate of the whole system for one of the subset's; -1 stays.
Eigen::Index coordinate_of(const SystemSubset& subset, Eigen::Index own, const System& system) {
  if (own < 0) return own;
  const auto particle = static_cast<std::size_t>(own) / 3;
  if (particle < subset.particles.size()) return 3 * static_cast<Eigen::Index>(subset.particles[particle]) + own % 3;
  return system.angle(subset.edges[static_cast<std::size_t>(own) - 3 * subset.particles.size()]);
}

}  // namespace

Islands::Islands(const System& system, const Settings& settings, const linear::Cancellation& cancel)
    : system_(&system), settings_(settings), cancel_(&cancel), components_(system) {
  local_particle_.assign(system.particle_count(), kNone);
  local_edge_.assign(system.edges.size(), kNone);
}

std::vector<Islands::Island> Islands::islands_of(std::span<const ContactTerm> contacts,
                                                 std::vector<Index>& island_of) const {
  geometry::UnionFind tied(components_.unknowns.size());
  for (const ContactTerm& term : contacts) {
    Index before = kNone;
    for (std::size_t c = 0; c < term.corners; ++c) {
      const Index own = components_.of_particle[term.particles[c]];
      if (own == kNone) continue;
      if (before != kNone) tied.join(before, own);
      before = own;
    }
  }
  island_of.assign(components_.unknowns.size(), kNone);
  std::vector<Index> tied_unknowns(components_.unknowns.size(), 0);
  for (Index c = 0; c < components_.unknowns.size(); ++c) tied_unknowns[tied.root(c)] += components_.unknowns[c];
  std::vector<Island> islands;
  Index open = kNone, in_open = 0;  // an island that small ones still join
  for (Index c = 0; c < components_.unknowns.size(); ++c) {
    const Index root = tied.root(c);
    if (root == c) {
      const bool small = tied_unknowns[c] < kLeastUnknowns;
      if (!small || open == kNone) {
        islands.emplace_back();
        island_of[c] = static_cast<Index>(islands.size() - 1);
        if (small) {
          open = island_of[c];
          in_open = 0;
        }
      } else {
        island_of[c] = open;
      }
      if (small && (in_open += tied_unknowns[c]) >= kLeastUnknowns) open = kNone;
    }
    island_of[c] = island_of[root];
    islands[island_of[c]].push_back(c);
  }
  return islands;
}

SystemSubset Islands::members_of(const Island& island, bool with_loose, const std::vector<Index>& contacts,
                                 const Stage& stage) {
  SystemSubset own;
  for (const Index c : island) {
    components_.particles.append(c, own.particles);
    components_.edges.append(c, own.edges);
    components_.stretch_elements.append(c, own.stretch_elements);
    components_.joints.append(c, own.joints);
    components_.membranes.append(c, own.membranes);
    components_.hinges.append(c, own.hinges);
  }
  if (with_loose) own.edges.insert(own.edges.end(), components_.loose_edges.begin(), components_.loose_edges.end());
  // Held particles and edges come along with the elements that lean on them.
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
  for (const Index l : own.stretch_elements) {
    need(system_->stretch_elements[l].a);
    need(system_->stretch_elements[l].b);
  }
  for (const Index m : own.membranes) {
    for (const Index p : system_->cloth.membranes[m].p) need(p);
  }
  for (const Index h : own.hinges) {
    for (const Index p : system_->cloth.hinges[h].p) need(p);
  }
  for (const Index i : contacts) {
    for (std::size_t c = 0; c < stage.contacts[i].corners; ++c) need(stage.contacts[i].particles[c]);
  }
  return own;
}

NewtonResult Islands::minimise_island(const Island& island, bool with_loose, const std::vector<Index>& contacts,
                                      const Begin& begin, VectorX& q, Frames& frames) {
  const Stage& stage = *begin.stage;
  const SystemSubset own = members_of(island, with_loose, contacts, stage);
  const System system = system_->subset(own, local_particle_, local_edge_);
  Stage own_stage;
  own_stage.base = gathered(stage.base, own, *system_);
  own_stage.base_velocity = gathered(stage.base_velocity, own, *system_);
  own_stage.span = stage.span;
  own_stage.time = stage.time;
  own_stage.tolerance = stage.tolerance;
  own_stage.strains.stiffness = gathered_strains(stage.strains.stiffness, own, *system_);
  own_stage.strains.with_limits = stage.strains.with_limits;
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
    Newton newton(system, settings_, patterns_, *cancel_);
    result = newton.minimise(own_stage, gathered(*begin.guess, own, *system_), own_q, own_frames);
  }
  if (!result.converged) {
    result.largest_change.coordinate = coordinate_of(own, result.largest_change.coordinate, *system_);
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
  std::vector<Index> island_of;
  const std::vector<Island> islands = islands_of(stage.contacts, island_of);
  if (islands.size() < 2) {
    if (whole_ == nullptr) whole_ = std::make_unique<Newton>(*system_, settings_, patterns_, *cancel_);
    return whole_->minimise(stage, guess, q, frames);
  }
  std::vector<std::vector<Index>> contacts(islands.size());
  for (Index i = 0; i < stage.contacts.size(); ++i) {
    const ContactTerm& term = stage.contacts[i];
    for (std::size_t c = 0; c < term.corners; ++c) {
      const Index component = components_.of_particle[term.particles[c]];
      if (component == kNone) continue;
      contacts[island_of[component]].push_back(i);
      break;
    }
  }
  // Islands share held particles. Each island begins at the state before, whatever the others have written.
  const VectorX q_before = q;
  const Frames frames_before = frames;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (system_->fixed[static_cast<std::size_t>(i)]) q[i] = guess[i];
  }
  NewtonResult all;
  all.converged = true;
  for (Index p = 0; p < islands.size(); ++p) {
    const Begin begin{&stage, &guess, &q_before, &frames_before};
    const NewtonResult own = minimise_island(islands[p], p == 0, contacts[p], begin, q, frames);
    all.iterations = std::max(all.iterations, own.iterations);
    all.projected = std::max(all.projected, own.projected);
    all.last_step = std::max(all.last_step, own.last_step);
    if (own.converged) continue;
    all.converged = false;
    all.largest_change = own.largest_change;
    return all;
  }
  return all;
}

}  // namespace touchstone::sim
