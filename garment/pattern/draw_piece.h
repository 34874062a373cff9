// Draws the pieces of a flat pattern with all that a tailor needs to cut and sew them.
//
//   cut and sew line   allowance.h; the legs of darts straight and equally long
//   notches            of seams (notches.h) and at the mouth of darts, with a hole 1 cm before the tip
//   grain              a line with arrows along the warp
//   words              name, number, how often to cut it; along every seam its name and that of the piece to which it
//                      is sewn, and its allowance where that is not the usual one; the name of a dart beyond its tip
#pragma once

#include <algorithm>
#include <map>

#include "garment/pattern/drawing.h"
#include "garment/pattern/flat_pattern.h"

namespace ease {

/// Width of the allowance, m: that of all edges, and of edges by the name of their seam or loop.
struct Allowances {
  double all = 0.010;
  std::map<std::string, double> by_name;
  double widest() const {
    double width = all;
    for (const auto& [name, by_its_name] : by_name) width = std::max(width, by_its_name);
    return width;
  }
};

/// One drawing of every piece, each about its own origin.  Of two pieces that are mirror images within 2 mm only the
/// first is drawn, to be cut twice.
std::vector<DrawnPiece> drawPieces(const FlatPattern& pattern, const Allowances& allowances);

}  // namespace ease
