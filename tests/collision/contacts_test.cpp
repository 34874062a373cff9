#include "collision/contacts.h"

#include <catch2/catch.hpp>

#include "solver/mesh/topology.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// A body of two thick slabs that face each other across a gap; tests look at the middle, far from the slabs' rims.
TriangleMesh makeSlabs(double gap) {
  TriangleMesh slabs;
  const double thick = 0.2, wide = 0.4;
  slabs.positions.resize(16, 3);
  slabs.triangles.resize(24, 3);
  const auto box = [&](int which, double x0, double x1) {
    const int v = 8 * which, t = 12 * which;
    for (int i = 0; i < 8; ++i)
      slabs.positions.row(v + i) << (i & 1 ? x1 : x0), (i & 2 ? wide : -wide), (i & 4 ? wide : -wide);
    const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (int i = 0; i < 12; ++i) slabs.triangles.row(t + i) << v + faces[i][0], v + faces[i][1], v + faces[i][2];
  };
  box(0, -0.5 * gap - thick, -0.5 * gap);
  box(1, 0.5 * gap, 0.5 * gap + thick);
  return slabs;
}

struct Body {
  TriangleMesh mesh;
  TriangleTree tree;
  LevelSet level_set{LevelSetOptions{0.0025, 0.03}};
  Positions towards;
  explicit Body(const TriangleMesh& m) : mesh(m), tree(m.positions, m.triangles), towards(m.positions) {}
  BodyMoment moment(std::span<const Vec3> points, double tau = 0.0) {
    level_set.build(tree, points, 0.001);
    return {&level_set, &tree, &mesh.triangles, &mesh.positions, &towards, tau};
  }
};

constexpr double kMaxRecovery = 0.01;  // m

}  // namespace

TEST_CASE("a plane stands the offset away from the body, and there is none far from it") {
  Body body(makeSlabs(0.1));
  const std::vector<Vec3> points{{-0.047, 0.01, 0.02}, {-0.052, 0.03, 0.0}, {0.0, 0.0, 0.0}};
  const std::vector<double> offsets(3, 0.005);
  ContactFinder finder;
  Contacts contacts;
  finder.find(body.moment(points), points, offsets, kMaxRecovery, contacts);
  const std::vector<ContactPlane>& planes = contacts.planes;
  CHECK(planes[0].depth(points[0]) == Approx(0.002).margin(1e-5));
  CHECK(planes[1].depth(points[1]) == Approx(0.007).margin(1e-5));
  CHECK((planes[0].normal - Vec3::UnitX()).norm() < 1e-3);
  CHECK(planes[2].normal.isZero());
  CHECK(planes[2].depth(points[2]) == 0.0);
  CHECK(contacts.seconds.empty());
}

TEST_CASE("between parts nearer than twice the offset the planes of both are in the middle") {
  Body body(makeSlabs(0.004));
  const std::vector<double> offsets(1, 0.005);
  ContactFinder finder;
  Contacts contacts;
  for (const double x : {-0.0045, -0.001, 0.0012, 0.004}) {
    const std::vector<Vec3> points{{x, 0.01, 0.02}};
    finder.find(body.moment(points), points, offsets, kMaxRecovery, contacts);
    REQUIRE(contacts.seconds.size() == 1);
    const ContactPlane &first = contacts.planes[0], &second = contacts.seconds[0].plane;
    CHECK(first.normal.dot(second.normal) == Approx(-1.0).margin(1e-2));
    const double asked = x + first.depth(points[0]) * first.normal[0] + second.depth(points[0]) * second.normal[0];
    CHECK(asked == Approx(0.0).margin(1.25e-3));  // half a voxel
  }
}

// With a single plane a sample would slide along that part into the other one, from step to step.
TEST_CASE("in a crease the planes of both parts lead out of it") {
  const double slope = 0.5, gap = 0.002;  // above y = 0 each wall leans back by `slope`
  TriangleMesh walls = makeSlabs(gap);
  for (int v = 0; v < 16; ++v) walls.positions(v, 0) += (v < 8 ? -slope : slope) * (walls.positions(v, 1) + 0.4);
  Body body(walls);
  const auto distanceToWalls = [&](const Vec3& x) {
    return (0.5 * gap + slope * (x.y() + 0.4) - std::abs(x.x())) / std::hypot(1.0, slope);
  };
  const std::vector<double> offsets(1, 0.005);
  ContactFinder finder;
  Contacts contacts;
  Vec3 x(0.0005, -0.398, 0.01);
  const double before = distanceToWalls(x);
  REQUIRE(before < 0.0015);
  for (int round = 0; round < 8; ++round) {
    const std::vector<Vec3> points{x};
    finder.find(body.moment(points), points, offsets, kMaxRecovery, contacts);
    // The nearest point above both planes.
    for (int k = 0; k < 200; ++k) {
      x += contacts.planes[0].depth(x) * contacts.planes[0].normal;
      for (const auto& second : contacts.seconds) x += second.plane.depth(x) * second.plane.normal;
    }
    CHECK(distanceToWalls(x) > before - 1e-4);
  }
  CHECK(distanceToWalls(x) > 0.0045);
}

TEST_CASE("every sample keeps its own offset") {
  Body body(makeSlabs(0.1));
  const std::vector<Vec3> points{{-0.047, 0.01, 0.02}, {-0.047, 0.02, 0.02}};
  const std::vector<double> offsets{0.005, 0.012};
  ContactFinder finder;
  Contacts contacts;
  finder.find(body.moment(points), points, offsets, kMaxRecovery, contacts);
  CHECK(contacts.planes[0].depth(points[0]) == Approx(0.002).margin(1e-5));
  CHECK(contacts.planes[1].depth(points[1]) == Approx(0.009).margin(1e-5));
}

TEST_CASE("a level set is carried along with the body") {
  Body body(makeSlabs(0.1));
  body.towards.col(0).array() += 0.02;
  body.towards.col(1).array() += 0.01;
  const std::vector<Vec3> points{{-0.039, 0.01, 0.02}};  // 1 mm from the wall that has moved by half of 2 cm
  ContactFinder finder;
  std::vector<double> distances;
  finder.distances(body.moment(points, 0.5), points, distances);
  CHECK(distances[0] == Approx(0.001).margin(1e-5));
}

TEST_CASE("distances since the last find follow small moves") {
  Body body(makeSlabs(0.1));
  std::vector<Vec3> points{{-0.047, 0.01, 0.02}};
  const std::vector<double> offsets(1, 0.005);
  ContactFinder finder;
  Contacts contacts;
  finder.find(body.moment(points), points, offsets, kMaxRecovery, contacts);
  points[0][0] -= 0.004;
  std::vector<double> distances;
  finder.distancesSinceFind(points, distances);
  CHECK(distances[0] == Approx(-0.001).margin(1e-5));
  Penetration penetration;
  penetration.deepen(distances, 1, 0);
  CHECK(penetration.vertices == Approx(0.001).margin(1e-5));
  CHECK(penetration.centroids == 0.0);
}

TEST_CASE("a sample's motion is that of the part of the body whose plane it has") {
  Body body(makeSlabs(0.1));
  // The slabs come from where they are turned by 0.2 and moved.
  const Mat3 turn = Eigen::AngleAxisd(0.2, Vec3(0.3, 1.0, -0.2).normalized()).toRotationMatrix();
  const Vec3 shift(0.01, -0.02, 0.03);
  body.towards = body.mesh.positions * turn.transpose();
  body.towards.rowwise() += shift.transpose();
  const std::vector<Vec3> points{{-0.047, 0.01, 0.02}, {0.0, 0.0, 0.0}};
  const BodyMoment now = body.moment(points);
  BodyMoment start = now;
  start.tau = 1.0;
  ContactFinder finder;
  Contacts contacts;
  finder.find(now, points, std::vector<double>(2, 0.005), kMaxRecovery, contacts, &start);
  REQUIRE(contacts.motions.size() == 2);
  CHECK((contacts.motions[0] - (points[0] - turn * points[0] - shift)).norm() < 1e-12);
  CHECK(contacts.motions[1].isZero());
  finder.find(now, points, std::vector<double>(2, 0.005), kMaxRecovery, contacts);
  CHECK(contacts.motions.empty());
}

TEST_CASE("between two parts of the body each plane has its own part's motion") {
  Body body(makeSlabs(0.004));
  for (int v = 0; v < 16; ++v) body.towards(v, 1) += v < 8 ? 0.003 : -0.002;
  const std::vector<Vec3> points{{-0.0012, 0.01, 0.02}};
  const BodyMoment now = body.moment(points);
  BodyMoment start = now;
  start.tau = 1.0;
  ContactFinder finder;
  Contacts contacts;
  finder.find(now, points, std::vector<double>(1, 0.005), kMaxRecovery, contacts, &start);
  REQUIRE(contacts.seconds.size() == 1);
  REQUIRE(contacts.motions.size() == 2);
  for (int k = 0; k < 2; ++k) {
    const double away = (k == 0 ? contacts.planes[0] : contacts.seconds[0].plane).normal[0];
    CHECK((contacts.motions[k] - Vec3(0.0, away > 0.0 ? -0.003 : 0.002, 0.0)).norm() < 1e-12);
  }
}

TEST_CASE("a triangle is as deep in the body as its deepest point, though most of its points are left out") {
  Body body(makeSlabs(0.1));
  const std::vector<Vec3> none;
  const BodyMoment moment = body.moment(none);
  const double step = 0.005;
  const Vec3 a(-0.062, 0.0, 0.0), b(0.03, 0.02, 0.0), c(0.04, -0.03, 0.05);  // a corner is 12 mm deep
  CHECK(depthOfTriangle(moment, a, b, c, step) == Approx(0.012).epsilon(1e-9));
  const Vec3 across(0.072, 0.01, 0.02);  // both slabs, the second one deeper
  CHECK(depthOfTriangle(moment, a, across, c, step) == Approx(0.022).epsilon(1e-9));
  CHECK(depthOfTriangle(moment, Vec3(-0.049, 0.0, 0.0), b, c, step) == 0.0);
}
