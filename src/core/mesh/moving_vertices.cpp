// SPDX-License-Identifier: MIT
#include "mesh/moving_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "numbers/doubles/decimal_text.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::mesh {
namespace {

void check_shape(const Mesh::Impl& mesh, const Positions& x, const std::string& when) {
  const auto fail = [&](const std::string& what) { throw InvalidQuery("the positions" + when + ", " + what); };
  if (x.dimension != mesh.dimension) {
    fail("which have " + std::to_string(x.dimension) + " coordinates a vertex, do not fit a mesh in " +
         std::to_string(mesh.dimension) + " dimensions");
  }
  if (x.count != mesh.vertex_count) {
    fail("which are those of " + std::to_string(x.count) + " vertices, do not fit a mesh of " +
         std::to_string(mesh.vertex_count) + " vertices");
  }
  if (x.data == nullptr && x.floats == nullptr && x.count > 0) {
    fail("which have no data, do not fit a mesh with vertices");
  }
}

double coordinate(const Positions& x, std::size_t vertex, int k) noexcept {
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(vertex) * x.vertex_stride + k * x.coordinate_stride;
  return x.data != nullptr ? x.data[at] : static_cast<double>(x.floats[at]);
}

Vec3 vertex_at(const Positions& x, std::size_t vertex) noexcept {
  return {coordinate(x, vertex, 0), coordinate(x, vertex, 1), x.dimension == 3 ? coordinate(x, vertex, 2) : 0};
}

bool is_finite(const Vec3& v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

[[noreturn]] void throw_not_finite(std::size_t vertex, const Vec3& at, const char* when) {
  const double coordinates[3] = {at.x, at.y, at.z};
  std::size_t axis = 0;
  while (std::isfinite(coordinates[axis])) ++axis;
  refuse_coordinate(vertex, axis, coordinates[axis], when, "; coordinates must be finite");
}

TOUCHSTONE_BEHIND_GUARD void check_finite(const Motion& motion, const char* start) {
  for (std::size_t v = 0; v < motion.size(); ++v) {
    if (!is_finite(motion[v].start)) throw_not_finite(v, motion[v].start, start);
  }
  for (std::size_t v = 0; v < motion.size(); ++v) {
    if (!is_finite(motion[v].end)) throw_not_finite(v, motion[v].end, kAtEnd);
  }
}

}  // namespace

void refuse_coordinate(std::size_t vertex, std::size_t axis, double value, const char* when, const std::string& fault) {
  throw InvalidQuery("vertex " + std::to_string(vertex) + " has " + "xyz"[axis] + " = " + numbers::decimal_text(value) +
                     when + fault);
}

void set_motion(Motion& motion, const Mesh::Impl& mesh, const Positions& x0, const Positions& x1, int threads) {
  threads::validate_threads(threads);
  const char* const start = &x0 == &x1 ? "" : kAtStart;  // the same object: at rest
  check_shape(mesh, x0, start);
  check_shape(mesh, x1, kAtEnd);
  motion.resize(mesh.vertex_count);
  constexpr std::size_t kVerticesAtATime = 4096;
  threads::for_each_range(motion.size(), kVerticesAtATime, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) motion[v] = {vertex_at(x0, v), vertex_at(x1, v)};
  });
  check_finite(motion, start);
}

Motion motion_of(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1, int threads) {
  Motion motion;
  set_motion(motion, mesh, x0, x1, threads);
  return motion;
}

namespace {

/// The median of some numbers, evenly by their places; 0 of none.
template <class NumberAt>
double usual(std::size_t count, const NumberAt& number_at) {
  constexpr std::size_t kMost = 1001;
  const std::size_t taken = std::min(kMost, count);
  if (taken == 0) return 0;
  std::vector<double> numbers(taken);
  for (std::size_t i = 0; i < taken; ++i) numbers[i] = number_at(i * count / taken);
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(taken / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

}  // namespace

double usual_edge_length(const Mesh::Impl& mesh, const Motion& motion) {
  return usual(mesh.edges.size(), [&](std::size_t e) {
    const Vec3 &a = motion[mesh.edges[e][0]].start, &b = motion[mesh.edges[e][1]].start;
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  });
}

namespace {

Vec3 usual_way(const Motion& motion) {
  const auto along = [&](double Vec3::*axis) {
    return usual(motion.size(), [&](std::size_t v) { return way_of(motion[v]).*axis; });
  };
  return {along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)};
}

/// The length of way - beside, or a little more; infinity where a coordinate overflows. A coordinate of the difference
/// is off by less than 2^-51 of the greatest one of the two.
double length_beside(const Vec3& way, const Vec3& beside) noexcept {
  double largest = 0;
  for (const double x : {way.x, way.y, way.z, beside.x, beside.y, beside.z}) largest = std::max(largest, std::fabs(x));
  const double length = std::hypot(way.x - beside.x, way.y - beside.y, way.z - beside.z) + 0x1p-48 * largest;
  constexpr double kMost = std::numeric_limits<double>::max();
  return length <= kMost ? length : std::numeric_limits<double>::infinity();  // of NaN, too
}

}  // namespace

std::vector<double> lengths_beside_usual_way(const Motion& motion) {
  const Vec3 beside = usual_way(motion);
  std::vector<double> lengths;
  lengths.reserve(motion.size());
  for (const MovingVertex& vertex : motion) lengths.push_back(length_beside(way_of(vertex), beside));
  return lengths;
}

double usual_length_beside_usual_way(const Motion& motion) {
  const Vec3 beside = usual_way(motion);
  return usual(motion.size(), [&](std::size_t v) { return length_beside(way_of(motion[v]), beside); });
}

Query query_of(const Motion& motion, Kind kind, const std::array<Index, 4>& corners) noexcept {
  Query query;
  query.kind = kind;
  for (std::size_t c = 0; c < corner_count(kind); ++c) {
    query.start[c] = motion[corners[c]].start;
    query.end[c] = motion[corners[c]].end;
  }
  return query;
}

}  // namespace touchstone::mesh

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

Query query_of(const Mesh& mesh, const MeshPair& pair, const Positions& x0, const Positions& x1) {
  mesh::check_shape(mesh.impl(), x0, "t = 0");
  mesh::check_shape(mesh.impl(), x1, "t = 1");
  const auto corners = mesh.corners(pair);
  Query query;
  query.kind = pair.kind;
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    query.start[c] = mesh::vertex_at(x0, corners[c]);
    query.end[c] = mesh::vertex_at(x1, corners[c]);
  }
  return query;
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
