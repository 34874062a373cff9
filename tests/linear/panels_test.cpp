#include "solver/linear/panels.h"

#include <oneapi/tbb/global_control.h>

#include <catch2/catch.hpp>

#include "solver/linear/cholesky.h"
#include "solver/linear/gradient_system.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// Lower triangle of a sheet's graph Laplacian, shifted by a tenth of its diagonal.
SparseMatrix shiftedLaplacian(int side) {
  const TriangleMesh sheet = makeSheet(side, side, 1.0, 1.0);
  SparseMatrix lower = vertexPattern(static_cast<int>(sheet.positions.rows()), sheet.triangles);
  lower.coeffs().setConstant(-1.0);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(lower.cols());
  const Eigen::VectorXd sums = lower.selfadjointView<Eigen::Lower>() * ones;
  for (int j = 0; j < lower.cols(); ++j) lower.coeffRef(j, j) = -1.1 * (sums[j] + 1.0);
  return lower;
}

Panels panelsOf(const SparseMatrix& lower) {
  Cholesky cholesky(Cholesky::Kind::kSupernodal);
  cholesky.analyse(lower);
  REQUIRE(cholesky.factor(lower));
  Panels panels;
  cholesky.copyTo(panels);
  return panels;
}

}  // namespace

TEST_CASE("panels solve their system to single precision, for one right-hand side and for three") {
  for (const int side : {1, 5, 60}) {  // 60: large enough for parallel subtrees
    const SparseMatrix lower = shiftedLaplacian(side);
    const int n = static_cast<int>(lower.cols());
    Panels panels = panelsOf(lower);
    const Positions expected = randomPositions(n, 3);
    const Positions right = lower.selfadjointView<Eigen::Lower>() * expected;
    Positions x = right;
    panels.solve(x.data(), x.data(), 3);
    CHECK((x - expected).norm() < 1e-5 * expected.norm());

    Eigen::VectorXd one = right.col(1);
    panels.solve(one.data(), one.data(), 1);
    CHECK((one - expected.col(1)).norm() < 1e-5 * expected.norm());
  }
}

TEST_CASE("panels of new values on the same pattern replace the old") {
  const SparseMatrix lower = shiftedLaplacian(20);
  Cholesky cholesky(Cholesky::Kind::kSupernodal);
  cholesky.analyse(lower);
  REQUIRE(cholesky.factor(lower));
  Panels panels;
  cholesky.copyTo(panels);
  REQUIRE(cholesky.factor(2.0 * lower));
  cholesky.copyTo(panels);
  const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(lower.cols(), -1.0, 1.0);
  Eigen::VectorXd x = lower.selfadjointView<Eigen::Lower>() * expected;
  x *= 2.0;
  panels.solve(x.data(), x.data(), 1);
  CHECK((x - expected).norm() < 1e-5 * expected.norm());
}

TEST_CASE("a solve is the same to the last bit with one thread and with several") {
  const SparseMatrix lower = shiftedLaplacian(60);
  Panels panels = panelsOf(lower);
  const Positions right = randomPositions(static_cast<int>(lower.cols()), 3);
  Positions one(right.rows(), 3), several(right.rows(), 3);
  {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
    panels.solve(right.data(), one.data(), 3);
  }
  for (int repeat = 0; repeat < 20; ++repeat) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
    panels.solve(right.data(), several.data(), 3);
    REQUIRE(one == several);
  }
}
