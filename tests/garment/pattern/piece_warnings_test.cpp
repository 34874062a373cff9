#include "garment/pattern/piece_warnings.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// A flat sheet, 0.4 m wide, cut along a column of vertices beside its edge.
std::vector<std::string> warningsOfStrip(int cells) {
  Seam seam = columnSeam(cells, 1);
  seam.name = "edge";
  const RestGarment garment = restGarment(bentSheet(cells, 0.4, [](double, double) { return 0.0; }), {seam});
  return pieceWarnings(flattenGarment(garment, exactSettings()), StrainLimits());
}

}  // namespace

TEST_CASE("a strip that is too narrow to sew is told, with the seam beside it") {
  const std::vector<std::string> warnings = warningsOfStrip(50);  // 8 mm
  REQUIRE(warnings.size() == 1);
  CHECK(warnings.front().find("is too small to sew: 32.0 cm^2, 0.8 cm wide") != std::string::npos);
  CHECK(warnings.front().find("between the seams 'edge'") != std::string::npos);
}

TEST_CASE("a narrow waistband is not too small") {
  CHECK(warningsOfStrip(20).empty());  // 20 mm
}
