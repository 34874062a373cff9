// A drawing on sheets of paper that a printer takes, to be glued together.
//
//    A1 | A2 | A3      A page shows a tile of the drawing and, on the right and below, a strip that the next page is
//    ---+----+---      glued on.  Crosses at a quarter and three quarters of every edge lie on those of the neighbour.
//    B1 | B2 |         Tiles without a line are left out.  The first page has the plan of all pages.
#pragma once

#include "garment/pattern/pdf_file.h"

namespace ease {

struct Paper {
  double width = 210.0, height = 297.0;  // mm; A4
};

/// Cover and tiles.
std::vector<PdfPage> paperTiles(const Drawing& drawing, const Paper& paper);

}  // namespace ease
