// A drawing as SVG in millimetres: one group per piece, in it one per kind of line, which Inkscape shows as layers.
#pragma once

#include <string>

#include "garment/pattern/drawing.h"

namespace ease {

/// The text of the SVG file.
std::string svgText(const Drawing& drawing);

/// Returns the text with <, >, & and quotes as SVG and HTML want them.
std::string escaped(const std::string& text);

/// Colour of lines, 0xRRGGBB: red is cut, blue is sewn, green are marks; as laser cutters take them.
int colourOf(Ink ink);

}  // namespace ease
