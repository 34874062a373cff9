// A pattern as DXF in the form of the apparel industry (AAMA, later ASTM D6673), AutoCAD R12, always in millimetres:
// one block per piece, inserted once.  Layers are numbers:
//
//    1  cut line, texts   2  corners of the cut line   3  its other points   4  notches   7  grain   8  inner lines
//   13  drill holes      14  sew line                 15  words
//
// A notch is a point on the cut line with its depth as z and the direction inwards as angle, in degrees.
#pragma once

#include "garment/pattern/drawing.h"

namespace ease {

/// The text of the DXF file.
std::string dxfText(const Drawing& drawing);

}  // namespace ease
