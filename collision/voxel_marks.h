// Marks the corners of the grid voxels around a set of points, stored in blocks of 8 x 8 x 8 corners.
//
// Corner (i, j, k) is the point (i, j, k) times the side of a voxel.  In its block it is bit 8 (j mod 8) + k mod 8 of
// word i mod 8: a row along z is a byte, a slab of eight rows (constant i) is a 64-bit word.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

using GridPoint = std::array<int, 3>;

struct MarkedBlock {
  GridPoint origin;                           // lowest corner; its coordinates are multiples of 8
  std::array<std::uint64_t, 8> corners = {};  // one bit per corner
};

class VoxelMarks {
 public:
  /// Marks the corners of every voxel that is within `margin` (m, in each coordinate) of a point and within `reach`.
  /// Clears earlier marks.  `voxel` is the side of a voxel, m.  All points must be finite.
  void mark(std::span<const Vec3> points, double margin, double voxel, const Eigen::AlignedBox3d& reach);

  /// The blocks with at least one marked corner, in the order of their origins.
  const std::vector<MarkedBlock>& blocks() const { return blocks_; }

 private:
  struct Range {
    GridPoint low, high;  // corners, both included
  };
  template <class Visit>
  void visitBlocks(const Range& range, const Visit& visit) const;
  void createBlocks();

  GridPoint first_{}, size_{};  // lowest block of the table, and the size of the table, both in blocks
  std::vector<int> table_;      // by block of the table: its index in blocks_; -1: not marked
  std::vector<MarkedBlock> blocks_;
  std::vector<Range> ranges_;  // one per point
};

}  // namespace ease
