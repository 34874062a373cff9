// Garments that the tests of the pattern share.
#pragma once

#include <cmath>

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// The mesh as its own rest shape, warp downwards.
inline RestGarment restGarment(const TriangleMesh& mesh, const std::vector<Seam>& seams = {},
                               const Vec3& grain = {0.0, -1.0, 0.0}) {
  RestGarment garment{mesh, {}, seams, {}};
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Mat32 edges = edgeMatrix(mesh.positions, mesh.triangles, t);
    garment.rest_edges.push_back(planeFrame(edges, grain).transpose() * edges);
  }
  return garment;
}

/// Settings under which the alternation goes on until hardly anything moves.
inline FlatSettings exactSettings() {
  FlatSettings settings;
  settings.woven.max_iterations = 20000;
  settings.woven.tolerance = 1e-12;
  settings.max_darts = 0;
  return settings;
}

/// Lower part of a cone about y, its tip on top at the origin: vertex 0 is the tip where `is_closed`, then rings of
/// `around` vertices down to `radius` and -`height`.  Open above at a third of the height otherwise.
inline TriangleMesh cone(int around, int rings, double radius, double height, bool is_closed) {
  const int first = is_closed ? 1 : 0;
  TriangleMesh mesh{Positions(first + around * rings, 3),
                    Triangles(2 * around * (rings - 1) + (is_closed ? around : 0), 3)};
  if (is_closed) mesh.positions.row(0).setZero();
  int t = 0;
  for (int r = 0; r < rings; ++r)
    for (int i = 0; i < around; ++i) {
      const double share = is_closed ? (r + 1.0) / rings : (1.0 + 2.0 * r / (rings - 1)) / 3.0,
                   angle = 2.0 * M_PI * i / around;
      mesh.positions.row(first + r * around + i) << share * radius * std::cos(angle), -share * height,
          -share * radius * std::sin(angle);
      const int j = (i + 1) % around, above = first + (r - 1) * around, here = first + r * around;
      if (r == 0) {
        if (is_closed) mesh.triangles.row(t++) << 0, here + i, here + j;
        continue;
      }
      mesh.triangles.row(t++) << above + i, here + i, here + j;
      mesh.triangles.row(t++) << above + i, here + j, above + j;
    }
  return mesh;
}

/// A sheet bent to the graph z(x, y) over [-size / 2, size / 2]^2, n x n cells, facing +z.
template <class Height>
TriangleMesh bentSheet(int n, double size, const Height& height) {
  TriangleMesh mesh{Positions((n + 1) * (n + 1), 3), Triangles(2 * n * n, 3)};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = size * (1.0 * i / n - 0.5), y = size * (1.0 * j / n - 0.5);
      mesh.positions.row(j * (n + 1) + i) << x, y, height(x, y);
    }
  int t = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      if ((i + j) % 2 == 0) {
        mesh.triangles.row(t++) << a, b, d;
        mesh.triangles.row(t++) << a, d, c;
      } else {
        mesh.triangles.row(t++) << a, b, c;
        mesh.triangles.row(t++) << b, d, c;
      }
    }
  return mesh;
}

/// A seam along the vertices with x-index i of a bentSheet() of n by n edges.
inline Seam columnSeam(int n, int i) {
  Seam seam{"column", {}, false};
  for (int j = 0; j <= n; ++j) seam.vertices.push_back(j * (n + 1) + i);
  return seam;
}

}  // namespace ease
