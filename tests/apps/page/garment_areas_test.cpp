#include "apps/page/garment_areas.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/tube.h"

using namespace ease;
using Catch::Matchers::Contains;

namespace {

SceneInput tubeInput() {
  SceneInput input;
  input.garment = tube(24, 6, 0.5);
  return input;
}

}  // namespace

TEST_CASE("a garment without seams has a front and a back, facing +z and -z") {
  const SceneInput input = tubeInput();
  const GarmentAreas areas = garmentAreas(Scene(), input);
  REQUIRE(areas.of_triangle.size() == static_cast<size_t>(input.garment.triangles.rows()));
  CHECK(std::set<std::string>(areas.names.begin(), areas.names.end()) == std::set<std::string>{"front", "back"});
  for (int t = 0; t < input.garment.triangles.rows(); ++t) {
    double z = 0.0;
    for (int corner = 0; corner < 3; ++corner) z += input.garment.positions(input.garment.triangles(t, corner), 2);
    if (std::abs(z) > 0.3) CHECK(areas.names[areas.of_triangle[t]] == (z > 0.0 ? "front" : "back"));
  }
}

TEST_CASE("the place of a triangle is told by its part and the nearest edge") {
  const SceneInput input = tubeInput();
  const GarmentAreas areas = garmentAreas(Scene(), input);
  CHECK_THAT(placeInWords(areas, input, 0), Contains(" cm from the edge '"));
}
