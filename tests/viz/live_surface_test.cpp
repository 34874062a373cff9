#include "viz/live_surface.h"

#include <vtkPolyDataMapper.h>

#include <catch2/catch.hpp>

#include "tests/viz/fixtures.h"

using namespace ease;

TEST_CASE("a surface counts what changes on it, and nothing that stays") {
  TriangleMesh mesh = test::gridMesh(4);
  LiveSurface surface({100, 100, 100});
  CHECK_FALSE(surface.actor->GetVisibility());
  surface.set(mesh);
  CHECK(surface.actor->GetVisibility());
  long before = surface.changes;
  const auto changed = [&] {
    const bool has_changed = surface.changes != before;
    before = surface.changes;
    return has_changed;
  };
  surface.move(mesh.positions);
  CHECK_FALSE(changed());
  mesh.positions.row(3) *= 2.0;
  surface.move(mesh.positions);
  CHECK(changed());
  CHECK(surface.actor->GetBounds()[1] == Approx(mesh.positions.col(0).maxCoeff()));
  const std::vector<Rgb> red(mesh.triangles.rows(), Rgb{200, 0, 0});
  surface.color(red);
  CHECK(changed());
  surface.color(red);
  CHECK_FALSE(changed());
  surface.color({});
  CHECK(changed());
  CHECK_FALSE(surface.actor->GetMapper()->GetScalarVisibility());
  surface.set({});
  CHECK_FALSE(surface.actor->GetVisibility());
}

TEST_CASE("a surface far from the origin is where it is, and moves") {
  LiveSurface surface({1, 2, 3});
  TriangleMesh mesh{Positions(3, 3), Triangles(1, 3)};
  mesh.positions << 1000, 0, 0, 1001, 0, 0, 1000, 1704, 0;
  mesh.triangles << 0, 1, 2;
  surface.set(mesh);
  const double* bounds = surface.actor->GetBounds();
  CHECK(bounds[0] == Approx(1000.0));
  CHECK(bounds[3] == Approx(1704.0));
  surface.move(mesh.positions.array() + 1e-5);  // finer than single precision
  CHECK(surface.actor->GetBounds()[3] == Approx(1704.0 + 1e-5).epsilon(1e-10));
}
