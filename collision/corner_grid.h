// What a level set knows at the corners of voxels, stored where corners are filled: distance, gradient, nearest
// triangle of the body.
//
// An OpenVDB tree finds the leaf of 8 x 8 x 8 corners that holds a corner, and tells which corners are filled.  The
// values of leaf l stand at 512 l in flat arrays, in the order of the leaf's buffer, which holds the distances too.
#pragma once

#include <openvdb/openvdb.h>

#include <vector>

#include "collision/known_corners.h"

namespace ease {

struct CornerGrid {
  using Tree = openvdb::FloatTree;
  using Leaf = Tree::LeafNodeType;
  using Accessor = openvdb::tree::ValueAccessor<const Tree, false>;

  openvdb::FloatGrid::Ptr grid;
  std::vector<Leaf*> leaves;  // transientData() of leaf l is l
  std::vector<VoxelCorner> corners;
  std::vector<int> nearest;  // triangle nearest to each corner; -1 beyond the band

  /// `voxel`: side of a voxel, m.
  explicit CornerGrid(double voxel);

  void clear();
  /// Returns the leaf that holds the corner, an empty one if there was none.
  Leaf& leafOf(const openvdb::Coord& corner, openvdb::tree::ValueAccessor<Tree, false>& accessor);
  /// Turns these corners on; their values are still to be computed.
  void turnOn(const std::vector<MarkedBlock>& blocks);
  /// Turns these corners on and stores their values.  `filled`: by leaf, which corners those are.
  void fill(const KnownCorners& known, std::vector<Leaf::NodeMaskType>& filled);
  /// All corners that are on, without exposures.
  KnownCorners known() const;

  size_t place(const Leaf& leaf, int offset) const { return leaf.transientData() * size_t{Leaf::SIZE} + offset; }
  /// Finds the eight corners of the voxel whose lowest corner is `low`; returns false if one is not filled.
  bool findVoxel(const openvdb::Coord& low, Accessor& accessor, const VoxelCorner** corner) const;

  size_t memoryBytes() const;
};

}  // namespace ease
