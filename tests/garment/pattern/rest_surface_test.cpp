#include "garment/pattern/rest_surface.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("a sphere has the curvature 1 / r^2, a flat sheet none") {
  const RestSurface sphere = cap(32);
  double total = 0.0, area = 0.0;
  for (int t = 0; t < sphere.triangleCount(); ++t) {
    const auto corner = sphere.mesh.triangles.row(t);
    if (sphere.on_border[corner[0]] || sphere.on_border[corner[1]] || sphere.on_border[corner[2]]) continue;
    total += sphere.curvature[t] * sphere.area[t];
    area += sphere.area[t];
  }
  CHECK(total / area == Approx(1.0 / 0.04).epsilon(0.02));
  const RestSurface flat = flatSheet(4, 1.0);
  for (const double g : flat.curvature) CHECK(std::abs(g) < 1e-9);
  CHECK(flat.side == Approx(1.0));
}

TEST_CASE("a triangle without area at rest is refused by its number") {
  RestGarment garment = restGarment(bentSheet(2, 1.0, [](double, double) { return 0.0; }));
  garment.rest_edges[3].setZero();
  CHECK_THROWS_WITH(restSurface(garment.mesh, garment.rest_edges), Catch::Contains("triangle 3 has no area"));
}
