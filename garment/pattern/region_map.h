// A garment divided into regions by lines that cross its triangles.
//
//   label of v            the region that vertex v lies in
//   crossing on (a, b)    where the line between two regions crosses an edge whose ends have different labels,
//                         (1 - s) x_a + s x_b
//
//        2              2            A triangle with corners in two regions is crossed by one line; with corners in
//       / |            / |           three, by three lines that meet in the mean of their crossings (point 6).
//      4--3           4. 3           Point 3 + k lies on the edge opposite to corner k.
//     /   |          / 6 |
//    0----1         0--5-1
#pragma once

#include <array>

#include "garment/pattern/rest_surface.h"

namespace ease {

struct RegionMap {
  std::vector<int> label;        // by vertex
  std::vector<double> crossing;  // by edge of the topology, from its first vertex; where its ends differ
};

/// How a triangle is divided.
struct Division {
  struct Part {
    std::array<int, 3> points;  // 0 to 6, as in the drawing
    int corner;                 // one that has the part's label
  };
  std::array<Part, 6> parts;
  int part_count = 0;
  std::array<std::array<int, 2>, 3> lines;  // points
  int line_count = 0;
};

/// Divides a triangle by its corners' labels.
Division divide(const std::array<int, 3>& labels);

/// Points 0 to 6 of triangle t in its plane, m; those that the division does not use are undefined.
std::array<Vec2, 7> pointsOf(const RestSurface& surface, const RegionMap& map, int t);

inline std::array<int, 3> labelsOf(const RestSurface& surface, const RegionMap& map, int t) {
  return {map.label[surface.mesh.triangles(t, 0)], map.label[surface.mesh.triangles(t, 1)],
          map.label[surface.mesh.triangles(t, 2)]};
}

/// Whether the ends of an edge lie in different regions.
inline bool isCrossed(const RegionMap& map, const Edge& edge) {
  return map.label[edge.vertex[0]] != map.label[edge.vertex[1]];
}

/// Connected regions of a map, numbered by their first vertex.
struct Regions {
  std::vector<int> of;       // by vertex
  std::vector<double> area;  // by region, m^2; about, as vertices have thirds of the triangles around them
};

Regions connectedRegions(const RestSurface& surface, const RegionMap& map);

}  // namespace ease
