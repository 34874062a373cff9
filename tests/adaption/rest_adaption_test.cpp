#include "adaption/rest_adaption.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

TEST_CASE("cloth within the limit keeps its rest shape to the last bit, cloth beyond it is let out") {
  const TriangleMesh sheet = makeSheet(4, 4, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  RestAdaption adaption(cloth, 0.1, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  std::vector<Stretch> stretch;
  measureStretch(cloth, 1.02 * sheet.positions, stretch);
  CHECK_FALSE(adaption.adapt(stretch));
  CHECK(cloth.rest().positions == cloth.first().positions);
  measureStretch(cloth, 1.3 * sheet.positions, stretch);
  CHECK(adaption.adapt(stretch));
  double grown = 0.0;
  for (double area : cloth.restAreas()) grown += area;
  CHECK(grown > 1.01 * 0.04);
}
