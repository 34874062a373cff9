#include "garment/pattern/drawing.h"

#include <algorithm>

namespace ease {
namespace {

/// The piece with every point moved by `move`, and every direction by `turn`.
template <class Move, class Turn>
DrawnPiece moved(const DrawnPiece& piece, const Move& move, const Turn& turn) {
  DrawnPiece result = piece;
  for (PaperPoint& p : result.cut) p = move(p);
  for (PaperPoint& p : result.sew) p = move(p);
  for (DrawnLine& line : result.lines)
    for (PaperPoint& p : line.points) p = move(p);
  for (Notch& notch : result.notches) {
    notch.at = move(notch.at);
    notch.inward = turn(notch.inward);
  }
  for (PaperPoint& p : result.drills) p = move(p);
  for (DrawnText& text : result.texts) text.at = move(text.at);
  return result;
}

}  // namespace

Bounds boundsOf(const std::vector<PaperPoint>& points) {
  Bounds bounds{points.front(), points.front()};
  for (const PaperPoint& p : points) {
    bounds.lower = bounds.lower.cwiseMin(p);
    bounds.upper = bounds.upper.cwiseMax(p);
  }
  return bounds;
}

double areaWithin(const std::vector<PaperPoint>& points) {
  double area = 0.0;
  for (size_t i = 0; i < points.size(); ++i) {
    const PaperPoint &a = points[i], &b = points[(i + 1) % points.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

DrawnPiece placed(const DrawnPiece& piece, bool is_turned, const PaperPoint& by) {
  const double sign = is_turned ? -1.0 : 1.0;
  DrawnPiece result = moved(
      piece, [&](const PaperPoint& p) -> PaperPoint { return sign * p + by; },
      [&](const PaperPoint& d) -> PaperPoint { return sign * d; });
  result.axes *= sign;
  result.origin = sign * piece.origin + by;
  if (is_turned)
    for (DrawnText& text : result.texts) text.angle += text.angle > 0.0 ? -180.0 : 180.0;
  return result;
}

DrawnPiece mirrorImage(const DrawnPiece& piece) {
  const auto mirror = [](const PaperPoint& p) -> PaperPoint { return {-p.x(), p.y()}; };
  DrawnPiece result = moved(piece, mirror, mirror);
  result.axes.row(0) *= -1.0;
  result.origin.x() *= -1.0;
  std::reverse(result.cut.begin(), result.cut.end());
  std::reverse(result.sew.begin(), result.sew.end());
  for (DrawnText& text : result.texts) text.angle = -text.angle;
  return result;
}

}  // namespace ease
