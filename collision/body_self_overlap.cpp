#include "collision/body_self_overlap.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "collision/triangle_tree_data.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

using Corners = std::array<Vec3, 3>;

Corners cornersOf(const TriangleTree::Data& tree, int t) {
  return {tree.positions.row(tree.triangles(t, 0)), tree.positions.row(tree.triangles(t, 1)),
          tree.positions.row(tree.triangles(t, 2))};
}

/// Whether the triangles' projections onto the axis lie apart by more than round-off.
bool separates(const Vec3& axis, const Corners& a, const Corners& b, double slack) {
  const double length = axis.norm();
  const auto [a_low, a_high] = std::minmax({axis.dot(a[0] - a[0]), axis.dot(a[1] - a[0]), axis.dot(a[2] - a[0])});
  const auto [b_low, b_high] = std::minmax({axis.dot(b[0] - a[0]), axis.dot(b[1] - a[0]), axis.dot(b[2] - a[0])});
  return std::max(b_low - a_high, a_low - b_high) > slack * length;
}

/// Whether two triangles without a common vertex meet, by the separating axis theorem: the axes are the two normals,
/// the cross products of two edges and, for coplanar triangles, the edges' normals in the plane.  Triangles that touch
/// within round-off count as meeting.
bool meet(const Corners& a, const Corners& b, double slack) {
  const Vec3 normal_a = doubleAreaNormal(a[0], a[1], a[2]), normal_b = doubleAreaNormal(b[0], b[1], b[2]);
  if (separates(normal_a, a, b, slack) || separates(normal_b, a, b, slack)) return false;
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge_a = a[(i + 1) % 3] - a[i], edge_b = b[(i + 1) % 3] - b[i];
    if (separates(normal_a.cross(edge_a), a, b, slack) || separates(normal_b.cross(edge_b), a, b, slack)) return false;
    for (int j = 0; j < 3; ++j)
      if (separates(edge_a.cross(b[(j + 1) % 3] - b[j]), a, b, slack)) return false;
  }
  return true;
}

/// Whether the segment from p to q passes through the triangle, its edges included.
bool pierces(const Vec3& p, const Vec3& q, const Corners& a) {
  const auto volume = [&](const Vec3& s, const Vec3& t) { return (s - p).cross(t - p).dot(q - p); };
  const Vec3 normal = doubleAreaNormal(a[0], a[1], a[2]);
  const double height_p = normal.dot(p - a[0]), height_q = normal.dot(q - a[0]);
  if ((height_p > 0.0 && height_q > 0.0) || (height_p < 0.0 && height_q < 0.0)) return false;
  if (height_p == 0.0 && height_q == 0.0) return false;
  const auto [low, high] = std::minmax({volume(a[0], a[1]), volume(a[1], a[2]), volume(a[2], a[0])});
  return low >= 0.0 || high <= 0.0;
}

/// Whether two triangles with one common vertex cross along a segment that starts there: then the edge of one triangle
/// opposite to the vertex pierces the other.  `s_corner`, `t_corner`: the corner of each that is the common vertex.
bool crossFromVertex(const Corners& s, int s_corner, const Corners& t, int t_corner) {
  return pierces(s[(s_corner + 1) % 3], s[(s_corner + 2) % 3], t) ||
         pierces(t[(t_corner + 1) % 3], t[(t_corner + 2) % 3], s);
}

/// Whether triangles s and t cross.  Neighbours with a common edge never count as crossing.
bool cross(const TriangleTree::Data& tree, int s, int t) {
  int common = 0, s_corner = 0, t_corner = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (tree.triangles(s, i) == tree.triangles(t, j)) {
        ++common;
        s_corner = i;
        t_corner = j;
      }
  if (common > 1) return false;
  const Corners a = cornersOf(tree, s), b = cornersOf(tree, t);
  return common == 0 ? meet(a, b, 1e-6 * tree.slack) : crossFromVertex(a, s_corner, b, t_corner);
}

/// Finds the lanes of `leaf` whose triangles have no vertex in common with triangle k of `other`.  The exclusive or of
/// two vertex numbers is zero exactly if they are equal, so that a minimum of zero means a common vertex.
unsigned withoutCommonVertex(const TreeLeaf& leaf, const TreeLeaf& other, int k) {
  const unsigned a = other.vertex[0][k], b = other.vertex[1][k], c = other.vertex[2][k];
  const auto minimum = [](unsigned s, unsigned t) { return s < t ? s : t; };
  unsigned lanes = 0;
  for (int j = 0; j < kWidth; ++j) {
    const unsigned u = leaf.vertex[0][j], v = leaf.vertex[1][j], w = leaf.vertex[2][j];
    const unsigned of_u = minimum(minimum(u ^ a, u ^ b), u ^ c);
    const unsigned of_v = minimum(minimum(v ^ a, v ^ b), v ^ c);
    const unsigned of_w = minimum(minimum(w ^ a, w ^ b), w ^ c);
    lanes |= minimum(minimum(of_u, of_v), of_w) != 0 ? kLaneBit[j] : 0u;
  }
  return lanes;
}

/// Computes the bounding boxes of the leaf's triangles.
void triangleBoxes(const TreeLeaf& leaf, FloatLanes3& low, FloatLanes3& high) {
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < kWidth; ++k) {
      const float e1 = leaf.edge_1[axis][k], e2 = leaf.edge_2[axis][k];
      low[axis][k] = leaf.corner[axis][k] + floatMin(floatMin(e1, e2), 0.0f);
      high[axis][k] = leaf.corner[axis][k] + floatMax(floatMax(e1, e2), 0.0f);
    }
}

/// Finds the lanes of `leaf` whose triangles do not lie wholly on one side of the plane of triangle k of `other`.
unsigned cutByPlane(const TreeLeaf& leaf, const TreeLeaf& other, int k, float slack) {
  const float nx = other.normal[0][k], ny = other.normal[1][k], nz = other.normal[2][k];
  const float px = other.corner[0][k], py = other.corner[1][k], pz = other.corner[2][k];
  unsigned lanes = 0;
  for (int j = 0; j < kWidth; ++j) {
    const float a = nx * (leaf.corner[0][j] - px) + ny * (leaf.corner[1][j] - py) + nz * (leaf.corner[2][j] - pz);
    const float b = a + nx * leaf.edge_1[0][j] + ny * leaf.edge_1[1][j] + nz * leaf.edge_1[2][j];
    const float c = a + nx * leaf.edge_2[0][j] + ny * leaf.edge_2[1][j] + nz * leaf.edge_2[2][j];
    const float low = floatMin(floatMin(a, b), c), high = floatMax(floatMax(a, b), c);
    lanes |= floatMax(low, -high) <= slack ? kLaneBit[j] : 0u;
  }
  return lanes;
}

struct LeafBoxes {
  alignas(32) FloatLanes3 low, high;
};

/// Calls report(s, t) for each pair of crossing triangles, s of leaf l and t of leaf m, each pair once.  `boxes`: those
/// of leaf l's triangles.  `folded`: by vertex, whether its triangles may cross each other.
template <class Report>
void crossLeaves(const TriangleTree::Data& tree, int l, const LeafBoxes& boxes, int m,
                 const std::vector<unsigned char>& folded, const Report& report) {
  const TreeLeaf &first = tree.leaves[l], &second = tree.leaves[m];
  unsigned near = overlappingLanes(boxes.low, boxes.high, second.box, tree.slack) & ((1u << first.count) - 1u);
  if (near == 0) return;
  LeafBoxes others;
  triangleBoxes(second, others.low, others.high);
  for (; near != 0; near &= near - 1) {
    const int k = __builtin_ctz(near);
    const FloatBox box{{boxes.low[0][k], boxes.low[1][k], boxes.low[2][k]},
                       {boxes.high[0][k], boxes.high[1][k], boxes.high[2][k]}};
    unsigned candidates = overlappingLanes(others.low, others.high, box, tree.slack) & ((1u << second.count) - 1u);
    if (l == m) candidates &= ~((2u << k) - 1u);
    if (candidates == 0) continue;
    const bool folds = folded[first.vertex[0][k]] | folded[first.vertex[1][k]] | folded[first.vertex[2][k]];
    if (!folds) candidates &= withoutCommonVertex(second, first, k);
    if (candidates != 0) candidates &= cutByPlane(second, first, k, tree.slack);
    for (; candidates != 0; candidates &= candidates - 1) {
      const int s = first.triangle[k], t = second.triangle[__builtin_ctz(candidates)];
      if (cross(tree, s, t)) report(s, t);
    }
  }
}

/// Whether some triangle of a vertex faces away from the mean normal: only then can two of its triangles cross.
bool isFolded(const TriangleTree::Data& tree, int v) {
  const int begin = tree.fan_begin[v], end = tree.fan_begin[v + 1];
  Vec3 mean = Vec3::Zero();
  for (int i = begin; i < end; ++i) mean += tree.normals[tree.fan[i]];
  return std::any_of(tree.fan.begin() + begin, tree.fan.begin() + end,
                     [&](int t) { return !(tree.normals[t].dot(mean) > 0.0); });
}

}  // namespace

void BodySelfOverlap::find(const TriangleTree& tree, std::span<const unsigned char> asked,
                           std::span<const Exposure> known) {
  const TriangleTree::Data& data = tree.data();
  exposures_.assign(data.triangles.rows(), Exposure::unknown);
  std::copy(known.begin(), known.end(), exposures_.begin());
  leaf_in_region_.resize(data.leaves.size());
  parallelFor(static_cast<int>(data.leaves.size()), 1024, [&](int l) {
    const TreeLeaf& leaf = data.leaves[l];
    leaf_in_region_[l] = std::any_of(leaf.triangle.begin(), leaf.triangle.end(),
                                     [&](int t) { return asked[t] != 0 && exposures_[t] == Exposure::unknown; });
    if (!leaf_in_region_[l]) return;
    for (int t : leaf.triangle) exposures_[t] = Exposure::boundary;
  });
  findCrossings(data);
  buryPatches(tree);
  crossing_ = std::count(exposures_.begin(), exposures_.end(), Exposure::crossing);
  buried_ = std::count(exposures_.begin(), exposures_.end(), Exposure::buried);
}

void BodySelfOverlap::findCrossings(const TriangleTree::Data& tree) {
  folded_.assign(tree.positions.rows(), 0);
  parallelFor(static_cast<int>(tree.leaves.size()), 256, [&](int l) {
    if (!leaf_in_region_[l]) return;
    for (const auto& vertices : tree.leaves[l].vertex)
      for (int v : vertices) std::atomic_ref(folded_[v]).store(1, std::memory_order_relaxed);
  });
  parallelFor(static_cast<int>(tree.positions.rows()), 1024, [&](int v) {
    if (folded_[v]) folded_[v] = isFolded(tree, v);
  });
  const auto report = [&](int s, int t) {
    std::atomic_ref(exposures_[s]).store(Exposure::crossing, std::memory_order_relaxed);
    std::atomic_ref(exposures_[t]).store(Exposure::crossing, std::memory_order_relaxed);
  };
  parallelFor(static_cast<int>(tree.leaves.size()), 32, [&](int l) {
    if (!leaf_in_region_[l]) return;
    LeafBoxes boxes;
    triangleBoxes(tree.leaves[l], boxes.low, boxes.high);
    visitLeaves(tree, tree.leaves[l].box, [&](int m) {
      const bool is_done_from_m = m < l && leaf_in_region_[m];
      if (!is_done_from_m) crossLeaves(tree, l, boxes, m, folded_, report);
    });
  });
}

void BodySelfOverlap::buryPatches(const TriangleTree& tree) {
  const TriangleTree::Data& data = tree.data();
  const int m = static_cast<int>(data.triangles.rows());
  visited_.assign(m, 0);
  const auto belongs = [&](int t) { return t >= 0 && !visited_[t] && exposures_[t] == Exposure::boundary; };
  for (int seed = 0; seed < m; ++seed) {
    if (!belongs(seed) || data.normals[seed].isZero()) continue;
    visited_[seed] = 1;
    patch_.assign(1, seed);
    for (size_t next = 0; next < patch_.size(); ++next)
      for (int k = 0; k < 3; ++k)
        if (const int t = data.neighbours(patch_[next], k); belongs(t)) {
          visited_[t] = 1;
          patch_.push_back(t);
        }
    const Corners corners = cornersOf(data, seed);
    if (tree.windingOutside(seed, (corners[0] + corners[1] + corners[2]) / 3.0) == 0) continue;
    for (int t : patch_) exposures_[t] = Exposure::buried;
  }
}

size_t BodySelfOverlap::memoryBytes() const {
  return exposures_.capacity() * sizeof(Exposure) + leaf_in_region_.capacity() + folded_.capacity() +
         visited_.capacity() + patch_.capacity() * sizeof(int);
}

}  // namespace ease
