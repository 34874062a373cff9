#include "garment/pattern/paper_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "garment/pattern/outline_crossing.h"
#include "garment/pattern/sheet.h"

namespace ease {
namespace {

constexpr double kMargin = 10.0;  // mm that printers leave
constexpr double kGlue = 10.0;    // mm, width of the strip that is glued on
constexpr double kCross = 4.0;    // mm, half a cross

DrawnLine boxLine(const PaperPoint& lower, const PaperPoint& upper) {
  return {Ink::paper, {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}, true};
}

bool meets(const std::vector<PaperPoint>& line, bool is_closed, const PaperPoint& lower, const PaperPoint& upper) {
  const PaperPoint corners[] = {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}};
  const size_t n = line.size();
  double s = 0.0, t = 0.0;
  for (size_t i = 0; i + (is_closed ? 0 : 1) < n; ++i) {
    const PaperPoint &a = line[i], &b = line[(i + 1) % n];
    const auto isWithin = [&](const PaperPoint& p) {
      return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
    };
    if (isWithin(a) || isWithin(b)) return true;
    for (int k = 0; k < 4; ++k)
      if (crossing(a, b, corners[k], corners[(k + 1) % 4], s, t)) return true;
  }
  return false;
}

/// Whether anything of a piece lies in a part of the drawing.
bool isWithin(const DrawnPiece& piece, const PaperPoint& lower, const PaperPoint& upper) {
  if (meets(piece.cut, true, lower, upper) || meets(piece.sew, true, lower, upper)) return true;
  for (const DrawnLine& line : piece.lines)
    if (meets(line.points, line.is_closed, lower, upper)) return true;
  for (const DrawnText& text : piece.texts)
    if (meets({text.at, text.at}, false, lower, upper)) return true;
  return false;
}

/// Names of the pieces in a part of the drawing.
std::vector<std::string> namesWithin(const Drawing& drawing, const PaperPoint& lower, const PaperPoint& upper) {
  std::vector<std::string> names;
  for (const DrawnPiece& piece : drawing.pieces)
    if (isWithin(piece, lower, upper)) names.push_back(piece.name);
  return names;
}

/// "A1": rows by letters from the top, columns by numbers from the left.
std::string tileName(int row, int column) {
  std::string letters;
  for (int r = row; r >= 0; r = r / 26 - 1) letters.insert(letters.begin(), static_cast<char>('A' + r % 26));
  return letters + std::to_string(column + 1);
}

struct Tile {
  int row, column;
  PaperPoint lower;                // its lower left corner in the drawing, mm
  std::vector<std::string> names;  // of the pieces on it
};

bool isAmong(const std::vector<Tile>& tiles, int row, int column) {
  return std::any_of(tiles.begin(), tiles.end(), [&](const Tile& t) { return t.row == row && t.column == column; });
}

/// The first names that fit, and how many more there are.
std::string fewNames(const std::vector<std::string>& names) {
  constexpr size_t kLetters = 40;
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0 && text.size() + names[i].size() > kLetters) return fmt::format("{} and {} more", text, names.size() - i);
    text += (i > 0 ? ", " : "") + names[i];
  }
  return text;
}

/// The part of the drawing in one tile, the names of the pieces on it and of the pages beside it.
PdfPage tilePage(const Paper& paper, const std::vector<Tile>& tiles, size_t i) {
  const Tile& tile = tiles[i];
  PdfPage page{paper.width, paper.height, {}, {}, {}};
  const PaperPoint from(kMargin, kMargin), to(paper.width - kMargin, paper.height - kMargin);
  page.views.push_back({from + PaperPoint(0.0, kGlue) - tile.lower, 1.0, from, to});
  const PaperPoint inner_from = from + PaperPoint(0.0, kGlue), inner_to = to - PaperPoint(kGlue, 0.0);
  page.lines.push_back(boxLine(inner_from, inner_to));
  page.lines.push_back(boxLine(from, to));
  const PaperPoint size = inner_to - inner_from;
  const auto cross = [&](const PaperPoint& at) {
    page.lines.push_back({Ink::paper, {at - PaperPoint(kCross, 0.0), at + PaperPoint(kCross, 0.0)}, false});
    page.lines.push_back({Ink::paper, {at - PaperPoint(0.0, kCross), at + PaperPoint(0.0, kCross)}, false});
  };
  for (const double share : {0.25, 0.75}) {
    cross(inner_from + PaperPoint(share * size.x(), 0.0));
    cross(inner_from + PaperPoint(share * size.x(), size.y()));
    cross(inner_from + PaperPoint(0.0, share * size.y()));
    cross(inner_from + PaperPoint(size.x(), share * size.y()));
  }
  const std::string name = tileName(tile.row, tile.column);
  for (const PaperPoint& at :
       {PaperPoint(inner_from.x() + 8.0, inner_to.y() - 8.0), PaperPoint(inner_to.x() - 8.0, inner_to.y() - 8.0),
        PaperPoint(inner_from.x() + 8.0, inner_from.y() + 4.0), PaperPoint(inner_to.x() - 8.0, inner_from.y() + 4.0)})
    page.texts.push_back({at, 4.0, 0.0, name});
  const PaperPoint box = from + PaperPoint(4.0, 3.0);
  page.lines.push_back(boxLine(box, box + PaperPoint(kTestBox, 4.0)));
  page.texts.push_back({box + PaperPoint(0.5 * kTestBox, 0.8), 2.4, 0.0, "5 cm"});
  const double foot = from.x() + 0.5 * size.x() + 28.0;  // middle of the words beside the box
  page.texts.push_back({{foot, from.y() + 3.4},
                        2.4,
                        0.0,
                        fmt::format("{}, page {} of {}: {}", name, i + 2, tiles.size() + 1, fewNames(tile.names))});
  if (isAmong(tiles, tile.row + 1, tile.column))
    page.texts.push_back(
        {{foot, from.y() + 0.4}, 2.4, 0.0, fmt::format("glue {} here", tileName(tile.row + 1, tile.column))});
  if (isAmong(tiles, tile.row, tile.column + 1))
    page.texts.push_back({to - PaperPoint(3.0, 0.5 * size.y()), 2.6, 90.0,
                          fmt::format("glue {} here", tileName(tile.row, tile.column + 1))});
  return page;
}

PdfPage coverPage(const Drawing& drawing, const Paper& paper, const std::vector<Tile>& tiles, const PaperPoint& step) {
  PdfPage cover{paper.width, paper.height, {}, {}, {}};
  const double top = paper.height - kMargin;
  cover.texts.push_back({{0.5 * paper.width, top - 8.0}, 6.0, 0.0, drawing.title});
  std::vector<std::string> lines = {
      fmt::format("{} pages; print them at 100 %, not fitted to the page", tiles.size() + 1),
      "measure the box: it must be 5 cm wide and high",
      "cut each page along its left and upper line, or fold it there; lay it on the strips of "
      "its neighbours, cross on cross"};
  lines.insert(lines.end(), drawing.notes.begin(), drawing.notes.end());
  const double foot = top - 20.0 - 6.0 * static_cast<double>(lines.size());  // of the words
  for (size_t i = 0; i < lines.size(); ++i)
    cover.texts.push_back({{0.5 * paper.width, top - 18.0 - 6.0 * static_cast<double>(i)}, 2.8, 0.0, lines[i]});
  const PaperPoint box(kMargin + 5.0, kMargin + 5.0);
  cover.lines.push_back(boxLine(box, box + PaperPoint(kTestBox, kTestBox)));
  cover.texts.push_back({box + PaperPoint(0.5 * kTestBox, 0.5 * kTestBox - 1.5), 3.0, 0.0, "5 cm x 5 cm"});
  int columns = 0, rows = 0;
  for (const Tile& tile : tiles) {
    columns = std::max(columns, tile.column + 1);
    rows = std::max(rows, tile.row + 1);
  }
  const double room_x = paper.width - 2.0 * kMargin, room_y = foot - (kMargin + kTestBox + 10.0);
  const double scale = std::min(room_x / (columns * step.x()), room_y / (rows * step.y()));
  const PaperPoint at(0.5 * (paper.width - scale * columns * step.x()), foot - scale * drawing.height);
  cover.views.push_back({at, scale, at, at + scale * PaperPoint(drawing.width, drawing.height)});
  for (const Tile& tile : tiles) {
    cover.lines.push_back(boxLine(at + scale * tile.lower, at + scale * (tile.lower + step)));
    const PaperPoint corner = at + scale * (tile.lower + PaperPoint(0.0, step.y()));  // beside the pieces' names
    cover.texts.push_back({corner + PaperPoint(3.5, -4.0), 2.8, 0.0, tileName(tile.row, tile.column)});
  }
  return cover;
}

}  // namespace

std::vector<PdfPage> paperTiles(const Drawing& drawing, const Paper& paper) {
  const PaperPoint step(paper.width - 2.0 * kMargin - kGlue, paper.height - 2.0 * kMargin - kGlue);
  const int columns = static_cast<int>(std::ceil(drawing.width / step.x())),
            rows = static_cast<int>(std::ceil(drawing.height / step.y()));
  std::vector<Tile> tiles;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const PaperPoint lower(column * step.x(), drawing.height - (row + 1) * step.y());
      std::vector<std::string> names = namesWithin(drawing, lower, lower + step);
      if (!names.empty()) tiles.push_back({row, column, lower, std::move(names)});
    }
  std::vector<PdfPage> pages = {coverPage(drawing, paper, tiles, step)};
  for (size_t i = 0; i < tiles.size(); ++i) pages.push_back(tilePage(paper, tiles, i));
  return pages;
}

}  // namespace ease
