#include "garment/pattern/region_map.h"

#include "solver/mesh/disjoint_sets.h"

namespace ease {

Division divide(const std::array<int, 3>& labels) {
  Division division;
  const auto part = [&](int a, int b, int c, int corner) {
    division.parts[division.part_count++] = {{a, b, c}, corner};
  };
  if (labels[0] != labels[1] && labels[1] != labels[2] && labels[2] != labels[0]) {
    for (int k = 0; k < 3; ++k) {
      const int after = 3 + (k + 2) % 3, before = 3 + (k + 1) % 3;  // crossings on the edges to the next, to the last
      part(k, after, 6, k);
      part(k, 6, before, k);
      division.lines[division.line_count++] = {3 + k, 6};
    }
    return division;
  }
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    if (labels[k] == labels[i] || labels[k] == labels[j]) continue;
    part(k, 3 + j, 3 + i, k);  // corner k lies alone
    part(3 + j, i, 3 + i, i);
    part(i, j, 3 + i, i);
    division.lines[division.line_count++] = {3 + j, 3 + i};
    return division;
  }
  part(0, 1, 2, 0);
  return division;
}

std::array<Vec2, 7> pointsOf(const RestSurface& surface, const RegionMap& map, int t) {
  std::array<Vec2, 7> points;
  for (int k = 0; k < 3; ++k) points[k] = surface.corner(t, k);
  points[6].setZero();
  for (int k = 0; k < 3; ++k) {
    const int e = surface.topology.triangle_edges(t, k), i = (k + 1) % 3, j = (k + 2) % 3;
    const bool from_i = surface.topology.edges[e].vertex[0] == surface.mesh.triangles(t, i);
    const double s = from_i ? map.crossing[e] : 1.0 - map.crossing[e];
    points[3 + k] = (1.0 - s) * points[i] + s * points[j];
    points[6] += points[3 + k] / 3.0;
  }
  return points;
}

Regions connectedRegions(const RestSurface& surface, const RegionMap& map) {
  DisjointSets sets(surface.vertexCount());
  for (const Edge& edge : surface.topology.edges)
    if (!isCrossed(map, edge)) sets.join(edge.vertex[0], edge.vertex[1]);
  Regions regions{std::vector<int>(surface.vertexCount(), -1), {}};
  std::vector<int> number(surface.vertexCount(), -1);
  for (int v = 0; v < surface.vertexCount(); ++v) {
    int& region = number[sets.find(v)];
    if (region < 0) {
      region = static_cast<int>(regions.area.size());
      regions.area.push_back(0.0);
    }
    regions.of[v] = region;
  }
  for (int t = 0; t < surface.triangleCount(); ++t)
    for (int k = 0; k < 3; ++k) regions.area[regions.of[surface.mesh.triangles(t, k)]] += surface.area[t] / 3.0;
  return regions;
}

}  // namespace ease
