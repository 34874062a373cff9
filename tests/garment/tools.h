// A body, requests and measurements that the tests of the garment tools share.
#pragma once

#include <string>
#include <vector>

#include "garment/boundary_loop.h"
#include "tests/collision/bodies.h"

namespace ease {

using bodies::capsule;
using bodies::joined;
using bodies::moved;
using bodies::smallestAngle;

constexpr double kRadius = 0.12, kHalfLength = 0.3;  // m: size of the capsule around the y axis

inline TriangleMesh capsuleBody() {
  return capsule(kHalfLength, kRadius, 12);
}

inline LoopRequest planeLoop(const std::string& name, const Vec3& point, const Vec3& normal) {
  return {name, {}, {}, PlaneNear{point, normal, point}};
}

/// Requests a loop through `count` points around the capsule at height y + wave * sin(2 angle), m.
inline LoopRequest pointLoop(const std::string& name, double y, int count, double wave = 0.0) {
  LoopRequest loop{name, {}, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    loop.points.emplace_back(kRadius * std::sin(angle), y + wave * std::sin(2.0 * angle), kRadius * std::cos(angle));
  }
  return loop;
}

inline double areaOf(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (int t = 0; t < mesh.triangles.rows(); ++t) sum += triangleArea(mesh.positions, mesh.triangles, t);
  return sum;
}

inline long eulerCharacteristic(const TriangleMesh& mesh) {
  const Topology topology = buildTopology(mesh, "mesh");
  return mesh.positions.rows() - static_cast<long>(topology.edges.size()) + mesh.triangles.rows();
}

}  // namespace ease
