// Cuts a triangle mesh exactly along curves that cross its edges.
//
//        c
//       / \          a triangle that curves pass is split into convex polygons, and those into triangles; the points
//      p---q         of the curves become vertices p, q, which the triangles on both sides share
//     /     \.
//    a-------b
#pragma once

#include <vector>

#include "garment/boundary_loop.h"

namespace ease {

struct CutMesh {
  TriangleMesh mesh;                     // the vertices of the uncut mesh come first
  std::vector<int> source;               // for each triangle, the triangle of the uncut mesh that it is a part of
  std::vector<std::vector<int>> curves;  // vertices along each curve
};

/// Cuts the mesh along the loops.  Throws InputError naming two loops that cross or touch.
CutMesh cutAlong(const TriangleMesh& mesh, const Topology& topology, const std::vector<BoundaryLoop>& loops);

}  // namespace ease
