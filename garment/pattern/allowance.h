// Seam allowance: the cut line around the sew line.
//
//         Q_______ P        corner C of edges A (fold) and B, directions a and b, widths w_a and w_b
//     A'  :       \.        A', B'  offset lines
//   ------:--C     \ B'     P       where B' meets A, beyond C
//     A       \     \.      Q       on A', where the mirror image of B' in A meets it
//           B  \     \.
//
//   mitre        A' and B' go on until they meet, at most kMitre widths from C; beyond that the corner is cut off
//   mirror       A' ends at Q, then goes by way of P to B': folded along A, the allowance of A ends exactly on the cut
//                line of B
//   two mirrors  both, where the corner is sharp and it does not matter which seam is pressed first
//   step         where edges of different widths meet with hardly a corner, such as a bound neck and a shoulder
//   dart         its legs have none; the cut line runs across the mouth as a roof, which lies on the cut line of the
//                seam once the dart is folded
//
// An edge of the garment, such as its hem, is folded: there A is that edge.
#pragma once

#include "garment/pattern/drawing.h"

namespace ease {

/// An edge of a piece's sew line.
struct SewnEdge {
  std::vector<PaperPoint> points;  // mm; the last is the first of the next edge
  double width = 0.0;              // mm, of the allowance
  bool is_folded = false;          // an edge of the garment, sewn to nothing
  bool is_dart = false;            // a leg of a dart: it and the next edge, or it and the one before
};

/// The cut line, counter-clockwise, of a piece whose edges run counter-clockwise.  Throws InputError about `name`, in
/// words, where it cannot be followed.
std::vector<PaperPoint> cutLine(const std::vector<SewnEdge>& edges, const std::string& name = "a piece");

}  // namespace ease
