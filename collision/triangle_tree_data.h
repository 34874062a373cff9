// Memory layout of the tree over the triangles: each node has eight boxes, each leaf eight triangles, both stored as
// structures of arrays.
//
// A lane is one of the eight.  Boxes and triangles are stored in single precision, relative to the surface's centre,
// and only serve to discard triangles that are too far away.  The distances to all others are computed in double
// precision from `positions`.  `slack` is an upper bound of the round-off in single precision, m: a comparison discards
// a triangle only if it fails by more than that.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision/triangle_tree.h"

namespace ease {

constexpr int kWidth = 8;  // lanes

using FloatLanes = std::array<float, kWidth>;   // one value for each of eight boxes or triangles
using FloatLanes3 = std::array<FloatLanes, 3>;  // one for each coordinate

struct FloatBox {
  std::array<float, 3> low, high;
};

struct alignas(32) TreeNode {
  FloatLanes3 low, high;            // boxes of the children; missing children have low > high
  std::array<int, kWidth> child{};  // number of a node, or ~l for leaf l
  int children = 0;
};

struct alignas(32) TreeLeaf {
  FloatLanes3 corner;                             // corner a of the triangle (a, b, c)
  FloatLanes3 edge_1, edge_2;                     // b - a, c - a
  FloatLanes3 normal;                             // unit length; zero for a degenerate triangle
  FloatLanes double_area;                         // m^2
  std::array<FloatLanes, 3> inverse_square;       // 1 / |b - a|^2, 1 / |c - a|^2, 1 / |c - b|^2; 0 for length 0
  FloatBox box;                                   // bounding box of the eight triangles
  std::array<int, kWidth> triangle;               // numbers of the triangles; lanes from `count` on repeat the last one
  std::array<std::array<int, kWidth>, 3> vertex;  // corners of the triangles
  int count = 0;
};

struct TriangleTree::Data {
  Triangles triangles;
  Positions positions;          // m
  std::vector<Vec3> normals;    // of the triangles, unit length; zero for a degenerate one
  std::vector<TreeNode> nodes;  // parents come before their children; the first is the root
  std::vector<TreeLeaf> leaves;
  std::vector<int> leaf_of_triangle;
  std::vector<int> fan_begin, fan;  // triangles around vertex v: fan[fan_begin[v]] ... fan[fan_begin[v + 1] - 1]
  Triangles neighbours;             // neighbours(t, k): triangle across the edge of t that starts at corner k; -1: none
  Eigen::AlignedBox3d bounds;
  Vec3 centre = Vec3::Zero();
  float slack = 0.0f;  // upper bound of the round-off, m

  /// Converts the box to single precision, relative to the centre.
  FloatBox relative(const Eigen::AlignedBox3d& box) const;
};

/// Coordinates of missing boxes and of the open end of unbounded ones.  They are finite because the difference of two
/// infinities is NaN.
constexpr float kMissing = 1e30f, kEndless = 1e20f;  // m

inline float floatMax(float a, float b) {
  return a > b ? a : b;
}
inline float floatMin(float a, float b) {
  return a < b ? a : b;
}

/// Bit of each lane; a set of lanes is the sum of their bits.
constexpr std::array<unsigned, kWidth> kLaneBit = {1, 2, 4, 8, 16, 32, 64, 128};

/// Tells which of eight squared distances are small.
struct NearLanes {
  unsigned near;      // set of the lanes within the bound
  unsigned smallest;  // lane of the smallest distance
};

inline NearLanes nearLanes(const FloatLanes& squared, float bound) {
  // The bits of non-negative floats, read as integers, sort like the floats.  The lane replaces the last three bits.
  unsigned near = 0;
  std::uint32_t smallest = std::numeric_limits<std::uint32_t>::max();
  for (int k = 0; k < kWidth; ++k) {
    near |= squared[k] <= bound ? kLaneBit[k] : 0u;
    smallest = std::min(smallest, (std::bit_cast<std::uint32_t>(squared[k]) & ~7u) | static_cast<std::uint32_t>(k));
  }
  return {near, smallest & 7u};
}

/// Finds the lanes whose boxes come within `slack` (m) of `box`.  The loop has no branches, so that it vectorises.
inline unsigned overlappingLanes(const FloatLanes3& low, const FloatLanes3& high, const FloatBox& box, float slack) {
  const float x_low = box.low[0] - slack, y_low = box.low[1] - slack, z_low = box.low[2] - slack;
  const float x_high = box.high[0] + slack, y_high = box.high[1] + slack, z_high = box.high[2] + slack;
  unsigned lanes = 0;
  for (int k = 0; k < kWidth; ++k) {
    const float x = floatMax(low[0][k] - x_high, x_low - high[0][k]);
    const float y = floatMax(low[1][k] - y_high, y_low - high[1][k]);
    const float z = floatMax(low[2][k] - z_high, z_low - high[2][k]);
    lanes |= floatMax(floatMax(x, y), z) <= 0.0f ? kLaneBit[k] : 0u;
  }
  return lanes;
}

/// Size of the stack of nodes still to be visited: seven siblings per level, for 14 levels of eight children.
constexpr int kStackSize = 7 * 14 + 8;

/// Calls visit(leaf) for every leaf whose box comes within round-off of `box`.
template <class Visit>
void visitLeaves(const TriangleTree::Data& tree, const FloatBox& box, const Visit& visit) {
  std::array<int, kStackSize> stack;
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const TreeNode& node = tree.nodes[stack[--size]];
    for (unsigned lanes = overlappingLanes(node.low, node.high, box, tree.slack); lanes != 0; lanes &= lanes - 1) {
      const int child = node.child[__builtin_ctz(lanes)];
      if (child < 0)
        visit(~child);
      else
        stack[size++] = child;
    }
  }
}

}  // namespace ease
