// Places pieces on cloth of a given width, the grain along it, so that as little length as possible is used.
//
// Each piece goes where its lower side rests on what lies below, as low as possible, then as far left as possible, or
// upside down where that is lower.  Many orders of the pieces are tried, always the same ones.
#pragma once

#include "garment/pattern/drawing.h"

namespace ease {

struct Placement {
  size_t piece;
  bool is_turned;  // by half a turn
  PaperPoint by;   // mm
};

struct Layout {
  std::vector<Placement> placements;
  double width = 0.0, length = 0.0;  // mm, that are used
};

/// Lays out pieces on cloth whose usable width is `cloth_width`, mm.  `gap`: least distance of cut lines, mm.  Throws
/// InputError naming a piece that is wider than the cloth.
Layout layOut(const std::vector<DrawnPiece>& pieces, double cloth_width, double gap);

}  // namespace ease
