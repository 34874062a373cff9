#include "garment/pattern/flat_pattern.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// A flat sheet of 20 x 20 cells with a seam down its middle.
RestGarment halves() {
  Seam middle{"middle", {}, false};
  for (int j = 0; j <= 20; ++j) middle.vertices.push_back(21 * j + 10);
  return restGarment(bentSheet(20, 0.6, [](double, double) { return 0.0; }), {middle});
}

}  // namespace

TEST_CASE("every edge of a seam has one on the other side, and both sides are as long as the seam") {
  const FlatPattern pattern = flattenGarment(halves(), exactSettings());
  REQUIRE(pattern.seams.size() == 1);
  const SeamSides& seam = pattern.seams.front();
  CHECK(seam.rest_length == Approx(0.6));
  CHECK(seam.left_length == Approx(0.6).epsilon(1e-9));
  CHECK(seam.right_length == Approx(0.6).epsilon(1e-9));
  CHECK(lengthOf(pattern.cut.edges[seam.left].vertices, pattern.x) == seam.left_length);
  const std::vector<SewnPair> pairs = sewnPairs(pattern.cut);
  CHECK(pairs.size() == 20);
  for (const SewnPair& pair : pairs) {
    CHECK(pattern.cut.pieces.glue[pair.a0] == pattern.cut.pieces.glue[pair.b0]);
    CHECK(pattern.cut.pieces.glue[pair.a1] == pattern.cut.pieces.glue[pair.b1]);
  }
  CHECK_FALSE(isDartLeg(pattern.cut, seam.left));
}

TEST_CASE("pieces that lie flat are sewn to the garment that they were cut from") {
  const RestGarment garment = halves();
  const std::vector<Mat2> sewn = sewnEdges(flattenGarment(garment, exactSettings()));
  REQUIRE(sewn.size() == garment.rest_edges.size());
  for (size_t t = 0; t < sewn.size(); ++t) CHECK((sewn[t] - garment.rest_edges[t]).norm() < 1e-8);
}

TEST_CASE("pieces flattened again for longer threads are longer, and keep what was told of them") {
  const RestGarment garment = halves();
  const FlatSettings settings = exactSettings();
  const FlatPattern first = flattenGarment(garment, settings);
  std::vector<Mat2> grown = garment.rest_edges;
  for (Mat2& edges : grown) edges.row(0) *= 1.1;
  const FlatPattern again = flattenAgain(first, grown, settings);
  const std::vector<Mat2> sewn = sewnEdges(again);
  for (size_t t = 0; t < sewn.size(); ++t) CHECK((sewn[t] - grown[t]).norm() < 1e-8);
  CHECK(again.pieces.front().strain.thread_mean == first.pieces.front().strain.thread_mean);
}

TEST_CASE("a piece far below the limit of shear shears more, so that its threads stretch less") {
  const RestGarment cap = restGarment(bentSheet(12, 0.6, [](double x, double y) { return 0.5 * (x * x + y * y); }));
  FlatSettings settings;
  settings.max_darts = 0;
  const FlatPattern softer = flattenGarment(cap, settings);
  FlatSettings narrow = settings;
  narrow.limits.shear = 1e-6;  // no room
  const FlatPattern stiffer = flattenGarment(cap, narrow);
  CHECK(softer.shear.front() < settings.woven.shear);
  CHECK(stiffer.shear.front() == settings.woven.shear);
  CHECK(softer.pieces.front().strain.thread_mean < 0.8 * stiffer.pieces.front().strain.thread_mean);
  CHECK(keeps(softer.pieces.front().strain, settings.limits));
}

TEST_CASE("a piece that had to be opened to lie flat is told") {
  const FlatPattern pattern = flattenGarment(restGarment(cone(24, 6, 0.2, 0.3, false)), exactSettings());
  REQUIRE(pattern.warnings.size() == 1);
  CHECK(pattern.warnings.front().find("was cut open along '" + pattern.lines.front().seam.name + "'") !=
        std::string::npos);
}

TEST_CASE("a dart that was given where cloth lacks width is left out, and no piece is cut in two for it") {
  FlatSettings settings;
  settings.max_darts = 0;
  const FlatPattern pattern =
      flattenGarment(restGarment(bentSheet(8, 0.4, [](double x, double y) { return 2.0 * (x * x - y * y); }),
                                 {{"bust dart", {4, 13, 22, 31, 40}, false}}),
                     settings);
  CHECK(pattern.pieces.size() == 1);
  CHECK(pattern.pieces.front().darts == 0);
  CHECK(pattern.lines.empty());
  CHECK(std::count(pattern.warnings.begin(), pattern.warnings.end(),
                   "the dart 'bust dart' was left out: its legs do not open on the paper, or it leads across a seam") ==
        1);
}
