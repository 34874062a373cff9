// The sewing pattern that `ease pattern` wrote, as it is shown in the plane, and where its pieces and lines lie on the
// garment.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/studio/tool.h"
#include "garment/pattern/drawing.h"

namespace ease {

/// A vertex of the pattern as a mean of vertices of the garment.
struct GarmentPoint {
  std::vector<std::pair<int, double>> shares;  // vertex, share of it
};

/// A part of a piece's outline.
struct SheetEdge {
  std::string name;  // of the seam, dart or opening, or of the garment's boundary
  bool is_sewn = false;
  std::vector<PaperPoint> points;        // mm
  std::vector<GarmentPoint> on_garment;  // of each point
};

struct SheetPiece {
  std::string name;
  std::vector<int> numbers;            // of the piece, and of its mirror image where that is cut from the same drawing
  std::vector<PaperPoint> cut, grain;  // mm
  PaperPoint name_at;                  // mm
  std::vector<SheetEdge> edges;
};

/// A piece, or a line by its name; none: nothing is picked.
struct SheetPick {
  enum class What { none, piece, line } what = What::none;
  size_t piece = 0;
  std::string line;
  bool is_sewn = false;  // a line that is sewn; else a boundary of the garment
  bool operator==(const SheetPick&) const = default;
};

struct PatternSheet {
  std::shared_ptr<const MadeGarment> made;            // the garment that it is of
  std::vector<SheetPiece> pieces;                     // as drawn
  std::vector<std::vector<int>> triangles;            // of the garment, for each number of a piece
  std::vector<std::pair<std::string, double>> seams;  // length to sew by name, m

  Bounds bounds() const;
  /// What lies under a point: a line within `near` (mm) of it, else the piece around it.
  SheetPick at(const PaperPoint& point, double near) const;
  /// Whether the line with this name is one of the pattern's.
  bool has(const std::string& line, bool is_sewn) const;
  /// What was picked, for people.
  std::string wordsOf(const SheetPick& pick) const;
};

/// Reads pattern.json and pattern.vtp from a directory.  Throws InputError naming a file that is missing or of another
/// garment.
PatternSheet readPatternSheet(const std::filesystem::path& directory, std::shared_ptr<const MadeGarment> made);

/// Lights on the garment what is picked on paper.  Does nothing where the garment has other triangles by now.
void addPatternMarks(const PatternSheet& sheet, const SheetPick& pick, const Stage& stage, Marks& marks);

}  // namespace ease
