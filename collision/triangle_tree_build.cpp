#include <algorithm>
#include <numeric>

#include "collision/triangle_tree_data.h"
#include "solver/base/parallel.h"
#include "solver/linear/incidence.h"

namespace ease {

namespace {

/// Sorts the triangles into leaves of eight and the leaves into nodes of eight, by repeated halving along the longest
/// axis of the centroids' bounding box.  All leaves except the last are full; so are all nodes except the last of each
/// level.
struct Builder {
  const std::vector<Vec3>& centroids;
  std::vector<int>& order;  // triangles in tree order; leaf l holds order[8 l] ... order[8 l + 7]
  std::vector<TreeNode>& nodes;

  struct Range {
    int first, count;  // first leaf, number of leaves
  };

  /// Builds the node that covers these leaves and all nodes below it; returns its number.
  int build(Range range) {
    int unit = 1;
    while (unit * kWidth < range.count) unit *= kWidth;
    std::vector<Range> parts;
    split(range, unit, parts);
    const int index = static_cast<int>(nodes.size());
    nodes.emplace_back();
    nodes[index].children = static_cast<int>(parts.size());
    for (size_t k = 0; k < parts.size(); ++k) {
      const int child = parts[k].count == 1 ? ~parts[k].first : build(parts[k]);
      nodes[index].child[k] = child;
    }
    return index;
  }

  /// Splits the leaves into up to eight parts of `unit` leaves; the last part may be smaller.
  void split(Range range, int unit, std::vector<Range>& parts) {
    const int units = (range.count + unit - 1) / unit;
    if (units == 0) return;  // the surface has no triangles
    if (units == 1) {
      parts.push_back(range);
      return;
    }
    const Range left{range.first, units / 2 * unit};
    const Range right{range.first + left.count, range.count - left.count};
    const auto begin = order.begin() + range.first * kWidth;
    const auto middle = order.begin() + right.first * kWidth;
    const auto end = order.begin() + std::min<long>((right.first + right.count) * long{kWidth}, std::ssize(order));
    const int axis = longestAxis(begin, end);
    std::nth_element(begin, middle, end, [&](int s, int t) {
      return centroids[s][axis] != centroids[t][axis] ? centroids[s][axis] < centroids[t][axis] : s < t;
    });
    split(left, unit, parts);
    split(right, unit, parts);
  }

  int longestAxis(std::vector<int>::const_iterator begin, std::vector<int>::const_iterator end) const {
    Eigen::AlignedBox3d box;
    for (auto t = begin; t != end; ++t) box.extend(centroids[*t]);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    return axis;
  }
};

/// Lists the triangles around each vertex, in ascending order.
void collectFans(TriangleTree::Data& tree) {
  const int n = static_cast<int>(tree.positions.rows());
  const Incidence corners(n, {tree.triangles.data(), static_cast<size_t>(tree.triangles.size())});
  tree.fan_begin.assign(1, 0);
  tree.fan.clear();
  for (int v = 0; v < n; ++v) {
    for (const int corner : corners.of(v)) tree.fan.push_back(corner / 3);
    tree.fan_begin.push_back(static_cast<int>(tree.fan.size()));
  }
}

/// Finds the triangle with the lowest number, other than t, that has the edge (a, b); -1: none.
int otherTriangle(const TriangleTree::Data& tree, int t, int a, int b) {
  for (int i = tree.fan_begin[a]; i < tree.fan_begin[a + 1]; ++i) {
    const int s = tree.fan[i];
    if (s != t && (tree.triangles.row(s).array() == b).any()) return s;
  }
  return -1;
}

void collectNeighbours(TriangleTree::Data& tree) {
  const int m = static_cast<int>(tree.triangles.rows());
  tree.neighbours.resize(m, 3);
  parallelFor(m, 4096, [&](int t) {
    for (int k = 0; k < 3; ++k)
      tree.neighbours(t, k) = otherTriangle(tree, t, tree.triangles(t, k), tree.triangles(t, (k + 1) % 3));
  });
}

void buildNodes(TriangleTree::Data& tree) {
  const int m = static_cast<int>(tree.triangles.rows());
  std::vector<Vec3> centroids(m);
  for (int t = 0; t < m; ++t)
    centroids[t] = (tree.positions.row(tree.triangles(t, 0)) + tree.positions.row(tree.triangles(t, 1)) +
                    tree.positions.row(tree.triangles(t, 2))) /
                   3.0;
  std::vector<int> order(m);
  std::iota(order.begin(), order.end(), 0);
  tree.leaves.resize((m + kWidth - 1) / kWidth);
  Builder{centroids, order, tree.nodes}.build({0, static_cast<int>(tree.leaves.size())});
  tree.leaf_of_triangle.resize(m);
  for (size_t l = 0; l < tree.leaves.size(); ++l) {
    TreeLeaf& leaf = tree.leaves[l];
    const int first = static_cast<int>(l) * kWidth;
    leaf.count = std::min(kWidth, m - first);
    for (int k = 0; k < kWidth; ++k) leaf.triangle[k] = order[first + std::min(k, leaf.count - 1)];
    for (int k = 0; k < kWidth; ++k) {
      tree.leaf_of_triangle[leaf.triangle[k]] = static_cast<int>(l);
      for (int c = 0; c < 3; ++c) leaf.vertex[c][k] = tree.triangles(leaf.triangle[k], c);
    }
  }
}

using DoubleLanes = Eigen::Array<double, kWidth, 1>;  // one value for each of a leaf's triangles
using DoubleLanes3 = std::array<DoubleLanes, 3>;      // one for each coordinate

Eigen::Map<Eigen::Array<float, kWidth, 1>> arrayOf(FloatLanes& lanes) {
  return Eigen::Map<Eigen::Array<float, kWidth, 1>>(lanes.data());
}

DoubleLanes squaredNorm(const DoubleLanes3& a) {
  return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

void setInverseSquare(const DoubleLanes3& edge, FloatLanes& inverse_square) {
  const Eigen::Array<float, kWidth, 1> squared = squaredNorm(edge).cast<float>();
  arrayOf(inverse_square) = (squared > 0.0f).select(1.0f / squared, 0.0f);
}

/// Updates the corners, edges, normals and box of a leaf's eight triangles at once.
void refitLeaf(TriangleTree::Data& tree, TreeLeaf& leaf) {
  std::array<DoubleLanes3, 3> corner;
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < kWidth; ++k)
      for (int axis = 0; axis < 3; ++axis) corner[c][axis][k] = tree.positions(leaf.vertex[c][k], axis);
  DoubleLanes3 edge_1, edge_2, edge_3;
  for (int axis = 0; axis < 3; ++axis) {
    DoubleLanes &a = corner[0][axis], &b = corner[1][axis], &c = corner[2][axis];
    a -= tree.centre[axis];
    b -= tree.centre[axis];
    c -= tree.centre[axis];
    edge_1[axis] = b - a;
    edge_2[axis] = c - a;
    edge_3[axis] = edge_2[axis] - edge_1[axis];
    leaf.box.low[axis] = static_cast<float>(a.min(b).min(c).minCoeff());
    leaf.box.high[axis] = static_cast<float>(a.max(b).max(c).maxCoeff());
    arrayOf(leaf.corner[axis]) = a.cast<float>();
    arrayOf(leaf.edge_1[axis]) = edge_1[axis].cast<float>();
    arrayOf(leaf.edge_2[axis]) = edge_2[axis].cast<float>();
  }
  DoubleLanes3 normal;  // normal times double area; normalised below
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    normal[i] = edge_1[j] * edge_2[k] - edge_1[k] * edge_2[j];
  }
  const DoubleLanes double_area = squaredNorm(normal).sqrt();
  arrayOf(leaf.double_area) = double_area.cast<float>();
  for (int axis = 0; axis < 3; ++axis) {
    normal[axis] = (double_area > 0.0).select(normal[axis] / double_area, 0.0);
    arrayOf(leaf.normal[axis]) = normal[axis].cast<float>();
  }
  for (int k = 0; k < leaf.count; ++k) tree.normals[leaf.triangle[k]] = Vec3(normal[0][k], normal[1][k], normal[2][k]);
  setInverseSquare(edge_1, leaf.inverse_square[0]);
  setInverseSquare(edge_2, leaf.inverse_square[1]);
  setInverseSquare(edge_3, leaf.inverse_square[2]);
}

FloatBox boxOf(const TriangleTree::Data& tree, int child) {
  if (child < 0) return tree.leaves[~child].box;
  const TreeNode& node = tree.nodes[child];
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = *std::min_element(node.low[axis].begin(), node.low[axis].end());
    box.high[axis] = *std::max_element(node.high[axis].begin(), node.high[axis].end());
  }
  return box;
}

void refitNodes(TriangleTree::Data& tree) {
  for (int i = static_cast<int>(tree.nodes.size()) - 1; i >= 0; --i) {
    TreeNode& node = tree.nodes[i];
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis].fill(kMissing);
      node.high[axis].fill(-kMissing);
    }
    for (int k = 0; k < node.children; ++k) {
      const FloatBox box = boxOf(tree, node.child[k]);
      for (int axis = 0; axis < 3; ++axis) {
        node.low[axis][k] = box.low[axis];
        node.high[axis][k] = box.high[axis];
      }
    }
  }
}

}  // namespace

TriangleTree::TriangleTree(const Positions& positions, const Triangles& triangles) : data_(std::make_unique<Data>()) {
  data_->triangles = triangles;
  data_->positions = positions;
  data_->normals.resize(triangles.rows());
  collectFans(*data_);
  collectNeighbours(*data_);
  buildNodes(*data_);
  refit(positions);
}

TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

void TriangleTree::refit(const Positions& positions) {
  Data& tree = *data_;
  tree.positions = positions;
  tree.bounds.setEmpty();
  for (Eigen::Index v = 0; v < positions.rows(); ++v) tree.bounds.extend(positions.row(v).transpose());
  if (!tree.bounds.isEmpty()) {
    tree.centre = tree.bounds.center();
    // A coordinate rounds by at most 6e-8 of its size; the sums of products that are compared collect about a dozen
    // such errors.
    tree.slack = static_cast<float>(1e-6 * 0.5 * tree.bounds.sizes().maxCoeff());
  }
  parallelFor(static_cast<int>(tree.leaves.size()), 128, [&](int l) { refitLeaf(tree, tree.leaves[l]); });
  refitNodes(tree);
}

Eigen::AlignedBox3d TriangleTree::bounds() const {
  return data_->bounds;
}

FloatBox TriangleTree::Data::relative(const Eigen::AlignedBox3d& box) const {
  const Eigen::Vector3f low = (box.min() - centre).cast<float>(), high = (box.max() - centre).cast<float>();
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

}  // namespace ease
