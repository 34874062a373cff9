#include "collision/body/iso_surface.h"

#include <catch2/catch.hpp>

#include "solver/mesh/topology.h"
#include "tests/collision/bodies.h"

using namespace ease;
using namespace ease::bodies;

namespace {

constexpr double kRadius = 0.1, kVoxel = 0.02;

Distance ball(const Vec3& x) {
  return {x.norm() - kRadius, x.normalized()};
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
