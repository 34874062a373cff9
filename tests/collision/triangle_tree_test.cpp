#include "collision/triangle_tree.h"

#include <catch2/catch.hpp>
#include <limits>

#include "collision/point_triangle.h"
#include "tests/collision/bodies.h"

using namespace ease;
using namespace ease::bodies;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TriangleTree treeOf(const TriangleMesh& mesh) {
  return TriangleTree(mesh.positions, mesh.triangles);
}

/// A sphere with waves on it, so that no two triangles are alike.
TriangleMesh wavySphere(double phase) {
  TriangleMesh mesh = sphere(0.3, 12);
  for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) {
    const Vec3 x = mesh.positions.row(v);
    mesh.positions.row(v) *= 1.0 + 0.1 * std::sin(17.0 * x[0] + 11.0 * x[1] + 23.0 * x[2] + phase);
  }
  return mesh;
}

ClosestPoint bruteForce(const TriangleMesh& mesh, const Vec3& x) {
  ClosestPoint best;
  double least = kInfinity;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 point =
        closestOnTriangle(x, mesh.positions.row(mesh.triangles(t, 0)), mesh.positions.row(mesh.triangles(t, 1)),
                          mesh.positions.row(mesh.triangles(t, 2)))
            .point;
    if ((x - point).squaredNorm() >= least) continue;
    least = (x - point).squaredNorm();
    best.triangle = t;
    best.point = point;
  }
  best.distance = std::sqrt(least);
  return best;
}

}  // namespace

TEST_CASE("the closest point is that of a search through all triangles") {
  const TriangleMesh mesh = wavySphere(0.0);
  const TriangleTree tree = treeOf(mesh);
  std::vector<Vec3> points = pointsIn(Vec3::Constant(-0.5), Vec3::Constant(0.5), 1000);
  for (const Vec3& far : pointsIn(Vec3::Constant(-1e4), Vec3::Constant(1e4), 50)) points.push_back(far);
  for (int v = 0; v < 50; ++v) points.push_back(mesh.positions.row(v));
  for (const Vec3& x : points) {
    const ClosestPoint expected = bruteForce(mesh, x), found = tree.closest(x, kInfinity);
    CHECK(found.triangle >= 0);
    CHECK(found.distance == Approx(expected.distance).epsilon(1e-14).margin(1e-15));
    CHECK((found.point - expected.point).norm() <= 1e-7 * expected.distance);
    CHECK((x - found.point).norm() == Approx(found.distance).epsilon(1e-14).margin(1e-15));
  }
}

TEST_CASE("a hint changes nothing but the time taken") {
  const TriangleMesh mesh = wavySphere(0.0);
  const TriangleTree tree = treeOf(mesh);
  int hint = 0;
  for (const Vec3& x : pointsIn(Vec3::Constant(-0.5), Vec3::Constant(0.5), 1000)) {
    hint = (hint + 131) % static_cast<int>(mesh.triangles.rows());
    const ClosestPoint plain = tree.closest(x, 0.1), hinted = tree.closest(x, 0.1, hint);
    CHECK(hinted.triangle == plain.triangle);
    CHECK(hinted.distance == plain.distance);
    CHECK(hinted.pseudonormal == plain.pseudonormal);
  }
}

TEST_CASE("beyond the distance asked for there is no closest point, up to it there is") {
  const TriangleTree tree = treeOf(box(Vec3::Zero(), Vec3::Ones()));
  const Vec3 x(0.25, 0.5, 1.5);
  CHECK(tree.closest(x, 0.499).triangle == -1);
  CHECK(tree.closest(x, 0.499).distance == 0.499);
  CHECK(tree.closest(x, 0.5).triangle >= 0);
  CHECK(tree.closest(x, 0.5).distance == 0.5);
  CHECK(tree.signedDistance(x, 0.25) == 0.25);
  CHECK(tree.signedDistance(Vec3::Constant(0.5), 0.25) == -0.25);
}

TEST_CASE("the signed distance to a box is that of the formula") {
  const Vec3 low(-0.2, -0.3, -0.1), high(0.2, 0.1, 0.4);
  const TriangleTree tree = treeOf(box(low, high));
  for (const Vec3& x : pointsIn(Vec3::Constant(-0.6), Vec3::Constant(0.6), 2000))
    CHECK(tree.signedDistance(x, kInfinity) == Approx(distanceToBox(x, low, high)).margin(1e-14));
}

TEST_CASE("pseudonormals weigh faces by their angles, however these are cut into triangles") {
  const TriangleTree tree = treeOf(box(Vec3::Zero(), Vec3::Ones()));
  const Vec3 corner = tree.closest(Vec3(1.1, 1.2, 1.3), 1.0).pseudonormal;
  CHECK((corner - 0.5 * std::numbers::pi * Vec3::Ones()).norm() < 1e-14);
  const Vec3 edge = tree.closest(Vec3(1.1, 1.2, 0.5), 1.0).pseudonormal;
  CHECK((edge - Vec3(1.0, 1.0, 0.0)).norm() < 1e-14);
  const Vec3 face = tree.closest(Vec3(0.3, 0.2, -0.5), 1.0).pseudonormal;
  CHECK((face - Vec3(0.0, 0.0, -1.0)).norm() < 1e-14);
}

TEST_CASE("pseudonormals alone give the sign where the surface does not overlap itself") {
  const TriangleTree tree = treeOf(wavySphere(0.0));
  for (const Vec3& x : pointsIn(Vec3::Constant(-0.4), Vec3::Constant(0.4), 2000)) {
    const ClosestPoint found = tree.closest(x, kInfinity);
    CHECK(((x - found.point).dot(found.pseudonormal) < 0.0) == (tree.windingNumber(x) == 1));
  }
}

TEST_CASE("refitting equals building anew") {
  const TriangleMesh first = wavySphere(0.0), second = moved(wavySphere(2.0), Vec3(0.5, -0.2, 0.1));
  TriangleTree refitted = treeOf(first);
  refitted.refit(second.positions);
  const TriangleTree rebuilt = treeOf(second);
  for (const Vec3& x : pointsIn(Vec3(0.0, -0.7, -0.4), Vec3(1.0, 0.3, 0.6), 1000)) {
    const ClosestPoint a = refitted.closest(x, kInfinity), b = rebuilt.closest(x, kInfinity);
    CHECK(a.triangle == b.triangle);
    CHECK(a.point == b.point);
    CHECK(refitted.windingNumber(x) == rebuilt.windingNumber(x));
  }
}

TEST_CASE("rays through vertices and edges are counted once") {
  const TriangleTree tree = treeOf(joined(box(Vec3::Zero(), Vec3::Ones()), sphere(0.5, 8)));
  for (double u : {0.0, 0.125, 0.5, 1.0})
    for (double v : {0.0, 0.125, 0.5, 1.0}) {
      CHECK(tree.windingNumber(Vec3(u, v, -2.0)) == 0);
      CHECK(tree.windingNumber(Vec3(u, v, 2.0)) == 0);
    }
  CHECK(tree.windingNumber(Vec3(0.5, 0.5, 0.75)) == 1);
  CHECK(tree.windingNumber(Vec3(0.125, 0.125, 0.25)) == 2);
  CHECK(tree.windingNumber(Vec3(0.0, 0.0, -0.25)) == 1);
}

TEST_CASE("two overlapping spheres are their union") {
  const double offset = 0.12, radius = 0.2;
  const TriangleMesh ball = sphere(radius, 24);
  const TriangleTree tree = treeOf(joined(moved(ball, Vec3(offset, 0.0, 0.0)), moved(ball, Vec3(-offset, 0.0, 0.0))));
  const double edge = radius * 0.5 * std::numbers::pi / 24, facet = edge * edge / (4.0 * radius);
  for (const Vec3& x : pointsIn(Vec3(-0.4, -0.3, -0.3), Vec3(0.4, 0.3, 0.3), 4000)) {
    const double expected = distanceToTwoSpheres(x, offset, radius), found = tree.signedDistance(x, kInfinity);
    if (std::abs(expected) > facet) CHECK((found < 0.0) == (expected < 0.0));
    CHECK(std::abs(found - expected) < (expected > 0.0 ? facet : edge));
  }
}

TEST_CASE("a sphere within a sphere is no part of the boundary") {
  const TriangleMesh outer = sphere(0.3, 10);
  const TriangleTree alone = treeOf(outer), filled = treeOf(joined(moved(sphere(0.1, 5), Vec3(0.1, 0.0, 0.0)), outer));
  for (const Vec3& x : pointsIn(Vec3::Constant(-0.4), Vec3::Constant(0.4), 1000))
    CHECK(filled.signedDistance(x, kInfinity) == alone.signedDistance(x, kInfinity));
}

TEST_CASE("of a surface without triangles nothing is near, and every point is outside") {
  for (const long vertices : {0L, 3L}) {
    TriangleTree tree(Positions::Zero(vertices, 3), Triangles(0, 3));
    tree.refit(Positions::Ones(vertices, 3));
    CHECK(tree.closest({1.0, 1.0, 1.0}, 10.0).triangle == -1);
    CHECK(tree.closest({1.0, 1.0, 1.0}, std::numeric_limits<double>::infinity()).triangle == -1);
    CHECK(tree.closestOfUnion({1.0, 1.0, 1.0}, 10.0).distance == 10.0);
    CHECK(tree.signedDistance({0.0, 0.0, 0.0}, 10.0) == 10.0);
    CHECK(tree.windingNumber({0.0, 0.0, 0.0}) == 0);
  }
}
