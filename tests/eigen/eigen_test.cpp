// The Eigen overloads copy every coordinate to the right corner, bit for bit, from every type of Eigen's vectors.
// SPDX-License-Identifier: MIT
#include <Eigen/Dense>

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <vector>

#include <touchstone/eigen.hpp>
#include <touchstone/touchstone.hpp>

#include "support/catch.hpp"

using Eigen::MatrixXd;
using Eigen::RowVector3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using touchstone::Vec3;

namespace {

bool same_bits(const Vec3& a, const Vec3& b) { return std::memcmp(&a, &b, sizeof(Vec3)) == 0; }

/// Corner i of N x 3 numbered coordinates, as `numbered` fills them.
Vec3 numbered_corner(int i, double offset) { return {offset + 3 * i, offset + 3 * i + 1, offset + 3 * i + 2}; }

MatrixXd numbered(int corners, double offset) {
  MatrixXd m(corners, 3);
  for (int i = 0; i < corners; ++i) {
    const Vec3 corner = numbered_corner(i, offset);
    m.row(i) << corner.x, corner.y, corner.z;
  }
  return m;
}

template <typename QueryType>
void check_numbered(const QueryType& query) {
  for (std::size_t i = 0; i < query.start.size(); ++i) {
    CAPTURE(i);
    CHECK(same_bits(query.start[i], numbered_corner(static_cast<int>(i), 0)));
    CHECK(same_bits(query.end[i], numbered_corner(static_cast<int>(i), 100)));
  }
}

}  // namespace

TEST_CASE("a corner keeps its bits, whatever kind of Eigen vector it comes from") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Vec3 expected{-0.0, tiny, 1e300};
  const Vector3d column(-0.0, tiny, 1e300);
  const RowVector3d row = column.transpose();
  const VectorXd dynamic = column;
  const double memory[5] = {-0.0, 7, tiny, 7, 1e300};
  MatrixXd columns(3, 2);
  columns << column, column;

  CHECK(same_bits(touchstone::to_vec3(column), expected));
  CHECK(same_bits(touchstone::to_vec3(row), expected));
  CHECK(same_bits(touchstone::to_vec3(dynamic), expected));
  CHECK(same_bits(touchstone::to_vec3(column.array()), expected));
  CHECK(same_bits(touchstone::to_vec3(columns.col(1)), expected));
  CHECK(same_bits(touchstone::to_vec3(columns.transpose().row(1)), expected));
  CHECK(same_bits(touchstone::to_vec3(dynamic.head<3>()), expected));
  CHECK(same_bits(touchstone::to_vec3(Eigen::Map<const Vector3d, 0, Eigen::InnerStride<2>>(memory)), expected));
  CHECK(same_bits(touchstone::to_vec3(Eigen::Ref<const Vector3d>(column)), expected));
}

TEST_CASE("an expression is evaluated") {
  const Vector3d a(1, 2, 3);
  const Vector3d b(10, 20, 30);
  Eigen::Matrix3d swap;
  swap << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  CHECK(same_bits(touchstone::to_vec3(a + 2 * b), Vec3{21, 42, 63}));
  CHECK(same_bits(touchstone::to_vec3(swap * a), Vec3{2, 1, 3}));
  CHECK(same_bits(touchstone::to_vec3(Vector3d::Zero()), Vec3{0, 0, 0}));
  CHECK(same_bits(touchstone::to_vec3(a.cast<float>().cast<double>()), Vec3{1, 2, 3}));
}

TEST_CASE("two coordinates lie in the plane z = 0") {
  CHECK(same_bits(touchstone::to_vec3(Vector2d(4, 5)), Vec3{4, 5, 0}));
  CHECK(same_bits(touchstone::to_vec3(VectorXd(Vector2d(4, 5))), Vec3{4, 5, 0}));
  MatrixXd flat(2, 2);
  flat << 1, 2, 3, 4;
  const touchstone::PointPoint query = touchstone::point_point(flat, flat);
  CHECK(same_bits(query.start[1], Vec3{3, 4, 0}));
}

TEST_CASE("a dynamic size that is no corner's is an error that names it") {
  CHECK_THROWS_AS(touchstone::to_vec3(VectorXd(4)), touchstone::InvalidQuery);
  CHECK_THROWS_AS(touchstone::edge_edge(MatrixXd(3, 3), MatrixXd(4, 3)), touchstone::InvalidQuery);
  CHECK_THROWS_WITH(touchstone::edge_edge(MatrixXd(4, 3), MatrixXd(4, 1)),
                    "the corners are 4 x 1, not 4 rows of two or three coordinates");
}

TEST_CASE("every corner of every kind of query lands in its place") {
  const MatrixXd start = numbered(4, 0);
  const MatrixXd end = numbered(4, 100);
  const auto s = [&](int i) { return start.row(i); };
  const auto e = [&](int i) { return Vector3d(end.row(i)); };

  check_numbered(touchstone::edge_edge(start, end));
  check_numbered(touchstone::vertex_face(start, end));
  check_numbered(touchstone::point_edge(start.topRows(3), end.topRows<3>()));
  check_numbered(touchstone::point_point(start.topRows(2), end.topRows<2>()));
  check_numbered(touchstone::edge_edge(Eigen::Matrix<double, 4, 3, Eigen::RowMajor>(start), end));

  check_numbered(touchstone::edge_edge(s(0), s(1), s(2), s(3), e(0), e(1), e(2), e(3)));
  check_numbered(touchstone::vertex_face(s(0), s(1), s(2), s(3), e(0), e(1), e(2), e(3)));
  check_numbered(touchstone::point_edge(s(0), s(1), s(2), e(0), e(1), e(2)));
  check_numbered(touchstone::point_point(s(0), s(1), e(0), e(1)));
}

TEST_CASE("a query from Eigen is solved, and its weights go back to Eigen") {
  Eigen::Matrix<double, 4, 3> start;
  start << -1, 0, 0, 1, 0, 0, 0, -1, 1, 0, 1, 1;
  Eigen::Matrix<double, 4, 3> end = start;
  end.bottomRows<2>().col(2).setConstant(-1);
  const touchstone::Answer answer = touchstone::solve(touchstone::edge_edge(start, end));
  REQUIRE(answer.contact);
  CHECK(answer.toi == 0.5);
  CHECK(touchstone::to_eigen(answer.weights_a) == Vector3d(0.5, 0.5, 0));
  CHECK(touchstone::to_eigen(Vec3{1, 2, 3}) == Vector3d(1, 2, 3));
}

TEST_CASE("positions and elements of a mesh are those of matrices, in either storage order") {
  const MatrixXd by_columns = numbered(5, 0);
  const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> by_rows = by_columns;
  const auto at = [](const touchstone::Positions& x, int vertex, int k) {
    return x.data[vertex * x.vertex_stride + k * x.coordinate_stride];
  };
  for (int vertex = 0; vertex < 5; ++vertex) {
    for (int k = 0; k < 3; ++k) {
      CHECK(at(touchstone::to_positions(by_columns), vertex, k) == by_columns(vertex, k));
      CHECK(at(touchstone::to_positions(by_rows), vertex, k) == by_columns(vertex, k));
      if (vertex < 3)
        CHECK(at(touchstone::to_positions(by_rows.middleRows(2, 3)), vertex, k) == by_rows(vertex + 2, k));
      if (k < 2) CHECK(at(touchstone::to_positions(by_columns.rightCols(2)), vertex, k) == by_columns(vertex, k + 1));
    }
  }
  CHECK(touchstone::to_positions(by_columns).count == 5);
  const Eigen::MatrixXf floats = by_columns.cast<float>();
  const touchstone::Positions view = touchstone::to_positions(floats);
  CHECK(view.data == nullptr);
  CHECK(view.floats[2 * view.vertex_stride + view.coordinate_stride] == floats(2, 1));
  CHECK(touchstone::to_positions(by_columns.leftCols<2>()).dimension == 2);
  CHECK_THROWS_AS(touchstone::to_positions(by_columns.leftCols(1)), touchstone::InvalidQuery);

  Eigen::MatrixXi faces(2, 3);
  faces << 0, 1, 2, 2, 1, 3;
  CHECK(touchstone::to_elements<3>(faces) == std::vector<std::array<touchstone::MeshIndex, 3>>{{0, 1, 2}, {2, 1, 3}});
  CHECK_THROWS_AS(touchstone::to_elements<2>(faces), touchstone::InvalidMesh);
  faces(1, 2) = -1;
  CHECK_THROWS_AS(touchstone::to_elements<3>(faces), touchstone::InvalidMesh);
  const Eigen::Matrix<std::int64_t, 1, 2> large(0, std::int64_t{1} << 32);
  CHECK_THROWS_AS(touchstone::to_elements<2>(large), touchstone::InvalidMesh);
  CHECK(touchstone::to_elements<2>(Eigen::Matrix<std::uint64_t, 1, 2>(7, 9))[0][1] == 9);

  // A vertex falls on a face: the same answer from columns and from rows.
  MatrixXd start(4, 3);
  start << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1;
  MatrixXd end = start;
  end(3, 2) = -1;
  touchstone::MeshElements elements;
  elements.vertex_count = 4;
  elements.faces = {{0, 1, 2}};
  const touchstone::Mesh mesh(elements);
  const Eigen::Matrix<double, 4, 3, Eigen::RowMajor> end_by_rows = end;
  const auto step = touchstone::free_step(mesh, touchstone::to_positions(start), touchstone::to_positions(end_by_rows));
  CHECK(step.first_contact.toi == 0.5);
  CHECK(touchstone::to_matrix(step.positions)(3, 2) > 0);
  CHECK(touchstone::to_matrix(step.positions).topRows(3) == start.topRows(3));
}

TEST_CASE("meshes of matrices are asked without any view of the caller's own") {
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> floats(5, 3);
  floats << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 2, 2, 2;
  const MatrixXd vertices = floats.cast<double>();
  const Eigen::Matrix<std::uint32_t, 1, 3> faces(0, 1, 2);
  const Eigen::Matrix<std::int64_t, 1, 2> edges(3, 4);
  const touchstone::Mesh mesh = touchstone::make_mesh(vertices, faces, edges);
  CHECK(mesh.faces().size() == 1);
  CHECK(mesh.edges().front() == std::array<touchstone::MeshIndex, 2>{3, 4});
  CHECK(mesh.points().empty());
  CHECK(touchstone::make_mesh(floats, faces).points().size() == 2);
  CHECK(touchstone::make_mesh(vertices, edges).edges().size() == 1);
  CHECK(touchstone::make_mesh(vertices, MatrixXd(0, 3).cast<int>()).points().size() == 5);
  const touchstone::Mesh flat = touchstone::make_mesh(vertices.leftCols(2), edges);
  CHECK(flat.dimension() == 2);
  CHECK_THROWS_AS(touchstone::make_mesh(vertices.leftCols(1), edges), touchstone::InvalidQuery);
  CHECK_THROWS_AS(touchstone::make_mesh(vertices, Eigen::MatrixXi(1, 4)), touchstone::InvalidMesh);

  MatrixXd way = MatrixXd::Zero(5, 3);
  way(3, 2) = -2;
  const auto first = touchstone::first_contact(mesh, vertices, vertices + way);
  CHECK(first.toi == 0.5);
  CHECK(touchstone::first_contact(mesh, floats, vertices + 0.25 * way).free());
  const auto step = touchstone::free_step(mesh, vertices, vertices + way, {});
  CHECK(step.first_contact.toi == 0.5);
  CHECK(touchstone::intersections(mesh, touchstone::to_matrix(step.positions)).empty());
  way(3, 2) = -1;
  CHECK(touchstone::intersections(touchstone::make_mesh(vertices, faces), vertices + way).size() == 1);
  way(3, 2) = -2;
  touchstone::MeshElements elements = touchstone::mesh_elements(vertices, faces, edges);
  elements.separation.distance = 0.5;
  CHECK(touchstone::first_contact(touchstone::Mesh(elements), vertices, vertices + way).toi == 0.25);
}

TEST_CASE("an answer is written for a person") {
  const auto written = [](const touchstone::Answer& answer) {
    std::ostringstream out;
    out << answer;
    CHECK(out.str() == to_string(answer));
    return out.str();
  };
  const touchstone::VertexFace query = {{Vec3{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                        {Vec3{0.25, 0.25, -2}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(written(touchstone::solve(query, 0.25)) == "no contact");
  CHECK(written(touchstone::solve(query)) ==
        "contact at t in [0.3333333333333333, 0.33333333333333337], crossing, v against f");
  touchstone::SolveOptions options;
  options.wanted = touchstone::Wanted::contact;
  CHECK(written(touchstone::solve(query, options)) == "contact");
  touchstone::PointPoint points = {{Vec3{0, 0, 0}, {1, 0, 0}}, {Vec3{0, 0, 0}, {-1, 0, 0}}};
  CHECK(written(touchstone::solve(points)) == "contact at t = 0.5, isolated, p against q");
}
