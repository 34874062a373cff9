#include "garment/surface_place.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("a point is told by the nearest triangle and the shares of its corners") {
  TriangleMesh mesh{Positions(4, 3), Triangles(2, 3)};
  mesh.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  const SurfacePlaces places(mesh);
  const SurfacePlace at = places.nearest({0.75, 0.25, 0.1}, 0.5);
  CHECK(at.triangle == 0);
  CHECK((at.share - Vec3(0.25, 0.5, 0.25)).norm() < 1e-12);
  CHECK(places.nearest({0.1, 0.6, 0.0}, 0.5, 0).triangle == 1);
  CHECK(places.nearest({0.5, 0.5, 2.0}, 0.5).triangle == -1);
}
