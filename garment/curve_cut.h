// Cutting a triangle mesh exactly along curves that cross its edges.
//
//        c
//       / \          a triangle that curves pass is split into convex polygons, these into triangles; the points of
//      p---q         curves become vertices p, q, shared by the triangles on either side
//     /     \.
//    a-------b
#pragma once

#include <vector>

#include "garment/boundary_loop.h"

namespace ease {

struct CutMesh {
  TriangleMesh mesh;                     // the vertices of the uncut mesh come first
  std::vector<int> source;               // triangle of the uncut mesh that each triangle is a part of
  std::vector<std::vector<int>> curves;  // vertices along each curve
};

/// Throws InputError naming two loops that cross or touch.
CutMesh cutAlong(const TriangleMesh& mesh, const Topology& topology, const std::vector<BoundaryLoop>& loops);

}  // namespace ease
