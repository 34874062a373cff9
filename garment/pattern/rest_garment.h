// The garment that a pattern is made of, and what becomes of its mesh so that lines run along edges.
#pragma once

#include <array>
#include <vector>

#include "garment/looped_mesh.h"
#include "garment/seam.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

/// A garment at rest, as a mesh and as the flat triangles that it consists of.
struct RestGarment {
  TriangleMesh mesh;             // in space, m; tells front from back, not how long anything is
  std::vector<Mat2> rest_edges;  // of every triangle, m; rows: warp and weft
  std::vector<Seam> seams;
  std::vector<NamedLoop> loops;
};

/// A vertex of the cut garment as a mean of vertices of the uncut one.
struct CutVertex {
  std::array<int, 3> from;
  Vec3 share;
};

/// A garment whose lines run along edges that it did not have before: its triangles were cut, or its vertices slid
/// within its surface.
struct CutUp {
  RestGarment garment;
  std::vector<CutVertex> vertices;  // the uncut garment's come first
  std::vector<int> source;          // of every triangle: the uncut triangle that it is a part of, or that it was
};

}  // namespace ease
