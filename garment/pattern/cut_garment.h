// The garment cut into the pieces of its sewing pattern: which vertices, triangles and outlines they have, and which
// edges of them are sewn together.
//
//        neck                an outline runs counter-clockwise, seen from outside the garment; it is divided where
//       .----.               another line or another piece begins, and at the tips of darts
//      /      \  shoulder
//     |  front |             lines that end inside a piece are darts; a piece that is no disk after all lines were cut
//     |   /\   | side        is cut once more, along the shortest way (makeDisks)
//     '--'  '--'
//        hem
#pragma once

#include <string>
#include <vector>

#include "garment/looped_mesh.h"
#include "garment/pieces.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

enum class LineKind {
  seam,    // asked for
  opened,  // cut so that a piece is a disk
  dart,
};

/// A line of the mesh's edges along which the garment is cut.
struct CutLine {
  Seam seam;
  LineKind kind = LineKind::seam;
};

/// A part of a piece's outline.
struct PieceEdge {
  int piece = 0;
  std::vector<int> vertices;  // of the cut mesh, in order along the outline
  int line = -1;              // number of the cut line; -1: an edge of the garment, such as the hem
  LineKind kind = LineKind::seam;
  std::string name;  // of the line, or of the garment's boundary loop
  int partner = -1;  // the edge that it is sewn to, whose vertices run the other way round; -1: none
};

struct CutGarment {
  Pieces pieces;  // its mesh is the cut mesh
  std::vector<PieceEdge> edges;
  std::vector<std::vector<int>> outlines;  // of each piece: its edges in order, counter-clockwise
};

/// Cuts the garment.  Throws InputError where a piece has no outline, several of them, or a handle.
CutGarment cutGarment(const TriangleMesh& garment, const std::vector<CutLine>& lines,
                      const std::vector<NamedLoop>& loops);

/// Lines that open pieces with several outlines along the shortest ways between these; `rest_edges` are the flat
/// edges of the triangles, m.  Throws InputError naming the loops and seams around a piece that cannot be opened.
std::vector<CutLine> makeDisks(const TriangleMesh& garment, const std::vector<Mat2>& rest_edges,
                               const std::vector<CutLine>& lines, const std::vector<NamedLoop>& loops);

/// Lengths of a flat triangle's edges opposite to its corners, m.
inline Vec3 edgeLengths(const Mat2& rest_edges) {
  return {(rest_edges.col(1) - rest_edges.col(0)).norm(), rest_edges.col(1).norm(), rest_edges.col(0).norm()};
}

}  // namespace ease
