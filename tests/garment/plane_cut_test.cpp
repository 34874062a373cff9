#include "garment/plane_cut.h"

#include <catch2/catch.hpp>

#include "solver/mesh/topology.h"

using namespace ease;

TEST_CASE("cutting a square along a plane leaves the area behind it, with its edge on the plane") {
  TriangleMesh square;
  square.positions.resize(4, 3);
  square.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  square.triangles.resize(2, 3);
  square.triangles << 0, 1, 2, 0, 2, 3;
  const Plane plane = {{0.3, 0.0, 0.0}, Vec3::UnitX()};
  const TriangleMesh left = cutByPlane(square, plane, 1e-6);
  double area = 0.0;
  for (int t = 0; t < left.triangles.rows(); ++t) area += triangleArea(left.positions, left.triangles, t);
  CHECK(area == Approx(0.3).epsilon(1e-12));
  CHECK(left.positions.col(0).maxCoeff() == Approx(0.3).epsilon(1e-15));
  CHECK(buildTopology(left, "left").boundary_loops.size() == 1);

  const TriangleMesh snapped = cutByPlane(square, {{0.999, 0.0, 0.0}, Vec3::UnitX()}, 0.01);
  CHECK(snapped.positions.rows() == 4);
  CHECK(snapped.positions.col(0).maxCoeff() == 0.999);
}
