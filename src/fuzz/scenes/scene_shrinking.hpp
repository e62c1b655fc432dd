// Makes a failing scene readable: few elements, small integers. The moves that scenes of bodies and steps of a mesh
// share.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/mesh.hpp>

#include "fuzz/shrinking/shrink_numbers.hpp"

namespace touchstone::fuzz {

/// An element weighs more than any number of a scene.
inline constexpr std::int64_t kElementDifficulty = 1'000'000;

inline std::int64_t difficulty_of_elements(const MeshElements& elements) {
  return kElementDifficulty *
         static_cast<std::int64_t>(3 * elements.faces.size() + 2 * elements.edges.size() + elements.vertex_count + 1);
}

/// Drops a vertex with its elements and its radius. Its positions are the caller's.
inline void drop_vertex(MeshElements& elements, MeshIndex vertex) {
  const auto drop = [vertex](auto& all) {
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const auto& one) { return std::count(one.begin(), one.end(), vertex) > 0; }),
              all.end());
    for (auto& one : all) {
      for (MeshIndex& corner : one) corner -= corner > vertex ? 1 : 0;
    }
  };
  drop(elements.faces), drop(elements.edges), drop(elements.rules.vertex_pairs);
  if (!elements.radii.empty()) elements.radii.erase(elements.radii.begin() + vertex);
  if (!elements.rules.groups.empty()) elements.rules.groups.erase(elements.rules.groups.begin() + vertex);
  --elements.vertex_count;
}

/// The simplest scene so far, and moves that offer simpler ones.
template <class Scene>
class SceneShrinking {
 public:
  /// @param difficulty_of  a smaller number is easier to read
  /// @param still_fails    may throw InvalidQuery or InvalidMesh for a scene without meaning, which then does not fail
  /// @param stop           called before each try; true ends the shrinking
  SceneShrinking(const Scene& scene, std::int64_t (*difficulty_of)(const Scene&),
                 const std::function<bool(const Scene&)>& still_fails, const std::function<bool()>& stop)
      : difficulty_of_(difficulty_of),
        still_fails_(still_fails),
        stop_(stop),
        best_(scene),
        difficulty_(difficulty_of(scene)) {}

  const Scene& best() const noexcept { return best_; }
  std::int64_t difficulty() const noexcept { return difficulty_; }
  /// The tries are limited, so that equal runs have equal results.
  bool over() const { return tries_ >= kMostTries || (stop_ && stop_()); }

  /// Offers the best scene with a change. @returns whether it is the best one now
  template <class Change>
  bool change(const Change& change) {
    Scene candidate = best_;
    change(candidate);
    const std::int64_t its_difficulty = difficulty_of_(candidate);
    if (its_difficulty >= difficulty_ || over()) return false;
    ++tries_;
    try {
      if (!still_fails_(candidate)) return false;
    } catch (const InvalidQuery&) {
      return false;
    } catch (const InvalidMesh&) {
      return false;
    }
    best_ = std::move(candidate);
    difficulty_ = its_difficulty;
    return true;
  }

  /// Drops faces, edges and vertices. @param elements  the MeshElements of a scene
  /// @param drop  drops a vertex of a scene
  template <class Elements, class Drop>
  void drop_elements(const Elements& elements, const Drop& drop) {
    drop_runs([&](Scene & scene) -> auto& { return elements(scene).faces; });
    drop_runs([&](Scene & scene) -> auto& { return elements(scene).edges; });
    for (std::size_t face = 0; face < elements(best_).faces.size(); ++face) {
      for (const auto& side : {std::array<std::size_t, 2>{0, 1}, {1, 2}, {0, 2}}) {
        const bool replaced = change([&](Scene& scene) {
          MeshElements& all = elements(scene);
          const auto corners = all.faces[face];
          all.faces.erase(all.faces.begin() + static_cast<std::ptrdiff_t>(face));
          const std::array<MeshIndex, 2> edge = {corners[side[0]], corners[side[1]]};
          const bool is_there = std::any_of(all.edges.begin(), all.edges.end(), [&](const auto& one) {
            return one == edge || one == std::array{edge[1], edge[0]};
          });
          if (!is_there) all.edges.push_back(edge);
        });
        if (replaced) break;
      }
    }
    for (std::size_t v = elements(best_).vertex_count; v-- > 0;) {
      change([&](Scene& scene) { drop(scene, static_cast<MeshIndex>(v)); });
    }
    change([&](Scene& scene) { elements(scene).radii.clear(); });
  }

  /// @param for_each  calls a function with each number of a scene
  template <class ForEach>
  void simplify_numbers(const ForEach& for_each) {
    std::size_t count = 0;
    for_each(best_, [&](double&) { ++count; });
    for (std::size_t n = 0; n < count && !over(); ++n) {
      const auto with = [&](Scene& scene, const auto& f) {
        std::size_t at = 0;
        for_each(scene, [&](double& x) {
          if (at++ == n) f(x);
        });
      };
      simplify_number(
          [&] {
            double value = 0;
            with(best_, [&](const double& x) { value = x; });
            return value;
          },
          [&](double value) { return change([&](Scene& scene) { with(scene, [value](double& x) { x = value; }); }); });
    }
  }

 private:
  /// Drops runs of a list's members, long ones first.
  template <class List>
  void drop_runs(const List& list) {
    for (std::size_t run = list(best_).size(); run > 0; run /= 2) {
      for (std::size_t first = 0; first < list(best_).size();) {
        const bool dropped = change([&](Scene& scene) {
          auto& all = list(scene);
          const auto from = all.begin() + static_cast<std::ptrdiff_t>(first);
          all.erase(from, from + static_cast<std::ptrdiff_t>(std::min(run, all.size() - first)));
        });
        if (!dropped) first += run;
      }
    }
  }

  static constexpr std::uint64_t kMostTries = 20'000;

  std::uint64_t tries_ = 0;
  std::int64_t (*difficulty_of_)(const Scene&);
  const std::function<bool(const Scene&)>& still_fails_;
  const std::function<bool()>& stop_;
  Scene best_;
  std::int64_t difficulty_;
};

}  // namespace touchstone::fuzz
