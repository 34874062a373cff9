#include "viz/poly_data.h"

#include <vtkPoints.h>

#include "tests/viz/fixtures.h"

TEST_CASE("VTK's cells are our triangles, with indices of 32 bits") {
  const ease::TriangleMesh mesh = test::gridMesh(5);
  const auto cells = ease::toCells(mesh.triangles);
  REQUIRE(cells->GetNumberOfCells() == mesh.triangles.rows());
  CHECK_FALSE(cells->IsStorage64Bit());
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    vtkIdType count;
    const vtkIdType* vertices;
    cells->GetCellAtId(t, count, vertices);
    REQUIRE(count == 3);
    for (int k = 0; k < 3; ++k) CHECK(vertices[k] == mesh.triangles(t, k));
  }
}

TEST_CASE("VTK's points are our positions in single precision, and its cells are shared") {
  const ease::TriangleMesh mesh = test::gridMesh(5);
  const auto cells = ease::toCells(mesh.triangles);
  const auto data = ease::toPolyData(mesh.positions, cells);
  REQUIRE(data->GetNumberOfPoints() == mesh.positions.rows());
  CHECK(data->GetPoints()->GetDataType() == VTK_FLOAT);
  for (int i = 0; i < mesh.positions.rows(); ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(data->GetPoint(i)[k] == static_cast<double>(static_cast<float>(mesh.positions(i, k))));
  CHECK(data->GetPolys() == cells.Get());
}
