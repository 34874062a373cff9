// Closed surfaces with known distances, points around them, measures of meshes.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease::bodies {

inline TriangleMesh meshOf(const std::vector<Vec3>& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  TriangleMesh mesh;
  mesh.positions.resize(static_cast<long>(vertices.size()), 3);
  mesh.triangles.resize(static_cast<long>(triangles.size()), 3);
  for (size_t v = 0; v < vertices.size(); ++v) mesh.positions.row(static_cast<long>(v)) = vertices[v];
  for (size_t t = 0; t < triangles.size(); ++t) mesh.triangles.row(static_cast<long>(t)) = triangles[t];
  return mesh;
}

/// A box of twelve triangles.
inline TriangleMesh box(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> vertices;
  for (int v = 0; v < 8; ++v)
    vertices.emplace_back(v & 1 ? high[0] : low[0], v & 2 ? high[1] : low[1], v & 4 ? high[2] : low[2]);
  return meshOf(vertices, {{0, 2, 3},
                           {0, 3, 1},
                           {4, 5, 7},
                           {4, 7, 6},
                           {0, 1, 5},
                           {0, 5, 4},
                           {2, 6, 7},
                           {2, 7, 3},
                           {0, 4, 6},
                           {0, 6, 2},
                           {1, 3, 7},
                           {1, 7, 5}});
}

/// A capsule around the axis from (0, -half_length, 0) to (0, half_length, 0); a sphere for half_length 0.  `rings`:
/// strips of triangles on each half sphere; those on the tube are as wide.
inline TriangleMesh capsule(double half_length, double radius, int rings) {
  const int around = 4 * rings;
  std::vector<Vec3> vertices = {{0.0, -half_length - radius, 0.0}};
  const auto ring = [&](double latitude, double shift) {
    for (int i = 0; i < around; ++i) {
      const double longitude = 2.0 * std::numbers::pi * i / around;
      vertices.push_back(radius * Vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                       std::cos(latitude) * std::cos(longitude)) +
                         Vec3(0.0, shift, 0.0));
    }
  };
  const double step = 0.5 * std::numbers::pi / rings;
  const int tube = static_cast<int>(std::ceil(2.0 * half_length / (radius * step)));
  for (int r = 1; r <= rings; ++r) ring(-0.5 * std::numbers::pi + r * step, -half_length);
  for (int s = 1; s <= tube; ++s) ring(0.0, half_length * (2.0 * s / tube - 1.0));
  for (int r = 1; r < rings; ++r) ring(r * step, half_length);
  vertices.emplace_back(0.0, half_length + radius, 0.0);
  const int last = static_cast<int>(vertices.size()) - 1, strips = (last - 1) / around - 1;
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around, top = 1 + strips * around;
    triangles.emplace_back(0, 1 + j, 1 + i);
    triangles.emplace_back(last, top + i, top + j);
    for (int s = 0; s < strips; ++s) {
      const int a = 1 + s * around + i, b = 1 + s * around + j;
      triangles.emplace_back(a, b, b + around);
      triangles.emplace_back(a, b + around, a + around);
    }
  }
  return meshOf(vertices, triangles);
}

inline TriangleMesh sphere(double radius, int rings) {
  return capsule(0.0, radius, rings);
}

inline TriangleMesh moved(TriangleMesh mesh, const Vec3& shift) {
  mesh.positions.rowwise() += shift.transpose();
  return mesh;
}

inline TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh mesh;
  mesh.positions.resize(a.positions.rows() + b.positions.rows(), 3);
  mesh.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  mesh.positions << a.positions, b.positions;
  mesh.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.positions.rows())).matrix();
  return mesh;
}

/// Volume that a closed surface encloses, m^3.
inline double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 a = mesh.positions.row(mesh.triangles(t, 0)), b = mesh.positions.row(mesh.triangles(t, 1));
    const Vec3 c = mesh.positions.row(mesh.triangles(t, 2));
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

/// Smallest angle over all triangles, degrees.
inline double smallestAngle(const TriangleMesh& mesh) {
  double least = 180.0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = mesh.positions.row(mesh.triangles(t, k));
      const Vec3 u = mesh.positions.row(mesh.triangles(t, (k + 1) % 3)).transpose() - a;
      const Vec3 v = mesh.positions.row(mesh.triangles(t, (k + 2) % 3)).transpose() - a;
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / std::numbers::pi);
    }
  return least;
}

/// Points spread evenly but irregularly over a box; every run gets the same points.
inline std::vector<Vec3> pointsIn(const Vec3& low, const Vec3& high, int count) {
  std::vector<Vec3> points(count);
  for (int i = 0; i < count; ++i) {
    const Vec3 share(std::fmod(0.5 + i * 0.8191725133961645, 1.0), std::fmod(0.5 + i * 0.6710436067037893, 1.0),
                     std::fmod(0.5 + i * 0.5497004779019703, 1.0));
    points[i] = low + share.cwiseProduct(high - low);
  }
  return points;
}

inline double distanceToBox(const Vec3& x, const Vec3& low, const Vec3& high) {
  const Vec3 beyond = (low - x).cwiseMax(x - high);
  return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

inline double distanceToCapsule(const Vec3& x, double half_length, double radius) {
  return (x - Vec3(0.0, std::clamp(x[1], -half_length, half_length), 0.0)).norm() - radius;
}

/// Signed distance to the union of two spheres of equal radius around the points (+-offset, 0, 0).
inline double distanceToTwoSpheres(const Vec3& x, double offset, double radius) {
  const Vec3 mirrored(std::abs(x[0]), x[1], x[2]);  // nearer to the sphere on the right
  const Vec3 from_centre = mirrored - Vec3(offset, 0.0, 0.0);
  const double plain = from_centre.norm() - radius;
  // Seen from inside, the sphere's nearest point may lie in the other sphere; then the seam is nearest.
  const bool nearest_is_buried = from_centre[0] * radius + offset * from_centre.norm() < 0.0;
  if (plain >= 0.0 || !nearest_is_buried) return plain;
  const double seam = std::sqrt(radius * radius - offset * offset);
  return -std::hypot(std::hypot(x[1], x[2]) - seam, x[0]);
}

}  // namespace ease::bodies
