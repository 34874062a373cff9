// A limb in poses between which bodies are interpolated.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A closed limb along x from 0 to 1, each point (x, y, z) of it moved to place(x, y, z).
template <class Place>
TriangleMesh makeLimbAt(const Place& place) {
  const int around = 12, along = 30;
  TriangleMesh limb;
  limb.positions.resize(around * (along + 1) + 2, 3);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double a = 2.0 * M_PI * i / around, x = static_cast<double>(j) / along;
      limb.positions.row(j * around + i) = place(x, 0.05 * std::cos(a), 0.05 * std::sin(a));
    }
  const int first = around * (along + 1), last = first + 1;
  limb.positions.row(first) = place(-0.02, 0.0, 0.0);
  limb.positions.row(last) = place(1.02, 0.0, 0.0);
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    triangles.push_back({first, next, i});
    triangles.push_back({last, along * around + i, along * around + next});
    for (int j = 0; j < along; ++j) {
      const int a = j * around + i, b = j * around + next;
      triangles.push_back({a, b, a + around});
      triangles.push_back({b, b + around, a + around});
    }
  }
  limb.triangles.resize(static_cast<int>(triangles.size()), 3);
  for (size_t t = 0; t < triangles.size(); ++t)
    limb.triangles.row(static_cast<int>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  return limb;
}

/// Bent at x = 0.5 about the z axis by `angle`, smoothly.
inline TriangleMesh makeLimb(double angle) {
  return makeLimbAt([&](double x, double y, double z) {
    const double s = std::clamp((x - 0.35) / 0.3, 0.0, 1.0);
    const Mat3 R = Eigen::AngleAxisd(angle * s * s * (3.0 - 2.0 * s), Vec3::UnitZ()).toRotationMatrix();
    return Vec3(Vec3(0.5, 0.0, 0.0) + R * Vec3(x - 0.5, y, z));
  });
}

/// Twisted about its axis by `angle` from end to end.
inline TriangleMesh makeTwistedLimb(double angle) {
  return makeLimbAt(
      [&](double x, double y, double z) { return Vec3(Eigen::AngleAxisd(angle * x, Vec3::UnitX()) * Vec3(x, y, z)); });
}

inline double largestMove(const Positions& a, const Positions& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

}  // namespace ease
