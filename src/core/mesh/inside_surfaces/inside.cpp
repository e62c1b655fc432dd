// SPDX-License-Identifier: MIT
#include "mesh/inside_surfaces/inside.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <set>
#include <tuple>
#include <utility>

#include "broad_phase/box_tree.hpp"
#include "mesh/contacts.hpp"
#include "mesh/folds.hpp"
#include "mesh/inside_surfaces/pieces.hpp"
#include "mesh/inside_surfaces/ray_passes.hpp"
#include "mesh/mesh_elements.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/integers/exact_number.hpp"
#include "solver/cascade.hpp"

namespace touchstone::mesh {
namespace {

using broad_phase::Box;
using RestingTree = broad_phase::BoxTree<Box>;
using numbers::Exact;
using Point = ExactPoint;

constexpr std::size_t kLeastFaces = 4;  // of a closed surface

/// A closed surface around a piece that it does not meet, with its winding number.
struct Around {
  Index inner, outer;
  int winding = 0;
  bool touches = false;
};

enum class AskedPairs : std::uint8_t { oriented, all };  ///< pairs of oriented surfaces, or pieces in closed surfaces

struct InsideSearch {
  const Mesh::Impl& mesh;
  const Motion& motion;
  int threads;
  const std::atomic<bool>* stop;
  AskedPairs asked;

  bool is_asked(const Piece& piece) const noexcept {
    return asked == AskedPairs::all || piece.sort == PieceSort::oriented;
  }
};

bool is_within(const Box& inner, const Box& outer) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (inner.low[k] < outer.low[k] || outer.high[k] < inner.high[k]) return false;
  }
  return true;
}

/// Calls found(inner, outer) for pieces that are asked about, each in the box around another piece of which is_outer is
/// true. Several threads may call it at the same time.
template <class IsOuter, class Found>
void for_each_nested_box(const InsideSearch& search, const Pieces& pieces, const IsOuter& is_outer,
                         const Found& found) {
  std::vector<Index> inner, outer;
  for (Index i = 0; i < pieces.size(); ++i) {
    if (!search.is_asked(pieces[i])) continue;
    inner.push_back(i);
    if (is_outer(pieces[i])) outer.push_back(i);
  }
  if (outer.empty() || inner.size() < 2) return;
  const auto tree_of = [&](const std::vector<Index>& some) {
    const auto box_of = [&](Index n) { return pieces[some[n]].box; };
    return RestingTree(some.size(), box_of, search.threads);
  };
  const RestingTree outers = tree_of(outer), inners = tree_of(inner);
  broad_phase::for_each_pair_block(outers, inners, {search.threads},
                                   [&](const broad_phase::Pair* pairs, std::size_t count) {
                                     check_stop(search.stop);
                                     for (std::size_t n = 0; n < count; ++n) {
                                       const Index o = outer[pairs[n][0]], i = inner[pairs[n][1]];
                                       if (i != o && is_within(pieces[i].box, pieces[o].box)) found(i, o);
                                     }
                                   });
}

/// The closed surfaces around pieces by their boxes, in ascending order.
std::vector<Around> nested_boxes(const InsideSearch& search, const Pieces& pieces) {
  std::vector<Around> nested;
  std::mutex lock;
  for_each_nested_box(
      search, pieces, [](const Piece& piece) { return piece.is_closed(); },
      [&](Index inner, Index outer) {
        const std::lock_guard<std::mutex> guard(lock);
        nested.push_back({inner, outer});
      });
  std::sort(nested.begin(), nested.end(),
            [](const Around& a, const Around& b) { return std::tie(a.inner, a.outer) < std::tie(b.inner, b.outer); });
  return nested;
}

/// The pairs of pieces that meet, in both orders.
std::set<std::array<Index, 2>> meeting(const Pieces& pieces, const std::vector<Intersection>& all) {
  std::set<std::array<Index, 2>> pairs;
  for (const Intersection& one : all) {
    if (one.sort == IntersectionSort::inside) continue;
    const std::vector<Index> seconds = pieces.of(one.second_element, one.second);
    for (const Index a : pieces.of(one.first_element, one.first)) {
      for (const Index b : seconds) {
        if (a != b) pairs.insert({{a, b}, {b, a}});
      }
    }
  }
  return pairs;
}

/// Finds the winding numbers: by the passes of one ray for each inner piece through the faces of the outer ones. Sums
/// of whole numbers do not depend on their order, so the number of threads does not count.
void find_winding_numbers(const InsideSearch& search, const Pieces& pieces, std::vector<Around>& nested) {
  struct Start {
    Ray ray;
    double last;
    std::size_t begin, end;  // in `nested`
  };
  std::vector<Start> rays;
  std::vector<char> is_outer(pieces.size(), 0);
  for (std::size_t n = 0; n < nested.size(); ++n) {
    const auto& [inner, outer, winding, touches] = nested[n];
    if (n == 0 || nested[n - 1].inner != inner) {
      const auto& [a, b] = pieces[inner].middle;
      rays.push_back({{search.motion[a].start, search.motion[b].start}, pieces[outer].box.high[0], n, n});
    }
    rays.back().last = std::max(rays.back().last, pieces[outer].box.high[0]);
    rays.back().end = n + 1;
    is_outer[outer] = 1;
  }
  std::vector<Index> faces;
  for (std::size_t f = 0; f < search.mesh.faces.size(); ++f) {
    if (is_outer[pieces.of_face(static_cast<Index>(f))] != 0) faces.push_back(static_cast<Index>(f));
  }
  const auto corners_of = [&](Index n) {
    const auto& face = search.mesh.faces[faces[n]];
    return std::array{search.motion[face[0]].start, search.motion[face[1]].start, search.motion[face[2]].start};
  };
  const auto box_of_ray = [&](Index n) { return rays[n].ray.box(rays[n].last); };
  const auto box_of_face = [&](Index n) {
    Box box = broad_phase::empty_box();
    for (const Vec3& corner : corners_of(n)) broad_phase::extend(box, corner);
    return box;
  };
  const RestingTree ray_boxes(rays.size(), box_of_ray, search.threads);
  const RestingTree face_boxes(faces.size(), box_of_face, search.threads);
  std::mutex lock;
  broad_phase::for_each_pair_block(
      ray_boxes, face_boxes, {search.threads}, [&](const broad_phase::Pair* pairs, std::size_t count) {
        check_stop(search.stop);
        for (std::size_t n = 0; n < count; ++n) {
          const Start& start = rays[pairs[n][0]];
          const Index outer = pieces.of_face(faces[pairs[n][1]]);
          const auto end = nested.begin() + static_cast<std::ptrdiff_t>(start.end);
          const auto around = std::lower_bound(nested.begin() + static_cast<std::ptrdiff_t>(start.begin), end, outer,
                                               [](const Around& a, Index number) { return a.outer < number; });
          if (around == end || around->outer != outer) continue;
          const auto corners = corners_of(pairs[n][1]);
          const int winding = passes(start.ray, corners);
          // A piece that is all at one position is on the surfaces with which it shares a vertex.
          const bool touches = same_position(start.ray.a, start.ray.b) &&
                               std::any_of(corners.begin(), corners.end(),
                                           [&](const Vec3& corner) { return same_position(start.ray.a, corner); });
          if (winding == 0 && !touches) continue;
          const std::lock_guard<std::mutex> guard(lock);
          around->winding += winding;
          around->touches = around->touches || touches;
        }
      });
}

/// The closed surfaces around pieces that they do not meet, in ascending order: those whose winding number is not 0.
/// The number is 0 or 1 for a surface that is not oriented.
std::vector<Around> surfaces_around(const InsideSearch& search, const Pieces& pieces,
                                    const std::vector<Intersection>& all) {
  std::vector<Around> nested = nested_boxes(search, pieces);
  if (nested.empty()) return nested;
  const std::set<std::array<Index, 2>> met = meeting(pieces, all);
  std::erase_if(nested, [&](const Around& one) {
    const Piece &inner = pieces[one.inner], &outer = pieces[one.outer];
    return met.count({one.inner, one.outer}) != 0 ||
           (search.mesh.has_rules() &&
            !corners_may_collide(search.mesh, std::array{inner.vertex}, search.mesh.faces[outer.least]));
  });
  find_winding_numbers(search, pieces, nested);
  for (Around& one : nested) one.winding = pieces[one.outer].sort == PieceSort::even ? one.winding & 1 : one.winding;
  std::erase_if(nested, [](const Around& one) { return one.winding == 0 || one.touches; });
  return nested;
}

/// The signs of the volumes that closed surfaces enclose, with their normals outwards. @param volumes  zeros, by piece
std::map<Index, int> signs_of_volumes(const InsideSearch& search, const Pieces& pieces,
                                      std::map<Index, Exact> volumes) {
  for (std::size_t f = 0; !volumes.empty() && f < search.mesh.faces.size(); ++f) {
    const Index piece = pieces.of_face(static_cast<Index>(f));
    const auto volume = volumes.find(piece);
    if (volume == volumes.end()) continue;
    const Point origin = exact(search.motion[pieces[piece].vertex].start);
    const auto corner = [&](std::size_t i) { return exact(search.motion[search.mesh.faces[f][i]].start) - origin; };
    volume->second = volume->second + geometry::dot(corner(0), geometry::cross(corner(1), corner(2)));
  }
  std::map<Index, int> signs;
  for (const auto& [piece, volume] : volumes) signs[piece] = numbers::sign_of(volume);
  return signs;
}

/// The surfaces around one piece.
struct AroundOne {
  Index inner;
  const Around *begin, *end;
  Index outermost;
  int sum = 0;
};

/// By inner pieces, in ascending order. The outermost surface has the fewest ones around itself and, where surfaces
/// meet each other, the box that begins first along x.
std::vector<AroundOne> by_inner(const Pieces& pieces, const std::vector<Around>& all) {
  std::map<Index, int> depth;
  for (const Around& one : all) ++depth[one.inner];
  std::vector<AroundOne> groups;
  const auto order = [&](Index piece) {
    const auto found = depth.find(piece);
    return std::pair(found == depth.end() ? 0 : found->second, pieces[piece].box.low[0]);
  };
  for (const Around& one : all) {
    if (groups.empty() || groups.back().inner != one.inner) groups.push_back({one.inner, &one, &one, one.outer});
    AroundOne& group = groups.back();
    group.end = &one + 1;
    group.sum += one.winding;
    if (order(one.outer) < order(group.outermost)) group.outermost = one.outer;
  }
  return groups;
}

}  // namespace

void add_inside(const Mesh::Impl& mesh, const Motion& motion, int threads, const std::atomic<bool>* stop,
                std::vector<Intersection>& all) {
  if (mesh.faces.size() < 2 * kLeastFaces) return;
  const InsideSearch search{mesh, motion, threads, stop, AskedPairs::oriented};
  const Pieces pieces(mesh, motion);
  const std::vector<Around> around = surfaces_around(search, pieces, all);
  const std::vector<AroundOne> groups = by_inner(pieces, around);
  std::map<Index, Exact> volumes;
  for (const AroundOne& one : groups) volumes[one.inner], volumes[one.outermost];
  const auto signs = signs_of_volumes(search, pieces, std::move(volumes));
  for (const AroundOne& one : groups) {
    const int sign = signs.at(one.inner);
    const bool in_room = signs.at(one.outermost) < 0;
    if (sign == 0 || (sign > 0 ? one.sum + (in_room ? 1 : 0) <= 0 : one.sum >= 0)) continue;
    const Around* const outer = std::find_if(one.begin, one.end, [&](const Around& o) { return o.winding * sign > 0; });
    Intersection found;
    found.first_element = MeshElement::vertex;
    found.first = pieces[one.inner].vertex;
    found.second_element = MeshElement::face;
    found.second = pieces[outer->outer].least;
    found.sort = IntersectionSort::inside;
    all.push_back(found);
  }
}

namespace {

MeshElement element_of(PieceSort sort) noexcept {
  if (sort == PieceSort::point) return MeshElement::vertex;
  return sort == PieceSort::wire ? MeshElement::edge : MeshElement::face;
}

std::vector<EnclosedPart> find_enclosed(const InsideSearch& search, const Pieces& pieces,
                                        const std::vector<Intersection>& found, ClosedParts closed) {
  const std::vector<Around> around = surfaces_around(search, pieces, found);
  std::vector<AroundOne> groups = by_inner(pieces, around);
  const auto is_oriented = [&](Index piece) { return pieces[piece].sort == PieceSort::oriented; };
  std::set<Index> inside;  // the vertices of surfaces that `intersections` says to be inside another one
  for (const Intersection& one : found) {
    if (one.sort == IntersectionSort::inside && closed == ClosedParts::unasked) inside.insert(one.first);
  }
  std::erase_if(groups, [&](const AroundOne& one) {
    return pieces[one.inner].is_closed() && inside.count(pieces[one.inner].vertex) != 0;
  });
  std::map<Index, Exact> rooms;  // where it counts whether the outermost surface is one
  for (const AroundOne& one : groups) {
    if (one.sum == 0 && is_oriented(one.outermost)) rooms[one.outermost];
  }
  const auto signs = signs_of_volumes(search, pieces, std::move(rooms));
  std::vector<EnclosedPart> enclosed;
  for (const AroundOne& one : groups) {
    const auto room = signs.find(one.outermost);
    if (one.sum == 0 && (room == signs.end() || room->second >= 0)) continue;
    EnclosedPart& piece = enclosed.emplace_back();
    piece.element = element_of(pieces[one.inner].sort);
    piece.vertex = pieces[one.inner].vertex;
    std::for_each(one.begin, one.end, [&](const Around& o) { piece.faces.push_back(pieces[o.outer].least); });
  }
  std::stable_sort(enclosed.begin(), enclosed.end(),
                   [](const EnclosedPart& a, const EnclosedPart& b) { return a.vertex < b.vertex; });
  return enclosed;
}

std::size_t count_in_open(const InsideSearch& search, const Pieces& pieces) {
  std::vector<std::atomic<bool>> in_open(pieces.size());
  for_each_nested_box(
      search, pieces, [](const Piece& piece) { return piece.sort == PieceSort::open && !piece.branches; },
      [&](Index inner, Index) { in_open[inner].store(true, std::memory_order_relaxed); });
  return static_cast<std::size_t>(std::count(in_open.begin(), in_open.end(), true));
}

TOUCHSTONE_BEHIND_GUARD Insides find_insides(const Mesh::Impl& mesh, const Positions& x, const MeshOptions& options,
                                             const std::vector<Intersection>& found, ClosedParts closed) {
  if (mesh.faces.empty()) return {};
  const Motion motion = motion_of(mesh, x, x, options.threads);
  const InsideSearch search{mesh, motion, options.threads, options.stop, AskedPairs::all};
  const Pieces pieces(mesh, motion);
  return {find_enclosed(search, pieces, found, closed), pieces.branching(), count_in_open(search, pieces)};
}

}  // namespace
}  // namespace touchstone::mesh

namespace touchstone {

Insides insides(const Mesh& mesh, const Positions& x, const MeshOptions& options,
                const std::vector<Intersection>& found, ClosedParts closed) {
  const numbers::DefaultFloatEnvironment environment;
  return mesh::find_insides(mesh.impl(), x, options, found, closed);
}

}  // namespace touchstone
