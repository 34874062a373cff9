#include "garment/paint.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/sheet.h"

using namespace ease;

TEST_CASE("paint acts in full within half its radius, fades, and leaves all beyond as it is") {
  const TriangleMesh sheet = makeSheet(40, 40, 1.0, 1.0);
  const Brush brush{{0.5, 0.5, 0.0}, 0.3, 1.4};
  const std::vector<double> scales = paintedScales(sheet, {brush});
  int full = 0, faded = 0, untouched = 0;
  for (int t = 0; t < sheet.triangles.rows(); ++t) {
    Vec3 centroid = Vec3::Zero();
    for (int k = 0; k < 3; ++k) centroid += sheet.positions.row(sheet.triangles(t, k)) / 3.0;
    const double distance = (centroid - brush.at).norm();
    if (distance < 0.15) {
      CHECK(scales[t] == 1.4);
      ++full;
    } else if (distance < 0.3) {
      CHECK((scales[t] > 1.0 && scales[t] < 1.4 + 1e-12));
      ++faded;
    } else {
      CHECK(scales[t] == 1.0);
      ++untouched;
    }
  }
  CHECK(full > 100);
  CHECK(faded > 100);
  CHECK(untouched > 100);
}

TEST_CASE("paint over paint multiplies") {
  const TriangleMesh sheet = makeSheet(4, 4, 0.1, 0.1);
  const Brush more{{0.05, 0.05, 0.0}, 1.0, 1.5}, less{{0.05, 0.05, 0.0}, 1.0, 0.5};
  for (const double scale : paintedScales(sheet, {more, less})) CHECK(scale == Approx(0.75));
}

TEST_CASE("paint beside the garment is refused") {
  const TriangleMesh sheet = makeSheet(4, 4, 0.1, 0.1);
  const Brush far{{5, 0, 0}, 0.1, 1.5};
  CHECK_THROWS_AS(paintedScales(sheet, {far}), InputError);
  CHECK_THROWS_WITH(paintedScales(sheet, {far}), "paint number 1: at = [5, 0, 0], radius = 0.1: touches no triangle");
}

TEST_CASE("more paint leads from one painting to the other, and the same is nothing more") {
  const std::vector<double> none, some = {1.2, 1.0}, other = {1.5, 0.8};
  CHECK(paintBetween(none, some) == some);
  CHECK(paintBetween(some, none) == std::vector<double>{1.0 / 1.2, 1.0});
  CHECK(paintBetween(some, other) == std::vector<double>{1.5 / 1.2, 0.8});
  CHECK(paintBetween(some, some).empty());
  CHECK(paintBetween(none, none).empty());
}

TEST_CASE("a stroke that passes a place twice paints it once, and no further than a ball does") {
  const TriangleMesh sheet = makeSheet(40, 40, 1.0, 1.0);
  const Vec3 left(0.3, 0.5, 0.0), right(0.7, 0.5, 0.0);
  const std::vector<double> once = paintedScales(sheet, {{left, 0.2, 1.2, {left, right}}});
  const std::vector<double> twice = paintedScales(sheet, {{left, 0.2, 1.2, {left, right, left}}});
  double difference = 0.0;
  for (size_t t = 0; t < once.size(); ++t) difference = std::max(difference, std::abs(once[t] - twice[t]));
  CHECK(difference < 1e-12);
  CHECK(*std::max_element(once.begin(), once.end()) == 1.2);
  // At its ends it is a ball, and half way it acts in full.
  const Brush stroke{left, 0.2, 1.2, {left, right}}, ball{left, 0.2, 1.2};
  CHECK(brushWeight(stroke, {0.15, 0.5, 0.0}) == brushWeight(ball, {0.15, 0.5, 0.0}));
  CHECK(brushWeight(stroke, {0.5, 0.55, 0.0}) == 1.0);
  CHECK(brushWeight(ball, {0.5, 0.55, 0.0}) < 0.1);
}
