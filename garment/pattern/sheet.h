// All pieces of a pattern on one sheet, with a test box and what the marks mean.
#pragma once

#include "garment/pattern/layout.h"

namespace ease {

constexpr double kTestBox = 50.0;  // mm, side of the box by which users see whether a print has the right size

/// The sheet; its pieces lie on it as they may lie on cloth `cloth_width` mm wide.  Throws InputError as layOut() does.
/// `notes`: what to know before cutting, a few lines.
Drawing drawSheet(const std::string& title, const std::vector<DrawnPiece>& pieces, double cloth_width,
                  const std::vector<std::string>& notes = {});

/// Length of cloth that all pieces take, mirrored ones cut twice, mm.
double clothLength(const std::vector<DrawnPiece>& pieces, double cloth_width);

/// Lines of a notch: from the cut line inwards.
inline DrawnLine notchLine(const Notch& notch) {
  return {Ink::notch, {notch.at, notch.at + notch.depth * notch.inward}, false};
}

}  // namespace ease
