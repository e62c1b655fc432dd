// SPDX-License-Identifier: MIT
#include "fuzz/bodies/shrink_bodies.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "fuzz/shrinking/shrink_numbers.hpp"
#include "fuzz/shrinking/simplicity.hpp"

namespace touchstone::fuzz {
namespace {

using families::BodyScene;
using families::BodyShape;

constexpr std::int64_t kElement = 1'000'000;

template <class F>
void for_each_scene_number(BodyScene& scene, const F& f) {
  const auto of_point = [&](Vec3& p) { f(p.x), f(p.y), f(p.z); };
  for (BodyShape& shape : scene.shapes) {
    for (Vec3& point : shape.points) of_point(point);
    for (double& radius : shape.elements.radii) f(radius);
  }
  for (RigidMotion& motion : scene.motions) {
    for (auto* q : {&motion.q0, &motion.q1}) std::for_each(q->begin(), q->end(), f);
    of_point(motion.p0), of_point(motion.p1);
  }
  f(scene.separation.distance);
}

class BodyShrinking {
 public:
  BodyShrinking(const BodyScene& scene, const std::function<bool(const BodyScene&)>& still_fails,
                const std::function<bool()>& stop)
      : still_fails_(still_fails), stop_(stop), best_(scene), difficulty_(difficulty(scene)) {}

  BodyScene shrunk() {
    std::int64_t before = 0;
    do {
      before = difficulty_;
      drop_bodies();
      for (std::size_t b = 0; b < best_.shapes.size(); ++b) drop_elements(b);
      rest();
      simplify_numbers();
    } while (difficulty_ < before && !over());
    return best_;
  }

 private:
  bool over() const { return stop_ && stop_(); }

  bool offer(const BodyScene& candidate) {
    const std::int64_t its_difficulty = difficulty(candidate);
    if (its_difficulty >= difficulty_ || over()) return false;
    try {
      if (!still_fails_(candidate)) return false;
    } catch (const InvalidQuery&) {
      return false;
    } catch (const InvalidMesh&) {
      return false;
    }
    best_ = candidate;
    difficulty_ = its_difficulty;
    return true;
  }

  /// Offers the best scene with a change.
  template <class Change>
  bool change(const Change& change) {
    BodyScene candidate = best_;
    change(candidate);
    return offer(candidate);
  }

  void drop_bodies() {
    change([](BodyScene& scene) { scene.rules = {}; });
    for (std::size_t b = best_.shapes.size(); b-- > 0 && best_.shapes.size() > 2;) {
      change([b](BodyScene& scene) {
        scene.shapes.erase(scene.shapes.begin() + static_cast<std::ptrdiff_t>(b));
        scene.motions.erase(scene.motions.begin() + static_cast<std::ptrdiff_t>(b));
      });
    }
  }

  /// Drops runs of a list's members, long ones first.
  template <class List>
  void drop_runs(const List& list) {
    for (std::size_t run = list(best_).size(); run > 0; run /= 2) {
      for (std::size_t first = 0; first < list(best_).size();) {
        const bool dropped = change([&](BodyScene& scene) {
          auto& all = list(scene);
          const auto from = all.begin() + static_cast<std::ptrdiff_t>(first);
          all.erase(from, from + static_cast<std::ptrdiff_t>(std::min(run, all.size() - first)));
        });
        if (!dropped) first += run;
      }
    }
  }

  void drop_elements(std::size_t b) {
    drop_runs([b](BodyScene & scene) -> auto& { return scene.shapes[b].elements.faces; });
    drop_runs([b](BodyScene & scene) -> auto& { return scene.shapes[b].elements.edges; });
    for (std::size_t face = 0; face < best_.shapes[b].elements.faces.size(); ++face) {
      for (const auto& [i, j] : {std::array{0, 1}, std::array{1, 2}, std::array{0, 2}}) {
        const bool replaced =
            change([&, first = static_cast<std::size_t>(i), second = static_cast<std::size_t>(j)](BodyScene& scene) {
              MeshElements& elements = scene.shapes[b].elements;
              const auto corners = elements.faces[face];
              elements.faces.erase(elements.faces.begin() + static_cast<std::ptrdiff_t>(face));
              elements.edges.push_back({corners[first], corners[second]});
            });
        if (replaced) break;
      }
    }
    for (std::size_t v = best_.shapes[b].points.size(); v-- > 0;) {
      change([&](BodyScene& scene) { drop_vertex(scene.shapes[b], static_cast<MeshIndex>(v)); });
    }
    change([b](BodyScene& scene) { scene.shapes[b].elements.radii.clear(); });
  }

  /// With its elements.
  static void drop_vertex(BodyShape& shape, MeshIndex vertex) {
    MeshElements& elements = shape.elements;
    const auto drop = [vertex](auto& all) {
      all.erase(std::remove_if(all.begin(), all.end(),
                               [&](const auto& one) { return std::count(one.begin(), one.end(), vertex) > 0; }),
                all.end());
      for (auto& one : all) {
        for (MeshIndex& corner : one) corner -= corner > vertex ? 1 : 0;
      }
    };
    drop(elements.faces), drop(elements.edges);
    shape.points.erase(shape.points.begin() + vertex);
    if (!elements.radii.empty()) elements.radii.erase(elements.radii.begin() + vertex);
    --elements.vertex_count;
  }

  /// Bodies that do not turn or move.
  void rest() {
    for (std::size_t b = 0; b < best_.motions.size(); ++b) {
      change([b](BodyScene& scene) { scene.motions[b] = {}; });
      change([b](BodyScene& scene) { scene.motions[b].q0 = scene.motions[b].q1 = {1, 0, 0, 0}; });
      change([b](BodyScene& scene) { scene.motions[b].q1 = scene.motions[b].q0; });
      change([b](BodyScene& scene) { scene.motions[b].q0 = scene.motions[b].q1; });
      change([b](BodyScene& scene) { scene.motions[b].p0 = scene.motions[b].p1; });
      change([b](BodyScene& scene) { scene.motions[b].p1 = scene.motions[b].p0; });
    }
    change([](BodyScene& scene) { scene.separation = {}; });
  }

  void simplify_numbers() {
    std::size_t count = 0;
    for_each_scene_number(best_, [&](double&) { ++count; });
    for (std::size_t n = 0; n < count && !over(); ++n) {
      const auto with = [&](BodyScene& scene, const auto& f) {
        std::size_t at = 0;
        for_each_scene_number(scene, [&](double& x) {
          if (at++ == n) f(x);
        });
      };
      simplify_number(
          [&] {
            double value = 0;
            with(best_, [&](const double& x) { value = x; });
            return value;
          },
          [&](double value) {
            return change([&](BodyScene& scene) { with(scene, [value](double& x) { x = value; }); });
          });
    }
  }

  const std::function<bool(const BodyScene&)>& still_fails_;
  const std::function<bool()>& stop_;
  BodyScene best_;
  std::int64_t difficulty_;
};

}  // namespace

std::int64_t difficulty(const BodyScene& scene) {
  std::int64_t sum = 0;
  BodyScene read = scene;
  for_each_scene_number(read, [&](double& x) { sum += std::min(difficulty(x), kElement / 1000); });
  for (const BodyShape& shape : scene.shapes) {
    const std::size_t elements =
        3 * shape.elements.faces.size() + 2 * shape.elements.edges.size() + shape.points.size() + 1;
    sum += kElement * static_cast<std::int64_t>(elements);
  }
  for (const RigidMotion& motion : scene.motions) sum += motion.q0 == motion.q1 ? 0 : 100;
  return sum + (scene.rules.body_pairs.empty() ? 0 : kElement);
}

BodyScene shrink_bodies(const BodyScene& scene, const std::function<bool(const BodyScene&)>& still_fails,
                        const std::function<bool()>& stop) {
  return BodyShrinking(scene, still_fails, stop).shrunk();
}

}  // namespace touchstone::fuzz
