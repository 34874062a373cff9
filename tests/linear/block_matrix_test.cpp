#include "solver/linear/block_matrix.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

/// A symmetric matrix on a sheet's pattern, all of whose values differ.
BlockMatrix someMatrix(const TriangleMesh& sheet) {
  const Topology topology = buildTopology(sheet, "sheet");
  BlockMatrix matrix(static_cast<int>(sheet.positions.rows()), topology.edges);
  for (int i = 0; i < matrix.rows(); ++i)
    for (int k = matrix.rowBegin(i); k < matrix.rowEnd(i); ++k) {
      const int j = matrix.column(k);
      Mat3 block;
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) block(a, b) = std::sin(1.0 + (3.0 * i + a) * (3.0 * j + b));
      matrix.block(k) = i == j ? Mat3(block + 20.0 * Mat3::Identity()) : block;
    }
  return matrix;
}

}  // namespace

TEST_CASE("blocks and scalars are the same matrix") {
  const TriangleMesh sheet = makeSheet(5, 4, 1.0, 1.0);
  const BlockMatrix matrix = someMatrix(sheet);
  SparseMatrix lower;
  matrix.toScalar(std::vector<char>(matrix.rows(), 0), lower);
  const Positions x = randomPositions(matrix.rows(), 2);
  Positions y(matrix.rows(), 3);
  matrix.multiply(x, y);
  const Eigen::VectorXd expected =
      lower.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(x.data(), x.size());
  REQUIRE(expected.norm() > 1.0);
  CHECK((Eigen::Map<const Eigen::VectorXd>(y.data(), y.size()) - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE("rows and columns of fixed vertices are those of the identity") {
  const TriangleMesh sheet = makeSheet(5, 4, 1.0, 1.0);
  const BlockMatrix matrix = someMatrix(sheet);
  std::vector<char> fixed(matrix.rows(), 0);
  fixed[7] = 1;
  SparseMatrix lower;
  matrix.toScalar(fixed, lower);
  Eigen::MatrixXd dense = lower.selfadjointView<Eigen::Lower>() * Eigen::MatrixXd::Identity(lower.rows(), lower.cols());
  CHECK(dense.block<3, 3>(21, 21) == Mat3::Identity());
  dense.block<3, 3>(21, 21).setZero();
  CHECK(dense.middleRows<3>(21).norm() == 0.0);
}
