// SPDX-License-Identifier: MIT
#include "fuzz/steps/fuzz_steps.hpp"

#include <cstddef>
#include <sstream>
#include <string>

#include "fuzz/scenes/judge_reply.hpp"
#include "fuzz/steps/judge_step.hpp"
#include "fuzz/steps/shrink_steps.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone {
namespace fuzz {
namespace {

using families::StepScene;

std::vector<double> numbers_of(const std::vector<Vec3>& positions) {
  std::vector<double> numbers;
  for (const Vec3& at : positions) numbers.insert(numbers.end(), {at.x, at.y, at.z});
  return numbers;
}

}  // namespace

StepScene step_of(const SceneCase& name, const StepFuzzOptions& options) {
  StepScene scene = families::step_scene(static_cast<families::StepFamily>(name.family), name.seed, name.index);
  if (!options.separations) scene.elements.separation = {};
  if (!options.groups) scene.elements.rules = {};
  return scene;
}

SceneOutcome<StepScene> search_steps(const std::function<StepSolver()>& new_solver, const StepFuzzOptions& options,
                                     const std::optional<SceneCase>& a_case, const SceneWatch& watch) {
  SceneSort<StepScene> sort;
  sort.families = families::step_families();
  sort.make = [&](const SceneCase& name) { return step_of(name, options); };
  sort.new_judge = [&] {
    return [&, solver = new_solver()](const StepScene& scene) { return judge_step(scene, solver, options); };
  };
  sort.difficulty = [](const StepScene& scene) { return difficulty(scene); };
  sort.shrink = shrink_steps;
  return search_scenes(sort, options, a_case, watch);
}

std::vector<std::string> left_out_by(const StepFuzzOptions& options) {
  std::vector<std::string> left_out;
  if (!options.separations) left_out.push_back("separations");
  if (!options.groups) left_out.push_back("groups");
  return left_out;
}

StepFuzzFinding finding_of(const StepFinding& finding) {
  const StepScene& scene = finding.scene;
  return {finding.failure.failure,
          finding.failure.question,
          finding.failure.detail,
          finding.count,
          scene.mesh(),
          numbers_of(scene.x0),
          numbers_of(scene.x1),
          case_text(families::step_families(), finding.name)};
}

StepReply library_reply(const Mesh& mesh, const Positions& x0, const Positions& x1) {
  StepReply reply;
  reply.candidates = candidates(mesh, x0, x1);
  reply.free = free_step(mesh, x0, x1).length;
  const FirstContact first = first_contact(mesh, x0, x1);
  reply.first_contact = first.at_start.empty() ? first.toi : 0;
  return reply;
}

}  // namespace fuzz

inline namespace TOUCHSTONE_ABI {

bool operator==(const StepReply& a, const StepReply& b) { return fuzz::same_replies(a, b); }

std::string to_string(const StepFuzzFinding& finding) {
  std::ostringstream out;
  out << fuzz::headline_of({finding.failure, finding.question, finding.detail}, finding.count);
  const auto position_text = [](const std::vector<double>& positions, std::size_t v) {
    std::string text = "(";
    for (std::size_t k = 3 * v; k < 3 * v + 3; ++k) {
      text.append(k > 3 * v ? ", " : "").append(numbers::decimal_text(positions[k]));
    }
    return text + ")";
  };
  for (std::size_t v = 0; v < finding.mesh.vertex_count(); ++v) {
    const std::string start = position_text(finding.x0, v), end = position_text(finding.x1, v);
    out << "  vertex " << v << "  " << start << (start == end ? " at all times" : " -> " + end) << "\n";
  }
  const auto list = [&](const char* name, const auto& elements) {
    if (elements.empty()) return;
    out << "  " << name;
    for (const auto& corners : elements) {
      out << " ";
      for (std::size_t c = 0; c < corners.size(); ++c) out << (c > 0 ? "-" : "") << corners[c];
    }
    out << "\n";
  };
  list("faces", finding.mesh.faces());
  list("edges", finding.mesh.edges());
  const MeshElements elements = finding.mesh.elements();
  if (elements.separation.distance > 0) {
    out << "  separation " << numbers::decimal_text(elements.separation.distance) << ", "
        << touchstone::name_of(elements.separation.metric) << "\n";
  }
  if (!elements.rules.groups.empty()) {
    out << "  groups of the vertices:";
    for (const MeshIndex group : elements.rules.groups) out << " " << group;
    out << "; vertices of group 0 do not collide with each other\n";
  }
  out << "  found as " << finding.case_name << "\n";
  return out.str();
}

StepFuzzReport fuzz_steps(const StepSolver& solver, const StepFuzzOptions& options) {
  const auto outcome =
      fuzz::search_steps([&] { return solver; }, options, std::nullopt,
                         [&](std::uint64_t) { return options.stop == nullptr || !options.stop->load(); });
  StepFuzzReport report;
  report.steps = outcome.scenes;
  report.failures = outcome.failures;
  report.kinds_of_failure = outcome.kinds_of_failure;
  report.left_out = fuzz::left_out_by(options);
  report.stopped = outcome.stopped;
  for (const fuzz::StepFinding& finding : outcome.findings) report.findings.push_back(fuzz::finding_of(finding));
  return report;
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
