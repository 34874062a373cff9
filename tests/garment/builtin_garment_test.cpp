#include "garment/builtin_garment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "collision/body/mannequin.h"
#include "collision/triangle_tree.h"
#include "garment/named_loop.h"
#include "solver/base/error.h"
#include "solver/mesh/topology.h"

using namespace ease;

namespace {

constexpr double kOffset = 0.005;  // m

Vec3 vertex(const TriangleMesh& mesh, int t, int k) {
  return mesh.positions.row(mesh.triangles(t, k % 3));
}

/// Lists all angles of the triangles, degrees, in ascending order.
std::vector<double> sortedAngles(const TriangleMesh& mesh) {
  std::vector<double> angles;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 u = vertex(mesh, t, k + 1) - vertex(mesh, t, k), v = vertex(mesh, t, k + 2) - vertex(mesh, t, k);
      angles.push_back(std::acos(u.normalized().dot(v.normalized())) * 180.0 / M_PI);
    }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// Computes the smallest distance of vertices, edge midpoints and centroids to the body, m.
double clearance(const TriangleMesh& garment, const TriangleMesh& body) {
  const TriangleTree tree(body.positions, body.triangles);
  double least = 1.0;
  for (int t = 0; t < garment.triangles.rows(); ++t) {
    Vec3 centroid = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = vertex(garment, t, k), b = vertex(garment, t, k + 1);
      centroid += a / 3.0;
      least = std::min({least, tree.signedDistance(a, 0.1), tree.signedDistance(0.5 * (a + b), 0.1)});
    }
    least = std::min(least, tree.signedDistance(centroid, 0.1));
  }
  return least;
}

/// Computes the largest angle by which a loop turns at one of its vertices, degrees.
double sharpestTurn(const std::vector<int>& loop, const Positions& positions) {
  double sharpest = 0.0;
  const size_t n = loop.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec3 a = positions.row(loop[i]), b = positions.row(loop[(i + 1) % n]), c = positions.row(loop[(i + 2) % n]);
    sharpest = std::max(sharpest, std::acos((b - a).normalized().dot((c - b).normalized())) * 180.0 / M_PI);
  }
  return sharpest;
}

}  // namespace

TEST_CASE("a built-in garment has the number of vertices asked for, well-shaped triangles and clearance") {
  const TriangleMesh body = mannequin("t");
  for (const std::string name : {"t-shirt", "dress"})
    for (const int vertices : {600, 3000}) {
      INFO(name << " " << vertices);
      const TriangleMesh garment = builtinGarment(name, vertices, kOffset);
      CHECK(std::abs(garment.positions.rows() - vertices) <= 0.03 * vertices);
      const std::vector<double> angles = sortedAngles(garment);
      CHECK(angles.front() > 5.0);
      CHECK(angles[angles.size() / 1000] > 20.0);
      CHECK(clearance(garment, body) >= kOffset);
    }
}

TEST_CASE("a built-in garment has four smooth, plane openings: neck, hem and two sleeves") {
  for (const std::string name : {"t-shirt", "dress"}) {
    INFO(name);
    const TriangleMesh garment = builtinGarment(name, 2000, kOffset);
    const Topology topology = buildTopology(garment, name);
    REQUIRE(topology.boundary_loops.size() == 4);
    // A sphere with four holes has the Euler characteristic 2 - 4.
    CHECK(garment.positions.rows() - static_cast<long>(topology.edges.size()) + garment.triangles.rows() == -2);
    for (const std::vector<int>& loop : topology.boundary_loops) CHECK(sharpestTurn(loop, garment.positions) < 60.0);

    const auto spread = [&](const std::string& where, const Vec3& normal) {
      double low = 1e9, high = -1e9;
      for (int v : findLoop(topology, garment.positions, where)) {
        const double along = normal.dot(Vec3(garment.positions.row(v)));
        low = std::min(low, along);
        high = std::max(high, along);
      }
      return high - low;
    };
    CHECK(spread("bottom", Vec3::UnitY()) < 1e-9);
    CHECK(spread("left", Vec3(1.0, 0.25, 0.0).normalized()) < 1e-9);
    CHECK(spread("right", Vec3(-1.0, 0.25, 0.0).normalized()) < 1e-9);
    CHECK(spread("top", Vec3(0.0, 0.90, 0.44).normalized()) < 1e-9);
  }
}

TEST_CASE("the coarsest garment still passes around arms and trunk") {
  const TriangleMesh body = mannequin("t");
  for (const std::string name : {"t-shirt", "dress"}) {
    INFO(name);
    const TriangleMesh garment = builtinGarment(name, 300, kOffset);
    CHECK(std::abs(garment.positions.rows() - 300) <= 9);
    CHECK(sortedAngles(garment).front() > 10.0);
    CHECK(clearance(garment, body) >= kOffset);
    CHECK(buildTopology(garment, name).boundary_loops.size() == 4);
  }
}

TEST_CASE("a built-in garment takes the measures of the mannequin that wears it, and keeps the offset") {
  for (const BodyMeasures& measures : {BodyMeasures{1.5, 0.7, 0.56, 0.75}, BodyMeasures{1.9, 1.25, 1.1, 1.3}})
    for (const std::string name : {"t-shirt", "dress"}) {
      INFO(name << " for a height of " << *measures.height);
      const TriangleMesh body = mannequin("t", measures), garment = builtinGarment(name, 600, kOffset, measures);
      CHECK(clearance(garment, body) >= kOffset);
      CHECK(sortedAngles(garment).front() > 4.0);
      CHECK(buildTopology(garment, name).boundary_loops.size() == 4);
    }
}

TEST_CASE("a built-in garment faces outwards and keeps the offset asked for") {
  const TriangleMesh body = mannequin("t");
  for (const double offset : {0.0, 0.05}) {
    INFO(offset);
    const TriangleMesh garment = builtinGarment("t-shirt", 1000, offset);
    CHECK(clearance(garment, body) >= offset);
    CHECK(buildTopology(garment, "t-shirt").boundary_loops.size() == 4);
    double outwards = 0.0;  // sum of area-weighted normals along the direction away from the middle
    for (int t = 0; t < garment.triangles.rows(); ++t) {
      const Vec3 a = vertex(garment, t, 0), b = vertex(garment, t, 1), c = vertex(garment, t, 2);
      const Vec3 middle(0.0, 1.2, 0.0);
      outwards += doubleAreaNormal(a, b, c).dot((a + b + c) / 3.0 - middle);
    }
    CHECK(outwards > 0.05);
  }
}

TEST_CASE("a built-in garment is the same every time") {
  const TriangleMesh first = builtinGarment("dress", 600, kOffset), second = builtinGarment("dress", 600, kOffset);
  REQUIRE(first.positions.rows() == second.positions.rows());
  CHECK(first.triangles == second.triangles);
  CHECK(first.positions == second.positions);
}

TEST_CASE("an impossible garment is refused with what was expected") {
  CHECK_THROWS_AS(builtinGarment("kilt", 3000, kOffset), InputError);
  CHECK_THROWS_WITH(builtinGarment("kilt", 3000, kOffset),
                    "there is no built-in garment \"kilt\"; there are \"t-shirt\" and \"dress\"");
  CHECK_THROWS_WITH(builtinGarment("dress", 20, kOffset),
                    "vertices = 20: expected 300 to 100000 for the built-in garment 'dress'");
  CHECK_THROWS_WITH(builtinGarment("dress", 3000, 0.2),
                    "builtin = 'dress': [collision] offset = 0.2 m: expected 0 to 0.05 m");
}
