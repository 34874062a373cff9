// How the tree over the triangles is stored: eight boxes a node, eight triangles a leaf, structure of arrays.
//
// Boxes and triangles are kept in single precision relative to the surface's centre and serve to discard; whatever they
// cannot discard is computed in double precision from `positions`.  `slack` bounds what rounding to single precision
// can shift: every comparison that discards leaves that much room.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision/triangle_tree.h"

namespace ease {

constexpr int kWidth = 8;

using Lanes = std::array<float, kWidth>;  // one value of eight boxes or triangles
using Lanes3 = std::array<Lanes, 3>;      // by coordinate

struct FloatBox {
  std::array<float, 3> low, high;
};

struct alignas(32) TreeNode {
  Lanes3 low, high;                 // of the children; those that are missing have low > high
  std::array<int, kWidth> child{};  // another node; or the complement ~l of leaf l
  int children = 0;
};

struct alignas(32) TreeLeaf {
  Lanes3 corner;                                  // a of the triangle (a, b, c)
  Lanes3 edge_1, edge_2;                          // b - a, c - a
  Lanes3 normal;                                  // unit; zero where degenerate
  Lanes double_area;                              // m^2
  std::array<Lanes, 3> inverse_square;            // of the lengths of b - a, c - a, c - b; zero where these are
  FloatBox box;                                   // of all
  std::array<int, kWidth> triangle;               // lanes from `count` on repeat the last one
  std::array<std::array<int, kWidth>, 3> vertex;  // of these, by corner
  int count = 0;
};

struct TriangleTree::Data {
  Triangles triangles;
  Positions positions;          // m
  std::vector<Vec3> normals;    // of the triangles, unit; zero where degenerate
  std::vector<TreeNode> nodes;  // a node before its children; the first is the root
  std::vector<TreeLeaf> leaves;
  std::vector<int> leaf_of_triangle;
  std::vector<int> fan_begin, fan;  // triangles around vertex v: fan[fan_begin[v]] ... fan[fan_begin[v + 1] - 1]
  Triangles neighbours;             // of a triangle over the edge that starts at its corner; -1: none
  Eigen::AlignedBox3d bounds;
  Vec3 centre = Vec3::Zero();
  float slack = 0.0f;  // m

  FloatBox relative(const Eigen::AlignedBox3d& box) const;
};

/// What boxes that are missing or without end hold instead of infinity, whose differences are not numbers.
constexpr float kMissing = 1e30f, kEndless = 1e20f;  // m

inline float larger(float a, float b) {
  return a > b ? a : b;
}
inline float smaller(float a, float b) {
  return a < b ? a : b;
}

/// One bit a lane; a set of lanes is their sum.
constexpr std::array<unsigned, kWidth> kLaneBit = {1, 2, 4, 8, 16, 32, 64, 128};

/// Of eight squared distances, the lanes where they are at most a bound, and the lane of the least.
struct NearLanes {
  unsigned near, least;
};

inline NearLanes nearLanes(const Lanes& squared, float bound) {
  // Floats that are not negative are in the order of their bits, of which the last three give way to the lane.
  unsigned near = 0;
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  for (int k = 0; k < kWidth; ++k) {
    near |= squared[k] <= bound ? kLaneBit[k] : 0u;
    least = std::min(least, (std::bit_cast<std::uint32_t>(squared[k]) & ~7u) | static_cast<std::uint32_t>(k));
  }
  return {near, least & 7u};
}

/// Lanes whose boxes come within `slack` of `box`.  One loop over the lanes without branches, so that it vectorises.
inline unsigned overlappingLanes(const Lanes3& low, const Lanes3& high, const FloatBox& box, float slack) {
  const float x_low = box.low[0] - slack, y_low = box.low[1] - slack, z_low = box.low[2] - slack;
  const float x_high = box.high[0] + slack, y_high = box.high[1] + slack, z_high = box.high[2] + slack;
  unsigned lanes = 0;
  for (int k = 0; k < kWidth; ++k) {
    const float x = larger(low[0][k] - x_high, x_low - high[0][k]);
    const float y = larger(low[1][k] - y_high, y_low - high[1][k]);
    const float z = larger(low[2][k] - z_high, z_low - high[2][k]);
    lanes |= larger(larger(x, y), z) <= 0.0f ? kLaneBit[k] : 0u;
  }
  return lanes;
}

/// Room for the nodes still to be visited: seven siblings a level, and eight to the power of 14 leaves are enough.
constexpr int kStackSize = 7 * 14 + 8;

/// Calls visit(leaf) for every leaf whose box comes within rounding of `box`.
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
