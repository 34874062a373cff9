#include "collision/level_set.h"

#include <fmt/format.h>
#include <openvdb/openvdb.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "collision/body_self_overlap.h"
#include "collision/triangle_tree_data.h"
#include "collision/voxel_blend.h"
#include "collision/voxel_marks.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
using Accessor = openvdb::tree::ValueAccessor<const Tree, false>;
using openvdb::Coord;

constexpr int kSide = Leaf::DIM;                                      // corners along one side of a leaf
constexpr float kUnfilled = std::numeric_limits<float>::quiet_NaN();  // phi of a corner not computed yet

struct Voxel {
  Leaf* leaf;
  int offset;
};

/// Finds a filled corner one step before the corner at `offset` along z, y or x, in that order; -1: none.
int filledNeighbour(const Leaf& leaf, int offset) {
  for (int step = 1; step < kSide * kSide * kSide; step *= kSide)
    if ((offset / step) % kSide > 0 && leaf.isValueOn(static_cast<openvdb::Index>(offset - step))) return offset - step;
  return -1;
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

struct LevelSet::Data {
  LevelSetOptions options;
  double per_voxel;    // 1 / side of a voxel, 1/m
  double corner_band;  // m: corners up to this far from the surface are exact; enough for samples within the band
  float far;           // m: corner_band in single precision: |phi| of the corners beyond it
  VoxelMarks marks;
  openvdb::FloatGrid::Ptr grid;
  std::vector<Leaf*> leaves;         // transientData() of leaf l is l
  std::vector<VoxelCorner> corners;  // those of leaf l begin at 512 l, in the order of its buffer, which holds phi too
  std::vector<int> nearest;          // triangle nearest to each corner; -1 beyond the band
  const TriangleTree* body = nullptr;
  Eigen::AlignedBox3d reach;                   // m: outside this box every distance is beyond the band
  std::vector<unsigned char> nearest_to_some;  // by triangle: whether it is nearest to any corner
  BodySelfOverlap overlap;
  long filled_on_demand = 0;
  std::vector<int> missed;  // samples that need an unfilled corner
  std::vector<Voxel> demanded;

  Vec3 position(const Coord& corner) const { return options.voxel * Vec3(corner[0], corner[1], corner[2]); }
  Coord cell(const Vec3& x) const {
    const auto floor = [&](int axis) { return static_cast<int>(std::floor(x[axis] * per_voxel)); };
    return Coord(floor(0), floor(1), floor(2));
  }

  void createLeaves();
  void resizeCorners();
  void fillLeaf(Leaf& leaf);
  void resolveOverlap();
  void fillVoxel(const Voxel& voxel);
  void store(const Voxel& voxel, const Vec3& x, const ClosestPoint& found);
  Vec3 gradientAt(const Vec3& x, const ClosestPoint& found) const;
  void demand(const Coord& corner, openvdb::tree::ValueAccessor<Tree, false>& accessor);
  bool findCorners(const Coord& low, Accessor& accessor, const VoxelCorner** corner) const;
  LevelSetSample sampleAt(const Vec3& x, Accessor& accessor) const;
  LevelSetSample exactAt(const Vec3& x, int nearby) const;
};

LevelSet::LevelSet(const LevelSetOptions& options) : data_(std::make_unique<Data>()) {
  if (!(options.voxel > 0.0 && std::isfinite(options.voxel)))
    throw InputError(fmt::format("level set: voxel = {} m, must be positive", options.voxel));
  if (!(options.band > 0.0 && std::isfinite(options.band)))
    throw InputError(fmt::format("level set: band = {} m, must be positive", options.band));
  data_->options = options;
  data_->per_voxel = 1.0 / options.voxel;
  data_->corner_band = options.band + std::sqrt(3.0) * options.voxel;
  data_->far = static_cast<float>(data_->corner_band);
  data_->grid = openvdb::FloatGrid::create(kUnfilled);
  data_->grid->setTransform(openvdb::math::Transform::createLinearTransform(options.voxel));
}

LevelSet::~LevelSet() = default;
LevelSet::LevelSet(LevelSet&&) noexcept = default;
LevelSet& LevelSet::operator=(LevelSet&&) noexcept = default;

void LevelSet::build(const TriangleTree& body, std::span<const Vec3> points, double margin) {
  Data& data = *data_;
  for (size_t i = 0; i < points.size(); ++i)
    if (!points[i].allFinite()) throw ComputationError(fmt::format("level set: point {} is not finite", i));
  data.body = &body;
  data.filled_on_demand = 0;
  data.reach = body.bounds();
  if (!data.reach.isEmpty()) {
    data.reach.min().array() -= data.options.band;
    data.reach.max().array() += data.options.band;
  }
  data.grid->tree().clear();
  data.marks.mark(points, margin, data.options.voxel, data.reach);
  data.createLeaves();
  data.nearest_to_some.assign(body.data().triangles.rows(), 0);
  parallelFor(static_cast<int>(data.leaves.size()), 1, [&](int l) { data.fillLeaf(*data.leaves[l]); });
  data.resolveOverlap();
}

void LevelSet::Data::createLeaves() {
  leaves.clear();
  for (const MarkedBlock& block : marks.blocks()) {
    Leaf* leaf = grid->tree().touchLeaf(Coord(block.origin[0], block.origin[1], block.origin[2]));
    for (int x = 0; x < kSide; ++x) leaf->getValueMask().getWord<std::uint64_t>(x) = block.corners[x];
    leaf->setTransientData(static_cast<openvdb::Index32>(leaves.size()));
    leaves.push_back(leaf);
  }
  resizeCorners();
}

void LevelSet::Data::resizeCorners() {
  corners.resize(leaves.size() * Leaf::SIZE);
  nearest.resize(corners.size());
}

/// Computes signed distances.  Their signs come from pseudonormals: wrong only where the surface overlaps itself.
void LevelSet::Data::fillLeaf(Leaf& leaf) {
  const int* filled = &nearest[leaf.transientData() * size_t{Leaf::SIZE}];
  const float* phi = leaf.buffer().data();
  for (auto on = leaf.getValueMask().beginOn(); on; ++on) {
    const int offset = static_cast<int>(on.pos()), before = filledNeighbour(leaf, offset);
    const Vec3 x = position(leaf.offsetToGlobalCoord(on.pos()));
    ClosestPoint found = body->closest(x, corner_band, before >= 0 ? filled[before] : -1);
    if (found.triangle >= 0) {
      if ((x - found.point).dot(found.pseudonormal) < 0.0) found.distance = -found.distance;
      std::atomic_ref(nearest_to_some[found.triangle]).store(1, std::memory_order_relaxed);
    } else {
      // Two neighbours beyond the band have equal signs, because no surface lies between them.
      const bool has_known_sign = before >= 0 && filled[before] < 0;
      if (has_known_sign ? phi[before] < 0.0f : body->windingNumber(x) > 0) found.distance = -found.distance;
    }
    store({&leaf, offset}, x, found);
  }
}

/// Recomputes, as distances to the union, the corners whose nearest triangle crosses another or is buried in the body.
void LevelSet::Data::resolveOverlap() {
  overlap.find(*body, nearest_to_some);
  if (overlap.crossing() + overlap.buried() == 0) return;
  const std::span<const Exposure> exposures = overlap.exposures();
  parallelFor(static_cast<int>(leaves.size()), 1, [&](int l) {
    for (auto on = leaves[l]->getValueMask().beginOn(); on; ++on) {
      const int triangle = nearest[l * size_t{Leaf::SIZE} + on.pos()];
      if (triangle < 0 || exposures[triangle] == Exposure::boundary) continue;
      const Vec3 x = position(leaves[l]->offsetToGlobalCoord(on.pos()));
      store({leaves[l], static_cast<int>(on.pos())}, x, body->closestOfUnion(x, corner_band, triangle, exposures));
    }
  });
}

void LevelSet::Data::fillVoxel(const Voxel& voxel) {
  const Vec3 x = position(voxel.leaf->offsetToGlobalCoord(voxel.offset));
  store(voxel, x, body->closestOfUnion(x, corner_band));
}

Vec3 LevelSet::Data::gradientAt(const Vec3& x, const ClosestPoint& found) const {
  if (found.triangle < 0) return Vec3::Zero();
  // On the surface the direction to the closest point is only round-off, so the pseudonormal replaces it.
  const bool on_surface = std::abs(found.distance) < 1e-7 * options.voxel;
  return on_surface ? found.pseudonormal.normalized() : Vec3((x - found.point) / found.distance);
}

void LevelSet::Data::store(const Voxel& voxel, const Vec3& x, const ClosestPoint& found) {
  const Vec3 gradient = gradientAt(x, found);
  voxel.leaf->buffer().data()[voxel.offset] = static_cast<float>(found.distance);
  const size_t at = voxel.leaf->transientData() * size_t{Leaf::SIZE} + voxel.offset;
  for (int axis = 0; axis < 3; ++axis) corners[at].gradient[axis] = static_cast<float>(gradient[axis]);
  corners[at].phi = static_cast<float>(found.distance);
  nearest[at] = found.triangle;
}

/// Finds the eight corners of the voxel whose lowest corner is `low`; returns false if one is not filled.
bool LevelSet::Data::findCorners(const Coord& low, Accessor& accessor, const VoxelCorner** corner) const {
  const Leaf* lowest = accessor.probeConstLeaf(low);
  const openvdb::Index offset = Leaf::coordToOffset(low);
  const auto last = [&](int axis) { return (low[axis] & (kSide - 1)) == kSide - 1; };
  if (!(last(0) | last(1) | last(2))) {
    if (!lowest || !isVoxelFilled(*lowest, offset)) return false;
    const VoxelCorner* first = &corners[lowest->transientData() * size_t{Leaf::SIZE} + offset];
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
    corner[c] = &corners[leaf[c]->transientData() * size_t{Leaf::SIZE} + Leaf::coordToOffset(at)];
  }
  return true;
}

LevelSetSample LevelSet::Data::sampleAt(const Vec3& x, Accessor& accessor) const {
  if (!reach.contains(x)) return {x.allFinite() ? options.band : kUnfilled, Vec3::Zero(), -1};
  const Vec3 index = x * per_voxel;
  const Coord low = cell(x);
  VoxelCorners around;
  for (int axis = 0; axis < 3; ++axis) around.within[axis] = static_cast<float>(index[axis] - low[axis]);
  if (!findCorners(low, accessor, around.corner)) return {kUnfilled, Vec3::Zero(), -1};
  const VoxelBlend found = blend(around, options.voxel, far);
  if (found.beyond || std::abs(found.phi) >= options.band)
    return {std::copysign(options.band, found.phi), Vec3::Zero(), -1};
  const int triangle = nearest[around.corner[found.closest] - corners.data()];
  if (found.folded) return exactAt(x, triangle);
  return {found.phi, found.normal, triangle};
}

LevelSetSample LevelSet::Data::exactAt(const Vec3& x, int nearby) const {
  const ClosestPoint found = body->closestOfUnion(x, corner_band, nearby, overlap.exposures());
  if (found.triangle < 0 || std::abs(found.distance) >= options.band)
    return {std::copysign(options.band, found.distance), Vec3::Zero(), -1};
  return {found.distance, gradientAt(x, found), found.triangle};
}

void LevelSet::sample(std::span<const Vec3> points, std::span<LevelSetSample> samples) {
  Data& data = *data_;
  constexpr int kBlock = 512;
  const int count = static_cast<int>(points.size());
  parallelFor((count + kBlock - 1) / kBlock, 1, [&](int block) {
    Accessor accessor(data.grid->tree());
    for (int i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i)
      samples[i] = data.sampleAt(points[i], accessor);
  });
  data.missed.clear();
  for (int i = 0; i < count; ++i)
    if (std::isnan(samples[i].phi)) data.missed.push_back(i);
  if (data.missed.empty()) return;

  data.demanded.clear();
  openvdb::tree::ValueAccessor<Tree, false> marker(data.grid->tree());
  for (int i : data.missed) {
    if (!points[i].allFinite()) throw ComputationError(fmt::format("level set: sample {} is not finite", i));
    for (int c = 0; c < 8; ++c) data.demand(data.cell(points[i]).offsetBy(c >> 2, (c >> 1) & 1, c & 1), marker);
  }
  parallelFor(static_cast<int>(data.demanded.size()), 16, [&](int v) { data.fillVoxel(data.demanded[v]); });
  data.filled_on_demand += std::ssize(data.demanded);
  Accessor accessor(data.grid->tree());
  for (int i : data.missed) samples[i] = data.sampleAt(points[i], accessor);
}

void LevelSet::Data::demand(const Coord& corner, openvdb::tree::ValueAccessor<Tree, false>& accessor) {
  Leaf* leaf = accessor.probeLeaf(corner);
  if (!leaf) {
    leaf = accessor.touchLeaf(corner);
    leaf->setTransientData(static_cast<openvdb::Index32>(leaves.size()));
    leaves.push_back(leaf);
    resizeCorners();
  }
  const openvdb::Index offset = Leaf::coordToOffset(corner);
  if (leaf->isValueOn(offset)) return;
  leaf->getValueMask().setOn(offset);
  demanded.push_back({leaf, static_cast<int>(offset)});
}

size_t LevelSet::memoryBytes() const {
  return data_->grid->tree().memUsage() + data_->corners.capacity() * (sizeof(VoxelCorner) + sizeof(int)) +
         data_->leaves.capacity() * sizeof(Leaf*) + data_->nearest_to_some.capacity() + data_->overlap.memoryBytes();
}

long LevelSet::filledVoxels() const {
  return static_cast<long>(data_->grid->tree().activeVoxelCount());
}
long LevelSet::filledOnDemand() const {
  return data_->filled_on_demand;
}
long LevelSet::overlappingTriangles() const {
  return data_->overlap.crossing() + data_->overlap.buried();
}

}  // namespace ease
