// Which corners of a grid of voxels lie around a set of points, in blocks of 8 x 8 x 8.
//
// Corner (i, j, k) is the point (i, j, k) times the voxel's length.  Of the block that holds it, it is bit 8 (j mod 8)
// + k mod 8 of word i mod 8: a row along z is a byte, a slab of eight rows a word.
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
  GridPoint origin;                           // lowest corner; multiples of 8
  std::array<std::uint64_t, 8> corners = {};  // one bit each
};

class VoxelMarks {
 public:
  /// Marks the corners of every voxel within `margin` (m, by coordinate) of one of the points and within `reach`.  The
  /// points are finite.
  void mark(std::span<const Vec3> points, double margin, double voxel, const Eigen::AlignedBox3d& reach);

  /// In the order of their origins; each with at least one corner.
  const std::vector<MarkedBlock>& blocks() const { return blocks_; }

 private:
  struct Range {
    GridPoint low, high;  // corners, both included
  };
  template <class Visit>
  void visitBlocks(const Range& range, const Visit& visit) const;
  void createBlocks();

  GridPoint first_{}, size_{};  // of the table, in blocks
  std::vector<int> table_;      // by block: its place in blocks_; -1: none
  std::vector<MarkedBlock> blocks_;
  std::vector<Range> ranges_;  // of the points
};

}  // namespace ease
