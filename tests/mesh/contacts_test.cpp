// The contacts of whole meshes are those of all pairs, asked one by one; they do not depend on threads, nor on the
// order of vertices and faces.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include <touchstone/contact_times.hpp>
#include <touchstone/touchstone.hpp>

#include "broad_phase/box_tree.hpp"
#include "broad_phase/grid.hpp"
#include "mesh/same_bytes.hpp"
#include "mesh/scenes.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr double kMost = std::numeric_limits<double>::max();

struct BruteForce {
  std::vector<MeshContact> all, at_start, earliest;
  double toi = INFINITY, toi_upper = INFINITY;
};

BruteForce brute_force(const Scene& scene, double t_max) {
  BruteForce result;
  const Parts parts = parts_of(scene.elements);
  for (const MeshPair& pair : all_pairs(scene.elements)) {
    const Query query = query_between(scene, parts, pair, scene.x0, scene.x1);
    const Separation separation{separation_between(scene, parts, pair), scene.elements.separation.metric};
    const Answer answer = solve(query, {.t_max = t_max, .separation = separation});
    if (!answer.contact) continue;
    result.all.push_back({pair, separation, answer});
    if (answer.starts_within) result.at_start.push_back({pair, separation, answer});
  }
  // The first contacts by exact times.
  std::vector<std::pair<MeshContact, ExactTime>> later;
  for (const MeshContact& contact : result.all) {
    if (contact.answer.starts_within) continue;
    const Query query = query_between(scene, parts, contact.pair, scene.x0, scene.x1);
    later.push_back({contact, contact_times(query, contact.separation, t_max).front().first});
  }
  const auto least =
      std::min_element(later.begin(), later.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (least != later.end()) {
    result.toi = least->second.lower();
    result.toi_upper = least->second.upper();
    for (const auto& [contact, time] : later) {
      if (time == least->second) result.earliest.push_back(contact);
    }
  }
  std::sort(result.all.begin(), result.all.end(), [](const MeshContact& a, const MeshContact& b) {
    return std::tie(a.answer.toi, a.answer.toi_upper, a.pair) < std::tie(b.answer.toi, b.answer.toi_upper, b.pair);
  });
  return result;
}

bool agrees(const FirstContact& found, const BruteForce& expected) {
  return found.contact == !expected.earliest.empty() && found.toi == expected.toi &&
         found.toi_upper == expected.toi_upper && same_bytes(found.earliest, expected.earliest) &&
         same_bytes(found.at_start, expected.at_start);
}

void add_rules(seeded::Rng& random, Scene& scene) {
  MeshElements& elements = scene.elements;
  const auto vertex = [&] { return static_cast<MeshIndex>(random.below(elements.vertex_count)); };
  if (random.one_in(2)) {
    for (std::size_t i = 0; i < 3 * elements.vertex_count; ++i) {
      const MeshIndex a = vertex();
      const MeshIndex b = vertex();
      elements.rules.vertex_pairs.push_back({a, b});
    }
  }
  if (random.one_in(2)) {
    for (std::size_t v = 0; v < elements.vertex_count; ++v) {
      elements.rules.groups.push_back(static_cast<MeshIndex>(10 * random.below(3)));
    }
    if (random.one_in(2)) elements.rules.group_rule = GroupRule::only_listed;
    elements.rules.group_pairs = {{0, 0}, {20, 10}};
  }
  if (random.one_in(2)) {
    for (const MeshPair& pair : all_pairs(elements)) {
      if (random.one_in(3)) continue;
      const bool one_sort = pair.kind == Kind::edge_edge || pair.kind == Kind::point_point;
      const bool swapped = one_sort && random.one_in(2);
      elements.rules.element_pairs.push_back(swapped ? MeshPair{pair.kind, pair.second, pair.first} : pair);
    }
  }
}

/// Which contacts a test has seen; a test that sees none proves nothing.
struct Seen {
  std::map<std::string, int> counts;
  void add(const std::string& what, bool seen) { counts[what] += seen ? 1 : 0; }
  void check() const {
    for (const auto& [what, count] : counts) {
      INFO(what << ": " << count);
      CHECK((count > 0 || !whole_effort("that each sort of scene is seen")));
    }
  }
};

/// Whether the moving boxes of the two elements meet.
bool boxes_meet(const Query& query) {
  std::array<broad_phase::MovingBox, 2> boxes{broad_phase::empty_moving_box(), broad_phase::empty_moving_box()};
  const std::size_t of_first = query.kind == Kind::edge_edge ? 2 : 1;
  for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
    broad_phase::MovingBox& box = boxes[c < of_first ? 0 : 1];
    broad_phase::extend(box.start, query.start[c]);
    broad_phase::extend(box.end, query.end[c]);
  }
  return broad_phase::meet(boxes[0], boxes[1]);
}

}  // namespace

TEST_CASE("the contacts of a mesh are those of all pairs by brute force") {
  seeded::Rng random(101);
  Seen seen;
  const std::size_t rounds = effort(60);
  for (std::size_t round = 0; round < rounds; ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 24);
      const bool extreme = random.one_in(8), separated = random.one_in(2), with_rules = random.one_in(2);
      if (extreme) {  // the differences of coordinates overflow, or everything is subnormal
        double size = 0;
        for (const double x : scene.x0) size = std::max(size, std::fabs(x));
        const int exponent = (random.one_in(2) ? 1023 : -1050) - std::ilogb(size);
        for (double& x : scene.x0) x = std::ldexp(x, exponent);
        for (double& x : scene.x1) x = std::clamp(std::ldexp(x, exponent), -kMost, kMost);
      }
      if (separated) add_separation(random, scene);
      if (with_rules) add_rules(random, scene);
      if (random.one_in(4)) {  // half of the loose points are listed, and the others do not collide
        const std::vector<MeshIndex> loose = parts_of(scene.elements).points;
        std::vector<MeshIndex>& listed = scene.elements.points.emplace();
        std::copy_if(loose.begin(), loose.end(), std::back_inserter(listed),
                     [&](MeshIndex) { return random.one_in(2); });
      }
      const bool by_pair = separated && random.one_in(2);
      if (by_pair) add_pair_separations(random, scene);
      const Mesh mesh(scene.elements);
      FirstContactOptions options;
      options.t_max = random.one_in(3) ? random.unit() : 1;
      options.threads = random.one_in(3) ? 2 : 1;
      const BruteForce expected = brute_force(scene, options.t_max);
      const FirstContact found = first_contact(mesh, scene.start(), scene.end(), options);
      CAPTURE(round, scene.name, separated, with_rules, options.t_max);
      REQUIRE(agrees(found, expected));
      REQUIRE(found.free() == expected.all.empty());
      REQUIRE(same_bytes(all_contacts(mesh, scene.start(), scene.end(), options), expected.all));

      std::vector<MeshPair> asked = all_pairs(scene.elements);
      std::sort(asked.begin(), asked.end());
      const std::vector<MeshPair> near = candidates(mesh, scene.start(), scene.end(), options);
      REQUIRE(std::includes(asked.begin(), asked.end(), near.begin(), near.end()));
      REQUIRE(std::all_of(expected.all.begin(), expected.all.end(), [&](const MeshContact& contact) {
        return std::binary_search(near.begin(), near.end(), contact.pair);
      }));
      if (!separated) {
        std::vector<MeshPair> meeting;
        std::copy_if(asked.begin(), asked.end(), std::back_inserter(meeting), [&](const MeshPair& pair) {
          return boxes_meet(query_of(mesh, pair, scene.start(), scene.end()));
        });
        REQUIRE(near == meeting);
      }
      seen.add(scene.name + " with a first contact", found.contact);
      seen.add(scene.name + " with contact at the start", !found.at_start.empty());
      seen.add("several first contacts", found.earliest.size() > 1);
      seen.add(scene.name + " with pairs that are no candidates", near.size() < asked.size());
      seen.add("separations of pairs", by_pair && found.contact);
      seen.add("extreme coordinates", extreme && found.contact);
      seen.add("rules that exclude", with_rules && found.contact);
    }
  }
  seen.check();
}

TEST_CASE("the contacts of larger meshes are those of all pairs by brute force") {
  seeded::Rng random(107);
  std::size_t contacts = 0, left_out = 0;
  for (std::size_t round = 0; round < effort(2); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, TOUCHSTONE_SLOW_BUILD ? 60 : 250);
      if (round % 2 == 1) add_separation(random, scene);
      const Mesh mesh(scene.elements);
      const BruteForce expected = brute_force(scene, 1);
      FirstContactOptions options;
      options.threads = 2;
      CAPTURE(round, scene.name);
      REQUIRE(agrees(first_contact(mesh, scene.start(), scene.end(), options), expected));
      REQUIRE(same_bytes(all_contacts(mesh, scene.start(), scene.end(), options), expected.all));
      contacts += expected.all.size();
      left_out += all_pairs(scene.elements).size() - candidates(mesh, scene.start(), scene.end(), options).size();
    }
  }
  CHECK(contacts > 1000 / (TOUCHSTONE_SLOW_BUILD ? 20 : 1));
  CHECK(left_out > 0);
}

TEST_CASE("a pair may collide as the rules say, and has the separation of its radii") {
  seeded::Rng random(102);
  for (std::size_t round = 0; round < effort(40); ++round) {
    for (const Layout layout : kLayouts) {
      Scene scene = random_scene(random, layout, 20);
      add_separation(random, scene);
      add_rules(random, scene);
      add_pair_separations(random, scene);
      const Mesh made(scene.elements), mesh = random.one_in(2) ? made : Mesh(made.elements());
      const Parts parts = parts_of(scene.elements);
      REQUIRE(mesh.edges() == parts.edges);
      REQUIRE(mesh.points() == parts.points);
      const std::vector<MeshPair> pairs = all_pairs(scene.elements);
      const std::set<MeshPair> expected(pairs.begin(), pairs.end());
      std::size_t wrong = 0;
      const auto check = [&](const MeshPair& pair) {
        wrong += mesh.may_collide(pair) != (expected.count(pair) != 0) ? 1 : 0;
        wrong += mesh.separation(pair).distance != separation_between(scene, parts, pair) ? 1 : 0;
      };
      const auto edges = static_cast<MeshIndex>(parts.edges.size());
      for (MeshIndex i = 0; i < edges; ++i) {
        for (MeshIndex j = i + 1; j < edges; ++j) check({Kind::edge_edge, i, j});
      }
      for (MeshIndex v = 0; v < 20; ++v) {
        for (MeshIndex f = 0; f < scene.elements.faces.size(); ++f) check({Kind::vertex_face, v, f});
        for (MeshIndex e = 0; e < edges; ++e) check({Kind::point_edge, v, e});
        for (MeshIndex w = v + 1; w < 20; ++w) check({Kind::point_point, v, w});
      }
      CAPTURE(round, scene.name);
      REQUIRE(wrong == 0);
    }
  }
}

TEST_CASE("pairs of a large mesh at rest are those whose boxes touch, by a grid, for any number of threads") {
  // A rough sheet with some 20,000 faces, edges that stand on it, and loose points above it.
  const MeshIndex n = TOUCHSTONE_SLOW_BUILD ? 40 : 100;
  MeshElements elements;
  std::vector<Vec3> x;
  seeded::Rng random(109);
  for (MeshIndex i = 0; i <= n; ++i) {
    for (MeshIndex j = 0; j <= n; ++j)
      x.push_back({i + 0.8 * random.symmetric(), j + 0.8 * random.symmetric(), random.symmetric()});
  }
  for (MeshIndex i = 0; i < n; ++i) {
    for (MeshIndex j = 0; j < n; ++j) {
      const MeshIndex v = i * (n + 1) + j;
      elements.faces.push_back({v, v + n + 1, v + n + 2});
      elements.faces.push_back({v, v + n + 2, v + 1});
    }
  }
  for (MeshIndex v = 0; v < n * n; v += 3) {
    elements.edges.push_back({v, static_cast<MeshIndex>(x.size())});
    x.push_back({x[v].x + random.symmetric(), x[v].y, x[v].z + 1});
    x.push_back({x[v].x, x[v].y + random.symmetric(), x[v].z + random.symmetric()});  // loose
  }
  elements.vertex_count = x.size();
  const Mesh mesh(elements);

  std::vector<broad_phase::Box> edges, vertices, faces;
  const auto box_of = [&](const auto& corners) {
    broad_phase::Box box = broad_phase::empty_box();
    for (const MeshIndex corner : corners) broad_phase::extend(box, x[corner]);
    return box;
  };
  for (const auto& edge : mesh.edges()) edges.push_back(box_of(edge));
  for (const auto& face : mesh.faces()) faces.push_back(box_of(face));
  for (MeshIndex v = 0; v < x.size(); ++v) vertices.push_back(box_of(std::array{v}));
  std::vector<MeshPair> expected;
  const auto add = [&](Kind kind, MeshIndex i, MeshIndex j) {
    if (mesh.may_collide({kind, i, j})) expected.push_back({kind, i, j});
  };
  broad_phase::for_each_overlap(edges, [&](MeshIndex i, MeshIndex j) { add(Kind::edge_edge, i, j); });
  broad_phase::for_each_overlap(vertices, faces, [&](MeshIndex i, MeshIndex j) { add(Kind::vertex_face, i, j); });
  broad_phase::for_each_overlap(vertices, edges, [&](MeshIndex i, MeshIndex j) { add(Kind::point_edge, i, j); });
  broad_phase::for_each_overlap(vertices, [&](MeshIndex i, MeshIndex j) { add(Kind::point_point, i, j); });
  std::sort(expected.begin(), expected.end());
  CHECK(expected.size() > (TOUCHSTONE_SLOW_BUILD ? 5'000U : 60'000U));
  const auto at_rest = intersections(mesh, x);
  for (const int threads : {1, 2, 16}) {
    CAPTURE(threads);
    CHECK((candidates(mesh, x, x, {threads}) == expected));
    CHECK(same_bytes(intersections(mesh, x, {threads}), at_rest));
    CHECK(intersects(mesh, x, {threads}));
  }
}

TEST_CASE("1 to 64 threads give the same bytes") {
  seeded::Rng random(103);
  std::size_t contacts = 0, crossings = 0;
  for (const Layout layout : kLayouts) {
    Scene scene = random_scene(random, layout, TOUCHSTONE_SLOW_BUILD ? 40 : 100);
    add_separation(random, scene);
    const Mesh mesh(scene.elements);
    FirstContactOptions options;
    const FirstContact first = first_contact(mesh, scene.start(), scene.end(), options);
    const auto all = all_contacts(mesh, scene.start(), scene.end(), options);
    const auto near = candidates(mesh, scene.start(), scene.end(), options);
    const auto at_rest = intersections(mesh, scene.start(), options);
    contacts += all.size();
    crossings += at_rest.size();
    for (const int threads : {2, 3, 16, 64, 0}) {
      CAPTURE(scene.name, threads);
      options.threads = threads;
      CHECK(same_bytes(first_contact(mesh, scene.start(), scene.end(), options), first));
      CHECK(same_bytes(all_contacts(mesh, scene.start(), scene.end(), options), all));
      CHECK(candidates(mesh, scene.start(), scene.end(), options) == near);
      CHECK(same_bytes(intersections(mesh, scene.start(), options), at_rest));
      CHECK(intersects(mesh, scene.start(), options) == !at_rest.empty());
    }
  }
  CHECK(contacts > 50);
  CHECK(crossings > (TOUCHSTONE_SLOW_BUILD ? 10U : 50U));  // the scenes of slow builds are smaller
}

TEST_CASE("shuffled vertices and faces give the same time and the same pairs") {
  seeded::Rng random(104);
  int contacts = 0, shortened = 0;
  for (std::size_t round = 0; round < effort(60); ++round) {
    Scene scene = random_scene(random, kLayouts[round % kLayouts.size()], 40);
    if (random.one_in(2)) add_separation(random, scene);
    const auto count = scene.elements.vertex_count;
    std::vector<MeshIndex> renamed(count);
    std::iota(renamed.begin(), renamed.end(), MeshIndex{0});
    for (std::size_t i = count; i > 1; --i) std::swap(renamed[i - 1], renamed[random.below(i)]);
    Scene shuffled = scene;
    const auto n = static_cast<std::size_t>(scene.elements.dimension);
    for (std::size_t v = 0; v < count; ++v) {
      for (std::size_t k = 0; k < n; ++k) {
        shuffled.x0[renamed[v] * n + k] = scene.x0[v * n + k];
        shuffled.x1[renamed[v] * n + k] = scene.x1[v * n + k];
      }
    }
    const auto rename = [&](auto& elements) {
      for (auto& element : elements) {
        for (MeshIndex& v : element) v = renamed[v];
        std::rotate(element.begin(), element.begin() + 1, element.end());
      }
      for (std::size_t i = elements.size(); i > 1; --i) std::swap(elements[i - 1], elements[random.below(i)]);
    };
    rename(shuffled.elements.faces);
    rename(shuffled.elements.edges);
    for (std::size_t v = 0; v < scene.elements.radii.size(); ++v) {
      shuffled.elements.radii[renamed[v]] = scene.elements.radii[v];
    }
    const Mesh one(scene.elements), other(shuffled.elements);
    const FirstContact a = first_contact(one, scene.start(), scene.end());
    const FirstContact b = first_contact(other, shuffled.start(), shuffled.end());
    CAPTURE(round, scene.name);
    REQUIRE(a.toi == b.toi);
    REQUIRE(a.toi_upper == b.toi_upper);
    const auto corners = [&](const Mesh& mesh, const std::vector<MeshContact>& found, bool rename_them) {
      std::set<std::set<MeshIndex>> sets;
      for (const MeshContact& contact : found) {
        std::set<MeshIndex> set;
        const auto c = mesh.corners(contact.pair);
        for (std::size_t i = 0; i < corner_count(contact.pair.kind); ++i)
          set.insert(rename_them ? renamed[c[i]] : c[i]);
        sets.insert(set);
      }
      return sets;
    };
    REQUIRE(corners(one, a.earliest, true) == corners(other, b.earliest, false));
    REQUIRE(corners(one, a.at_start, true) == corners(other, b.at_start, false));

    // The same crossings at rest, and the same free step.
    const auto crossings = [&](const Mesh& mesh, const Scene& of, bool rename_them) {
      std::multiset<std::tuple<std::set<MeshIndex>, bool>> sets;
      for (const Intersection& found : intersections(mesh, of.start())) {
        std::set<MeshIndex> set;
        const auto add = [&](MeshElement element, MeshIndex number) {
          const auto put = [&](MeshIndex v) { set.insert(rename_them ? renamed[v] : v); };
          if (element == MeshElement::vertex) put(number);
          if (element == MeshElement::edge) std::for_each_n(mesh.edges()[number].begin(), 2, put);
          if (element == MeshElement::face) std::for_each_n(mesh.faces()[number].begin(), 3, put);
        };
        add(found.first_element, found.first);
        add(found.second_element, found.second);
        sets.insert({set, found.sort == IntersectionSort::pierces});
      }
      return sets;
    };
    REQUIRE(crossings(one, scene, true) == crossings(other, shuffled, false));
    const FreeStep step = free_step(one, scene.start(), scene.end());
    const FreeStep same = free_step(other, shuffled.start(), shuffled.end());
    REQUIRE(step.outcome == same.outcome);
    REQUIRE(step.length == same.length);
    for (std::size_t v = 0; v < count; ++v) {
      for (std::size_t k = 0; k < n; ++k) REQUIRE(same.positions[renamed[v] * n + k] == step.positions[v * n + k]);
    }
    shortened += step.outcome == StepOutcome::shortened ? 1 : 0;
    contacts += a.contact ? 1 : 0;
  }
  CHECK((contacts > 0 || !whole_effort("a contact is seen")));
  CHECK((shortened > 0 || !whole_effort("a step is shortened")));
}

TEST_CASE("a mesh in two parts meets as its parts do, each by itself and with the other") {
  seeded::Rng random(105);
  int between_parts = 0;
  for (std::size_t round = 0; round < effort(60); ++round) {
    const Layout layout = kLayouts[round % kLayouts.size()];
    Scene a = random_scene(random, layout, 16), b = random_scene(random, layout, 16);
    Scene merged = a;
    const auto shift = static_cast<MeshIndex>(a.elements.vertex_count);
    merged.elements.vertex_count += b.elements.vertex_count;
    for (auto face : b.elements.faces) {
      for (MeshIndex& v : face) v += shift;
      merged.elements.faces.push_back(face);
    }
    for (auto edge : b.elements.edges) {
      for (MeshIndex& v : edge) v += shift;
      merged.elements.edges.push_back(edge);
    }
    merged.x0.insert(merged.x0.end(), b.x0.begin(), b.x0.end());
    merged.x1.insert(merged.x1.end(), b.x1.begin(), b.x1.end());
    for (std::size_t v = 0; v < merged.elements.vertex_count; ++v) merged.elements.rules.groups.push_back(v >= shift);
    const auto first_of = [&](GroupRule rule, std::vector<std::array<MeshIndex, 2>> pairs) {
      merged.elements.rules.group_rule = rule;
      merged.elements.rules.group_pairs = std::move(pairs);
      return first_contact(Mesh(merged.elements), merged.start(), merged.end());
    };
    const auto time = [](const FirstContact& f) { return std::tuple(f.toi, f.toi_upper); };
    const auto all = first_of(GroupRule::all_but_listed, {});
    const auto between = first_of(GroupRule::only_listed, {{1, 0}});
    const auto apart = first_of(GroupRule::all_but_listed, {{0, 1}});
    const auto of_a = first_contact(Mesh(a.elements), a.start(), a.end());
    const auto of_b = first_contact(Mesh(b.elements), b.start(), b.end());
    CAPTURE(round);
    REQUIRE(time(apart) == std::min(time(of_a), time(of_b)));
    REQUIRE(time(all) == std::min(time(apart), time(between)));
    REQUIRE(all.at_start.size() == of_a.at_start.size() + of_b.at_start.size() + between.at_start.size());
    between_parts += between.contact ? 1 : 0;
  }
  CHECK((between_parts > 0 || !whole_effort("a contact between the parts is seen")));
}
