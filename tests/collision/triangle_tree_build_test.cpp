// Checks the layout of a built tree, on which the searches rely (triangle_tree_data.h).
#include <algorithm>
#include <catch2/catch.hpp>

#include "collision/triangle_tree_data.h"
#include "solver/energy/element.h"
#include "tests/collision/bodies.h"

using namespace ease;
using namespace ease::bodies;

namespace {

/// The first triangles of a sphere: 1100 of them make three levels of nodes.
TriangleMesh partOfSphere(int triangles) {
  TriangleMesh mesh = sphere(0.3, 12);
  REQUIRE(mesh.triangles.rows() >= triangles);
  mesh.triangles = Triangles(mesh.triangles.topRows(triangles));
  return mesh;
}

/// Triangles that all lie in one place, so that only their numbers tell them apart.
TriangleMesh pile(int triangles) {
  TriangleMesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  mesh.triangles = Triangles(mesh.triangles.replicate(triangles, 1));
  return mesh;
}

TriangleTree treeOf(const TriangleMesh& mesh) {
  return TriangleTree(mesh.positions, mesh.triangles);
}

/// The box stored in a child itself.
FloatBox boxOf(const TriangleTree::Data& tree, int child) {
  if (child < 0) return tree.leaves[~child].box;
  const TreeNode& node = tree.nodes[child];
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = *std::min_element(node.low[axis].begin(), node.low[axis].begin() + node.children);
    box.high[axis] = *std::max_element(node.high[axis].begin(), node.high[axis].begin() + node.children);
  }
  return box;
}

void checkBoxes(const TriangleTree::Data& tree) {
  for (const TreeLeaf& leaf : tree.leaves) {
    Eigen::AlignedBox3d corners;
    for (int k = 0; k < leaf.count; ++k)
      for (int c = 0; c < 3; ++c) corners.extend(tree.positions.row(tree.triangles(leaf.triangle[k], c)).transpose());
    const FloatBox expected = tree.relative(corners);
    CHECK(leaf.box.low == expected.low);
    CHECK(leaf.box.high == expected.high);
  }
  for (const TreeNode& node : tree.nodes)
    for (int k = 0; k < kWidth; ++k)
      for (int axis = 0; axis < 3; ++axis) {
        if (k >= node.children) {
          CHECK(node.low[axis][k] > node.high[axis][k]);
          continue;
        }
        CHECK(node.low[axis][k] == boxOf(tree, node.child[k]).low[axis]);
        CHECK(node.high[axis][k] == boxOf(tree, node.child[k]).high[axis]);
      }
}

}  // namespace

TEST_CASE("each triangle lies in one leaf, each leaf and each node but the root below one parent that comes before") {
  for (const TriangleMesh& mesh : {partOfSphere(1), partOfSphere(8), partOfSphere(9), partOfSphere(65),
                                   partOfSphere(513), partOfSphere(1100), pile(100)}) {
    const TriangleTree whole = treeOf(mesh);
    const TriangleTree::Data& tree = whole.data();
    const int triangles = static_cast<int>(mesh.triangles.rows());
    INFO(triangles);
    std::vector<int> leaves_of(triangles, 0), parents_of_leaf(tree.leaves.size(), 0),
        parents_of_node(tree.nodes.size(), 0);
    for (int i = 0; i < std::ssize(tree.nodes); ++i) {
      REQUIRE(tree.nodes[i].children >= 1);
      REQUIRE(tree.nodes[i].children <= kWidth);
      for (int k = 0; k < tree.nodes[i].children; ++k) {
        const int child = tree.nodes[i].child[k];
        CHECK((child < 0 || child > i));
        ++(child < 0 ? parents_of_leaf.at(~child) : parents_of_node.at(child));
      }
    }
    for (int l = 0; l < std::ssize(tree.leaves); ++l)
      for (int k = 0; k < tree.leaves[l].count; ++k) {
        ++leaves_of.at(tree.leaves[l].triangle[k]);
        CHECK(tree.leaf_of_triangle[tree.leaves[l].triangle[k]] == l);
      }
    CHECK(leaves_of == std::vector<int>(triangles, 1));
    CHECK(parents_of_leaf == std::vector<int>(tree.leaves.size(), 1));
    CHECK(parents_of_node.front() == 0);
    CHECK(std::all_of(parents_of_node.begin() + 1, parents_of_node.end(), [](int count) { return count == 1; }));
  }
}

TEST_CASE("all leaves but the last are full, and lanes beyond the last triangle repeat it") {
  const TriangleMesh mesh = partOfSphere(517);
  const TriangleTree whole = treeOf(mesh);
  const TriangleTree::Data& tree = whole.data();
  REQUIRE(tree.leaves.size() == 65);
  int partly = 0;
  for (const TreeLeaf& leaf : tree.leaves) {
    partly += leaf.count < kWidth ? 1 : 0;
    for (int k = 0; k < kWidth; ++k) {
      CHECK(leaf.triangle[k] == leaf.triangle[std::min(k, leaf.count - 1)]);
      for (int c = 0; c < 3; ++c) CHECK(leaf.vertex[c][k] == mesh.triangles(leaf.triangle[k], c));
    }
  }
  CHECK(partly == 1);
}

TEST_CASE("boxes of leaves hold their triangles, those of nodes their children, tightly, wherever the surface goes") {
  const TriangleMesh mesh = partOfSphere(1100);
  TriangleTree tree = treeOf(mesh);
  checkBoxes(tree.data());
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  Positions elsewhere = mesh.positions * turn.transpose();
  elsewhere.rowwise() += Eigen::RowVector3d(5.0, -3.0, 0.1);
  tree.refit(elsewhere);
  checkBoxes(tree.data());
  CHECK(tree.bounds().min() == Vec3(elsewhere.colwise().minCoeff()));
  CHECK(tree.bounds().max() == Vec3(elsewhere.colwise().maxCoeff()));
}

TEST_CASE("a triangle's lanes are its corner, edges, normal and area from the surface's centre, also of no area") {
  TriangleMesh mesh = moved(box(Vec3::Zero(), Vec3::Ones()), {2.0, 0.0, 0.0});
  mesh.triangles.row(5) << 0, 1, 1;
  const TriangleTree whole = treeOf(mesh);
  const TriangleTree::Data& tree = whole.data();
  CHECK((tree.centre - Vec3(2.5, 0.5, 0.5)).norm() == 0.0);
  for (const TreeLeaf& leaf : tree.leaves)
    for (int k = 0; k < leaf.count; ++k) {
      const int t = leaf.triangle[k];
      const Vec3 a = mesh.positions.row(mesh.triangles(t, 0)), b = mesh.positions.row(mesh.triangles(t, 1)),
                 c = mesh.positions.row(mesh.triangles(t, 2));
      const Vec3 area = doubleAreaNormal(a, b, c);
      CHECK(tree.normals[t] == (t == 5 ? Vec3(Vec3::Zero()) : area));  // the box's triangles have areas of a half
      CHECK(leaf.double_area[k] == (t == 5 ? 0.0f : 1.0f));
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(leaf.corner[axis][k] == static_cast<float>((a - tree.centre)[axis]));
        CHECK(leaf.edge_1[axis][k] == static_cast<float>((b - a)[axis]));
        CHECK(leaf.edge_2[axis][k] == static_cast<float>((c - a)[axis]));
        CHECK(leaf.normal[axis][k] == static_cast<float>(tree.normals[t][axis]));
      }
      const Vec3 edges[] = {b - a, c - a, c - b};
      for (int e = 0; e < 3; ++e) {
        const double squared = edges[e].squaredNorm();
        CHECK(leaf.inverse_square[e][k] == (squared > 0.0 ? static_cast<float>(1.0 / squared) : 0.0f));
      }
    }
}

TEST_CASE("a vertex's fan is the triangles that hold it, neighbours are those across an edge, none on a border") {
  const TriangleMesh mesh = partOfSphere(200);
  const TriangleTree whole = treeOf(mesh);
  const TriangleTree::Data& tree = whole.data();
  const auto holds = [&](int t, int v) { return (mesh.triangles.row(t).array() == v).any(); };
  REQUIRE(static_cast<long>(tree.fan_begin.size()) == mesh.positions.rows() + 1);
  for (int v = 0; v < mesh.positions.rows(); ++v) {
    std::vector<int> expected;
    for (int t = 0; t < mesh.triangles.rows(); ++t)
      if (holds(t, v)) expected.push_back(t);
    CHECK(std::vector<int>(tree.fan.begin() + tree.fan_begin[v], tree.fan.begin() + tree.fan_begin[v + 1]) == expected);
  }
  int borders = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      int other = -1;
      for (int s = 0; s < mesh.triangles.rows(); ++s)
        if (s != t && holds(s, mesh.triangles(t, k)) && holds(s, mesh.triangles(t, (k + 1) % 3))) other = s;
      CHECK(tree.neighbours(t, k) == other);
      borders += other < 0 ? 1 : 0;
    }
  CHECK(borders > 0);
  CHECK(borders < 300);
}

TEST_CASE("lanes of the tree and of the energies serve in one file without being mixed up") {
  const FloatLanes squared = {4.0f, 9.0f, 1.0f, 16.0f, 25.0f, 36.0f, 49.0f, 64.0f};
  const Column<double> column{0.0, 3.0, 4.0};
  const NearLanes found = nearLanes(squared, static_cast<float>(dot(column, column)) - 9.0f);
  CHECK(found.near == (kLaneBit[0] | kLaneBit[1] | kLaneBit[2] | kLaneBit[3]));
  CHECK(found.smallest == 2u);
  CHECK(floatMax(squared[0], squared[1]) == 9.0f);
  CHECK(floatMin(squared[0], squared[1]) == 4.0f);
}
