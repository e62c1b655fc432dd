// Multigrid for large sheets, against dense and sparse factors of the same matrices.
// SPDX-License-Identifier: MIT
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <limits>

#include "cloth/cloth_scenes.hpp"
#include "linear/multigrid.hpp"
#include "linear/sparse_solver.hpp"
#include "support/catch.hpp"

using namespace touchstone::linear;
using touchstone::seeded::Rng;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

namespace {

/// A sheet's mesh with a mass at each point, and forces that pull at the points of a triangle or hinge.
struct Net {
  struct Pull {
    std::size_t block;
    Vector along;
  };
  Blocks blocks;                 // the unknowns of each triangle or hinge
  std::vector<Pull> pulls;       // the matrix is the sum of these times their transposes
  std::vector<int> coordinates;  // of each unknown
  Vector mass;                   // of each unknown
  int size() const { return static_cast<int>(coordinates.size()); }

  Eigen::SparseMatrix<double> matrix() const {
    std::vector<Eigen::Triplet<double>> all;
    for (int i = 0; i < size(); ++i) all.emplace_back(i, i, mass[i]);
    for (const auto& [block, along] : pulls) {
      for (Eigen::Index a = 0; a < along.size(); ++a) {
        for (Eigen::Index b = 0; b < along.size(); ++b) {
          const int row = blocks[block][static_cast<std::size_t>(a)],
                    column = blocks[block][static_cast<std::size_t>(b)];
          if (row >= 0 && column >= 0) all.emplace_back(row, column, along[a] * along[b]);
        }
      }
    }
    Eigen::SparseMatrix<double> sum(size(), size());
    sum.setFromTriplets(all.begin(), all.end());
    return sum;
  }

  /// A block for an element with these points, and its place.
  std::size_t add_block(const std::vector<int>& unknown, const auto& points) {
    blocks.emplace_back();
    for (const auto p : points) {
      for (std::size_t axis = 0; axis < 3; ++axis) blocks.back().push_back(unknown[3 * p + axis]);
    }
    return blocks.size() - 1;
  }
};

/// Springs in random directions along a sheet's edges.
/// @param mass   relative to the springs
/// @param holes  the part of coordinates that are no unknowns
Net random_net(Rng& random, touchstone::sim::Index columns, double mass, double holes) {
  const touchstone::sim::SheetScene sheet = touchstone::sim::sheet_scene(1, 1, columns);
  const touchstone::sim::System system(sheet.scene);
  Net net;
  std::vector<int> unknown(3 * system.particle_count(), -1);
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    if (random.unit() < holes) continue;
    unknown[i] = net.size();
    net.coordinates.push_back(static_cast<int>(i));
  }
  for (const auto& membrane : system.cloth.membranes) {
    const std::size_t block = net.add_block(unknown, membrane.p);
    for (int edge = 0; edge < 3; ++edge) {
      Vector along = Vector::Zero(9);
      for (int axis = 0; axis < 3; ++axis) {
        along[3 * edge + axis] = random.symmetric();
        along[3 * ((edge + 1) % 3) + axis] = -along[3 * edge + axis];
      }
      net.pulls.push_back({block, along});
    }
  }
  net.mass = Vector::Constant(net.size(), mass);
  return net;
}

/// A sheet that resists bending alone, and has next to no mass: a bend as wide as the sheet costs least by far.
Net limp_net(touchstone::sim::Index columns) {
  const touchstone::sim::SheetScene sheet = touchstone::sim::sheet_scene(1, 1, columns);
  const touchstone::sim::System system(sheet.scene);
  Net net;
  std::vector<int> unknown(3 * system.particle_count());
  for (std::size_t i = 0; i < unknown.size(); ++i) net.coordinates.push_back(unknown[i] = static_cast<int>(i));
  for (const auto& hinge : system.cloth.hinges) {
    const std::size_t block = net.add_block(unknown, hinge.p);
    for (int axis = 0; axis < 3; ++axis) {
      // The ends of the edge against the corners beside it.
      Vector along = Vector::Zero(12);
      for (int p = 0; p < 4; ++p) along[3 * p + axis] = p < 2 ? 1 : -1;
      net.pulls.push_back({block, along});
    }
  }
  net.mass = Vector::Constant(net.size(), 1e-8);
  return net;
}

/// The upper triangle without zeros of the other one; rows ascend.
Eigen::SparseMatrix<double> upper(const Eigen::SparseMatrix<double>& matrix) {
  Eigen::SparseMatrix<double> part = matrix.triangularView<Eigen::Upper>();
  part.makeCompressed();
  return part;
}

Vector random_vector(Rng& random, int size) {
  Vector vector(size);
  for (double& v : vector) v = random.symmetric();
  return vector;
}

/// Iterations of conjugate gradients with this preconditioner, until its measure of the residual is this part of the
/// first.
int iterations(Multigrid& grid, const Eigen::SparseMatrix<double>& matrix, const Vector& right, double part = 1e-6) {
  Vector x = Vector::Zero(right.size()), r = right, z = r;
  grid.apply_inverse(z);
  Vector p = z;
  double rz = r.dot(z);
  const double enough = part * part * rz;
  int count = 0;
  for (; rz > enough && count < 1000; ++count) {
    const Vector hp = matrix * p;
    const double step = rz / p.dot(hp);
    x += step * p;
    r -= step * hp;
    z = r;
    grid.apply_inverse(z);
    const double before = rz;
    rz = r.dot(z);
    p = z + rz / before * p;
  }
  return count;
}

void fill(SparseSolver& solver, const Net& net) {
  solver.clear();
  std::size_t next = 0;
  for (int i = 0; i < net.size(); ++i) solver.add_diagonal(i, net.mass[i]);
  for (std::size_t b = 0; b < net.blocks.size(); ++b) {
    const auto size = static_cast<Eigen::Index>(net.blocks[b].size());
    Matrix own = Matrix::Zero(size, size);
    for (; next < net.pulls.size() && net.pulls[next].block == b; ++next)
      own += net.pulls[next].along * net.pulls[next].along.transpose();
    solver.add(b, own.data());
  }
}

}  // namespace

TEST_CASE("multigrid multiplies by its matrix, and its inverse is linear, symmetric and positive definite", "[slow]") {
  Rng random(5);
  for (const double holes : {0.0, 0.2, 0.7}) {
    const Net net = random_net(random, 14, 0.5, holes);
    const Eigen::SparseMatrix<double> matrix = net.matrix(), part = upper(matrix);
    const int size = net.size();
    CAPTURE(holes, size);
    Multigrid grid(net.coordinates, net.blocks, part.outerIndexPtr(), part.innerIndexPtr());
    for (const double scale : {1.0, 3.0}) {
      const Vector values = scale * Eigen::Map<const Vector>(part.valuePtr(), part.nonZeros());
      REQUIRE(grid.set(values.data()));
      Matrix inverse(size, size);
      for (int i = 0; i < size; ++i) {
        Vector column = Vector::Unit(size, i);
        grid.apply_inverse(column);
        inverse.col(i) = column;
      }
      CHECK((inverse - inverse.transpose()).norm() < 1e-13 * inverse.norm());
      const Vector x = random_vector(random, size);
      Vector applied = x, product(size);
      grid.apply_inverse(applied);
      CHECK((applied - inverse * x).norm() < 1e-13 * applied.norm());
      grid.multiply(x, product);
      CHECK((product - scale * matrix * x).norm() < 1e-14 * product.norm());
      // Every sweep lessens the error in the matrix's norm: the eigenvalues of the inverse times A are in (0, 1].
      const Matrix root = Eigen::SelfAdjointEigenSolver<Matrix>(scale * Matrix(matrix)).operatorSqrt();
      const Vector values_of_product =
          Eigen::SelfAdjointEigenSolver<Matrix>(root * inverse * root, Eigen::EigenvaluesOnly).eigenvalues();
      CHECK(values_of_product.minCoeff() > 0.05);
      CHECK(values_of_product.maxCoeff() < 1 + 1e-12);
    }
  }
}

TEST_CASE("with multigrid, conjugate gradients need hardly more iterations for a larger sheet") {
  Rng random(9);
  std::vector<int> counts;
  for (const touchstone::sim::Index columns : {25u, 50u, 100u}) {
    const Net net = random_net(random, columns, 0.01, 0);
    const Eigen::SparseMatrix<double> matrix = net.matrix(), part = upper(matrix);
    Multigrid grid(net.coordinates, net.blocks, part.outerIndexPtr(), part.innerIndexPtr());
    REQUIRE(grid.set(part.valuePtr()));
    counts.push_back(iterations(grid, matrix, random_vector(random, net.size())));
  }
  CAPTURE(counts);
  CHECK(counts[2] <= 30);
  CHECK(counts[2] < 1.6 * counts[0]);  // without its coarse levels: 68 to 72
}

TEST_CASE("several sheets, points without neighbours and a single point are as good as one sheet") {
  Rng random(21);
  const Net one = random_net(random, 20, 0.1, 0);
  Net all = one;
  for (const int at : {1, 3}) {  // another sheet of the same kind, and one that shares no number with these
    for (std::size_t b = 0; b < one.blocks.size(); ++b) {
      all.blocks.push_back(one.blocks[b]);
      for (int& i : all.blocks.back()) i += all.size();
      for (std::size_t k = 0; k < 3; ++k) all.pulls.push_back({all.blocks.size() - 1, one.pulls[3 * b + k].along});
    }
    for (const int c : one.coordinates) all.coordinates.push_back(c + at * 3 * one.size());
  }
  for (int lonely = 0; lonely < 60; ++lonely) all.coordinates.push_back(100 * one.size() + 4 * lonely);
  all.mass = Vector::Constant(all.size(), 0.1);
  const Eigen::SparseMatrix<double> matrix = all.matrix(), part = upper(matrix);
  Multigrid grid(all.coordinates, all.blocks, part.outerIndexPtr(), part.innerIndexPtr());
  REQUIRE(grid.set(part.valuePtr()));
  CHECK(iterations(grid, matrix, random_vector(random, all.size())) <= 30);

  const std::vector<int> first{0, 1, 2}, row{0, 1};
  Multigrid single({3, 5}, {}, first.data(), row.data());
  const std::vector<double> values{2, 4};
  REQUIRE(single.set(values.data()));
  Vector x(2);
  x << 6, 6;
  single.apply_inverse(x);
  CHECK((x - Eigen::Vector2d(3, 1.5)).norm() < 1e-14);
}

TEST_CASE("multigrid refuses what shows itself as not positive definite, and works again afterwards") {
  Rng random(13);
  const Net net = random_net(random, 14, 0.5, 0.1);
  const Eigen::SparseMatrix<double> matrix = net.matrix(), part = upper(matrix);
  Multigrid grid(net.coordinates, net.blocks, part.outerIndexPtr(), part.innerIndexPtr());
  using Limits = std::numeric_limits<double>;
  for (const double bad : {-1.0, 0.0, Limits::quiet_NaN(), Limits::infinity()}) {
    std::vector<double> values(part.valuePtr(), part.valuePtr() + part.nonZeros());
    values[static_cast<std::size_t>(part.outerIndexPtr()[net.size() / 2 + 1] - 1)] = bad;  // on the diagonal
    CHECK(!grid.set(values.data()));
    CHECK(grid.set(part.valuePtr()));
  }
  // Each point's own block is positive definite here, but a motion of all points costs less than nothing.
  std::vector<double> values(part.valuePtr(), part.valuePtr() + part.nonZeros());
  for (int i = 0; i < net.size(); ++i) values[static_cast<std::size_t>(part.outerIndexPtr()[i + 1] - 1)] -= 0.6;
  CHECK(!grid.set(values.data()));
}

TEST_CASE("a large sheet is solved by multigrid as by its factor, with contacts and where multigrid is too slow") {
  Rng random(17);
  // With little mass the sheet moves as a whole, which a few iterations do not find.
  for (const double mass : {1.0, 1e-2, 1e-9}) {
    for (const bool tied : {false, true}) {
      const Net net = random_net(random, 34, mass, 0.02);
      REQUIRE(net.size() > 3000);
      Eigen::SparseMatrix<double> matrix = net.matrix();
      PatternCache cache;
      SparseSolver solver(net.size(), net.blocks, net.coordinates, cache);
      std::vector<SparseSolver::Corners> contacts;
      if (tied) {
        for (int n = 0; n < 40; ++n) {
          SparseSolver::Corners corners;
          corners.fill(-1);
          for (std::size_t c = 0; c < 4; ++c) {  // of a point in the c-th quarter of the sheet
            const auto quarter = static_cast<std::uint64_t>(net.size() / 4);
            const auto one = static_cast<std::size_t>(c * quarter + random.below(quarter));
            for (std::size_t i = one < 2 ? 0 : one - 2; i < std::min(one + 3, net.coordinates.size()); ++i) {
              if (net.coordinates[i] / 3 != net.coordinates[one] / 3) continue;
              corners[3 * c + static_cast<std::size_t>(net.coordinates[i] % 3)] = static_cast<int>(i);
            }
          }
          contacts.push_back(corners);
        }
      }
      solver.set_contacts(contacts);
      fill(solver, net);
      std::vector<Eigen::Triplet<double>> ties;
      for (std::size_t n = 0; n < contacts.size(); ++n) {
        const std::array<double, 4> omega{0.5, 0.5, -0.25, -0.75};
        const Eigen::Vector3d normal = random_vector(random, 3);
        const Eigen::Matrix3d block = 10 * normal * normal.transpose();
        solver.add_contact(n, omega, block);
        for (std::size_t a = 0; a < 12; ++a) {
          for (std::size_t b = 0; b < 12; ++b) {
            if (contacts[n][a] < 0 || contacts[n][b] < 0) continue;
            ties.emplace_back(contacts[n][a], contacts[n][b],
                              omega[a / 3] * omega[b / 3] *
                                  block(static_cast<Eigen::Index>(a % 3), static_cast<Eigen::Index>(b % 3)));
          }
        }
      }
      Eigen::SparseMatrix<double> of_ties(net.size(), net.size());
      of_ties.setFromTriplets(ties.begin(), ties.end());
      CAPTURE(mass, tied);
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
      matrix += of_ties;
      const Vector right = random_vector(random, net.size());
      REQUIRE(solver.factorise());
      const Vector residual = right - matrix * solver.solve(right);
      // 1e-2 in the measure of the preconditioner, whose ratio to the factor is between 0.05 and 1.
      CHECK(residual.dot(factor.solve(residual)) < 1e-4 / 0.05 * right.dot(factor.solve(right)));
    }
  }
}

TEST_CASE("a sheet for which multigrid needs too many iterations is factorised") {
  Rng random(23);
  const Net net = limp_net(40);
  const Eigen::SparseMatrix<double> matrix = net.matrix(), part = upper(matrix);
  Multigrid grid(net.coordinates, net.blocks, part.outerIndexPtr(), part.innerIndexPtr());
  REQUIRE(grid.set(part.valuePtr()));
  PatternCache cache;
  SparseSolver solver(net.size(), net.blocks, net.coordinates, cache);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  for (int round = 0; round < 3; ++round) {
    Vector right = random_vector(random, net.size());
    for (int axis = 0; axis < 3; ++axis) {  // no motion of the whole sheet, which would be most of the solution
      auto along = right(Eigen::seq(axis, Eigen::last, 3));
      along.array() -= along.mean();
    }
    REQUIRE(iterations(grid, matrix, right, 1e-2) > 80);
    fill(solver, net);
    REQUIRE(solver.factorise());
    const Vector residual = right - matrix * solver.solve(right);
    CHECK(residual.dot(factor.solve(residual)) < 1e-12 * right.dot(factor.solve(right)));  // a factor's, not 1e-4
  }
}

TEST_CASE("with a contact beside the mesh, multigrid goes on where a sheet without contacts is factorised") {
  Rng random(31);
  const Net net = limp_net(40);
  const Eigen::SparseMatrix<double> matrix = net.matrix();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  SparseSolver::Corners far_apart;
  far_apart.fill(-1);
  for (int i = 0; i < 3; ++i) {
    far_apart[static_cast<std::size_t>(i)] = i;
    far_apart[static_cast<std::size_t>(3 + i)] = net.size() - 3 + i;
  }
  Vector right = random_vector(random, net.size());
  for (int axis = 0; axis < 3; ++axis) {
    auto along = right(Eigen::seq(axis, Eigen::last, 3));
    along.array() -= along.mean();
  }
  // A factor leaves next to nothing of the residual; multigrid ends at a hundredth in the norm, 1e-4 in its square.
  for (const bool tied : {false, true}) {
    PatternCache cache;
    SparseSolver solver(net.size(), net.blocks, net.coordinates, cache);
    if (tied) solver.set_contacts({far_apart});
    fill(solver, net);
    if (tied) solver.add_contact(0, {1, -1, 0, 0}, 1e-30 * Eigen::Matrix3d::Identity());
    REQUIRE(solver.factorise());
    const Vector residual = right - matrix * solver.solve(right);
    const double left = residual.dot(factor.solve(residual)) / right.dot(factor.solve(right));
    CAPTURE(tied, left);
    CHECK((left > 1e-9) == tied);
    CHECK(left < 1e-4 / 0.05);
  }
}

TEST_CASE("where the right-hand side of a large sheet is out of range, the solution is not zero but not finite") {
  Rng random(29);
  const Net net = random_net(random, 34, 0.1, 0);
  PatternCache cache;
  SparseSolver solver(net.size(), net.blocks, net.coordinates, cache);
  fill(solver, net);
  REQUIRE(solver.factorise());
  const Vector right = random_vector(random, net.size());
  CHECK(solver.solve(1e140 * right).allFinite());
  for (const double scale : {1e160, std::numeric_limits<double>::infinity()})
    CHECK(!solver.solve(scale * right).allFinite());
}
