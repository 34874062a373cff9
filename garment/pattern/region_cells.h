// The regions of a garment inside one triangle: where which level is the lowest, level by level exactly.
//
//        2           Levels are linear in a triangle, so that the cell of a label, where its level is the lowest, is a
//       / \          convex polygon.  Its points lie where two of these meet:
//      /---\           side k of the triangle (opposite to corner k)   beta_k = 0
//     / cell\          a line against label j                          phi(label) = phi(j)
//    0-------1       beta: barycentric coordinates.
#pragma once

#include <array>
#include <vector>

#include "garment/pattern/region_levels.h"

namespace ease {

/// A point of a cell.
struct CellPoint {
  Vec3 beta;              // barycentric coordinates
  std::array<int, 2> on;  // what meets there: 0 to 2 a side of the triangle, 3 + j a line against label j
  int side;               // what the cell's border runs along from here to the next point, as above
};

struct Cell {
  int label = 0;
  std::vector<CellPoint> points;  // counter-clockwise
};

/// The cells of a triangle, reused from triangle to triangle.
class Cells {
 public:
  /// Finds the cells of triangle t, those with some area.
  void find(const RegionLevels& levels, const Triangles& triangles, int t);

  int count() const { return count_; }
  const Cell& operator[](int i) const { return cells_[i]; }

 private:
  void clip(const RegionLevels& levels, const std::array<int, 3>& corners, int other, Cell& cell);

  std::vector<Cell> cells_;
  std::vector<int> labels_;
  std::vector<CellPoint> clipped_;
  int count_ = 0;
};

/// Corner 0, 1 or 2 of the triangle that a point is; -1: none.
inline int cornerAt(const CellPoint& point) {
  return point.on[0] < 3 && point.on[1] < 3 ? 3 - point.on[0] - point.on[1] : -1;
}

/// Adds the derivative of an energy by the levels at the triangle's corners: `by_corner[c]` is its derivative by
/// beta_c, that is the force on the point times corner c.  `derivative` is ordered as levels.phi.
void addByLevels(const RegionLevels& levels, const std::array<int, 3>& corners, int label, const CellPoint& point,
                 const Vec3& by_corner, std::vector<double>& derivative);

}  // namespace ease
