#include "collision/corner_grid.h"

#include <catch2/catch.hpp>

#include "collision/level_set.h"
#include "tests/collision/bodies.h"

using namespace ease;
using namespace ease::bodies;

namespace {

using Leaf = CornerGrid::Leaf;

MarkedBlock blockAt(int x, int y, int z, std::uint64_t slab) {
  MarkedBlock block{{x, y, z}, {}};
  block.corners.fill(slab);
  return block;
}

bool same(const std::vector<LevelSetSample>& a, const std::vector<LevelSetSample>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const LevelSetSample& s, const LevelSetSample& t) {
    return s.phi == t.phi && s.normal == t.normal && s.triangle == t.triangle;
  });
}

std::vector<LevelSetSample> sampled(LevelSet& level_set, const std::vector<Vec3>& points) {
  std::vector<LevelSetSample> samples(points.size());
  level_set.sample(points, samples);
  return samples;
}

}  // namespace

TEST_CASE("what one grid knows, another one is filled with") {
  CornerGrid grid(0.01);
  grid.turnOn({blockAt(8, 0, -8, 0x8001), blockAt(-8, 16, 0, 0x3)});
  REQUIRE(grid.leaves.size() == 2);
  float value = 0.0f;
  for (Leaf* leaf : grid.leaves)
    for (auto on = leaf->getValueMask().beginOn(); on; ++on) {
      const size_t at = grid.place(*leaf, static_cast<int>(on.pos()));
      grid.corners[at] = {{1.0f + value, 2.0f, 3.0f}, value};
      grid.nearest[at] = static_cast<int>(7.0f * value);
      ++value;
    }
  const KnownCorners known = grid.known();
  CHECK(known.values.size() == 32);

  CornerGrid other(0.01);
  other.turnOn({blockAt(8, 0, -8, 0x1100)});  // 0x100 is in no block of the first grid
  std::vector<Leaf::NodeMaskType> filled;
  other.fill(known, filled);
  REQUIRE(other.leaves.size() == 2);
  CHECK(filled[0].countOn() == 16);
  CHECK(other.leaves[0]->getValueMask().countOn() == 32);
  for (size_t l = 0; l < 2; ++l)
    for (auto on = filled[l].beginOn(); on; ++on) {
      const size_t at = grid.place(*grid.leaves[l], static_cast<int>(on.pos()));
      CHECK(other.corners[at].phi == grid.corners[at].phi);
      CHECK(other.corners[at].gradient[0] == grid.corners[at].gradient[0]);
      CHECK(other.nearest[at] == grid.nearest[at]);
      CHECK(other.leaves[l]->buffer().data()[on.pos()] == grid.corners[at].phi);
    }
}

TEST_CASE("a voxel across leaves is found once all of its corners are on") {
  CornerGrid grid(0.01);
  grid.turnOn({blockAt(0, 0, 0, ~0ull), blockAt(8, 0, 0, ~0ull)});
  CornerGrid::Accessor accessor(grid.grid->tree());
  const VoxelCorner* corner[8];
  CHECK(grid.findVoxel(openvdb::Coord(3, 3, 3), accessor, corner));
  CHECK(corner[7] - corner[0] == 64 + 8 + 1);
  CHECK(grid.findVoxel(openvdb::Coord(7, 3, 3), accessor, corner));
  CHECK(corner[4] - &grid.corners[0] == 512 + 3 * 8 + 3);
  CHECK(!grid.findVoxel(openvdb::Coord(3, 7, 3), accessor, corner));
  CHECK(!grid.findVoxel(openvdb::Coord(15, 0, 0), accessor, corner));
}

TEST_CASE("a level set with known corners is that of a new one, to the last bit") {
  const TriangleMesh ball = sphere(0.12, 16);
  for (const TriangleMesh& mesh :
       {ball, joined(moved(ball, Vec3(0.08, 0.0, 0.0)), moved(ball, Vec3(-0.08, 0.0, 0.0)))}) {
    const TriangleTree body(mesh.positions, mesh.triangles);
    const std::vector<Vec3> points = pointsIn(Vec3::Constant(-0.2), Vec3::Constant(0.2), 4000);
    const std::vector<Vec3> some(points.begin(), points.begin() + 2000), others(points.begin() + 2000, points.end());
    LevelSet first(LevelSetOptions{}), again(LevelSetOptions{}), fresh(LevelSetOptions{});
    first.build(body, some, 0.003);
    sampled(first, others);  // fills more corners on demand
    again.build(body, points, 0.003, first.known());
    fresh.build(body, points, 0.003);
    CHECK(same(sampled(again, points), sampled(fresh, points)));
    CHECK(again.filledOnDemand() == 0);
    CHECK(again.filledVoxels() >= fresh.filledVoxels());
  }
}
