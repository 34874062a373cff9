#include "solver/step/newton_system.h"

#include <catch2/catch.hpp>

#include "solver/linear/gradient_system.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// Matrix of springs along the edges of a sheet, with some mass on the diagonal. `disturbance` is the relative
/// variation of the springs' stiffness.
BlockMatrix springs(const TriangleMesh& sheet, double disturbance) {
  const Topology topology = buildTopology(sheet, "sheet");
  BlockMatrix matrix(static_cast<int>(sheet.positions.rows()), topology.edges);
  for (int i = 0; i < matrix.rows(); ++i) {
    Mat3 diagonal = 0.5 * Mat3::Identity();
    int own = -1;
    for (int k = matrix.rowBegin(i); k < matrix.rowEnd(i); ++k) {
      if (matrix.edge(k) < 0) {
        own = k;
        continue;
      }
      const double weight = 10.0 * (1.0 + disturbance * std::sin(7.0 * matrix.edge(k)));
      const Vec3 along = (sheet.positions.row(matrix.column(k)) - sheet.positions.row(i)).normalized();
      const Mat3 block = weight * along * along.transpose();
      matrix.block(k) = -block;
      diagonal += block;
    }
    matrix.block(own) = diagonal;
  }
  return matrix;
}

std::vector<int> orderingOf(const TriangleMesh& mesh) {
  return systemOrdering(static_cast<int>(mesh.positions.rows()), mesh.triangles);
}

const auto kNothingMore = [](const Positions&, Positions&) {};

}  // namespace

TEST_CASE("a solve that may not end lowers its quadratic form, and the factor is renewed for the next one") {
  const TriangleMesh sheet = makeSheet(15, 15, 1.0, 1.0);
  const BlockMatrix matrix = springs(sheet, 0.0);
  const std::vector<char> fixed(matrix.rows(), 0);
  NewtonSystem system(matrix, orderingOf(sheet));
  const auto more = [](const Positions& d, Positions& product) { product += 1e3 * d; };  // unknown to the factor
  const Positions right = randomPositions(matrix.rows(), 4);
  Positions d, product(matrix.rows(), 3);
  const SolveSummary summary = system.solve(matrix, more, fixed, right, 1e-10, d, 1);
  CHECK(summary.ok);
  CHECK(summary.iterations == 1);
  matrix.multiply(d, product);
  more(d, product);
  CHECK(0.5 * d.cwiseProduct(product).sum() < d.cwiseProduct(right).sum());
  CHECK(system.solve(matrix, more, fixed, right, 1e-10, d).factorisations == 1);
}

TEST_CASE("a fresh factor, rounded to single precision, solves in two iterations, an old one in a few more") {
  const TriangleMesh sheet = makeSheet(15, 15, 1.0, 1.0);
  const BlockMatrix first = springs(sheet, 0.0), second = springs(sheet, 0.3);
  const std::vector<char> fixed(first.rows(), 0);
  NewtonSystem system(first, orderingOf(sheet));
  const Positions expected = randomPositions(first.rows(), 4);
  Positions right(first.rows(), 3), d;
  first.multiply(expected, right);
  SolveSummary summary = system.solve(first, kNothingMore, fixed, right, 1e-10, d);
  CHECK(summary.ok);
  CHECK(summary.factorisations == 1);
  CHECK(summary.iterations <= 2);
  CHECK((d - expected).norm() < 1e-9 * expected.norm());

  second.multiply(expected, right);
  summary = system.solve(second, kNothingMore, fixed, right, 1e-10, d);
  CHECK(summary.factorisations == 0);
  CHECK(summary.iterations > 2);
  CHECK((d - expected).norm() < 1e-8 * expected.norm());
}

TEST_CASE("a solve after what the factor makes of the same force is the same to the last bit, of another too") {
  const TriangleMesh sheet = makeSheet(15, 15, 1.0, 1.0);
  const BlockMatrix first = springs(sheet, 0.0), second = springs(sheet, 0.3);
  const std::vector<char> fixed(first.rows(), 0);
  const auto solved = [&](const Positions* before) {
    NewtonSystem system(first, orderingOf(sheet));
    Positions d;
    CHECK(system.solve(first, kNothingMore, fixed, randomPositions(first.rows(), 4), 1e-10, d).ok);
    if (before) system.precondition(*before);
    CHECK(system.solve(second, kNothingMore, fixed, randomPositions(first.rows(), 5), 1e-6, d).ok);
    return d;
  };
  const Positions same = randomPositions(first.rows(), 5), other = randomPositions(first.rows(), 6);
  CHECK(solved(nullptr) == solved(&same));
  CHECK(solved(nullptr) == solved(&other));
}

TEST_CASE("what is added to the matrix is solved for too") {
  const TriangleMesh sheet = makeSheet(15, 15, 1.0, 1.0);
  const BlockMatrix matrix = springs(sheet, 0.0);
  NewtonSystem system(matrix, orderingOf(sheet));
  const auto more = [](const Positions& d, Positions& product) { product += 3.0 * d; };
  const Positions expected = randomPositions(matrix.rows(), 4);
  Positions right(matrix.rows(), 3), d;
  matrix.multiply(expected, right);
  more(expected, right);
  CHECK(system.solve(matrix, more, std::vector<char>(matrix.rows(), 0), right, 1e-10, d).ok);
  CHECK((d - expected).norm() < 1e-8 * expected.norm());
}

TEST_CASE("fixed vertices do not move") {
  const TriangleMesh sheet = makeSheet(6, 6, 1.0, 1.0);
  const BlockMatrix matrix = springs(sheet, 0.0);
  std::vector<char> fixed(matrix.rows(), 0);
  fixed[3] = fixed[30] = 1;
  NewtonSystem system(matrix, orderingOf(sheet));
  Positions d;
  const SolveSummary summary = system.solve(matrix, kNothingMore, fixed, randomPositions(matrix.rows(), 1), 1e-8, d);
  CHECK(summary.ok);
  CHECK(d.row(3).norm() == 0.0);
  CHECK(d.row(30).norm() == 0.0);
  CHECK(d.norm() > 0.1);
}

TEST_CASE("a matrix that is not positive definite is reported") {
  const TriangleMesh sheet = makeSheet(6, 6, 1.0, 1.0);
  BlockMatrix matrix = springs(sheet, 0.0);
  matrix.block(matrix.rowBegin(0)) = -50.0 * Mat3::Identity();
  NewtonSystem system(matrix, orderingOf(sheet));
  Positions d;
  CHECK_FALSE(
      system
          .solve(matrix, kNothingMore, std::vector<char>(matrix.rows(), 0), randomPositions(matrix.rows(), 1), 1e-8, d)
          .ok);
}
