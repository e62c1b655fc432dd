// The drop-in has the functions and types that programs written for Tight-Inclusion use, with the same signatures.
// SPDX-License-Identifier: MIT
#include <tight_inclusion/ccd.hpp>
#include <tight_inclusion/interval_root_finder.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/catch.hpp"

namespace {

using V = const Eigen::Vector3d&;
using A = const Eigen::Array3d&;

// Each function is given to a pointer whose type is written here, without the drop-in's own names for the types.
using Ccd = bool (*)(V, V, V, V, V, V, V, V, A, double, double&, double, double, long, double&, bool,
                     ticcd::CCDRootFindingMethod);
static_assert(std::is_same_v<decltype(&ticcd::edgeEdgeCCD), Ccd>);
static_assert(std::is_same_v<decltype(&ticcd::vertexFaceCCD), Ccd>);

using Tolerances = Eigen::Array3d (*)(V, V, V, V, V, V, V, V, double);
static_assert(std::is_same_v<decltype(&ticcd::compute_edge_edge_tolerances), Tolerances>);
static_assert(std::is_same_v<decltype(&ticcd::compute_vertex_face_tolerances), Tolerances>);

using DepthFirst = bool (*)(V, V, V, V, V, V, V, V, A, A, double, double&);
static_assert(std::is_same_v<decltype(&ticcd::edge_edge_interval_root_finder_DFS), DepthFirst>);
static_assert(std::is_same_v<decltype(&ticcd::vertex_face_interval_root_finder_DFS), DepthFirst>);

using BreadthFirst = bool (*)(V, V, V, V, V, V, V, V, A, double, A, double, double, long, double&, double&);
static_assert(std::is_same_v<decltype(&ticcd::edge_edge_interval_root_finder_BFS), BreadthFirst>);
static_assert(std::is_same_v<decltype(&ticcd::vertex_face_interval_root_finder_BFS), BreadthFirst>);

using ErrorBound = Eigen::Array3d (*)(const std::vector<Eigen::Vector3d>&, bool, bool);
static_assert(std::is_same_v<decltype(&ticcd::get_numerical_error), ErrorBound>);
static_assert(std::is_same_v<decltype(&ticcd::print_times), void (*)()>);
static_assert(std::is_same_v<decltype(&ticcd::return_queue_size), long (*)()>);

static_assert(std::is_same_v<ticcd::Scalar, double>);
static_assert(std::is_same_v<ticcd::Vector3, Eigen::Vector3d>);
static_assert(std::is_same_v<ticcd::Array3, Eigen::Array3d>);
static_assert(std::is_enum_v<ticcd::CCDRootFindingMethod> && !std::is_convertible_v<ticcd::CCDRootFindingMethod, int>);
static_assert(ticcd::DEFAULT_CCD_DISTANCE_TOL == 1e-6 && !ticcd::DEFAULT_NO_ZERO_TOI);

static_assert(std::is_same_v<decltype(&ticcd::power), std::uint64_t (*)(std::uint64_t, std::uint8_t)>);
static_assert(std::is_same_v<decltype(&ticcd::pow2), std::uint64_t (*)(std::uint8_t)>);
static_assert(std::is_same_v<decltype(&ticcd::reduction), std::uint8_t (*)(std::uint64_t, std::uint64_t&)>);
static_assert(std::is_same_v<decltype(ticcd::NumCCD::numerator), std::uint64_t>);
static_assert(std::is_same_v<decltype(ticcd::NumCCD::denom_power), std::uint8_t>);
static_assert(
    std::is_same_v<decltype(&ticcd::NumCCD::is_sum_leq_1), bool (*)(const ticcd::NumCCD&, const ticcd::NumCCD&)>);
static_assert(std::is_convertible_v<ticcd::NumCCD, double> && std::is_convertible_v<double, ticcd::NumCCD>);
static_assert(std::is_same_v<decltype(&ticcd::Interval::bisect),
                             std::pair<ticcd::Interval, ticcd::Interval> (ticcd::Interval::*)() const>);
static_assert(std::is_same_v<ticcd::Interval3, std::array<ticcd::Interval, 3>>);
static_assert(std::is_same_v<decltype(&ticcd::width), Eigen::Array3d (*)(const ticcd::Interval3&)>);

#ifndef TIGHT_INCLUSION_WITH_DOUBLE_PRECISION
#error "programs ask for the precision by this macro"
#endif

}  // namespace

TEST_CASE("a program may leave out the last arguments, give rows of a matrix, and use no result") {
  Eigen::Matrix<double, 8, 3, Eigen::RowMajor> rows;
  rows << -1, 0, 1, 1, 0, 1, 0, -1, 0, 0, 1, 0,  //
      -1, 0, -1, 1, 0, -1, 0, -1, 0, 0, 1, 0;
  double toi = -1, output_tolerance = -1;
  CHECK(ticcd::edgeEdgeCCD(rows.row(0), rows.row(1), rows.row(2), rows.row(3), rows.row(4), rows.row(5), rows.row(6),
                           rows.row(7), Eigen::Array3d(-1, -1, -1), 0, toi, 1e-6, 1, 1000000, output_tolerance));
  CHECK(toi == 0.5);
  CHECK(output_tolerance == 1e-6);
  const ticcd::Array3 tolerances = ticcd::compute_edge_edge_tolerances(
      rows.row(0), rows.row(1), rows.row(2), rows.row(3), rows.row(4), rows.row(5), rows.row(6), rows.row(7));
  CHECK((tolerances > 0).all());
  CHECK(ticcd::return_queue_size() == 0);
  ticcd::print_times();
}

TEST_CASE("the root finders are templates of the kind of query too") {
  const Eigen::Vector3d f0(-1, -1, 0), f1(1, -1, 0), f2(0, 1, 0), above(0, 0, 3), below(0, 0, -1);
  const Eigen::Array3d none = Eigen::Array3d::Zero();
  double toi = -1, output_tolerance = -1;
  CHECK(ticcd::interval_root_finder_DFS<true>(above, f0, f1, f2, below, f0, f1, f2, none, none, 0, toi));
  CHECK(toi == 0.75);
  CHECK_FALSE(ticcd::interval_root_finder_BFS<true>(above, f0, f1, f2, below, f0, f1, f2, none, 1e-6, none, 0, 0.5, -1,
                                                    toi, output_tolerance));
  CHECK(toi == std::numeric_limits<double>::infinity());
  CHECK(output_tolerance == 1e-6);
}
