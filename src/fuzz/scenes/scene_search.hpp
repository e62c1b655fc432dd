// The search for scenes, of whole bodies or of a mesh in a step, about which a function is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/fuzz.hpp>

#include "fuzz/worker_threads.hpp"

namespace touchstone::fuzz {

/// What is wrong with a reply about a scene.
struct SceneFailure {
  FuzzFailure failure = FuzzFailure::missed;
  std::string question;  ///< what was asked: "first contact", "candidates", "free step" and so on
  std::string detail;    ///< the elements and the times, for a person
};

/// The name of a scene, from which it is made again.
struct SceneCase {
  std::size_t family = 0;  ///< its place among the families of its sort
  std::uint64_t seed = 1, index = 0;
};

/// Failures of one class and one question, by the simplest of the scenes.
template <class Scene>
struct SceneFinding {
  SceneFailure failure;
  std::uint64_t count = 0;
  SceneCase name;  ///< of the scene before it was shrunk
  Scene scene;     ///< shrunk
};

struct SceneSettings {
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> cases;
  std::optional<double> seconds;    ///< of the search; the shrinking may take as long again, but 10 at least
  int threads = 1;                  ///< with `cases` and no `seconds` no result but shrinking depends on it
  std::size_t most_findings = 0;    ///< that are shrunk and returned; 0: all
  std::optional<SceneCase> a_case;  ///< this one alone
};

template <class Scene>
struct SceneOutcome {
  std::uint64_t scenes = 0;    ///< asked and judged
  std::uint64_t failures = 0;  ///< scenes with a wrong reply
  double seconds = 0;          ///< of the search
  std::vector<SceneFinding<Scene>> findings;
  std::size_t kinds_of_failure = 0;  ///< the number of findings, those beyond `most_findings` included
  bool stopped = false;              ///< by the watch
};

/// Called a few times a second with the number of scenes so far; false ends the run.
using SceneWatch = std::function<bool(std::uint64_t)>;

/// What is wrong with the reply about a scene; nothing when all of it is right.
template <class Scene>
using SceneJudge = std::function<std::optional<SceneFailure>(const Scene&)>;

/// What a search knows of one sort of scenes. All functions are called on several threads at a time.
template <class Scene>
struct SceneSort {
  std::vector<std::string_view> families;
  std::function<Scene(const SceneCase&)> make;
  std::function<SceneJudge<Scene>()> new_judge;  ///< of a thread: a process under test ends with the one that began it
  std::function<std::int64_t(const Scene&)> difficulty;
  /// A simpler scene for which the first function holds; the second one ends the shrinking.
  std::function<Scene(const Scene&, const std::function<bool(const Scene&)>&, const std::function<bool()>&)> shrink;
};

/// What is wrong, without what the elements are: "missed 3 times, candidates: DETAIL", with a line feed.
std::string headline_of(const SceneFailure& failure, std::uint64_t count);

/// @throws InvalidQuery  for options without meaning, and families that are not known
void check_step_options(const StepFuzzOptions& options, const std::vector<std::string_view>& families);

/// "bodies_touch 1 17".
std::string case_text(const std::vector<std::string_view>& families, const SceneCase& name);
std::optional<SceneCase> parse_scene_case(const std::vector<std::string_view>& families, std::string_view text);

/// Asks about scenes of every family in turn.
template <class Scene>
SceneOutcome<Scene> search_scenes(const SceneSort<Scene>& sort, const SceneSettings& settings,
                                  const SceneWatch& watch = {}) {
  using SearchClock = std::chrono::steady_clock;
  using Key = std::pair<FuzzFailure, std::string>;
  const auto key_of = [](const SceneFailure& failure) { return Key{failure.failure, failure.question}; };
  const auto seconds_from = [](SearchClock::time_point start) {
    return std::chrono::duration<double>(SearchClock::now() - start).count();
  };
  SceneOutcome<Scene> outcome;
  std::map<Key, SceneFinding<Scene>> found;
  std::mutex lock;
  std::atomic<std::uint64_t> next = 0, scenes = 0;
  std::atomic<bool> stop = false;
  const auto threads = static_cast<std::size_t>(std::max(settings.threads, 1));
  const auto watched = [&] {
    outcome.stopped = outcome.stopped || (watch && !watch(scenes));
    return !outcome.stopped;
  };
  // Counts a failure, and keeps the simplest scene, the first of those that are equally simple.
  const auto add = [&](const SceneFailure& failure, const SceneCase& name, const Scene& scene) {
    const auto [at, is_new] = found.try_emplace(key_of(failure), SceneFinding<Scene>{failure, 0, name, scene});
    SceneFinding<Scene>& known = at->second;
    ++known.count;
    ++outcome.failures;
    const auto rank = [&](const Scene& of, const SceneCase& its) {
      return std::make_tuple(sort.difficulty(of), its.index, its.family);
    };
    if (is_new || rank(known.scene, known.name) <= rank(scene, name)) return;
    known.failure = failure, known.name = name, known.scene = scene;
  };
  const std::size_t families = sort.families.size();
  const std::optional<std::uint64_t> cases = settings.a_case ? 1 : settings.cases;
  const SearchClock::time_point start = SearchClock::now();
  run_on_threads(
      threads, stop,
      [&](std::size_t) {
        const SceneJudge<Scene> judge = sort.new_judge();
        while (!stop) {
          const std::uint64_t number = next++;
          if ((cases && number >= *cases) || (settings.seconds && seconds_from(start) >= *settings.seconds)) return;
          const SceneCase name = settings.a_case.value_or(
              SceneCase{static_cast<std::size_t>(number % families), settings.seed, number / families});
          const Scene scene = sort.make(name);
          const std::optional<SceneFailure> failure = judge(scene);
          ++scenes;
          const std::lock_guard guard(lock);
          if (failure) add(*failure, name, scene);
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
  const SearchClock::time_point shrinking = SearchClock::now();
  const auto over = [&] {
    return stop || (settings.seconds && seconds_from(shrinking) >= std::max(10.0, *settings.seconds));
  };
  if (outcome.stopped || outcome.findings.empty()) return outcome;
  run_on_threads(
      std::min(threads, outcome.findings.size()), stop,
      [&](std::size_t) {
        const SceneJudge<Scene> judge = sort.new_judge();
        for (std::uint64_t i = next++; i < outcome.findings.size(); i = next++) {
          SceneFinding<Scene>& finding = outcome.findings[i];
          if (finding.failure.failure == FuzzFailure::hang) continue;  // each try would take its whole time
          const Key key = key_of(finding.failure);
          const auto still_fails = [&](const Scene& scene) {
            const auto failure = judge(scene);
            const bool same = failure && key_of(*failure) == key;
            if (same) finding.failure = *failure;
            return same;
          };
          finding.scene = sort.shrink(finding.scene, still_fails, over);
        }
      },
      watched);
  return outcome;
}

/// The search that the options of whole steps want. The families of a case are all that the sort has.
/// @param a_case  this case alone
/// @param watch   in place of the options' `stop`
/// @throws InvalidQuery  for options without meaning
template <class Scene>
SceneOutcome<Scene> search_scenes(SceneSort<Scene> sort, const StepFuzzOptions& options,
                                  const std::optional<SceneCase>& a_case, const SceneWatch& watch) {
  check_step_options(options, sort.families);
  const std::vector<std::string_view> known = std::move(sort.families);
  std::vector<std::size_t> chosen;
  sort.families.clear();
  for (std::size_t family = 0; family < known.size(); ++family) {
    const auto& names = options.families;
    if (!a_case && !names.empty() && std::find(names.begin(), names.end(), known[family]) == names.end()) continue;
    chosen.push_back(family);
    sort.families.push_back(known[family]);
  }
  sort.make = [&chosen, make = sort.make](const SceneCase& name) {
    return make({chosen.at(name.family), name.seed, name.index});
  };
  SceneSettings settings;
  settings.seed = options.seed;
  if (!options.seconds) settings.cases = options.cases;
  settings.seconds = options.seconds;
  settings.threads = options.threads;
  settings.most_findings = options.findings;
  settings.a_case = a_case;
  SceneOutcome<Scene> outcome = search_scenes(sort, settings, watch);
  for (SceneFinding<Scene>& finding : outcome.findings) finding.name.family = chosen.at(finding.name.family);
  return outcome;
}

}  // namespace touchstone::fuzz
