// SPDX-License-Identifier: MIT
#include "fuzz/bodies/judge_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>
#include <limits>
#include <map>

#include <touchstone/contact_times.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "fuzz/scenes/judge_reply.hpp"

namespace touchstone::fuzz {
namespace {

using families::BodyScene;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The pairs that first come into contact, of those that are not at the start.
std::vector<BodyContact> exact_first(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                     const std::vector<BodyContact>& contacts) {
  double toi = kNever;
  for (const BodyContact& one : contacts) {
    if (!one.answer.starts_within) toi = std::min(toi, one.answer.toi);
  }
  std::vector<BodyContact> first;
  std::optional<ExactTime> least;
  for (const BodyContact& one : contacts) {
    if (one.answer.starts_within || one.answer.toi != toi) continue;
    const ExactTime time = contact_times(query_of(bodies, one.pair, motions), one.separation).front().first;
    if (least && *least < time) continue;
    if (least && time < *least) first.clear();
    least = time;
    first.push_back(one);
  }
  return first;
}

bool same_answers(const Answer& a, const Answer& b) {
  return a.toi == b.toi && a.toi_upper == b.toi_upper && a.nature == b.nature && a.starts_within == b.starts_within &&
         a.feature_a == b.feature_a && a.feature_b == b.feature_b;
}

/// The first difference of lists in any order. @param question  in which they were told
std::optional<SceneFailure> difference_of_lists(const Bodies& bodies, const std::vector<BodyContact>& told,
                                                const std::vector<BodyContact>& exact, const char* question) {
  std::map<BodyPair, Answer> answers;
  for (const BodyContact& one : told) {
    if (!answers.emplace(one.pair, one.answer).second) {
      return SceneFailure{FuzzFailure::malformed, question, describe(bodies, one.pair) + " twice"};
    }
  }
  for (const BodyContact& one : exact) {
    const auto found = answers.find(one.pair);
    const std::string pair = describe(bodies, one.pair) + at_time(one.answer.toi);
    if (found == answers.end()) return SceneFailure{FuzzFailure::missed, question, pair};
    if (!same_answers(found->second, one.answer)) {
      return SceneFailure{found->second.toi > one.answer.toi ? FuzzFailure::late : FuzzFailure::differs, question,
                          pair + ", told" + at_time(found->second.toi)};
    }
    answers.erase(found);
  }
  if (answers.empty()) return std::nullopt;
  const auto& [pair, answer] = *answers.begin();
  return SceneFailure{FuzzFailure::phantom, question, describe(bodies, pair) + at_time(answer.toi)};
}

bool is_closed(const Mesh& mesh) {
  std::map<std::array<MeshIndex, 2>, int> sides;
  for (const auto& face : mesh.faces()) {
    for (std::size_t c = 0; c < 3; ++c) ++sides[{face[c], face[(c + 1) % 3]}];
  }
  return !sides.empty() && std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
    const auto& [corners, times] = side;
    const auto back = sides.find({corners[1], corners[0]});
    return times == 1 && back != sides.end() && back->second == 1;
  });
}

/// Whether a body's vertex is inside another body's closed surface at the start; nothing where the rays that were tried
/// meet a border of a face.
std::optional<bool> inside(const Bodies& bodies, const std::vector<RigidMotion>& motions, const BodyElement& vertex,
                           BodyIndex other) {
  static constexpr std::array<Vec3, 3> kRays = {
      {{0.577, 0.211, 0.789}, {-0.331, 0.877, 0.347}, {0.123, -0.719, 0.684}}};
  std::vector<RigidMotion> ray = motions;
  for (RigidMotion& motion : ray) motion.q1 = motion.q0, motion.p1 = motion.p0;
  RigidMotion& moving = ray[vertex.body];
  double size = 0;
  for (const BodyIndex b : {vertex.body, other}) {
    for (const Vec3& p : bodies.bodies[b].points()) size += std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
    size += std::fabs(motions[b].p0.x) + std::fabs(motions[b].p0.y) + std::fabs(motions[b].p0.z);
  }
  for (const Vec3& direction : kRays) {
    const Vec3& from = moving.p0;
    moving.p1 = {from.x + 4 * size * direction.x, from.y + 4 * size * direction.y, from.z + 4 * size * direction.z};
    bool clear = true, odd = false;
    const auto faces = static_cast<MeshIndex>(bodies.bodies[other].mesh().faces().size());
    for (MeshIndex face = 0; face < faces && clear; ++face) {
      SolveOptions options;
      options.method = Method::exact;
      const Answer met = solve(query_of(bodies, {Kind::vertex_face, vertex, {other, face}}, ray), options);
      if (!met.contact) continue;
      clear = met.feature_b == Feature::f && met.nature == Nature::crossing && !met.starts_within;
      odd = !odd;
    }
    if (clear) return odd;
  }
  return std::nullopt;
}

std::string name_of_body(BodyIndex body) { return std::string("body ").append(std::to_string(body)); }

/// The start: vertices inside closed surfaces are told, and no others.
std::optional<SceneFailure> judge_start(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                        const FirstBodyContact& told) {
  if (!told.start_checked) return SceneFailure{FuzzFailure::malformed, "start", "it was not asked about"};
  for (const BodyIntersection& one : told.start_intersections) {
    if (one.sort != IntersectionSort::inside || !is_closed(bodies.bodies[one.second.body].mesh())) continue;
    if (inside(bodies, motions, one.first, one.second.body).value_or(true)) continue;
    return SceneFailure{FuzzFailure::phantom, "start",
                        name_of_body(one.first.body).append(", not inside ").append(name_of_body(one.second.body))};
  }
  if (!told.start_intersections.empty()) return std::nullopt;
  for (BodyIndex a = 0; a < motions.size(); ++a) {
    for (BodyIndex b = 0; b < motions.size(); ++b) {
      // One vertex tells: bodies that do not intersect are inside as a whole, if their surface is one.
      if (a == b || !is_closed(bodies.bodies[a].mesh()) || !is_closed(bodies.bodies[b].mesh())) continue;
      if (!bodies.rules.body_pairs.empty() || !inside(bodies, motions, {a, 0}, b).value_or(false)) continue;
      return SceneFailure{FuzzFailure::missed, "start", name_of_body(a).append(" is inside ").append(name_of_body(b))};
    }
  }
  return std::nullopt;
}

/// The free step ends before the contact, and its own end is reached free.
std::optional<SceneFailure> judge_step(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                       const FirstBodyContact& first, const FreeBodyStep& step) {
  const auto wrong = [](FuzzFailure failure, const std::string& detail) {
    return SceneFailure{failure, "free step", detail};
  };
  if (step.poses.size() != motions.size()) return wrong(FuzzFailure::malformed, "another number of poses");
  const bool starts_free = first.at_start.empty() && first.start_intersections.empty();
  if ((step.outcome == StepOutcome::whole) != (starts_free && !first.contact)) {
    return wrong(FuzzFailure::differs, "the outcome is not that of the first contact");
  }
  if (step.outcome == StepOutcome::whole) return std::nullopt;
  if (!(step.length >= 0 && step.length < 1)) return wrong(FuzzFailure::malformed, "the length is outside of the step");
  if (step.outcome != StepOutcome::shortened) return std::nullopt;
  std::vector<RigidMotion> path;
  for (std::size_t b = 0; b < motions.size(); ++b) {
    path.push_back(motion_between({motions[b].q0, motions[b].p0}, step.poses[b], Turn::as_given));
  }
  const std::vector<BodyContact> met = exact_contacts(bodies, path);
  if (met.empty()) return std::nullopt;
  return wrong(FuzzFailure::missed, describe(bodies, met.front().pair) + " on the way to its end");
}

}  // namespace

std::vector<BodyContact> exact_contacts(const Bodies& bodies, const std::vector<RigidMotion>& motions) {
  std::vector<BodyContact> contacts;
  for (const BodyPair& pair : families::every_pair(bodies)) {
    const Separation separation = separation_of(bodies, pair);
    SolveOptions options;
    options.separation = separation;
    options.method = Method::exact;
    const Answer answer = solve(query_of(bodies, pair, motions), options);
    if (answer.contact) contacts.push_back({pair, separation, answer});
  }
  return contacts;
}

BodyReply library_body_reply(const Bodies& bodies, const std::vector<RigidMotion>& motions) {
  return {first_contact(bodies, motions), all_contacts(bodies, motions), candidates(bodies, motions),
          free_step(bodies, motions)};
}

std::optional<SceneFailure> judge_bodies(const BodyScene& scene, const BodySolver& solver) {
  const Bodies bodies = scene.bodies();
  const std::vector<RigidMotion>& motions = scene.motions;
  const std::vector<BodyContact> exact = exact_contacts(bodies, motions);
  BodyReply reply;
  try {
    reply = solver(bodies, motions);
  } catch (const std::exception& error) {
    return SceneFailure{FuzzFailure::crash, "all", error.what()};
  }
  for (const BodyContact& one : exact) {
    if (std::binary_search(reply.candidates.begin(), reply.candidates.end(), one.pair)) continue;
    return SceneFailure{FuzzFailure::missed, "candidates", describe(bodies, one.pair) + at_time(one.answer.toi)};
  }
  if (auto wrong = difference_of_lists(bodies, reply.all, exact, "all contacts")) return wrong;
  std::vector<BodyContact> starting;
  std::copy_if(exact.begin(), exact.end(), std::back_inserter(starting),
               [](const BodyContact& one) { return one.answer.starts_within; });
  if (auto wrong = difference_of_lists(bodies, reply.first.at_start, starting, "first contact")) return wrong;
  const std::vector<BodyContact> first = exact_first(bodies, motions, exact);
  if (auto wrong = difference_of_lists(bodies, reply.first.earliest, first, "first contact")) return wrong;
  const double toi = first.empty() ? kNever : first.front().answer.toi;
  if (reply.first.contact == first.empty() || reply.first.toi != toi) {
    return SceneFailure{FuzzFailure::differs, "first contact",
                        std::string("told").append(at_time(reply.first.toi)).append(", exact").append(at_time(toi))};
  }
  if (auto wrong = judge_start(bodies, motions, reply.first)) return wrong;
  return judge_step(bodies, motions, reply.first, reply.step);
}

}  // namespace touchstone::fuzz
