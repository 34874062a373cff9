// A flat square of cloth, the mesh that two of the examples start from.
#pragma once

#include <ease/solver/mesh/triangle_mesh.h>

/// (n + 1) x (n + 1) vertices, `side` m wide, centred on the origin: the columns run along `u`, the rows along `v`.
/// Vertex i of row j has the index j (n + 1) + i.
inline ease::TriangleMesh squareSheet(int n, double side, const ease::Vec3& u, const ease::Vec3& v) {
  ease::TriangleMesh sheet;
  sheet.positions.resize((n + 1) * (n + 1), 3);
  sheet.triangles.resize(2 * n * n, 3);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      sheet.positions.row(j * (n + 1) + i) = side * ((i / double(n) - 0.5) * u + (j / double(n) - 0.5) * v);
  int t = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      sheet.triangles.row(t++) << a, b, d;
      sheet.triangles.row(t++) << a, d, c;
    }
  return sheet;
}
