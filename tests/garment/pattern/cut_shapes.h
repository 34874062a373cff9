// Surfaces that the tests of found cuts share.
#pragma once

#include "garment/pattern/region_levels.h"
#include "tests/garment/pattern/shapes.h"

namespace ease {

inline RestSurface surfaceOf(const TriangleMesh& mesh) {
  return restSurface(mesh, restGarment(mesh).rest_edges);
}

inline RestSurface flatSheet(int n, double size) {
  return surfaceOf(bentSheet(n, size, [](double, double) { return 0.0; }));
}

/// Part of a sphere of radius 0.2 m over a square of 0.2 m.
inline RestSurface cap(int n) {
  return surfaceOf(bentSheet(n, 0.2, [](double x, double y) { return std::sqrt(0.04 - x * x - y * y); }));
}

/// Two labels, the second within `radius` of (x, y), m.
inline RegionLevels discLevels(const RestSurface& surface, double radius, double x = 0.0, double y = 0.0) {
  const int n = surface.vertexCount();
  RegionLevels levels{2, std::vector<double>(2 * n)};
  for (int v = 0; v < n; ++v) {
    levels.of(1)[v] = std::hypot(surface.mesh.positions(v, 0) - x, surface.mesh.positions(v, 1) - y) - radius;
    levels.of(0)[v] = -levels.of(1)[v];
  }
  return levels;
}

/// Two labels, the second where x > `at`, m.
inline RegionLevels halves(const RestSurface& surface, double at) {
  const int n = surface.vertexCount();
  RegionLevels levels{2, std::vector<double>(2 * n)};
  for (int v = 0; v < n; ++v) {
    levels.of(1)[v] = at - surface.mesh.positions(v, 0);
    levels.of(0)[v] = -levels.of(1)[v];
  }
  return levels;
}

}  // namespace ease
