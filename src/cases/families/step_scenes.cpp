// SPDX-License-Identifier: MIT
#include "families/step_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "families/body_scenes.hpp"
#include "numbers/doubles/nearest_float.hpp"
#include "seeded/rng.hpp"

namespace touchstone::families {
namespace {

using seeded::Rng;

Vec3 jitter(Rng& random, double size) {
  const double x = size * random.symmetric(), y = size * random.symmetric();
  return {x, y, size * random.symmetric()};
}
Vec3 sum(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// Adds a vertex that moves. @returns its number
MeshIndex add_vertex(StepScene& scene, const Vec3& at, const Vec3& way) {
  scene.x0.push_back(at);
  scene.x1.push_back(sum(at, way));
  return static_cast<MeshIndex>(scene.elements.vertex_count++);
}

/// A grid of n by n vertices over a square, with its triangles. `at` and `way` are functions of u and v in [0, 1].
template <class At, class Way>
void add_sheet(StepScene& scene, int n, const At& at, const Way& way) {
  const auto first = static_cast<MeshIndex>(scene.elements.vertex_count), width = static_cast<MeshIndex>(n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = static_cast<double>(i) / (n - 1), v = static_cast<double>(j) / (n - 1);
      add_vertex(scene, at(u, v), way(u, v));
    }
  }
  for (MeshIndex i = 0; i + 1 < width; ++i) {
    for (MeshIndex j = 0; j + 1 < width; ++j) {
      const MeshIndex a = first + i * width + j;
      scene.elements.faces.push_back({a, a + 1, a + width});
      scene.elements.faces.push_back({a + 1, a + width + 1, a + width});
    }
  }
}

void add_box(StepScene& scene, const Vec3& low, const Vec3& high, const Vec3& way) {
  const BodyShape box = box_shape(1, 1, 1);
  const auto first = static_cast<MeshIndex>(scene.elements.vertex_count);
  for (const Vec3& corner : box.points) {
    const Vec3 at = {corner.x > 0 ? high.x : low.x, corner.y > 0 ? high.y : low.y, corner.z > 0 ? high.z : low.z};
    add_vertex(scene, at, way);
  }
  for (const auto& [a, b, c] : box.elements.faces) scene.elements.faces.push_back({first + a, first + b, first + c});
}

StepScene sheets(Rng& random) {
  StepScene scene;
  const int n = random.between(3, 4);
  const double height = std::ldexp(1.0, -random.between(0, 12)), fall = height * random.uniform(0, 3);
  const double rough = random.one_in(3) ? 0 : height * random.uniform(0, 0.4);
  add_sheet(
      scene, n,
      [&](double u, double v) {
        return sum({u, v, 0}, jitter(random, rough));
      },
      [&](double, double) { return jitter(random, rough); });
  add_sheet(
      scene, n,
      [&](double u, double v) {
        return sum({u, v, height}, jitter(random, rough));
      },
      [&](double, double) {
        return sum({0, 0, -fall}, jitter(random, rough));
      });
  if (random.one_in(3)) scene.elements.separation.distance = height / 8;
  return scene;
}

StepScene folding(Rng& random) {
  StepScene scene;
  const double close = random.uniform(0, 1.2), rough = random.uniform(0, 0.1);
  add_sheet(
      scene, random.between(4, 6),
      [&](double u, double v) {
        return sum({u, v, 0}, jitter(random, rough));
      },
      [&](double u, double) {  // the half beyond u = 1/2 turns over
        const double beyond = std::max(u - 0.5, 0.0);
        return sum({-2 * close * beyond, 0, 4 * beyond * (1 - close) * close}, jitter(random, rough));
      });
  return scene;
}

StepScene stack(Rng& random) {
  StepScene scene;
  const int boxes = random.between(2, 4);
  double floor = 0;
  for (int i = 0; i < boxes; ++i) {
    const double gap = random.one_in(4) ? 0 : std::ldexp(1.0, -random.between(4, 40));
    const double x = random.one_in(2) ? 0 : random.uniform(-0.3, 0.3);
    const double low = floor + (i == 0 ? 0 : gap);
    add_box(scene, {x, x, low}, {x + 1, x + 1, low + 1}, {0, 0, i == 0 ? 0 : -gap * random.uniform(0, 2)});
    floor = low + 1;
  }
  return scene;
}

StepScene beads(Rng& random) {
  StepScene scene;
  const int count = random.between(6, 30);
  for (int i = 0; i < count; ++i) {
    const Vec3 at = jitter(random, 1);
    add_vertex(scene, at, random.one_in(4) ? Vec3{} : jitter(random, 2));
  }
  scene.elements.separation.distance = random.uniform(0.01, 0.2);
  if (random.one_in(4)) scene.elements.separation.metric = Metric::max;
  return scene;
}

StepScene rods(Rng& random) {
  StepScene scene;
  const int chains = random.between(2, 4), length = random.between(3, 6);
  for (int c = 0; c < chains; ++c) {
    const Vec3 from = jitter(random, 1), step = jitter(random, 0.5);
    for (int i = 0; i < length; ++i) {
      const double at = i;
      const MeshIndex vertex = add_vertex(
          scene, sum({from.x + at * step.x, from.y + at * step.y, from.z + at * step.z}, jitter(random, 0.1)),
          jitter(random, random.one_in(3) ? 0.1 : 1));
      if (i > 0) scene.elements.edges.push_back({vertex - 1, vertex});
    }
  }
  for (int i = random.between(0, 5); i > 0; --i) add_vertex(scene, jitter(random, 1), jitter(random, 1));
  if (random.one_in(3)) scene.elements.separation.distance = random.uniform(0.001, 0.05);
  return scene;
}

StepScene shells(Rng& random) {
  StepScene scene;
  const double gap = std::ldexp(1.0, -random.between(3, 20));
  add_box(scene, {0, 0, 0}, {1, 1, 1}, {});
  add_box(scene, {1 + gap, 0.25, 0.25}, {2, 1.25, 1.25}, {gap * random.uniform(-1, 0.5), random.symmetric(), 0});
  for (Vec3& at : scene.x0) at = sum(at, jitter(random, gap / 8));
  scene.elements.separation.distance = gap * random.uniform(0, 0.5);
  return scene;
}

StepScene one_vertex(Rng& random) {
  StepScene scene = random.one_in(2) ? sheets(random) : folding(random);
  const auto moving = static_cast<std::size_t>(random.below(scene.x0.size()));
  for (std::size_t v = 0; v < scene.x0.size(); ++v) scene.x1[v] = scene.x0[v];
  scene.x1[moving] = sum(scene.x0[moving], jitter(random, 1));
  return scene;
}

StepScene mixed_sizes(Rng& random) {
  StepScene scene;
  const int count = random.between(4, 10);
  for (int i = 0; i < count; ++i) {
    const double size = std::ldexp(1.0, -random.between(0, 40));
    const Vec3 at = jitter(random, random.one_in(2) ? 1 : size), way = jitter(random, random.one_in(2) ? 1 : size);
    const auto first = static_cast<MeshIndex>(scene.elements.vertex_count);
    for (int c = 0; c < 3; ++c) add_vertex(scene, sum(at, jitter(random, size)), sum(way, jitter(random, size)));
    scene.elements.faces.push_back({first, first + 1, first + 2});
  }
  return scene;
}

StepScene lattice_steps(Rng& random) {
  StepScene scene;
  const int most = random.between(1, 6), count = random.between(5, 12);
  const auto corner = [&] {
    const double x = random.between(0, most), y = random.between(0, most);
    return Vec3{x, y, static_cast<double>(random.between(0, most))};
  };
  for (int i = 0; i < count; ++i) {
    add_vertex(scene, corner(), {});
    if (!random.one_in(3)) scene.x1.back() = corner();
  }
  const auto vertices = static_cast<MeshIndex>(count);
  for (MeshIndex i = 0; i + 2 < vertices; ++i) {
    if (random.one_in(2)) scene.elements.faces.push_back({i, i + 1, i + 2});
  }
  for (MeshIndex i = 0; i + 3 < vertices; ++i) {
    if (random.one_in(4)) scene.elements.edges.push_back({i, i + 3});
  }
  if (random.one_in(4)) scene.elements.separation.distance = 0.5;
  return scene;
}

StepScene in_groups(Rng& random) {
  StepScene scene = lattice_steps(random);
  const std::size_t half = scene.elements.vertex_count / 2;
  for (std::size_t v = 0; v < scene.elements.vertex_count; ++v) scene.elements.rules.groups.push_back(v < half ? 0 : 1);
  scene.elements.rules.group_pairs = {{0, 0}};
  return scene;
}

StepScene in_the_plane(Rng& random) {
  StepScene scene = random.one_in(2) ? rods(random) : lattice_steps(random);
  scene.elements.faces.clear();
  for (auto* const positions : {&scene.x0, &scene.x1}) {
    for (Vec3& at : *positions) at.z = 0;
  }
  return scene;
}

StepScene another(Rng& random) {
  static constexpr std::array kOthers = {StepFamily::steps_sheets,     StepFamily::steps_fold,
                                         StepFamily::steps_stack,      StepFamily::steps_rods,
                                         StepFamily::steps_one_vertex, StepFamily::steps_lattice};
  return step_scene(random.pick(kOthers), random.bits(), 0);
}

StepScene far_from_the_origin(Rng& random) {
  StepScene scene = another(random);
  Vec3 offset;
  for (double* const x : {&offset.x, &offset.y, &offset.z}) {
    *x = std::ldexp(static_cast<double>(random.between(-3, 3)), random.between(4, 40));
  }
  for (auto* const positions : {&scene.x0, &scene.x1}) {
    for (Vec3& at : *positions) at = sum(at, offset);
  }
  return scene;
}

StepScene in_float32(Rng& random) {
  StepScene scene = random.one_in(2) ? another(random) : far_from_the_origin(random);
  for (auto* const positions : {&scene.x0, &scene.x1}) {
    for (Vec3& at : *positions) {
      for (double* const x : {&at.x, &at.y, &at.z}) *x = numbers::nearest_float(*x);
    }
  }
  return scene;
}

/// Climbs towards the least margin: the step ends where its first contact begins. Then, mostly, a vertex goes a little
/// farther or less far.
StepScene grazing(Rng& random) {
  StepScene scene = random.one_in(3) ? beads(random) : random.one_in(2) ? shells(random) : another(random);
  const Mesh mesh = scene.mesh();
  for (int climb = 0; climb < 8; ++climb) {
    const FirstContact first = first_contact(mesh, scene.x0, scene.x1);
    if (!first.contact || !first.at_start.empty() || first.toi_upper == 1) break;
    const double t = climb % 2 == 0 ? first.toi : first.toi_upper;
    for (std::size_t v = 0; v < scene.x0.size(); ++v) {
      Vec3& end = scene.x1[v];
      const Vec3& start = scene.x0[v];
      end = {start.x + t * (end.x - start.x), start.y + t * (end.y - start.y), start.z + t * (end.z - start.z)};
    }
  }
  if (random.one_in(4)) return scene;
  const std::size_t v = random.below(scene.x0.size());
  const double farther = 1 + std::ldexp(random.symmetric(), -random.between(1, 53));
  for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    scene.x1[v].*axis = scene.x0[v].*axis + farther * (scene.x1[v].*axis - scene.x0[v].*axis);
  }
  return scene;
}

StepScene made(StepFamily family, Rng& random) {
  switch (family) {
    case StepFamily::steps_sheets: return sheets(random);
    case StepFamily::steps_fold: return folding(random);
    case StepFamily::steps_stack: return stack(random);
    case StepFamily::steps_beads: return beads(random);
    case StepFamily::steps_rods: return rods(random);
    case StepFamily::steps_shells: return shells(random);
    case StepFamily::steps_far: return far_from_the_origin(random);
    case StepFamily::steps_one_vertex: return one_vertex(random);
    case StepFamily::steps_mixed: return mixed_sizes(random);
    case StepFamily::steps_float32: return in_float32(random);
    case StepFamily::steps_lattice: return lattice_steps(random);
    case StepFamily::steps_groups: return in_groups(random);
    case StepFamily::steps_plane: return in_the_plane(random);
    case StepFamily::steps_grazing: return grazing(random);
  }
  return {};
}

}  // namespace

const std::vector<std::string_view>& step_families() {
  static const std::vector<std::string_view> names = {
      "steps_sheets",  "steps_fold",   "steps_stack",      "steps_beads",  "steps_rods",
      "steps_shells",  "steps_far",    "steps_one_vertex", "steps_mixed",  "steps_float32",
      "steps_lattice", "steps_groups", "steps_plane",      "steps_grazing"};
  return names;
}

StepScene step_scene(StepFamily family, std::uint64_t seed, std::uint64_t index) {
  Rng random(seeded::seed_of_stream(seed + 0x9E3779B97F4A7C15u * (64 + static_cast<std::uint64_t>(family)), index));
  StepScene scene = made(family, random);
  scene.elements.edges = scene.mesh().edges();
  return scene;
}

}  // namespace touchstone::families
