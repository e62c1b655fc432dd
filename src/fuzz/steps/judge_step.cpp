// SPDX-License-Identifier: MIT
#include "fuzz/steps/judge_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "geometry/kind_traits.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::fuzz {
namespace {

using families::StepScene;

struct ExactStep {
  std::vector<MeshContact> contacts;  ///< of all pairs
  const MeshContact* first = nullptr;

  /// Whether the first contact is at this time or before it.
  bool begins_by(double time) const { return first != nullptr && first->answer.toi_upper <= time; }
};

/// The least and the greatest coordinates of an element in the step, along each axis.
using StepBox = std::array<std::array<double, 2>, 3>;

template <std::size_t N>
StepBox box_in_step(const std::array<MeshIndex, N>& corners, const StepScene& scene) {
  StepBox box;
  box.fill({std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
  for (const MeshIndex v : corners) {
    for (const Vec3& at : {scene.x0[v], scene.x1[v]}) {
      const std::array<double, 3> coordinates = {at.x, at.y, at.z};
      for (std::size_t k = 0; k < 3; ++k) {
        box[k] = {std::min(box[k][0], coordinates[k]), std::max(box[k][1], coordinates[k])};
      }
    }
  }
  return box;
}

struct StepBoxes {
  std::vector<StepBox> vertices, edges, faces;

  StepBoxes(const Mesh& mesh, const StepScene& scene) {
    for (MeshIndex v = 0; v < mesh.vertex_count(); ++v) vertices.push_back(box_in_step(std::array{v}, scene));
    for (const auto& edge : mesh.edges()) edges.push_back(box_in_step(edge, scene));
    for (const auto& face : mesh.faces()) faces.push_back(box_in_step(face, scene));
  }

  const StepBox& of(MeshElement sort, MeshIndex number) const {
    return (sort == MeshElement::face ? faces : sort == MeshElement::edge ? edges : vertices)[number];
  }
};

/// Whether two boxes are farther apart than this along an axis. If the difference of two doubles is rounded, it is so
/// by 2^-53 of itself, and the factor leaves more room than that.
bool are_apart(const StepBox& a, const StepBox& b, double distance) {
  const double room = distance * (1 + 0x1p-40);
  for (std::size_t k = 0; k < 3; ++k) {
    if (b[k][0] - a[k][1] > room || a[k][0] - b[k][1] > room) return true;
  }
  return false;
}

ExactStep exact_step(const Mesh& mesh, const StepScene& scene) {
  const Positions x0(scene.x0), x1(scene.x1);
  const StepBoxes boxes(mesh, scene);
  const double distance = scene.elements.separation.distance;
  const auto may_meet = [&](const MeshPair& pair) {
    const auto& [first, second] = geometry::traits_of(pair.kind);
    return !are_apart(boxes.of(first.sort, pair.first), boxes.of(second.sort, pair.second), distance);
  };
  ExactStep exact;
  SolveOptions options;
  options.method = Method::exact;
  for (const MeshPair& pair : families::every_pair(mesh, may_meet)) {
    options.separation = mesh.separation(pair);
    const Answer answer = solve(query_of(mesh, pair, x0, x1), options);
    if (answer.contact) exact.contacts.push_back({pair, options.separation, answer});
  }
  for (const MeshContact& one : exact.contacts) {
    const auto times = [](const Answer& answer) { return std::pair(answer.toi, answer.toi_upper); };
    if (exact.first == nullptr || times(one.answer) < times(exact.first->answer)) exact.first = &one;
  }
  return exact;
}

std::string at_that_time(double time) { return std::string(" at ").append(numbers::decimal_text(time)); }

/// "vertex 5 and face 2 (0-1-9) at 0.25"; "... between 0.3 and the next double".
std::string contact_text(const Mesh& mesh, const MeshContact& contact) {
  const auto& [toi, toi_upper] = std::pair(contact.answer.toi, contact.answer.toi_upper);
  if (toi == toi_upper) return mesh.describe(contact.pair) + at_that_time(toi);
  return mesh.describe(contact.pair) + " between " + numbers::decimal_text(toi) + " and the next double";
}

bool is_fraction(double x) { return x >= 0 && x <= 1; }

class StepJudge {
 public:
  StepJudge(const Mesh& mesh, const ExactStep& exact, const StepFuzzOptions& options)
      : mesh_(mesh), exact_(exact), options_(options) {}

  std::optional<SceneFailure> judge(const StepReply& reply) const {
    if (reply.candidates) {
      if (auto wrong = judge_candidates(*reply.candidates)) return wrong;
    }
    if (reply.free) {
      if (auto wrong = judge_free(*reply.free)) return wrong;
    }
    return reply.first_contact ? judge_first(*reply.first_contact) : std::nullopt;
  }

 private:
  std::optional<SceneFailure> judge_candidates(std::vector<MeshPair> told) const {
    for (MeshPair& pair : told) {
      if (!has_pair(mesh_, pair.kind, pair.first, pair.second)) {
        return SceneFailure{FuzzFailure::malformed, "candidates",
                            std::string(name_of(pair.kind)) + " " + std::to_string(pair.first) + " " +
                                std::to_string(pair.second) + " names an element that the mesh has not"};
      }
      pair = with_ascending(pair);
    }
    std::sort(told.begin(), told.end());
    for (const MeshContact& one : exact_.contacts) {
      if (std::binary_search(told.begin(), told.end(), one.pair)) continue;
      return SceneFailure{FuzzFailure::missed, "candidates", contact_text(mesh_, one) + " is not among them"};
    }
    return std::nullopt;
  }

  std::optional<SceneFailure> judge_free(double free) const {
    const auto wrong = [&](FuzzFailure failure, const std::string& what) {
      return SceneFailure{failure, "free", "a step of " + numbers::decimal_text(free) + what};
    };
    if (!is_fraction(free)) return wrong(FuzzFailure::malformed, ", which is not from 0 to 1");
    const MeshContact* const first = exact_.first;
    if (exact_.begins_by(free)) {
      const bool ends_there = first->answer.toi == free && first->answer.toi_upper == free;
      if (!(ends_there && (options_.may_end_in_contact || free == 0))) {
        return wrong(free == 1 ? FuzzFailure::missed : FuzzFailure::late,
                     (ends_there ? " ends in the first contact: " : " is longer than the way to the first contact: ") +
                         contact_text(mesh_, *first));
      }
    }
    const double room = first == nullptr ? 1 : first->answer.toi;
    const std::string text = first == nullptr ? ", and no contact" : ", and " + contact_text(mesh_, *first);
    if (free < options_.stall * room) return wrong(FuzzFailure::early, text + ": a stall");
    // The double before a contact is the longest step.
    if (options_.early_fraction && room - free > *options_.early_fraction && free < std::nextafter(room, 0))
      return wrong(FuzzFailure::early, text);
    return std::nullopt;
  }

  std::optional<SceneFailure> judge_first(double told) const {
    const auto wrong = [&](FuzzFailure failure, const std::string& what) {
      return SceneFailure{failure, "first contact", what};
    };
    const bool denies = told == std::numeric_limits<double>::infinity();
    const MeshContact* const first = exact_.first;
    const std::string text = "told" + at_that_time(told) + ", and exactly ";
    if (!denies && !is_fraction(told)) return wrong(FuzzFailure::malformed, "told" + at_that_time(told));
    if (denies && first != nullptr) return wrong(FuzzFailure::missed, contact_text(mesh_, *first));
    if (!denies && first == nullptr) return wrong(FuzzFailure::phantom, text + "none");
    if (denies) return std::nullopt;
    if (told - first->answer.toi > options_.late_fraction)
      return wrong(FuzzFailure::late, text + contact_text(mesh_, *first));
    if (options_.early_fraction && first->answer.toi - told > *options_.early_fraction)
      return wrong(FuzzFailure::early, text + contact_text(mesh_, *first));
    return std::nullopt;
  }

  const Mesh& mesh_;
  const ExactStep& exact_;
  const StepFuzzOptions& options_;
};

}  // namespace

MeshPair with_ascending(const MeshPair& pair) noexcept {
  const bool of_one_sort = pair.kind == Kind::edge_edge || pair.kind == Kind::point_point;
  if (!of_one_sort || pair.first <= pair.second) return pair;
  return {pair.kind, pair.second, pair.first};
}

bool has_pair(const Mesh& mesh, Kind kind, std::uint64_t first, std::uint64_t second) {
  const auto has = [&mesh](MeshElement sort, std::uint64_t number) {
    return number < (sort == MeshElement::face   ? mesh.faces().size()
                     : sort == MeshElement::edge ? mesh.edges().size()
                                                 : mesh.vertex_count());
  };
  const auto& [one, other] = geometry::traits_of(kind);
  return has(one.sort, first) && has(other.sort, second);
}

std::optional<SceneFailure> judge_step(const StepScene& scene, const StepSolver& solver,
                                       const StepFuzzOptions& options) {
  const Mesh mesh = scene.mesh();
  const Positions x0(scene.x0), x1(scene.x1);
  const ExactStep exact = exact_step(mesh, scene);
  try {
    const StepReply reply = solver(mesh, x0, x1);
    if (auto wrong = StepJudge(mesh, exact, options).judge(reply)) return wrong;
    if (options.twice && !(solver(mesh, x0, x1) == reply))
      return SceneFailure{FuzzFailure::differs, "all", "asked again, it says something else"};
  } catch (const NoReply& trouble) {
    return SceneFailure{trouble.failure(), "all", trouble.what()};
  } catch (const std::exception& error) {
    return SceneFailure{FuzzFailure::crash, "all", error.what()};
  }
  return std::nullopt;
}

}  // namespace touchstone::fuzz
