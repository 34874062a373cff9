// Meshes and numbers that several tests share.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Flat sheet of (n + 1) x (m + 1) vertices in the xy plane, `width` along x, `height` along y, m; interior vertices
/// moved by up to `jitter` of a cell.
inline TriangleMesh makeSheet(int n, int m, double width, double height, double jitter = 0.0) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  TriangleMesh sheet;
  sheet.positions.resize((n + 1) * (m + 1), 3);
  sheet.triangles.resize(2 * n * m, 3);
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool inside = i > 0 && i < n && j > 0 && j < m;
      const double dx = inside ? shift(random) : 0.0, dy = inside ? shift(random) : 0.0;
      sheet.positions.row(j * (n + 1) + i) << width * (i + dx) / n, height * (j + dy) / m, 0.0;
    }
  int t = 0;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      if ((i + j) % 2 == 0) {
        sheet.triangles.row(t++) << a, b, d;
        sheet.triangles.row(t++) << a, d, c;
      } else {
        sheet.triangles.row(t++) << a, b, c;
        sheet.triangles.row(t++) << b, d, c;
      }
    }
  return sheet;
}

/// Open tube about the y axis from y = 0 on, facing outwards; vertex i of ring j is j * around + i.
inline TriangleMesh makeTube(int around, int along, double radius, double height) {
  TriangleMesh tube;
  tube.positions.resize(around * (along + 1), 3);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / around;
      tube.positions.row(j * around + i) << radius * std::cos(angle), height * j / along, radius * std::sin(angle);
    }
  tube.triangles.resize(2 * around * along, 3);
  int t = 0;
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around;
      tube.triangles.row(t++) << a, a + around, b;
      tube.triangles.row(t++) << b, a + around, b + around;
    }
  return tube;
}

/// Random numbers in [-1, 1], n x 3, the same every time.
inline Positions randomPositions(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Positions x(n, 3);
  for (int i = 0; i < x.size(); ++i) x.data()[i] = uniform(random);
  return x;
}

}  // namespace ease
