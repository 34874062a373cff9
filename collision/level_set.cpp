#include "collision/level_set.h"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "collision/body_self_overlap.h"
#include "collision/corner_grid.h"
#include "collision/triangle_tree_data.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

using Leaf = CornerGrid::Leaf;
using Accessor = CornerGrid::Accessor;
using openvdb::Coord;

constexpr int kSide = Leaf::DIM;                                      // corners along one side of a leaf
constexpr float kUnfilled = std::numeric_limits<float>::quiet_NaN();  // phi of a sample that needs an unfilled corner

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

}  // namespace

struct LevelSet::Data {
  LevelSetOptions options;
  double per_voxel;    // 1 / side of a voxel, 1/m
  double corner_band;  // m: corners up to this far from the surface are exact; enough for samples within the band
  float far;           // m: corner_band in single precision: |phi| of the corners beyond it
  VoxelMarks marks;
  CornerGrid grid;
  std::vector<Leaf::NodeMaskType> known;  // by leaf: corners that build() was given
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

  explicit Data(const LevelSetOptions& given);
  void fillLeaf(Leaf& leaf);
  void resolveOverlap(std::span<const Exposure> known_exposures);
  void fillVoxel(const Voxel& voxel);
  void store(const Voxel& voxel, const Vec3& x, const ClosestPoint& found);
  Vec3 gradientAt(const Vec3& x, const ClosestPoint& found) const;
  void demand(const Coord& corner, openvdb::tree::ValueAccessor<CornerGrid::Tree, false>& accessor);
  LevelSetSample sampleAt(const Vec3& x, Accessor& accessor) const;
  LevelSetSample exactAt(const Vec3& x, int nearby) const;
};

LevelSet::Data::Data(const LevelSetOptions& given)
    : options(given),
      per_voxel(1.0 / given.voxel),
      corner_band(given.band + std::sqrt(3.0) * given.voxel),
      far(static_cast<float>(corner_band)),
      grid(given.voxel) {}

LevelSet::LevelSet(const LevelSetOptions& options) {
  if (!(options.voxel > 0.0 && std::isfinite(options.voxel)))
    throw InputError(fmt::format("level set: voxel = {} m, must be positive", options.voxel));
  if (!(options.band > 0.0 && std::isfinite(options.band)))
    throw InputError(fmt::format("level set: band = {} m, must be positive", options.band));
  data_ = std::make_unique<Data>(options);
}

LevelSet::~LevelSet() = default;
LevelSet::LevelSet(LevelSet&&) noexcept = default;
LevelSet& LevelSet::operator=(LevelSet&&) noexcept = default;

void LevelSet::build(const TriangleTree& body, std::span<const Vec3> points, double margin, const KnownCorners& known) {
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
  data.marks.mark(points, margin, data.options.voxel, data.reach);
  data.grid.clear();
  data.grid.turnOn(data.marks.blocks());
  data.grid.fill(known, data.known);
  data.nearest_to_some.assign(body.data().triangles.rows(), 0);
  parallelFor(static_cast<int>(data.grid.leaves.size()), 1, [&](int l) { data.fillLeaf(*data.grid.leaves[l]); });
  data.resolveOverlap(known.exposures);
}

void LevelSet::build(const TriangleTree& body, std::span<const Vec3> points, double margin) {
  build(body, points, margin, KnownCorners());
}

KnownCorners LevelSet::known() const {
  KnownCorners known = data_->grid.known();
  known.exposures.assign(data_->overlap.exposures().begin(), data_->overlap.exposures().end());
  return known;
}

/// Computes signed distances.  Their signs come from pseudonormals: wrong only where the surface overlaps itself.
void LevelSet::Data::fillLeaf(Leaf& leaf) {
  const int* filled = &grid.nearest[grid.place(leaf, 0)];
  const float* phi = leaf.buffer().data();
  for (auto on = leaf.getValueMask().beginOn(); on; ++on) {
    if (known[leaf.transientData()].isOn(on.pos())) continue;
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
void LevelSet::Data::resolveOverlap(std::span<const Exposure> known_exposures) {
  overlap.find(*body, nearest_to_some, known_exposures);
  if (overlap.crossing() + overlap.buried() == 0) return;
  const std::span<const Exposure> exposures = overlap.exposures();
  parallelFor(static_cast<int>(grid.leaves.size()), 1, [&](int l) {
    Leaf* leaf = grid.leaves[l];
    for (auto on = leaf->getValueMask().beginOn(); on; ++on) {
      const int triangle = grid.nearest[grid.place(*leaf, static_cast<int>(on.pos()))];
      if (known[l].isOn(on.pos()) || triangle < 0 || exposures[triangle] == Exposure::boundary) continue;
      const Vec3 x = position(leaf->offsetToGlobalCoord(on.pos()));
      store({leaf, static_cast<int>(on.pos())}, x, body->closestOfUnion(x, corner_band, triangle, exposures));
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
  const size_t at = grid.place(*voxel.leaf, voxel.offset);
  for (int axis = 0; axis < 3; ++axis) grid.corners[at].gradient[axis] = static_cast<float>(gradient[axis]);
  grid.corners[at].phi = static_cast<float>(found.distance);
  grid.nearest[at] = found.triangle;
}

LevelSetSample LevelSet::Data::sampleAt(const Vec3& x, Accessor& accessor) const {
  if (!reach.contains(x)) return {x.allFinite() ? options.band : kUnfilled, Vec3::Zero(), -1};
  const Vec3 index = x * per_voxel;
  const Coord low = cell(x);
  VoxelCorners around;
  for (int axis = 0; axis < 3; ++axis) around.within[axis] = static_cast<float>(index[axis] - low[axis]);
  if (!grid.findVoxel(low, accessor, around.corner)) return {kUnfilled, Vec3::Zero(), -1};
  const VoxelBlend found = blend(around, options.voxel, far);
  if (found.beyond || std::abs(found.phi) >= options.band)
    return {std::copysign(options.band, found.phi), Vec3::Zero(), -1};
  const int triangle = grid.nearest[around.corner[found.closest] - grid.corners.data()];
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
  std::atomic<bool> any_missed = false;
  parallelFor((count + kBlock - 1) / kBlock, 1, [&](int block) {
    Accessor accessor(data.grid.grid->tree());
    bool misses = false;
    for (int i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i) {
      samples[i] = data.sampleAt(points[i], accessor);
      misses |= std::isnan(samples[i].phi);
    }
    if (misses) any_missed = true;
  });
  data.missed.clear();
  for (int i = 0; any_missed && i < count; ++i)
    if (std::isnan(samples[i].phi)) data.missed.push_back(i);
  if (data.missed.empty()) return;

  data.demanded.clear();
  openvdb::tree::ValueAccessor<CornerGrid::Tree, false> marker(data.grid.grid->tree());
  for (int i : data.missed) {
    if (!points[i].allFinite()) throw ComputationError(fmt::format("level set: sample {} is not finite", i));
    for (int c = 0; c < 8; ++c) data.demand(data.cell(points[i]).offsetBy(c >> 2, (c >> 1) & 1, c & 1), marker);
  }
  parallelFor(static_cast<int>(data.demanded.size()), 16, [&](int v) { data.fillVoxel(data.demanded[v]); });
  data.filled_on_demand += std::ssize(data.demanded);
  Accessor accessor(data.grid.grid->tree());
  for (int i : data.missed) samples[i] = data.sampleAt(points[i], accessor);
}

void LevelSet::Data::demand(const Coord& corner, openvdb::tree::ValueAccessor<CornerGrid::Tree, false>& accessor) {
  Leaf& leaf = grid.leafOf(corner, accessor);
  const openvdb::Index offset = Leaf::coordToOffset(corner);
  if (leaf.isValueOn(offset)) return;
  leaf.getValueMask().setOn(offset);
  demanded.push_back({&leaf, static_cast<int>(offset)});
}

size_t LevelSet::memoryBytes() const {
  return data_->grid.memoryBytes() + data_->nearest_to_some.capacity() + data_->overlap.memoryBytes();
}

long LevelSet::filledVoxels() const {
  return static_cast<long>(data_->grid.grid->tree().activeVoxelCount());
}
long LevelSet::filledOnDemand() const {
  return data_->filled_on_demand;
}
long LevelSet::overlappingTriangles() const {
  return data_->overlap.crossing() + data_->overlap.buried();
}

}  // namespace ease
