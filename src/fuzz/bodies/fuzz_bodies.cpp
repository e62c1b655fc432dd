// SPDX-License-Identifier: MIT
#include "fuzz/bodies/fuzz_bodies.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <map>
#include <mutex>
#include <sstream>
#include <tuple>
#include <utility>

#include "fuzz/bodies/shrink_bodies.hpp"
#include "fuzz/worker_threads.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::fuzz {
namespace {

using BodyClock = std::chrono::steady_clock;
using families::BodyScene;
using BodyKey = std::tuple<FuzzFailure, std::string>;

BodyKey body_key(const BodyFailure& failure) { return {failure.failure, failure.question}; }

double seconds_from(BodyClock::time_point start) {
  return std::chrono::duration<double>(BodyClock::now() - start).count();
}

/// Counts a failure, and keeps the simplest scene, the first of those that are equally simple.
void add_body_finding(std::map<BodyKey, BodyFinding>& findings, const BodyFailure& failure, const BodyCase& name,
                      const BodyScene& scene) {
  const auto [at, is_new] = findings.try_emplace(body_key(failure), BodyFinding{failure, 0, name, scene});
  BodyFinding& known = at->second;
  ++known.count;
  const auto rank = [](const BodyScene& of, const BodyCase& its) {
    return std::make_tuple(difficulty(of), its.index, its.family);
  };
  if (is_new || rank(known.scene, known.name) <= rank(scene, name)) return;
  known.failure = failure, known.name = name, known.scene = scene;
}

std::string in_brackets(std::initializer_list<double> values) {
  std::string text = "(";
  for (const double x : values) text.append(text.size() > 1 ? ", " : "").append(numbers::decimal_text(x));
  return text + ")";
}

std::string scene_text_of(const Vec3& p) { return in_brackets({p.x, p.y, p.z}); }
std::string scene_text_of(const std::array<double, 4>& q) { return in_brackets({q[0], q[1], q[2], q[3]}); }

template <class Value>
std::string scene_text_of_change(const Value& start, const Value& end) {
  const std::string first = scene_text_of(start), second = scene_text_of(end);
  return first == second ? first + " at all times" : first + " -> " + second;
}

template <class Elements>
std::string scene_text_of_elements(const char* name, const Elements& elements) {
  std::string text;
  for (const auto& corners : elements) {
    text.empty() ? text.append("; ").append(name).append(" ") : text.append(", ");
    for (std::size_t c = 0; c < corners.size(); ++c) text.append(c > 0 ? "-" : "").append(std::to_string(corners[c]));
  }
  return text;
}

}  // namespace

std::string case_text(const BodyCase& name) {
  return std::string(families::name_of(name.family)) + " " + std::to_string(name.seed) + " " +
         std::to_string(name.index);
}

std::optional<BodyCase> parse_body_case(std::string_view text) {
  const std::size_t first = text.find(' '), second = text.find(' ', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return std::nullopt;
  const auto family = families::body_family_named(text.substr(0, first));
  BodyCase name;
  const auto read = [](std::string_view digits, std::uint64_t& number) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return error == std::errc() && end == digits.data() + digits.size();
  };
  if (!family || !read(text.substr(first + 1, second - first - 1), name.seed) ||
      !read(text.substr(second + 1), name.index)) {
    return std::nullopt;
  }
  name.family = *family;
  return name;
}

std::string to_string(const BodyFinding& finding) {
  std::ostringstream out;
  const BodyScene& scene = finding.scene;
  out << touchstone::name_of(finding.failure.failure) << " " << finding.count << " time"
      << (finding.count == 1 ? "" : "s") << ", " << finding.failure.question << ": " << finding.failure.detail << "\n";
  for (std::size_t b = 0; b < scene.shapes.size(); ++b) {
    const auto& [elements, points] = scene.shapes[b];
    out << "  body " << b << "  points";
    for (const Vec3& point : points) out << " " << scene_text_of(point);
    out << scene_text_of_elements("faces", elements.faces) << scene_text_of_elements("edges", elements.edges);
    for (std::size_t r = 0; r < elements.radii.size(); ++r) {
      out << (r == 0 ? "; radii " : ", ") << numbers::decimal_text(elements.radii[r]);
    }
    const RigidMotion& motion = scene.motions[b];
    out << "\n    orientation " << scene_text_of_change(motion.q0, motion.q1) << "\n    position "
        << scene_text_of_change(motion.p0, motion.p1) << "\n";
  }
  for (const auto& [a, b] : scene.rules.body_pairs) out << "  bodies " << a << " and " << b << " never collide\n";
  if (scene.separation.distance > 0) {
    out << "  separation " << numbers::decimal_text(scene.separation.distance) << ", "
        << touchstone::name_of(scene.separation.metric) << "\n";
  }
  return out.str();
}

BodyFuzzOutcome fuzz_bodies(const BodySolver& solver, const BodyFuzzSettings& settings, const BodyWatch& watch) {
  BodyFuzzOutcome outcome;
  std::map<BodyKey, BodyFinding> found;
  std::mutex lock;
  std::atomic<std::uint64_t> next = 0, scenes = 0;
  std::atomic<bool> stop = false;
  const auto threads = static_cast<std::size_t>(std::max(settings.threads, 1));
  const auto watched = [&] {
    outcome.stopped = outcome.stopped || (watch && !watch(scenes));
    return !outcome.stopped;
  };
  const auto name_of_case = [&](std::uint64_t number) {
    const std::size_t count = families::kEveryBodyFamily.size();
    return settings.a_case.value_or(
        BodyCase{families::kEveryBodyFamily[number % count], settings.seed, number / count});
  };
  const std::optional<std::uint64_t> cases = settings.a_case ? 1 : settings.cases;
  const BodyClock::time_point start = BodyClock::now();
  run_on_threads(
      threads, stop,
      [&](std::size_t) {
        while (!stop) {
          const std::uint64_t number = next++;
          if ((cases && number >= *cases) || (settings.seconds && seconds_from(start) >= *settings.seconds)) return;
          const BodyCase name = name_of_case(number);
          const BodyScene scene = families::body_scene(name.family, name.seed, name.index);
          const std::optional<BodyFailure> failure = judge_bodies(scene, solver);
          ++scenes;
          const std::lock_guard guard(lock);
          if (failure) add_body_finding(found, *failure, name, scene);
        }
      },
      watched);
  outcome.scenes = scenes;
  outcome.seconds = seconds_from(start);
  outcome.kinds_of_failure = found.size();
  for (auto& [key, finding] : found) {
    if (settings.most_findings == 0 || outcome.findings.size() < settings.most_findings) {
      outcome.findings.push_back(std::move(finding));
    }
  }
  next = 0, stop = false;
  const BodyClock::time_point shrinking = BodyClock::now();
  const auto over = [&] {
    return stop || (settings.seconds && seconds_from(shrinking) >= std::max(10.0, *settings.seconds));
  };
  if (outcome.stopped || outcome.findings.empty()) return outcome;
  run_on_threads(
      std::min(threads, outcome.findings.size()), stop,
      [&](std::size_t) {
        for (std::uint64_t i = next++; i < outcome.findings.size(); i = next++) {
          BodyFinding& finding = outcome.findings[i];
          const BodyKey key = body_key(finding.failure);
          finding.scene = shrink_bodies(
              finding.scene,
              [&](const BodyScene& scene) {
                const auto failure = judge_bodies(scene, solver);
                const bool same = failure && body_key(*failure) == key;
                if (same) finding.failure = *failure;
                return same;
              },
              over);
        }
      },
      watched);
  return outcome;
}

}  // namespace touchstone::fuzz
