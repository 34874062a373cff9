#include "solver/linear/cholesky.h"

#include <catch2/catch.hpp>

#include "solver/linear/gradient_system.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// Laplacian of a sheet's graph plus `shift` on the diagonal, lower triangle.
SparseMatrix graphLaplacian(double shift) {
  const TriangleMesh sheet = makeSheet(12, 9, 1.0, 1.0);
  SparseMatrix lower = vertexPattern(static_cast<int>(sheet.positions.rows()), sheet.triangles);
  for (int j = 0; j < lower.cols(); ++j)
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it)
      if (it.row() != j) {
        it.valueRef() = -1.0;
        lower.coeffRef(j, j) += 1.0;
        lower.coeffRef(it.row(), it.row()) += 1.0;
      }
  for (int j = 0; j < lower.cols(); ++j) lower.coeffRef(j, j) += shift;
  return lower;
}

}  // namespace

TEST_CASE("a factor solves its system, simplicial or supernodal, for several right-hand sides") {
  const SparseMatrix lower = graphLaplacian(0.1);
  const Eigen::MatrixXd expected = randomPositions(static_cast<int>(lower.cols()), 3);
  const Eigen::MatrixXd right = lower.selfadjointView<Eigen::Lower>() * expected;
  for (const auto kind : {Cholesky::Kind::kSimplicial, Cholesky::Kind::kSupernodal}) {
    Cholesky cholesky(kind);
    cholesky.analyse(lower);
    REQUIRE(cholesky.factor(lower));
    Eigen::MatrixXd x(right.rows(), right.cols());
    cholesky.solve(right.data(), x.data(), 3);
    CHECK((x - expected).norm() < 1e-11 * expected.norm());
  }
}

TEST_CASE("an indefinite matrix is reported, and the next one can still be factored") {
  Cholesky cholesky(Cholesky::Kind::kSimplicial);
  const SparseMatrix indefinite = graphLaplacian(-1.0), definite = graphLaplacian(1.0);
  cholesky.analyse(indefinite);
  CHECK_FALSE(cholesky.factor(indefinite));
  CHECK(cholesky.factor(definite));
}

TEST_CASE("an ordering given is kept up to the order of the elimination tree, and serves as well") {
  const SparseMatrix lower = graphLaplacian(0.1);
  Cholesky first(Cholesky::Kind::kSimplicial), second(Cholesky::Kind::kSimplicial);
  first.analyse(lower);
  second.analyse(lower, first.ordering());
  REQUIRE(second.factor(lower));
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(lower.cols(), -1.0, 1.0);
  Eigen::VectorXd x(right.size());
  second.solve(right.data(), x.data(), 1);
  CHECK((lower.selfadjointView<Eigen::Lower>() * x - right).norm() < 1e-11);
}

TEST_CASE("lifting an ordering keeps the three coordinates of a vertex together") {
  const std::vector<int> ordering{2, 0, 1};
  CHECK(liftOrdering(ordering) == std::vector<int>{6, 7, 8, 0, 1, 2, 3, 4, 5});
}
