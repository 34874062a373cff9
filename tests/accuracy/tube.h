// A tube of cloth and the bodies that it is put on.
#pragma once

#include "solver/model/cloth.h"
#include "tests/accuracy/meshes.h"
#include "tests/collision/bodies.h"
#include "tests/sheet.h"

namespace ease {

constexpr double kTubeOffset = 0.005;             // m
constexpr int kTubeAround = 48, kTubeAlong = 12;  // triangles

/// A capsule about the y axis whose round ends are far from the cloth; the same triangles for every radius.
inline TriangleMesh cylinder(double radius) {
  TriangleMesh body = bodies::capsule(0.15, 0.1, 24);
  body.positions.col(0) *= radius / 0.1;
  body.positions.col(2) *= radius / 0.1;
  return body;
}

/// A tube on a cylinder of this radius, from y = -0.06 m to 0.06 m.
inline TriangleMesh tubeOn(double radius) {
  TriangleMesh tube = makeTube(kTubeAround, kTubeAlong, radius + kTubeOffset, 0.12);
  tube.positions.col(1).array() -= 0.06;
  return tube;
}

/// Lengths of all rings at rest: their weft edges.
inline std::vector<double> restCircumferences(const Cloth& cloth) {
  std::vector<double> lengths(kTubeAlong, 0.0);
  for (int t = 0; t < cloth.triangleCount(); t += 2)  // a, a + around, b
    lengths[t / (2 * kTubeAround)] += cloth.restEdges()[t].col(1).norm();
  return lengths;
}

}  // namespace ease
