#include "collision/level_set.h"

#include <fmt/format.h>
#include <openvdb/openvdb.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "collision/self_overlap.h"
#include "collision/triangle_tree_data.h"
#include "solver/linear/parallel.h"
#include "solver/mesh/error.h"

namespace ease {

namespace {

using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
using Accessor = openvdb::tree::ValueAccessor<const Tree, false>;
using openvdb::Coord;

constexpr int kSide = Leaf::DIM;  // voxels along a leaf
constexpr float kUnfilled = std::numeric_limits<float>::quiet_NaN();

/// What a corner holds besides phi, which is in the leaf's own buffer.
struct Corner {
  float gradient[3];  // unit; zero beyond the band
  int triangle;       // nearest; -1 beyond the band
};

struct Voxel {
  Leaf* leaf;
  int offset;
};

/// Marks the corners from `low` to `high` within one leaf.  A row of eight along z is a byte, a slab of eight rows a
/// word.
void markWithinLeaf(Leaf& leaf, const Coord& low, const Coord& high) {
  const std::uint64_t row = (0xffull >> (kSide - 1 - (high[2] - low[2]))) << (low[2] & (kSide - 1));
  std::uint64_t slab = 0;
  for (int y = low[1]; y <= high[1]; ++y) slab |= row << (kSide * (y & (kSide - 1)));
  for (int x = low[0]; x <= high[0]; ++x) leaf.getValueMask().getWord<std::uint64_t>(x & (kSide - 1)) |= slab;
}

/// Calls visit(low, high) for the parts of the range that lie in one leaf each.
template <class Visit>
void splitByLeaf(const Coord& low, const Coord& high, const Visit& visit) {
  const auto end = [](int at, int last) { return std::min(at | (kSide - 1), last); };
  for (int x = low[0]; x <= high[0]; x = end(x, high[0]) + 1)
    for (int y = low[1]; y <= high[1]; y = end(y, high[1]) + 1)
      for (int z = low[2]; z <= high[2]; z = end(z, high[2]) + 1)
        visit(Coord(x, y, z), Coord(end(x, high[0]), end(y, high[1]), end(z, high[2])));
}

}  // namespace

struct LevelSet::Data {
  LevelSetOptions options;
  double corner_band;  // m: of a sample within the band, no corner is further from the surface
  openvdb::FloatGrid::Ptr grid;
  std::vector<Leaf*> leaves;    // leaf l has transientData() l
  std::vector<Corner> corners;  // of leaf l: corners[512 l] ... in the order of its buffer
  const TriangleTree* body = nullptr;
  Eigen::AlignedBox3d reach;  // outside, every distance is beyond the band
  std::vector<unsigned char> nearest_to_some;  // of the body's triangles: whether it is nearest to a corner
  SelfOverlap overlap;
  long filled_on_demand = 0;
  std::vector<int> missed;  // samples
  std::vector<Voxel> demanded;

  Vec3 position(const Coord& corner) const { return options.voxel * Vec3(corner[0], corner[1], corner[2]); }
  Coord cell(const Vec3& x) const {
    const Vec3 index = (x / options.voxel).array().floor();
    return Coord(static_cast<int>(index[0]), static_cast<int>(index[1]), static_cast<int>(index[2]));
  }

  void mark(std::span<const Vec3> points, double margin);
  void collectLeaves();
  void fillLeaf(Leaf& leaf);
  void resolveOverlap();
  void fillVoxel(const Voxel& voxel);
  void store(const Voxel& voxel, const Vec3& x, const ClosestPoint& found);
  void demand(const Coord& corner, openvdb::tree::ValueAccessor<Tree, false>& accessor);
  LevelSetSample sampleAt(const Vec3& x, Accessor& accessor) const;
  LevelSetSample blend(const float (&phi)[8], const Corner* const (&corner)[8], const Vec3& within) const;
};

LevelSet::LevelSet(const LevelSetOptions& options) : data_(std::make_unique<Data>()) {
  if (!(options.voxel > 0.0 && std::isfinite(options.voxel)))
    throw InputError(fmt::format("level set: voxel = {} m, must be positive", options.voxel));
  if (!(options.band > 0.0 && std::isfinite(options.band)))
    throw InputError(fmt::format("level set: band = {} m, must be positive", options.band));
  data_->options = options;
  data_->corner_band = options.band + std::sqrt(3.0) * options.voxel;
  data_->grid = openvdb::FloatGrid::create(kUnfilled);
  data_->grid->setTransform(openvdb::math::Transform::createLinearTransform(options.voxel));
}

LevelSet::~LevelSet() = default;
LevelSet::LevelSet(LevelSet&&) noexcept = default;
LevelSet& LevelSet::operator=(LevelSet&&) noexcept = default;

void LevelSet::build(const TriangleTree& body, std::span<const Vec3> points, double margin) {
  Data& data = *data_;
  data.body = &body;
  data.filled_on_demand = 0;
  data.reach = body.bounds();
  if (!data.reach.isEmpty()) {
    data.reach.min().array() -= data.options.band;
    data.reach.max().array() += data.options.band;
  }
  data.grid->tree().clear();
  data.mark(points, margin);
  data.collectLeaves();
  data.nearest_to_some.assign(body.data().triangles.rows(), 0);
  parallelFor(static_cast<int>(data.leaves.size()), 1, [&](int l) { data.fillLeaf(*data.leaves[l]); });
  data.resolveOverlap();
}

void LevelSet::Data::mark(std::span<const Vec3> points, double margin) {
  openvdb::tree::ValueAccessor<Tree, false> accessor(grid->tree());
  const Vec3 around = Vec3::Constant(margin);
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3& x = points[i];
    if (!x.allFinite()) throw ComputationError(fmt::format("level set: point {} is not finite", i));
    const Eigen::AlignedBox3d needed = Eigen::AlignedBox3d(x - around, x + around).intersection(reach);
    if (needed.isEmpty()) continue;
    splitByLeaf(cell(needed.min()), cell(needed.max()) + Coord(1),
                [&](const Coord& low, const Coord& high) { markWithinLeaf(*accessor.touchLeaf(low), low, high); });
  }
}

void LevelSet::Data::collectLeaves() {
  leaves.clear();
  grid->tree().getNodes(leaves);
  for (size_t l = 0; l < leaves.size(); ++l) leaves[l]->setTransientData(static_cast<openvdb::Index32>(l));
  corners.resize(leaves.size() * Leaf::SIZE);
}

/// Distances signed by the pseudonormals, which is right but where the surface overlaps itself.
void LevelSet::Data::fillLeaf(Leaf& leaf) {
  int hint = -1;
  bool last_beyond = false;
  double last_phi = 0.0;
  Vec3 last_x;
  for (auto on = leaf.getValueMask().beginOn(); on; ++on) {
    const Vec3 x = position(leaf.offsetToGlobalCoord(on.pos()));
    ClosestPoint found = body->closest(x, corner_band, hint);
    if (found.triangle >= 0) {
      if ((x - found.point).dot(found.pseudonormal) < 0.0) found.distance = -found.distance;
      std::atomic_ref(nearest_to_some[found.triangle]).store(1, std::memory_order_relaxed);
      hint = found.triangle;
      last_beyond = false;
    } else {
      // From a corner with nothing within the band the surface is not crossed on the way to one less than the band away.
      const bool same_side = last_beyond && (x - last_x).norm() < corner_band;
      found.distance = same_side ? last_phi : (body->windingNumber(x) > 0 ? -corner_band : corner_band);
      last_beyond = true;
      last_phi = found.distance;
      last_x = x;
    }
    store({&leaf, static_cast<int>(on.pos())}, x, found);
  }
}

/// Computes again, for the union, the corners whose nearest triangles turn out to be more than its boundary.
void LevelSet::Data::resolveOverlap() {
  overlap.find(*body, nearest_to_some);
  if (overlap.crossing() + overlap.buried() == 0) return;
  const std::span<const Exposure> exposures = overlap.exposures();
  parallelFor(static_cast<int>(leaves.size()), 1, [&](int l) {
    for (auto on = leaves[l]->getValueMask().beginOn(); on; ++on) {
      const int triangle = corners[l * size_t{Leaf::SIZE} + on.pos()].triangle;
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

void LevelSet::Data::store(const Voxel& voxel, const Vec3& x, const ClosestPoint& found) {
  Vec3 gradient = Vec3::Zero();
  if (found.triangle >= 0) {
    // On the surface the direction to the closest point is lost in rounding; the pseudonormal takes its place.
    const bool on_surface = std::abs(found.distance) < 1e-7 * options.voxel;
    gradient = on_surface ? found.pseudonormal.normalized() : Vec3((x - found.point) / found.distance);
  }
  voxel.leaf->buffer().data()[voxel.offset] = static_cast<float>(found.distance);
  Corner& corner = corners[voxel.leaf->transientData() * Leaf::SIZE + voxel.offset];
  for (int axis = 0; axis < 3; ++axis) corner.gradient[axis] = static_cast<float>(gradient[axis]);
  corner.triangle = found.triangle;
}

LevelSetSample LevelSet::Data::sampleAt(const Vec3& x, Accessor& accessor) const {
  if (!reach.contains(x)) return {x.allFinite() ? options.band : kUnfilled, Vec3::Zero(), -1};
  const Coord low = cell(x);
  float phi[8];
  const Corner* corner[8];
  const auto gather = [&](const Leaf* leaf, int c, openvdb::Index offset) {
    phi[c] = leaf ? leaf->buffer().data()[offset] : kUnfilled;
    corner[c] = leaf ? &corners[leaf->transientData() * Leaf::SIZE + offset] : nullptr;
  };
  const bool within_leaf =
      (low[0] & (kSide - 1)) < kSide - 1 && (low[1] & (kSide - 1)) < kSide - 1 && (low[2] & (kSide - 1)) < kSide - 1;
  const Leaf* leaf = accessor.probeConstLeaf(low);
  const openvdb::Index first = Leaf::coordToOffset(low);
  for (int c = 0; c < 8; ++c) {
    const int i = c >> 2, j = (c >> 1) & 1, k = c & 1;
    if (within_leaf) {
      gather(leaf, c, first + i * kSide * kSide + j * kSide + k);
    } else {
      const Coord at = low.offsetBy(i, j, k);
      gather(accessor.probeConstLeaf(at), c, Leaf::coordToOffset(at));
    }
  }
  for (float value : phi)
    if (std::isnan(value)) return {kUnfilled, Vec3::Zero(), -1};
  return blend(phi, corner, x / options.voxel - Vec3(low[0], low[1], low[2]));
}

/// `within`: where the sample lies in its voxel, from 0 to 1 along each axis.
LevelSetSample LevelSet::Data::blend(const float (&phi)[8], const Corner* const (&corner)[8], const Vec3& within) const {
  float sum = 0.0f, slope = 0.0f, greatest = -1.0f;
  float n[3] = {0.0f, 0.0f, 0.0f};
  const float f[3] = {static_cast<float>(within[0]), static_cast<float>(within[1]), static_cast<float>(within[2])};
  const Corner* nearest = nullptr;
  for (int c = 0; c < 8; ++c) {
    if (corner[c]->triangle < 0) return {std::copysign(options.band, phi[c]), Vec3::Zero(), -1};
    const float i = static_cast<float>(c >> 2), j = static_cast<float>((c >> 1) & 1), k = static_cast<float>(c & 1);
    const float weight = std::abs(1.0f - i - f[0]) * std::abs(1.0f - j - f[1]) * std::abs(1.0f - k - f[2]);
    const float* g = corner[c]->gradient;
    sum += weight * phi[c];
    slope += weight * (g[0] * (f[0] - i) + g[1] * (f[1] - j) + g[2] * (f[2] - k));
    for (int axis = 0; axis < 3; ++axis) n[axis] += weight * g[axis];
    if (weight > greatest) {
      greatest = weight;
      nearest = corner[c];
    }
  }
  const double distance = sum + 0.5 * options.voxel * slope;
  if (std::abs(distance) >= options.band) return {std::copysign(options.band, distance), Vec3::Zero(), -1};
  Vec3 normal(n[0], n[1], n[2]);
  // Where two sides of the surface are equally near, their gradients cancel and what is left points nowhere.
  constexpr double kCancelled = 0.1;
  if (normal.norm() < kCancelled) normal = Vec3(nearest->gradient[0], nearest->gradient[1], nearest->gradient[2]);
  return {distance, normal.normalized(), nearest->triangle};
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
    corners.resize(leaves.size() * Leaf::SIZE);
  }
  const openvdb::Index offset = Leaf::coordToOffset(corner);
  if (leaf->isValueOn(offset)) return;
  leaf->getValueMask().setOn(offset);
  demanded.push_back({leaf, static_cast<int>(offset)});
}

size_t LevelSet::memoryBytes() const {
  return data_->grid->tree().memUsage() + data_->corners.capacity() * sizeof(Corner) +
         data_->leaves.capacity() * sizeof(Leaf*) + data_->nearest_to_some.capacity() +
         data_->overlap.memoryBytes();
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
