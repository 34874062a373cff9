#include "garment/pattern/vertex_matrix.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("a linear function solves the Laplace equation between fixed vertices") {
  const RestSurface sheet = flatSheet(6, 1.0);
  const int n = sheet.vertexCount();
  VertexMatrix matrix(n, sheet.mesh.triangles);
  std::vector<double> right(n, 0.0);
  for (int t = 0; t < sheet.triangleCount(); ++t) {
    const Mat3 block = stiffnessBlock(sheet.rest_edges[t]);
    matrix.add(t, block);
    for (int k = 0; k < 3; ++k)  // what the fixed vertices pull
      for (int l = 0; l < 3; ++l)
        if (const int v = sheet.mesh.triangles(t, l); sheet.on_border[v])
          right[sheet.mesh.triangles(t, k)] -= block(k, l) * sheet.mesh.positions(v, 0);
  }
  for (int v = 0; v < n; ++v)
    if (sheet.on_border[v]) right[v] = sheet.mesh.positions(v, 0);
  matrix.fix(sheet.on_border);
  REQUIRE(matrix.factor());
  matrix.solve(right);
  for (int v = 0; v < n; ++v) CHECK(right[v] == Approx(sheet.mesh.positions(v, 0)).margin(1e-12));
}

TEST_CASE("a Laplacian without fixed vertices, diagonal or lines is not positive definite") {
  const RestSurface sheet = flatSheet(2, 1.0);
  VertexMatrix matrix(sheet.vertexCount(), sheet.mesh.triangles);
  matrix.clear();
  CHECK_FALSE(matrix.factor());
  for (int v = 0; v < sheet.vertexCount(); ++v) matrix.addDiagonal(v, 2.0);
  CHECK(matrix.factor());
}
