#include "solver/mesh/numbering.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "tests/sheet.h"

using namespace ease;

namespace {

/// A sheet of 20 x 20 squares, its vertices and triangles in a random order.
TriangleMesh shuffledSheet() {
  const TriangleMesh sheet = makeSheet(20, 20, 1.0, 1.0);
  Numbering random;
  random.vertices.resize(sheet.positions.rows());
  random.triangles.resize(sheet.triangles.rows());
  std::iota(random.vertices.begin(), random.vertices.end(), 0);
  std::iota(random.triangles.begin(), random.triangles.end(), 0);
  std::mt19937 generator(1);
  std::ranges::shuffle(random.vertices, generator);
  std::ranges::shuffle(random.triangles, generator);
  return renumbered(sheet, random);
}

/// Mean of |i - j| over the sides of the triangles.
double meanReach(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int a = 0; a < 3; ++a) sum += std::abs(mesh.triangles(t, a) - mesh.triangles(t, (a + 1) % 3));
  return sum / static_cast<double>(3 * mesh.triangles.rows());
}

}  // namespace

TEST_CASE("the numbering along the curve puts neighbours near each other in memory") {
  const TriangleMesh mesh = shuffledSheet();
  const TriangleMesh near = renumbered(mesh, spatialNumbering(mesh));
  CHECK(meanReach(mesh) > 100.0);
  CHECK(meanReach(near) < 30.0);
}

TEST_CASE("a renumbered mesh has the same shape, and is restored to the last bit") {
  const TriangleMesh mesh = shuffledSheet();
  const Numbering numbering = spatialNumbering(mesh);
  const TriangleMesh ordered = renumbered(mesh, numbering);
  CHECK(restored(ordered.positions, numbering.vertices) == mesh.positions);
  for (int k = 0; k < mesh.triangles.rows(); ++k)
    for (int a = 0; a < 3; ++a)
      CHECK(ordered.positions.row(ordered.triangles(k, a)) ==
            mesh.positions.row(mesh.triangles(numbering.triangles[k], a)));
}

TEST_CASE("a part of a mesh has the places of its triangles and no other vertex") {
  const TriangleMesh mesh = shuffledSheet();
  const std::vector<int> kept = {7, 3, 500};
  const Numbering numbering = partNumbering(mesh.triangles, kept);
  const TriangleMesh part = renumbered(mesh, numbering);
  REQUIRE(part.triangles.rows() == 3);
  CHECK(part.triangles.row(0) == Eigen::RowVector3i(0, 1, 2));  // in the order in which they are met
  CHECK(part.triangles.maxCoeff() + 1 == part.positions.rows());
  for (int k = 0; k < 3; ++k)
    for (int a = 0; a < 3; ++a)
      CHECK(part.positions.row(part.triangles(k, a)) == mesh.positions.row(mesh.triangles(kept[k], a)));
  CHECK(newNumbers(numbering.vertices)[mesh.triangles(500, 1)] == part.triangles(2, 1));
  CHECK(partNumbering(mesh.triangles, {}).vertices.empty());
}

TEST_CASE("values follow their numbers there and back") {
  const std::vector<int> order = {2, 0, 1};
  const std::vector<double> values = {10.0, 11.0, 12.0};
  CHECK(newNumbers(order) == std::vector<int>{1, 2, 0});
  CHECK(newNumbers({3, 1}) == std::vector<int>{-1, 1, -1, 0});
  CHECK(renumbered(values, {2, 1}) == std::vector<double>{12.0, 11.0});
  CHECK(renumbered(values, order) == std::vector<double>{12.0, 10.0, 11.0});
  CHECK(restored(renumbered(values, order), order) == values);
  CHECK(restored(std::vector<float>{5, 6, 1, 2, 3, 4}, order, 2) == std::vector<float>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("a mesh without extent or without triangles has a numbering") {
  TriangleMesh point;
  point.positions = Positions::Zero(3, 3);
  CHECK(spatialNumbering(point).vertices == std::vector<int>{0, 1, 2});
  CHECK(spatialNumbering(point).triangles.empty());
}
