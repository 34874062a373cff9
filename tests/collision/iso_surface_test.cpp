#include "collision/iso_surface.h"

#include <catch2/catch.hpp>

#include "solver/mesh/topology.h"

using namespace ease;

namespace {

constexpr double kRadius = 0.1, kVoxel = 0.02;

Distance ball(const Vec3& x) {
  return {x.norm() - kRadius, x.normalized()};
}

double smallestAngle(const TriangleMesh& mesh) {
  double least = 180.0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const Vec3 a = mesh.positions.row(mesh.triangles(t, c));
      const Vec3 u = mesh.positions.row(mesh.triangles(t, (c + 1) % 3)).transpose() - a;
      const Vec3 v = mesh.positions.row(mesh.triangles(t, (c + 2) % 3)).transpose() - a;
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / M_PI);
    }
  return least;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 a = mesh.positions.row(mesh.triangles(t, 0)), b = mesh.positions.row(mesh.triangles(t, 1));
    const Vec3 c = mesh.positions.row(mesh.triangles(t, 2));
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

}  // namespace

TEST_CASE("the surface of a ball is closed, on the ball, faces outwards and has even triangles") {
  const TriangleMesh mesh = isoSurface(ball, Vec3::Constant(-0.15), Vec3::Constant(0.15), kVoxel);
  const Topology topology = buildTopology(mesh, "ball");
  CHECK(topology.boundary_loops.empty());
  CHECK(mesh.positions.rows() - static_cast<long>(topology.edges.size()) + mesh.triangles.rows() == 2);
  for (int v = 0; v < mesh.positions.rows(); ++v) CHECK(std::abs(mesh.positions.row(v).norm() - kRadius) < 1e-6);
  CHECK(smallestAngle(mesh) > 25.0);
  CHECK(volume(mesh) == Approx(4.0 / 3.0 * M_PI * std::pow(kRadius, 3)).epsilon(0.03));
  double mean = 0.0;
  for (const Edge& edge : topology.edges)
    mean += (mesh.positions.row(edge.vertex[0]) - mesh.positions.row(edge.vertex[1])).norm();
  CHECK(mean / static_cast<double>(topology.edges.size()) == Approx(kVoxel).epsilon(0.3));
}

TEST_CASE("a point goes onto the surface along the gradient") {
  const Vec3 x(0.03, 0.05, -0.02);
  CHECK((ontoSurface(ball, x) - kRadius * x.normalized()).norm() < 1e-9);
}

TEST_CASE("relaxing makes bad triangles on a surface better and keeps the boundary") {
  const auto plane = [](const Vec3& x) { return Distance{x.z(), Vec3::UnitZ()}; };
  TriangleMesh mesh;  // a square cut into four triangles from a point near its corner
  mesh.positions.resize(5, 3);
  mesh.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.05, 0.1, 0;
  mesh.triangles.resize(4, 3);
  mesh.triangles << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
  const TriangleMesh before = mesh;
  relaxOnSurface(plane, 20, mesh);
  CHECK((mesh.positions.topRows(4) - before.positions.topRows(4)).norm() == 0.0);
  CHECK((mesh.positions.row(4) - Eigen::RowVector3d(0.5, 0.5, 0.0)).norm() < 0.01);
  CHECK(smallestAngle(mesh) > 2.0 * smallestAngle(before));
}
