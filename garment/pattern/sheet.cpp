#include "garment/pattern/sheet.h"

namespace ease {
namespace {

constexpr double kGap = 10.0;    // mm between cut lines
constexpr double kBand = 66.0;   // mm above the pieces, for the box and the title
constexpr double kMargin = 8.0;  // mm

}  // namespace

Drawing drawSheet(const std::string& title, const std::vector<DrawnPiece>& pieces, double cloth_width,
                  const std::vector<std::string>& notes) {
  const Layout layout = layOut(pieces, cloth_width, kGap);
  Drawing sheet;
  sheet.title = title;
  sheet.width = std::max(layout.width, 190.0) + 2.0 * kMargin;
  sheet.height = layout.length + kBand + 2.0 * kMargin;
  sheet.pieces.resize(pieces.size());
  for (const Placement& placement : layout.placements)
    sheet.pieces[placement.piece] =
        placed(pieces[placement.piece], placement.is_turned, placement.by + PaperPoint(kMargin, kMargin));
  const PaperPoint corner(kMargin, sheet.height - kMargin - kTestBox);
  sheet.lines.push_back({Ink::paper,
                         {corner, corner + PaperPoint(kTestBox, 0.0), corner + PaperPoint(kTestBox, kTestBox),
                          corner + PaperPoint(0.0, kTestBox)},
                         true});
  sheet.texts.push_back({corner + PaperPoint(0.5 * kTestBox, 0.5 * kTestBox - 1.5), 3.0, 0.0, "5 cm x 5 cm"});
  const double x = corner.x() + kTestBox + 70.0, top = corner.y() + kTestBox;
  sheet.texts.push_back({{x, top - 8.0}, 6.0, 0.0, title});
  sheet.notes = {"right side of the cloth up; red: cut, blue: sew, green: notches, grain"};
  sheet.notes.insert(sheet.notes.end(), notes.begin(), notes.end());
  std::vector<std::string> lines = sheet.notes;
  lines.emplace_back("the box is 5 cm wide: print at 100 %, not fitted to the page");
  for (size_t i = 0; i < lines.size(); ++i)
    sheet.texts.push_back({{x, top - 19.0 - 8.0 * static_cast<double>(i)}, 3.0, 0.0, lines[i]});
  return sheet;
}

double clothLength(const std::vector<DrawnPiece>& pieces, double cloth_width) {
  std::vector<DrawnPiece> all = pieces;
  for (const DrawnPiece& piece : pieces)
    if (piece.mirrored) all.push_back(mirrorImage(piece));
  return layOut(all, cloth_width, kGap).length;
}

}  // namespace ease
