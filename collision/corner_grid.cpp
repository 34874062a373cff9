#include "collision/corner_grid.h"

#include <bit>
#include <limits>

#include "solver/base/parallel.h"

namespace ease {

namespace {

using Leaf = CornerGrid::Leaf;
using openvdb::Coord;

constexpr int kSide = Leaf::DIM;                                      // corners along one side of a leaf
constexpr float kUnfilled = std::numeric_limits<float>::quiet_NaN();  // distance of a corner not computed yet

Coord origin(const MarkedBlock& block) {
  return Coord(block.origin[0], block.origin[1], block.origin[2]);
}

/// Calls visit(offset) for each corner of the block, in the order of a leaf's buffer.
template <class Visit>
void visitCorners(const MarkedBlock& block, const Visit& visit) {
  for (int x = 0; x < kSide; ++x)
    for (std::uint64_t left = block.corners[x]; left != 0; left &= left - 1)
      visit(x * kSide * kSide + std::countr_zero(left));
}

int cornerCount(const MarkedBlock& block) {
  int count = 0;
  for (const std::uint64_t slab : block.corners) count += std::popcount(slab);
  return count;
}

/// Whether all eight corners of the voxel whose lowest corner is at `offset` are filled; all must lie in the leaf.  A
/// slab of the leaf's mask (constant x) is a 64-bit word, a row along z is a byte of it.
bool isVoxelFilled(const Leaf& leaf, openvdb::Index offset) {
  constexpr std::uint64_t kFace = 0x0303;
  const openvdb::Index slab = offset / (kSide * kSide);
  const auto& mask = leaf.getValueMask();
  const std::uint64_t both = mask.getWord<std::uint64_t>(slab) & mask.getWord<std::uint64_t>(slab + 1);
  return ((both >> (offset % (kSide * kSide))) & kFace) == kFace;
}

}  // namespace

CornerGrid::CornerGrid(double voxel) : grid(openvdb::FloatGrid::create(kUnfilled)) {
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
}

void CornerGrid::clear() {
  grid->tree().clear();
  leaves.clear();
}

Leaf& CornerGrid::leafOf(const Coord& corner, openvdb::tree::ValueAccessor<Tree, false>& accessor) {
  if (Leaf* leaf = accessor.probeLeaf(corner)) return *leaf;
  Leaf* leaf = accessor.touchLeaf(corner);
  leaf->setTransientData(static_cast<openvdb::Index32>(leaves.size()));
  leaves.push_back(leaf);
  if (corners.size() < leaves.size() * Leaf::SIZE) {
    corners.resize(leaves.size() * Leaf::SIZE);
    nearest.resize(corners.size());
  }
  return *leaf;
}

void CornerGrid::turnOn(const std::vector<MarkedBlock>& blocks) {
  openvdb::tree::ValueAccessor<Tree, false> accessor(grid->tree());
  for (const MarkedBlock& block : blocks) {
    auto& mask = leafOf(origin(block), accessor).getValueMask();
    for (int x = 0; x < kSide; ++x) mask.getWord<std::uint64_t>(x) |= block.corners[x];
  }
}

void CornerGrid::fill(const KnownCorners& known, std::vector<Leaf::NodeMaskType>& filled) {
  turnOn(known.blocks);
  filled.assign(leaves.size(), Leaf::NodeMaskType());
  parallelFor(static_cast<int>(known.blocks.size()), 16, [&](int b) {
    const MarkedBlock& block = known.blocks[b];
    Leaf& leaf = *grid->tree().probeLeaf(origin(block));
    for (int x = 0; x < kSide; ++x) filled[leaf.transientData()].getWord<std::uint64_t>(x) = block.corners[x];
    int next = known.first[b];
    visitCorners(block, [&](int offset) {
      corners[place(leaf, offset)] = known.values[next];
      nearest[place(leaf, offset)] = known.nearest[next];
      leaf.buffer().data()[offset] = known.values[next++].phi;
    });
  });
}

KnownCorners CornerGrid::known() const {
  KnownCorners known;
  int count = 0;
  for (const Leaf* leaf : leaves) {
    MarkedBlock block{{leaf->origin()[0], leaf->origin()[1], leaf->origin()[2]}, {}};
    for (int x = 0; x < kSide; ++x) block.corners[x] = leaf->getValueMask().getWord<std::uint64_t>(x);
    known.blocks.push_back(block);
    known.first.push_back(count);
    count += cornerCount(block);
  }
  known.values.resize(count);
  known.nearest.resize(count);
  parallelFor(static_cast<int>(leaves.size()), 16, [&](int l) {
    int next = known.first[l];
    visitCorners(known.blocks[l], [&](int offset) {
      known.values[next] = corners[place(*leaves[l], offset)];
      known.nearest[next++] = nearest[place(*leaves[l], offset)];
    });
  });
  return known;
}

bool CornerGrid::findVoxel(const Coord& low, Accessor& accessor, const VoxelCorner** corner) const {
  const Leaf* lowest = accessor.probeConstLeaf(low);
  const openvdb::Index offset = Leaf::coordToOffset(low);
  const auto last = [&](int axis) { return (low[axis] & (kSide - 1)) == kSide - 1; };
  if (!(last(0) | last(1) | last(2))) {
    if (!lowest || !isVoxelFilled(*lowest, offset)) return false;
    const VoxelCorner* first = &corners[place(*lowest, static_cast<int>(offset))];
    for (int c = 0; c < 8; ++c) corner[c] = first + (c >> 2) * kSide * kSide + ((c >> 1) & 1) * kSide + (c & 1);
    return true;
  }
  // `crossed` has a bit for each axis along which the upper corners lie in the next leaf.  Corners with equal bits
  // there lie in the same leaf, which the first of them looks up.
  const int crossed = (last(0) ? 4 : 0) + (last(1) ? 2 : 0) + (last(2) ? 1 : 0);
  const Leaf* leaf[8];
  for (int c = 0; c < 8; ++c) {
    const Coord at = low.offsetBy(c >> 2, (c >> 1) & 1, c & 1);
    leaf[c] = c == 0 ? lowest : (c & crossed) == c ? accessor.probeConstLeaf(at) : leaf[c & crossed];
    if (!leaf[c] || !leaf[c]->isValueOn(Leaf::coordToOffset(at))) return false;
    corner[c] = &corners[place(*leaf[c], static_cast<int>(Leaf::coordToOffset(at)))];
  }
  return true;
}

size_t CornerGrid::memoryBytes() const {
  return grid->tree().memUsage() + corners.capacity() * (sizeof(VoxelCorner) + sizeof(int)) +
         leaves.capacity() * sizeof(Leaf*);
}

}  // namespace ease
