// SPDX-License-Identifier: MIT
#include "fuzz/steps/fuzz_steps.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include <touchstone/error.hpp>

#include "fuzz/steps/judge_step.hpp"
#include "fuzz/steps/shrink_steps.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone {
namespace fuzz {
namespace {

using families::StepScene;

void check_step_options(const StepFuzzOptions& options) {
  const auto require = [](bool holds, const std::string& reason) {
    if (!holds) throw InvalidQuery(reason);
  };
  const auto is_fraction = [](double x) { return x >= 0 && x <= 1; };
  require(options.cases > 0, "there are 0 cases; there must be 1 or more");
  require(options.threads >= 1 && options.threads <= 1024,
          "there are " + std::to_string(options.threads) + " threads; there must be 1 to 1024");
  require(is_fraction(options.stall), "stall must be in [0, 1]");
  require(is_fraction(options.late_fraction), "late_fraction must be in [0, 1]");
  require(!options.early_fraction || is_fraction(*options.early_fraction), "early_fraction must be in [0, 1]");
  require(!options.seconds || (*options.seconds > 0 && *options.seconds <= 1e9), "seconds must be in (0, 1e9]");
  const auto& known = families::step_families();
  for (const std::string& name : options.families) {
    require(std::find(known.begin(), known.end(), name) != known.end(), "'" + name + "' is no family of steps");
  }
}

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
  check_step_options(options);
  const auto& known = families::step_families();
  std::vector<std::size_t> chosen;
  for (std::size_t family = 0; family < known.size(); ++family) {
    const auto& names = options.families;
    if (names.empty() || std::find(names.begin(), names.end(), known[family]) != names.end()) chosen.push_back(family);
  }
  SceneSort<StepScene> sort;
  for (const std::size_t family : chosen) sort.families.push_back(known[family]);
  sort.make = [&](SceneCase name) {
    if (!a_case) name.family = chosen.at(name.family);
    return step_of(name, options);
  };
  sort.new_judge = [&] {
    return [&, solver = new_solver()](const StepScene& scene) { return judge_step(scene, solver, options); };
  };
  sort.difficulty = [](const StepScene& scene) { return difficulty(scene); };
  sort.shrink = shrink_steps;
  SceneSettings settings;
  settings.seed = options.seed;
  if (!options.seconds) settings.cases = options.cases;
  settings.seconds = options.seconds;
  settings.threads = options.threads;
  settings.most_findings = options.findings;
  settings.a_case = a_case;
  SceneOutcome<StepScene> outcome = search_scenes(sort, settings, watch);
  for (StepFinding& finding : outcome.findings) {
    if (!a_case) finding.name.family = chosen.at(finding.name.family);
  }
  return outcome;
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

bool operator==(const StepReply& a, const StepReply& b) {
  const auto in_order = [](const StepReply& reply) {
    std::vector<MeshPair> pairs = reply.candidates.value_or(std::vector<MeshPair>());
    for (MeshPair& pair : pairs) pair = fuzz::with_ascending(pair);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  };
  return a.free == b.free && a.first_contact == b.first_contact &&
         a.candidates.has_value() == b.candidates.has_value() && in_order(a) == in_order(b);
}

std::string to_string(const StepFuzzFinding& finding) {
  std::ostringstream out;
  out << touchstone::name_of(finding.failure) << " " << finding.count << " time" << (finding.count == 1 ? "" : "s")
      << ", " << finding.question << ": " << finding.detail << "\n";
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
