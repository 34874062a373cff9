// The drawing of a pattern, from which all files are written.  Millimetres; x across the fabric, y along its threads of
// warp, upwards.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace ease {

using PaperPoint = Eigen::Vector2d;  // mm

enum class Ink {
  cut,    // where the cloth is cut
  sew,    // where it is sewn
  notch,  // marks within the allowance
  grain,  // along the warp
  inner,  // lines that are drawn on the cloth, such as the legs of a dart
  drill,  // holes
  paper,  // what is not for the cloth: the test box
};

struct DrawnLine {
  Ink ink;
  std::vector<PaperPoint> points;
  bool is_closed = false;
};

struct DrawnText {
  PaperPoint at;  // middle of its baseline
  double height;  // mm, of a capital letter
  double angle;   // degrees, counter-clockwise
  std::string words;
  bool in_picture = false;  // names of the piece and its darts, which are read at any size
};

/// A cut into the allowance, from the outline inwards.
struct Notch {
  PaperPoint at;      // on the cut line
  PaperPoint inward;  // unit vector
  double depth;       // mm
};

struct DrawnPiece {
  std::string name;
  int number = 0;                                      // from 1
  int count = 0;                                       // pieces in all
  int quantity = 1;                                    // to be cut
  bool mirrored = false;                               // of two, one is the mirror image
  int source = 0;                                      // number of the piece in the flat pattern, from 0
  int mirror_image = -1;                               // and of the one that is its mirror image; -1: none
  std::map<int, int> mirror_edges;                     // of CutGarment::edges: from this piece's to those of that one
  Eigen::Matrix2d axes = Eigen::Matrix2d::Identity();  // from (warp, weft), m, to the drawing, mm: axes * x + origin
  PaperPoint origin = PaperPoint::Zero();
  std::vector<PaperPoint> cut, sew;  // closed, counter-clockwise
  std::vector<DrawnLine> lines;      // grain, legs of darts
  std::vector<Notch> notches;
  std::vector<PaperPoint> drills;
  std::vector<DrawnText> texts;  // its name first
};

/// Pieces on one sheet, from (0, 0) to (width, height).
struct Drawing {
  std::string title;
  double width = 0.0, height = 0.0;  // mm
  std::vector<DrawnPiece> pieces;
  std::vector<DrawnLine> lines;  // the test box
  std::vector<DrawnText> texts;
  std::vector<std::string> notes;  // what to know before cutting
};

struct Bounds {
  PaperPoint lower, upper;
};
Bounds boundsOf(const std::vector<PaperPoint>& points);

/// Area that a closed line encloses, mm^2; positive if it runs counter-clockwise.
double areaWithin(const std::vector<PaperPoint>& points);

/// A piece turned by half a turn about the origin if asked, its words with it, then moved.
DrawnPiece placed(const DrawnPiece& piece, bool is_turned, const PaperPoint& by);

/// The mirror image of a piece; its words stay readable.
DrawnPiece mirrorImage(const DrawnPiece& piece);

}  // namespace ease
