#include "garment/nearness.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/sheet.h"

using namespace ease;

TEST_CASE("the distance to a mesh is that to its nearest triangle, inside, at an edge or at a corner") {
  const TriangleMesh sheet = makeSheet(3, 3, 0.3, 0.3);
  CHECK(distanceTo(sheet, {0.12, 0.17, 0.05}) == Approx(0.05));
  CHECK(distanceTo(sheet, {0.12, -0.03, 0.04}) == Approx(0.05));
  CHECK(distanceTo(sheet, {-0.02, -0.01, 0.02}) == Approx(0.03));
}

TEST_CASE("a point far from the mesh is refused with its distance") {
  const TriangleMesh sheet = makeSheet(3, 3, 0.3, 0.3);
  CHECK_NOTHROW(expectNear(sheet, {0.1, 0.1, 0.09}, kNearLine, "seed", "the body"));
  CHECK_THROWS_AS(expectNear(sheet, {0.1, 0.1, 0.52}, kNearLine, "seed", "the body"), InputError);
  CHECK_THROWS_WITH(expectNear(sheet, {0.1, 0.1, 0.52}, kNearLine, "seed", "the body"),
                    "seed = [0.1, 0.1, 0.52] is 0.52 m from the body: expected within 0.1 m");
}
