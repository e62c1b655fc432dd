// What pickles of bodies and of their results are made of.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "python/pickles.hpp"
#include "python/rigid/rigid_results.hpp"

namespace touchstone::python {

/// What a Body is made of.
struct BodyRecord {
  MeshElements elements;
  std::vector<Vec3> points;
};

/// What Bodies are made of. Bodies that are copies of one are written once.
struct BodiesRecord {
  std::vector<BodyRecord> bodies;
  std::vector<std::uint32_t> which;  ///< of `bodies`, for each body
  BodyRules rules;
  Separation separation;
};

template <class Archive>
void members(Archive& archive, BodyRecord& x) {
  archive(x.elements, x.points);
}
template <class Archive>
void members(Archive& archive, BodyRules& x) {
  archive(x.body_pairs, x.groups, x.group_rule, x.group_pairs);
}
template <class Archive>
void members(Archive& archive, BodiesRecord& x) {
  archive(x.bodies, x.which, x.rules, x.separation);
}
template <class Archive>
void members(Archive& archive, BodyElement& x) {
  archive(x.body, x.element);
}
template <class Archive>
void members(Archive& archive, BodyPair& x) {
  archive(x.kind, x.first, x.second);
}
template <class Archive>
void members(Archive& archive, BodyContact& x) {
  archive(x.pair, x.separation, x.answer);
}
template <class Archive>
void members(Archive& archive, BodyIntersection& x) {
  archive(x.first_element, x.first, x.second_element, x.second, x.sort);
}
template <class Archive>
void members(Archive& archive, BodiesLeftOut& x) {
  archive(x.in_open, x.cancelled, x.excluded);
}
template <class Archive>
void members(Archive& archive, FirstBodyContact& x) {
  archive(x.contact, x.toi, x.toi_upper, x.earliest, x.at_start, x.start_checked, x.start_intersections,
          static_cast<BodiesLeftOut&>(x));
}
template <class Archive>
void members(Archive& archive, ScrewAnswer& x) {
  archive(x.verdict, x.free_until, x.contact_by, x.deviation, x.arcs);
}
template <class Archive>
void members(Archive& archive, BodyScrewContact& x) {
  archive(x.pair, x.answer);
}
template <class Archive>
void members(Archive& archive, BodyScrewAnswer& x) {
  archive(x.verdict, x.free_until, x.contact_by, x.pairs, x.start_checked, x.start_intersections,
          static_cast<BodiesLeftOut&>(x));
}
template <class Archive>
void members(Archive& archive, LeftOut& x) {
  archive(x.excluded, x.turned);
}
template <class Archive>
void members(Archive& archive, BodyPairs& x) {
  archive(x.pairs, x.separations, x.answers, x.left_out);
}
template <class Archive>
void members(Archive& archive, BodyIntersections& x) {
  archive(x.all, x.left_out);
}
template <class Archive>
void members(Archive& archive, FoundBodyContact& x) {
  archive(x.found, x.turned, x.t_max);
}
template <class Archive>
void members(Archive& archive, FoundBodyScrew& x) {
  archive(x.found, x.turned, x.t_max);
}
template <class Archive>
void members(Archive& archive, FoundBodyStep& x) {
  archive(x.outcome, x.length, x.poses, x.first_contact, x.proofs);
}

template <class Archive>
void members(Archive& archive, FoundBodyDistance& x) {
  archive(x.found.distance, x.found.pairs, x.found.intersections, static_cast<BodiesLeftOut&>(x.found));
}

}  // namespace touchstone::python
