#include "collision/voxel_marks.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/collision/bodies.h"

using namespace ease;
using namespace ease::bodies;

namespace {

std::set<GridPoint> cornersOf(const VoxelMarks& marks) {
  std::set<GridPoint> corners;
  for (const MarkedBlock& block : marks.blocks())
    for (int x = 0; x < 8; ++x)
      for (int bit = 0; bit < 64; ++bit)
        if (block.corners[x] >> bit & 1u)
          corners.insert({block.origin[0] + x, block.origin[1] + bit / 8, block.origin[2] + bit % 8});
  return corners;
}

const Eigen::AlignedBox3d kEverywhere(Vec3::Constant(-10.0), Vec3::Constant(10.0));

}  // namespace

TEST_CASE("exactly the corners of the voxels around the points are marked") {
  const double voxel = 0.125, margin = 0.05;
  const std::vector<Vec3> points = pointsIn(Vec3::Constant(-2.0), Vec3::Constant(2.0), 200);
  std::set<GridPoint> expected;
  for (const Vec3& x : points) {
    GridPoint low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = static_cast<int>(std::floor((x[axis] - margin) / voxel));
      high[axis] = static_cast<int>(std::floor((x[axis] + margin) / voxel)) + 1;
    }
    for (int i = low[0]; i <= high[0]; ++i)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int k = low[2]; k <= high[2]; ++k) expected.insert({i, j, k});
  }
  VoxelMarks marks;
  marks.mark(points, margin, voxel, kEverywhere);
  CHECK(cornersOf(marks) == expected);
}

TEST_CASE("marking clears earlier marks") {
  VoxelMarks marks;
  marks.mark(pointsIn(Vec3::Constant(-2.0), Vec3::Constant(2.0), 200), 0.1, 0.1, kEverywhere);
  marks.mark(std::vector<Vec3>{Vec3::Constant(0.55)}, 0.01, 0.1, kEverywhere);
  CHECK(cornersOf(marks).size() == 8);
  marks.mark({}, 0.01, 0.1, kEverywhere);
  CHECK(marks.blocks().empty());
}

TEST_CASE("nothing is marked out of reach") {
  VoxelMarks marks;
  marks.mark(std::vector<Vec3>{Vec3(20.0, 0.0, 0.0), Vec3(0.0, 1e30, 0.0)}, 0.01, 0.1, kEverywhere);
  CHECK(marks.blocks().empty());
  marks.mark(std::vector<Vec3>{Vec3(20.0, 0.0, 0.0), Vec3::Constant(0.55)}, 0.01, 0.1, kEverywhere);
  CHECK(cornersOf(marks).size() == 8);
}
