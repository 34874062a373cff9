// Triangle mesh as flat arrays: one row a vertex (m), one row a triangle (vertex indices, counter-clockwise from
// outside).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace ease {

static_assert(EIGEN_MAX_ALIGN_BYTES == 64 && EIGEN_MAX_STATIC_ALIGN_BYTES == 16,
              "Ease needs Eigen with the alignment that the library was compiled with; CMake's target ease::solver "
              "sets it, other builds need -DEIGEN_MAX_ALIGN_BYTES=64 -DEIGEN_MAX_STATIC_ALIGN_BYTES=16");

using Vec3 = Eigen::Vector3d;
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  // n x 3, m
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;     // m x 3

struct TriangleMesh {
  Positions positions;
  Triangles triangles;
};

/// Twice the area of triangle (a, b, c) times its unit normal, m^2.
inline Vec3 doubleAreaNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

/// Area of triangle `t`, m^2.
inline double triangleArea(const Positions& positions, const Triangles& triangles, int t) {
  const Vec3 a = positions.row(triangles(t, 0)), b = positions.row(triangles(t, 1)), c = positions.row(triangles(t, 2));
  return 0.5 * doubleAreaNormal(a, b, c).norm();
}

/// Area of all triangles together, m^2.
inline double totalArea(const TriangleMesh& mesh) {
  double area = 0.0;
  for (int t = 0; t < mesh.triangles.rows(); ++t) area += triangleArea(mesh.positions, mesh.triangles, t);
  return area;
}

/// Corner 0, 1 or 2 of triangle `t` at which `vertex` lies; the vertex must be one of them.
inline int cornerOf(const Triangles& triangles, int t, int vertex) {
  return triangles(t, 0) == vertex ? 0 : triangles(t, 1) == vertex ? 1 : 2;
}

}  // namespace ease
