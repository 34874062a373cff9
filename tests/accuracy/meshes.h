// Meshes of shapes whose answers are known.
#pragma once

#include <map>
#include <utility>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Flat sheet in the xy plane of n x m equal cells, all cut along the same diagonal; `width` along x, `height` along y,
/// m.  Vertex (i, j) is j (n + 1) + i.
inline TriangleMesh makeGrid(int n, int m, double width, double height) {
  TriangleMesh grid;
  grid.positions.resize((n + 1) * (m + 1), 3);
  grid.triangles.resize(2 * n * m, 3);
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) grid.positions.row(j * (n + 1) + i) << width * i / n, height * j / m, 0.0;
  int t = 0;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      grid.triangles.row(t++) << a, b, d;
      grid.triangles.row(t++) << a, d, c;
    }
  return grid;
}

/// Flat sheet in the xy plane of equilateral triangles: m + 1 rows across, at x = 0, sqrt(3)/2 edge, ..., each of n + 1
/// vertices along y, every second row half an edge further.  Vertex i of row j is j (n + 1) + i.
inline TriangleMesh makeEquilateral(int n, int m, double edge) {
  TriangleMesh sheet;
  sheet.positions.resize((n + 1) * (m + 1), 3);
  sheet.triangles.resize(2 * n * m, 3);
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i)
      sheet.positions.row(j * (n + 1) + i) << 0.5 * std::sqrt(3.0) * edge * j, edge * (i + 0.5 * (j % 2)), 0.0;
  int t = 0;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      if (j % 2 == 0) {
        sheet.triangles.row(t++) << a, c, b;
        sheet.triangles.row(t++) << b, c, d;
      } else {
        sheet.triangles.row(t++) << a, d, b;
        sheet.triangles.row(t++) << a, c, d;
      }
    }
  return sheet;
}

/// Icosahedron, each of its triangles cut into four `divisions` times, with its vertices on the sphere; outwards.
inline TriangleMesh makeSphere(int divisions, double radius) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleMesh sphere;
  sphere.positions.resize(12, 3);
  sphere.positions << -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, 0, 0, -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, g, 0, -1, g, 0, 1,
      -g, 0, -1, -g, 0, 1;
  sphere.triangles.resize(20, 3);
  sphere.triangles << 0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8,
      3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1;
  for (int d = 0; d < divisions; ++d) {
    std::map<std::pair<int, int>, int> middle;
    std::vector<Vec3> vertices(sphere.positions.rows());
    for (size_t i = 0; i < vertices.size(); ++i) vertices[i] = sphere.positions.row(static_cast<long>(i));
    const auto between = [&](int a, int b) {
      const auto [place, fresh] = middle.try_emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
      if (fresh) vertices.push_back(0.5 * (vertices[a] + vertices[b]));
      return place->second;
    };
    Triangles finer(4 * sphere.triangles.rows(), 3);
    for (int t = 0; t < sphere.triangles.rows(); ++t) {
      const int a = sphere.triangles(t, 0), b = sphere.triangles(t, 1), c = sphere.triangles(t, 2);
      const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.middleRows<4>(4 * t) << a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca;
    }
    sphere.triangles = finer;
    sphere.positions.resize(static_cast<long>(vertices.size()), 3);
    for (size_t i = 0; i < vertices.size(); ++i) sphere.positions.row(static_cast<long>(i)) = vertices[i];
    sphere.positions.rowwise().normalize();
  }
  sphere.positions.rowwise().normalize();
  sphere.positions *= radius;
  return sphere;
}

}  // namespace ease
