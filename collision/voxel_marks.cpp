#include "collision/voxel_marks.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kNone = -1, kWanted = 0;  // entries of the table before its blocks are numbered

/// Sets bits atomically, because other threads may set bits of the same word.  Does not write if all are set already,
/// which keeps the caches of other cores valid.
void setBits(std::uint64_t& word, std::uint64_t bits) {
  std::atomic_ref shared(word);
  if ((shared.load(std::memory_order_relaxed) & bits) != bits) shared.fetch_or(bits, std::memory_order_relaxed);
}

/// Returns a byte with the bits from `low` to `high` set, both included.
std::uint64_t bitRange(int low, int high) {
  return (0xffull >> (7 - (high - low))) << low;
}

/// Marks the corners from `low` to `high`, both included; all must lie in this block.
void markWithinBlock(MarkedBlock& block, const GridPoint& low, const GridPoint& high) {
  constexpr std::uint64_t kOneARow = 0x0101010101010101;  // times a row: that row repeated eight times
  const std::uint64_t row = bitRange(low[2] & 7, high[2] & 7);
  const int first = low[1] & 7, rows = (high[1] & 7) - first + 1;
  const std::uint64_t slab = row * ((kOneARow >> (8 * (8 - rows))) << (8 * first));
  for (int x = low[0] & 7; x <= (high[0] & 7); ++x) setBits(block.corners[x], slab);
}

}  // namespace

/// Divides the range by blocks and calls visit(index in the table, low, high) for its part in each block.
template <class Visit>
void VoxelMarks::visitBlocks(const Range& range, const Visit& visit) const {
  const auto end = [&](int at, int axis) { return std::min(at | 7, range.high[axis]); };
  for (int x = range.low[0]; x <= range.high[0]; x = end(x, 0) + 1)
    for (int y = range.low[1]; y <= range.high[1]; y = end(y, 1) + 1)
      for (int z = range.low[2]; z <= range.high[2]; z = end(z, 2) + 1) {
        const int place = (((x >> 3) - first_[0]) * size_[1] + (y >> 3) - first_[1]) * size_[2] + (z >> 3) - first_[2];
        visit(place, GridPoint{x, y, z}, GridPoint{end(x, 0), end(y, 1), end(z, 2)});
      }
}

void VoxelMarks::mark(std::span<const Vec3> points, double margin, double voxel, const Eigen::AlignedBox3d& reach) {
  blocks_.clear();
  Eigen::AlignedBox3d needed;
  for (const Vec3& x : points) needed.extend(x);
  if (needed.isEmpty()) return;
  const Vec3 around = Vec3::Constant(margin);
  needed = Eigen::AlignedBox3d(needed.min() - around, needed.max() + around).intersection(reach);
  if (needed.isEmpty()) return;

  const double per_voxel = 1.0 / voxel;
  const auto cell = [&](double x) { return static_cast<int>(std::floor(x * per_voxel)); };
  for (int axis = 0; axis < 3; ++axis) {
    first_[axis] = cell(needed.min()[axis]) >> 3;
    size_[axis] = ((cell(needed.max()[axis]) + 1) >> 3) - first_[axis] + 1;
  }
  table_.assign(static_cast<size_t>(size_[0]) * size_[1] * size_[2], kNone);
  ranges_.resize(points.size());
  const int count = static_cast<int>(points.size());
  parallelFor(count, 2048, [&](int i) {
    const Eigen::AlignedBox3d box = Eigen::AlignedBox3d(points[i] - around, points[i] + around).intersection(needed);
    ranges_[i] = {{0, 0, 0}, {-1, -1, -1}};  // empty
    if (box.isEmpty()) return;
    for (int axis = 0; axis < 3; ++axis) {
      ranges_[i].low[axis] = cell(box.min()[axis]);
      ranges_[i].high[axis] = cell(box.max()[axis]) + 1;
    }
    visitBlocks(ranges_[i], [&](int place, const GridPoint&, const GridPoint&) {
      std::atomic_ref(table_[place]).store(kWanted, std::memory_order_relaxed);
    });
  });
  createBlocks();
  parallelFor(count, 2048, [&](int i) {
    visitBlocks(ranges_[i], [&](int place, const GridPoint& low, const GridPoint& high) {
      markWithinBlock(blocks_[table_[place]], low, high);
    });
  });
}

void VoxelMarks::createBlocks() {
  size_t place = 0;
  for (int x = 0; x < size_[0]; ++x)
    for (int y = 0; y < size_[1]; ++y)
      for (int z = 0; z < size_[2]; ++z, ++place) {
        if (table_[place] == kNone) continue;
        table_[place] = static_cast<int>(blocks_.size());
        blocks_.push_back({{8 * (first_[0] + x), 8 * (first_[1] + y), 8 * (first_[2] + z)}, {}});
      }
}

}  // namespace ease
