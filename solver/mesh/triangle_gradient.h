// Deformation gradient of a triangle: how its flat rest shape became the shape in space.
//
//   E = [x1 - x0, x2 - x0]   3x2 edges in space, m
//   D                        2x2 the same edges at rest, in the material's plane (columns; rows: warp, weft), m
//   F = E D^-1               3x2, dimensionless; columns f_u, f_v: where warp and weft directions went
#pragma once

#include <Eigen/LU>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
using Mat32 = Eigen::Matrix<double, 3, 2>;

/// 3x2 edges of triangle t, m.
inline Mat32 edgeMatrix(const Positions& x, const Triangles& triangles, int t) {
  Mat32 edges;
  edges.col(0) = x.row(triangles(t, 1)) - x.row(triangles(t, 0));
  edges.col(1) = x.row(triangles(t, 2)) - x.row(triangles(t, 0));
  return edges;
}

/// Derivatives of F by the three vertices, one a row: F = sum_a x_a row(a).  1/m.
inline Mat32 shapeGradients(const Mat2& rest_inverse) {
  Mat32 b;
  b.row(1) = rest_inverse.row(0);
  b.row(2) = rest_inverse.row(1);
  b.row(0) = -b.row(1) - b.row(2);
  return b;
}

/// Orthonormal frame (3x2) in the plane of a triangle with these edges; its first column is `direction` projected.
inline Mat32 planeFrame(const Mat32& edges, const Vec3& direction) {
  const Vec3 n = edges.col(0).cross(edges.col(1)).normalized();
  Mat32 frame;
  frame.col(0) = (direction - n * n.dot(direction)).normalized();
  frame.col(1) = n.cross(frame.col(0));
  return frame;
}

}  // namespace ease
