#include "collision/body/surface_relaxation.h"

#include <catch2/catch.hpp>

#include "collision/body/iso_surface.h"
#include "solver/mesh/topology.h"
#include "tests/collision/bodies.h"
#include "tests/sheet.h"

using namespace ease;
using namespace ease::bodies;

namespace {

constexpr double kRadius = 0.1;

Distance ball(const Vec3& x) {
  return {x.norm() - kRadius, x.normalized()};
}

}  // namespace

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

TEST_CASE("a disturbed mesh of a ball, relaxed, is even again and lies on the ball, its edges flipped but as many") {
  TriangleMesh mesh = isoSurface(ball, Vec3::Constant(-0.15), Vec3::Constant(0.15), 0.02);
  const Positions shift = 0.008 * randomPositions(static_cast<int>(mesh.positions.rows()), 3);
  mesh.positions = kRadius * (mesh.positions + shift).rowwise().normalized();
  const TriangleMesh before = mesh;
  relaxOnSurface(ball, 12, mesh);
  CHECK((mesh.positions.rowwise().norm().array() - kRadius).abs().maxCoeff() < 1e-7);
  CHECK(smallestAngle(before) < 10.0);
  CHECK(smallestAngle(mesh) > 25.0);
  CHECK(volume(mesh) == Approx(4.0 / 3.0 * std::numbers::pi * std::pow(kRadius, 3)).epsilon(0.03));
  const Topology flipped = buildTopology(mesh, "ball"), plain = buildTopology(before, "ball");
  CHECK(flipped.edges.size() == plain.edges.size());
  CHECK(mesh.triangles != before.triangles);
}
