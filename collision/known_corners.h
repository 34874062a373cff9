// What a level set has computed, packed, to be taken over by another level set of the same body in the same pose.
#pragma once

#include <vector>

#include "collision/triangle_tree.h"
#include "collision/voxel_blend.h"
#include "collision/voxel_marks.h"

namespace ease {

/// Filled corners without the space between them: an eighth of the memory of the grid that they came from.
struct KnownCorners {
  std::vector<MarkedBlock> blocks;  // which corners; the values follow in the order of blocks and of bits
  std::vector<int> first;           // by block: place of its first value
  std::vector<VoxelCorner> values;
  std::vector<int> nearest;         // triangle nearest to each corner; -1 beyond the band
  std::vector<Exposure> exposures;  // by triangle of the body; unknown where no corner asked

  size_t memoryBytes() const {
    return blocks.capacity() * (sizeof(MarkedBlock) + sizeof(int)) +
           values.capacity() * (sizeof(VoxelCorner) + sizeof(int)) + exposures.capacity();
  }
};

}  // namespace ease
