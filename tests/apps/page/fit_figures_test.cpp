#include "apps/page/fit_figures.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/sheet.h"

using namespace ease;

namespace {

/// A sheet of 2 x 2 cells; stretched to 1.3 in its first triangle, crumpled in the second.
struct Measured {
  SceneInput input;
  ShownMoment moment;
  GarmentAreas areas;
  std::vector<double> first_areas, growth;

  Measured() {
    input.garment = makeSheet(2, 2, 0.2, 0.2);
    const auto triangles = static_cast<size_t>(input.garment.triangles.rows());
    moment.time_s = 0.5;
    moment.garment = input.garment.positions;
    moment.sigma_1.assign(triangles, 1.05F);
    moment.over.assign(triangles, 0.0F);
    moment.sigma_1[0] = 1.3F;
    moment.sigma_1[1] = std::numeric_limits<float>::quiet_NaN();
    moment.over[0] = moment.over[1] = 1.0F;
    moment.pressure.assign(input.garment.positions.rows(), 100.0F);
    moment.distance.assign(input.garment.positions.rows(), 0.01F);
    areas.names = {"one", "other"};
    for (size_t t = 0; t < triangles; ++t) areas.of_triangle.push_back(t < 2 ? 0 : 1);
    first_areas.assign(triangles, 0.005);
    growth.assign(triangles, 1.0);
    growth[0] = 1.2;
  }
};

}  // namespace

TEST_CASE("figures are those of each area, and of the whole garment at the end") {
  const Measured m;
  const auto figures = areaFigures(m.areas, m.input, m.moment, m.first_areas, m.growth);
  REQUIRE(figures.size() == 3);
  CHECK(figures[0].max_stretch == Approx(1.3));
  CHECK(figures[0].share_over_limit == 1.0);
  CHECK(figures[0].cloth_growth == Approx(1.1));
  CHECK(figures[1].max_stretch == Approx(1.05));
  CHECK(figures[1].share_over_limit == 0.0);
  CHECK(figures[2].share_over_limit == Approx(2.0 / 8.0));
  CHECK(figures[2].cloth_m2 == Approx(8 * 0.005));
  CHECK(figures[2].max_pressure_Pa == Approx(100.0));
  CHECK(figures[2].mean_distance_m == Approx(0.01));
}

TEST_CASE("the tightest places are the largest stretches, apart from each other, and never crumpled") {
  const Measured m;
  const MotionAlbum album{{m.moment}, {}, {}};
  const auto places = tightestPlaces(album, m.input, 3);
  REQUIRE(places.size() >= 2);
  CHECK(places[0].triangle == 0);
  CHECK(places[0].stretch == Approx(1.3));
  CHECK(places[0].time_s == 0.5);
  for (const TightPlace& place : places) CHECK(place.triangle != 1);
}
