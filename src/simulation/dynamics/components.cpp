// SPDX-License-Identifier: MIT
#include "dynamics/components.hpp"

#include <algorithm>
#include <initializer_list>
#include <numeric>

#include "geometry/union_find.hpp"

namespace touchstone::sim {
namespace {

bool is_free(const System& system, Index particle) {
  const auto* const fixed = system.fixed.data() + 3 * static_cast<std::size_t>(particle);
  return !fixed[0] || !fixed[1] || !fixed[2];
}

}  // namespace

template <class Component>
void Members::sort(std::size_t components, std::size_t count, Component component_of) {
  first.assign(components + 1, 0);
  for (Index i = 0; i < count; ++i) {
    if (const Index c = component_of(i); c != kNone) ++first[c + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  all.resize(first.back());
  std::vector<Index> next(first.begin(), first.end() - 1);
  for (Index i = 0; i < count; ++i) {
    if (const Index c = component_of(i); c != kNone) all[next[c]++] = i;
  }
}

void Members::append(Index component, std::vector<Index>& to) const {
  to.insert(to.end(), all.begin() + first[component], all.begin() + first[component + 1]);
}

Components::Components(const System& system) {
  // An angle goes with its edge. A free angle whose edge has held ends is a node of its own.
  const auto count = static_cast<Index>(system.particle_count());
  geometry::UnionFind tied(system.particle_count() + system.edges.size());
  const auto node_of_edge = [&](Index e) {
    if (is_free(system, system.edges[e].a)) return system.edges[e].a;
    if (is_free(system, system.edges[e].b)) return system.edges[e].b;
    return system.fixed[static_cast<std::size_t>(system.angle(e))] ? kNone : count + e;
  };
  const auto join_all = [&](std::initializer_list<Index> nodes) {
    Index before = kNone;
    for (const Index node : nodes) {
      if (node == kNone || (node < count && !is_free(system, node))) continue;
      if (before != kNone) tied.join(before, node);
      before = node;
    }
    return before;
  };
  for (const StretchElement& length : system.stretch_elements) join_all({length.a, length.b});
  for (const RodEdge& edge : system.edges) join_all({edge.a, edge.b});
  for (const Membrane& membrane : system.cloth.membranes) join_all({membrane.p[0], membrane.p[1], membrane.p[2]});
  for (const Hinge& hinge : system.cloth.hinges) join_all({hinge.p[0], hinge.p[1], hinge.p[2], hinge.p[3]});
  for (const Joint& joint : system.joints)
    join_all({joint.p[0], joint.p[1], joint.p[2], node_of_edge(joint.e), node_of_edge(joint.f)});

  std::vector<Index> component_of_root(system.particle_count() + system.edges.size(), kNone);
  std::size_t components = 0;
  const auto component = [&](Index node) {
    if (node == kNone || (node < count && !is_free(system, node))) return kNone;
    Index& known = component_of_root[tied.root(node)];
    if (known == kNone) known = static_cast<Index>(components++);
    return known;
  };
  of_particle.resize(count);
  for (Index p = 0; p < count; ++p) of_particle[p] = component(p);
  std::vector<Index> of_edge(system.edges.size());
  for (Index e = 0; e < of_edge.size(); ++e) {
    of_edge[e] = component(node_of_edge(e));
    if (of_edge[e] == kNone) loose_edges.push_back(e);
  }
  const auto first_known = [](std::initializer_list<Index> all) {
    for (const Index c : all) {
      if (c != kNone) return c;
    }
    return kNone;
  };
  particles.sort(components, count, [&](Index p) { return of_particle[p]; });
  edges.sort(components, of_edge.size(), [&](Index e) { return of_edge[e]; });
  stretch_elements.sort(components, system.stretch_elements.size(), [&](Index l) {
    return first_known({of_particle[system.stretch_elements[l].a], of_particle[system.stretch_elements[l].b]});
  });
  joints.sort(components, system.joints.size(), [&](Index j) {
    const Joint& joint = system.joints[j];
    return first_known({of_particle[joint.p[0]], of_particle[joint.p[1]], of_particle[joint.p[2]], of_edge[joint.e],
                        of_edge[joint.f]});
  });
  const auto sort_cloth = [&](const auto& elements, Members& members) {
    members.sort(components, elements.size(), [&](Index i) {
      const auto& p = elements[i].p;
      const auto free =
          std::find_if(p.begin(), p.end(), [&](Index particle) { return of_particle[particle] != kNone; });
      return free == p.end() ? kNone : of_particle[*free];
    });
  };
  sort_cloth(system.cloth.membranes, membranes);
  sort_cloth(system.cloth.hinges, hinges);
  unknowns.assign(components, 0);
  for (std::size_t c = 0; c < components; ++c) {
    unknowns[c] = 3 * (particles.first[c + 1] - particles.first[c]);
    for (Index e = edges.first[c]; e < edges.first[c + 1]; ++e) unknowns[c] += system.edges[edges.all[e]].twists;
  }
}

}  // namespace touchstone::sim
