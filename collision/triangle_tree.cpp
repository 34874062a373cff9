#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/point_triangle.h"
#include "collision/triangle_tree_data.h"

namespace ease {

namespace {

Vec3 corner(const TriangleTree::Data& tree, int t, int k) {
  return tree.positions.row(tree.triangles(t, k));
}

float square(float a) {
  return a * a;
}

/// A point in single precision relative to the surface's centre, for comparison with boxes and triangles.
struct FloatPoint {
  std::array<float, 3> x;
  double slack;  // m: upper bound of the round-off in a distance

  FloatPoint(const TriangleTree::Data& tree, const Vec3& point) {
    const Vec3 relative = point - tree.centre;
    for (int axis = 0; axis < 3; ++axis) x[axis] = static_cast<float>(relative[axis]);
    slack = tree.slack + 1e-6 * relative.cwiseAbs().maxCoeff();
  }

  /// Upper bound of the squared distance computed in single precision if the exact one is at most `squared` (m^2).
  float bound(double squared) const {
    const double distance = std::sqrt(squared) + slack;
    return static_cast<float>(distance * distance * (1.0 + 1e-6));
  }
};

/// Distance of the number x from the interval [low, high].
inline float outside(float x, float low, float high) {
  return floatMax(floatMax(low - x, x - high), 0.0f);
}

/// Computes the squared distances from the point to the node's eight boxes, m^2.
inline NearLanes boxDistances(const TreeNode& node, const FloatPoint& p, float bound, FloatLanes& squared) {
  const float x = p.x[0], y = p.x[1], z = p.x[2];
  for (int k = 0; k < kWidth; ++k)
    squared[k] = square(outside(x, node.low[0][k], node.high[0][k])) +
                 square(outside(y, node.low[1][k], node.high[1][k])) +
                 square(outside(z, node.low[2][k], node.high[2][k]));
  return nearLanes(squared, bound);
}

/// Squared distance of the point d from the segment between the origin and e, m^2.  `inverse_square` is 1 / |e|^2.
inline float segmentDistance(float dx, float dy, float dz, float ex, float ey, float ez, float inverse_square) {
  const float s = floatMin(floatMax((dx * ex + dy * ey + dz * ez) * inverse_square, 0.0f), 1.0f);
  return square(dx - s * ex) + square(dy - s * ey) + square(dz - s * ez);
}

/// Computes the squared distances from the point to the leaf's eight triangles, m^2: to the plane of a triangle if the
/// point projects into it, else to its nearest edge.
inline NearLanes triangleDistances(const TreeLeaf& leaf, const FloatPoint& p, float bound, FloatLanes& squared) {
  for (int k = 0; k < kWidth; ++k) {
    const float dx = p.x[0] - leaf.corner[0][k], dy = p.x[1] - leaf.corner[1][k], dz = p.x[2] - leaf.corner[2][k];
    const float nx = leaf.normal[0][k], ny = leaf.normal[1][k], nz = leaf.normal[2][k];
    const float ax = leaf.edge_1[0][k], ay = leaf.edge_1[1][k], az = leaf.edge_1[2][k];
    const float bx = leaf.edge_2[0][k], by = leaf.edge_2[1][k], bz = leaf.edge_2[2][k];
    const float qx = dy * nz - dz * ny, qy = dz * nx - dx * nz, qz = dx * ny - dy * nx;
    const float side_1 = ax * qx + ay * qy + az * qz, side_2 = bx * qx + by * qy + bz * qz;
    const float plane = square(dx * nx + dy * ny + dz * nz);
    const float to_1 = segmentDistance(dx, dy, dz, ax, ay, az, leaf.inverse_square[0][k]);
    const float to_2 = segmentDistance(dx, dy, dz, bx, by, bz, leaf.inverse_square[1][k]);
    const float to_3 = segmentDistance(dx - ax, dy - ay, dz - az, bx - ax, by - ay, bz - az, leaf.inverse_square[2][k]);
    const float inner = floatMin(floatMin(side_1, -side_2), leaf.double_area[k] + side_2 - side_1);
    squared[k] = inner >= 0.0f ? plane : floatMin(floatMin(to_1, to_2), to_3);
  }
  return nearLanes(squared, bound);
}

struct Nearest {
  int triangle = -1;
  double squared;  // m^2: squared distance, or the limit of the search
  TrianglePoint at;
};

/// Searches for the closest point among the triangles for which accepts(triangle, point) returns true: depth first, the
/// nearest child first.
template <class Accepts>
class Search {
 public:
  Search(const TriangleTree::Data& tree, const Vec3& x, double max_distance, const Accepts& accepts)
      : tree_(tree), x_(x), p_(tree, x), accepts_(accepts) {
    best_.squared = max_distance * max_distance;
    bound_ = p_.bound(best_.squared);
  }

  Nearest run(int hint) {
    const int first_leaf = hint >= 0 ? tree_.leaf_of_triangle[hint] : -1;
    if (hint >= 0) visitLeaf(tree_.leaves[first_leaf]);
    int next = 0;
    do {
      while (next >= 0) next = visitNode(tree_.nodes[next]);
      if (next != kNone && ~next != first_leaf) visitLeaf(tree_.leaves[~next]);
      for (next = kNone; next == kNone && size_ > 0;)
        if (stack_squared_[--size_] <= bound_) next = stack_child_[size_];
    } while (next != kNone);
    return best_;
  }

 private:
  static constexpr int kNone = std::numeric_limits<int>::min();  // no child

  /// Returns the nearest child within the bound, or kNone, and puts the others within the bound on the stack.
  int visitNode(const TreeNode& node) {
    alignas(32) FloatLanes squared;
    const auto [all_near, smallest] = boxDistances(node, p_, bound_, squared);
    const unsigned near =
        all_near & ((1u << node.children) - 1);  // within an infinite bound missing boxes are near, too
    if (near == 0) return kNone;
    for (unsigned others = near & ~(1u << smallest); others != 0; others &= others - 1) {
      const int k = __builtin_ctz(others);
      stack_squared_[size_] = squared[k];
      stack_child_[size_++] = node.child[k];
    }
    return node.child[smallest];
  }

  void visitLeaf(const TreeLeaf& leaf) {
    alignas(32) FloatLanes squared;
    const auto [near, smallest] = triangleDistances(leaf, p_, bound_, squared);
    if (near == 0) return;
    tryTriangle(leaf.triangle[smallest]);
    for (unsigned others = near & ~(1u << smallest); others != 0; others &= others - 1)
      if (const int k = __builtin_ctz(others); squared[k] <= bound_) tryTriangle(leaf.triangle[k]);
  }

  void tryTriangle(int t) {
    const TrianglePoint at = closestOnTriangle(x_, corner(tree_, t, 0), corner(tree_, t, 1), corner(tree_, t, 2));
    const double squared = (x_ - at.point).squaredNorm();
    const bool tie = squared == best_.squared && (best_.triangle < 0 || t < best_.triangle);
    if (!(squared < best_.squared || tie) || !accepts_(t, at.point)) return;
    best_ = {t, squared, at};
    bound_ = p_.bound(squared);
  }

  const TriangleTree::Data& tree_;
  const Vec3& x_;
  const FloatPoint p_;
  const Accepts& accepts_;
  Nearest best_;
  float bound_;
  std::array<float, kStackSize> stack_squared_;  // squared distances of nodes and leaves still to be visited
  std::array<int, kStackSize> stack_child_;
  int size_ = 0;
};

template <class Accepts>
Nearest nearest(const TriangleTree::Data& tree, const Vec3& x, double max_distance, int hint, const Accepts& accepts) {
  return Search<Accepts>(tree, x, max_distance, accepts).run(hint);
}

/// Angle of triangle t at its vertex v, radians.
double angleAt(const TriangleTree::Data& tree, int t, int v) {
  int k = 0;
  while (tree.triangles(t, k) != v) ++k;
  const Vec3 p = corner(tree, t, k), a = corner(tree, t, (k + 1) % 3) - p, b = corner(tree, t, (k + 2) % 3) - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Computes the pseudonormal: of a face its normal, of an edge the sum of its triangles' normals, of a vertex the sum
/// of its triangles' normals weighted by their angles there.
Vec3 pseudonormal(const TriangleTree::Data& tree, int t, Feature feature) {
  if (feature == Feature::face) return tree.normals[t];
  const bool on_edge = feature < Feature::vertex_0;
  const int k = static_cast<int>(feature) - static_cast<int>(on_edge ? Feature::edge_0 : Feature::vertex_0);
  const int v = tree.triangles(t, k), w = tree.triangles(t, (k + 1) % 3);
  Vec3 sum = Vec3::Zero();
  for (int i = tree.fan_begin[v]; i < tree.fan_begin[v + 1]; ++i) {
    const int s = tree.fan[i];
    if (!on_edge)
      sum += angleAt(tree, s, v) * tree.normals[s];
    else if ((tree.triangles.row(s).array() == w).any())
      sum += tree.normals[s];
  }
  return sum;
}

/// Adds distance and pseudonormal to the result of a search.
ClosestPoint describe(const TriangleTree::Data& tree, const Nearest& found, double max_distance) {
  if (found.triangle < 0) return {-1, Vec3::Zero(), max_distance, Vec3::Zero()};
  return {found.triangle, found.at.point, std::sqrt(found.squared),
          pseudonormal(tree, found.triangle, found.at.feature)};
}

/// Projects the edge from vertex i to vertex j along the ray onto the plane (u, v) with the ray at the origin, and
/// tells whether it crosses the half axis u > 0: +1 upwards, -1 downwards, 0 not.  The two triangles of an edge get
/// exactly opposite values, so that a ray through an edge or a vertex is counted once.
int edgeCrossing(const TriangleTree::Data& tree, const Vec3& x, int axis, int i, int j) {
  const int sign = i < j ? 1 : -1;
  if (i > j) std::swap(i, j);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double from_v = tree.positions(i, v) - x[v], to_v = tree.positions(j, v) - x[v];
  if ((from_v >= 0.0) == (to_v >= 0.0)) return 0;
  const double from_u = tree.positions(i, u) - x[u], to_u = tree.positions(j, u) - x[u];
  const double twice_area = from_u * to_v - from_v * to_u;
  if (to_v > from_v) return twice_area > 0.0 ? sign : 0;
  return twice_area < 0.0 ? -sign : 0;
}

/// Returns +1 if the ray from x along the positive `axis` leaves the body through triangle t, -1 if it enters, else 0.
int rayCrossing(const TriangleTree::Data& tree, const Vec3& x, int axis, int t) {
  int crossing = 0;
  for (int k = 0; k < 3; ++k)
    crossing += edgeCrossing(tree, x, axis, tree.triangles(t, k), tree.triangles(t, (k + 1) % 3));
  if (crossing == 0) return 0;
  const double ahead = tree.normals[t].dot(corner(tree, t, 0) - x) * tree.normals[t][axis];
  return ahead > 0.0 ? crossing : 0;
}

/// Computes the winding number at x by a ray along the positive `axis`; leaves out triangle `skipped` (-1: none).
int windingAlong(const TriangleTree::Data& tree, const Vec3& x, int axis, int skipped) {
  Eigen::AlignedBox3d ray(x, x);
  FloatBox box = tree.relative(ray);
  const float slack = static_cast<float>(FloatPoint(tree, x).slack);
  for (int k = 0; k < 3; ++k) {
    box.low[k] -= slack;
    box.high[k] += slack;
  }
  box.high[axis] = kEndless;
  int winding = 0;
  visitLeaves(tree, box, [&](int l) {
    const TreeLeaf& leaf = tree.leaves[l];
    for (int k = 0; k < leaf.count; ++k)
      if (leaf.triangle[k] != skipped) winding += rayCrossing(tree, x, axis, leaf.triangle[k]);
  });
  return winding;
}

}  // namespace

ClosestPoint TriangleTree::closest(const Vec3& x, double max_distance, int hint) const {
  const auto accept_any = [](int, const Vec3&) { return true; };
  return describe(*data_, nearest(*data_, x, max_distance, hint, accept_any), max_distance);
}

int TriangleTree::windingNumber(const Vec3& x) const {
  return windingAlong(*data_, x, 2, -1);
}

int TriangleTree::windingOutside(int triangle, const Vec3& point) const {
  const Data& tree = *data_;
  const Vec3 centroid = (corner(tree, triangle, 0) + corner(tree, triangle, 1) + corner(tree, triangle, 2)) / 3.0;
  constexpr double kInward = 1e-3;  // share of the way to the centroid: moves off the edges, which neighbours share
  const Vec3 inner = point + kInward * (centroid - point);
  int axis = 0;
  tree.normals[triangle].cwiseAbs().maxCoeff(&axis);
  const int ahead = windingAlong(tree, inner, axis, triangle);
  return tree.normals[triangle][axis] > 0.0 ? ahead : ahead - 1;
}

ClosestPoint TriangleTree::closestOfUnion(const Vec3& x, double max_distance, int hint,
                                          std::span<const Exposure> exposures) const {
  const Data& tree = *data_;
  ClosestPoint found = closest(x, max_distance, hint);
  if (found.triangle < 0) {
    found.distance = windingNumber(x) > 0 ? -max_distance : max_distance;
    return found;
  }
  const bool outer_side = (x - found.point).dot(found.pseudonormal) >= 0.0;
  if (!exposures.empty() && exposures[found.triangle] == Exposure::boundary) {
    if (!outer_side) found.distance = -found.distance;
    return found;
  }
  // No surface lies between x and the point found, so the winding number at x also holds on the point's near side.
  const int winding = windingNumber(x);
  const bool exposed = (outer_side ? winding : winding - 1) == 0;
  if (!exposed) {
    const auto bounds_union = [&](int t, const Vec3& point) {
      const Exposure exposure = exposures.empty() ? Exposure::unknown : exposures[t];
      if (exposure == Exposure::boundary || exposure == Exposure::buried) return exposure == Exposure::boundary;
      return windingOutside(t, point) == 0;
    };
    found = describe(tree, nearest(tree, x, max_distance, -1, bounds_union), max_distance);
  }
  if (winding > 0) found.distance = -found.distance;
  return found;
}

double TriangleTree::signedDistance(const Vec3& x, double max_distance) const {
  return closestOfUnion(x, max_distance).distance;
}

}  // namespace ease
