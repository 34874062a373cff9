// A drawing as PDF 1.6 at its true size: on one sheet, or on tiles of paper that are glued together.
//
// Every file holds the drawing once, as a form in millimetres that the pages show parts of.  Text is Helvetica, which
// every reader has; letters that it lacks become question marks.
#pragma once

#include <vector>

#include "garment/pattern/drawing.h"

namespace ease {

/// What a page shows: the drawing, or nothing, within a box; then lines and words of its own.  Millimetres of the page.
struct PdfPage {
  double width = 0.0, height = 0.0;
  struct View {
    PaperPoint at = PaperPoint::Zero();  // of the drawing's lower left corner
    double scale = 1.0;
    PaperPoint lower = PaperPoint::Zero(), upper = PaperPoint::Zero();  // box to which it is clipped
  };
  std::vector<View> views;
  std::vector<DrawnLine> lines;
  std::vector<DrawnText> texts;
};

/// A file of these pages.
std::string pdfText(const Drawing& drawing, const std::vector<PdfPage>& pages);

/// The page that shows the whole drawing.
PdfPage wholePage(const Drawing& drawing);

}  // namespace ease
