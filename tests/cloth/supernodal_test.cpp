// The factor by dense blocks against dense factors of the same matrices.
// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

#include "cloth/cloth_scenes.hpp"
#include "linear/sparse_solver.hpp"
#include "linear/supernodal_factor.hpp"
#include "support/catch.hpp"

using namespace touchstone::linear;
using touchstone::seeded::Rng;
using Matrix = Eigen::MatrixXd;

namespace {

int below(Rng& random, int count) { return static_cast<int>(random.below(static_cast<std::uint64_t>(count))); }

/// Blocks of up to four neighbours on a grid, of a band, or anywhere; some unknowns have none, and some blocks leave
/// rows out.
Blocks random_blocks(Rng& random, int size, int kind) {
  Blocks blocks;
  const int count = size * (1 + below(random, 3)) / 2, width = std::max(2, size / 12);
  for (int b = 0; b < count; ++b) {
    const int from = below(random, size);
    std::vector<int> block{from};
    for (int k = 0; k < 3; ++k) {
      int other = below(random, size);
      if (kind == 0) other = from + (k == 0 ? 1 : k == 1 ? width : width + 1);
      if (kind == 1) other = from + 1 + below(random, 5);
      if (other >= size || std::find(block.begin(), block.end(), other) != block.end()) other = -1;
      block.push_back(other);
    }
    blocks.push_back(block);
  }
  return blocks;
}

struct Example {
  SparsePattern pattern;
  std::vector<double> values;  // of the pattern's entries
  Matrix full;
};

/// @param shift  of the diagonal: of 1, the matrix is positive definite
Example random_example(Rng& random, int size, int kind, double shift) {
  const Blocks blocks = random_blocks(random, size, kind);
  Example example{SparsePattern(size, blocks), {}, Matrix::Zero(size, size)};
  const SparsePattern& p = example.pattern;
  for (const auto& block : blocks) {
    Eigen::Vector4d pull;
    for (int k = 0; k < 4; ++k) pull[k] = random.symmetric();
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 4; ++b) {
        if (block[a] < 0 || block[b] < 0) continue;
        example.full(p.numbers[static_cast<std::size_t>(block[a])], p.numbers[static_cast<std::size_t>(block[b])]) +=
            100 * pull[static_cast<Eigen::Index>(a)] * pull[static_cast<Eigen::Index>(b)];
      }
    }
  }
  example.full.diagonal().array() += shift;
  for (int column = 0; column < size; ++column) {
    for (int k = p.first[static_cast<std::size_t>(column)]; k < p.first[static_cast<std::size_t>(column) + 1]; ++k)
      example.values.push_back(example.full(p.row[static_cast<std::size_t>(k)], column));
  }
  return example;
}

}  // namespace

TEST_CASE("the factor by dense blocks solves what a dense factor solves, whatever the pattern") {
  Rng random(7);
  std::size_t most = 0;
  for (int round = 0; round < 60; ++round) {
    const int size = 1 + below(random, round < 30 ? 40 : 500), kind = round % 3;
    const Example example = random_example(random, size, kind, 1);
    const SparsePattern& p = example.pattern;
    CAPTURE(round, size, kind);
    SupernodalFactor factor(size, p.first.data(), p.row.data());
    most = std::max(most, factor.entries());
    for (const double scale : {1.0, 3.0}) {  // a factor is made again and again
      std::vector<double> values = example.values;
      for (double& v : values) v *= scale;
      REQUIRE(factor.factorise(values.data()));
      Eigen::VectorXd right(size);
      for (int i = 0; i < size; ++i) right[i] = random.symmetric();
      const Eigen::VectorXd known = (scale * example.full).llt().solve(right);
      Eigen::VectorXd x = right;
      factor.solve_in_place(x);
      // The condition number is at most some 10^3, as the pull on an unknown is.
      CHECK((x - known).norm() < 1e-11 * known.norm());
      CHECK((scale * example.full * x - right).norm() < 1e-11 * right.norm());
    }
  }
  CHECK(most > 50'000);  // panels of hundreds of columns
}

TEST_CASE("the factor by dense blocks says where a matrix is not positive definite, and works again afterwards") {
  Rng random(11);
  int indefinite = 0;
  for (int round = 0; round < 40; ++round) {
    const int size = 20 + below(random, 80);
    const Example example = random_example(random, size, round % 3, 1);
    CAPTURE(round, size);
    SupernodalFactor factor(size, example.pattern.first.data(), example.pattern.row.data());
    // Shifted by more, and by less, than the least eigenvalue.
    const double least = Eigen::SelfAdjointEigenSolver<Matrix>(example.full, Eigen::EigenvaluesOnly).eigenvalues()[0];
    for (const double part : {1.01, 0.99}) {
      std::vector<double> values = example.values;
      for (int column = 0; column < size; ++column)
        values[static_cast<std::size_t>(example.pattern.first[static_cast<std::size_t>(column) + 1] - 1)] -=
            part * least;
      const bool definite = factor.factorise(values.data());
      CHECK(definite == (part < 1));
      indefinite += definite ? 0 : 1;
    }
    std::vector<double> values = example.values;
    values[values.size() / 2] = std::numeric_limits<double>::quiet_NaN();
    CHECK(!factor.factorise(values.data()));
    CHECK(factor.factorise(example.values.data()));
  }
  CHECK(indefinite == 40);
}

TEST_CASE("the factor of a sheet fills up, and that of a cable does not") {
  const auto blocks_of_sheet = [](touchstone::sim::Index columns) {
    const touchstone::sim::SheetScene sheet = touchstone::sim::sheet_scene(1, 1, columns);
    const touchstone::sim::System system(sheet.scene);
    Blocks blocks;
    for (const auto& hinge : system.cloth.hinges) {
      std::vector<int> block;
      for (const touchstone::sim::Index p : hinge.p) {
        for (touchstone::sim::Index c = 0; c < 3; ++c) block.push_back(static_cast<int>(3 * p + c));
      }
      blocks.push_back(block);
    }
    return std::pair(static_cast<int>(system.size()), blocks);
  };
  const auto [size, blocks] = blocks_of_sheet(20);
  CHECK(SparsePattern(size, blocks).fills_up);
  Blocks cable;
  for (int i = 0; i + 11 <= 4 * 500; i += 4) {
    cable.emplace_back();
    for (int k = 0; k < 11; ++k) cable.back().push_back(i + k);
  }
  CHECK(!SparsePattern(4 * 500, cable).fills_up);
  // Five sheets that are alike: by fours they would be factorised entry by entry.
  Blocks five;
  for (int copy = 0; copy < 5; ++copy) {
    for (const auto& block : blocks) {
      five.push_back(block);
      for (int& i : five.back()) i += copy * size;
    }
  }
  PatternCache cache;
  SparseSolver solver(5 * size, five, {}, cache);
  solver.clear();
  Rng random(3);
  Eigen::VectorXd right(5 * size);
  for (int i = 0; i < 5 * size; ++i) {
    solver.add_diagonal(i, 2);
    right[i] = random.symmetric();
  }
  std::vector<Eigen::VectorXd> pulls;
  for (std::size_t b = 0; b < five.size(); ++b) {
    pulls.push_back(Eigen::VectorXd::Zero(12));
    for (double& pull : pulls.back()) pull = random.symmetric();
    const Matrix own = pulls.back() * pulls.back().transpose();
    solver.add(b, own.data());
  }
  REQUIRE(solver.factorise());
  const Eigen::VectorXd x = solver.solve(right);
  Eigen::VectorXd residual = right - 2 * x;
  for (std::size_t b = 0; b < five.size(); ++b) {
    double sum = 0;
    for (std::size_t k = 0; k < 12; ++k) sum += pulls[b][static_cast<Eigen::Index>(k)] * x[five[b][k]];
    for (std::size_t k = 0; k < 12; ++k) residual[five[b][k]] -= sum * pulls[b][static_cast<Eigen::Index>(k)];
  }
  CHECK(residual.norm() < 1e-11 * right.norm());
}
