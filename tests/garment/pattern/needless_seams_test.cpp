#include "garment/pattern/needless_seams.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("flat cloth needs no seam, but keeps those that were given") {
  const RestGarment garment =
      restGarment(bentSheet(8, 1.0, [](double, double) { return 0.0; }), {columnSeam(8, 2), columnSeam(8, 5)});
  CHECK(neededSeams(garment, 0, {}, {}).empty());
  REQUIRE(neededSeams(garment, 1, {}, {}).size() == 1);
  CHECK(neededSeams(garment, 1, {}, {}).front().name == "column");
}

TEST_CASE("a seam goes together with its mirror image, and stays where it has none") {
  const TriangleMesh sheet = bentSheet(8, 1.0, [](double, double) { return 0.0; });
  const double middle = 0.5 * (sheet.positions.col(0).minCoeff() + sheet.positions.col(0).maxCoeff());
  CHECK(neededSeams(restGarment(sheet, {columnSeam(8, 2), columnSeam(8, 6)}), 0, {}, {}, middle).empty());
  CHECK(neededSeams(restGarment(sheet, {columnSeam(8, 2)}), 0, {}, {}, middle).size() == 1);
}

TEST_CASE("a piece wider than the cloth keeps its seam") {
  const RestGarment garment = restGarment(bentSheet(8, 1.0, [](double, double) { return 0.0; }), {columnSeam(8, 4)});
  SewableSize narrow;
  narrow.widest = 0.8;
  CHECK(neededSeams(garment, 0, {}, narrow).size() == 1);
}

TEST_CASE("a strongly bent sheet keeps its seam") {
  const RestGarment garment =
      restGarment(bentSheet(12, 0.5, [](double x, double y) { return 3.0 * (x * x + y * y); }), {columnSeam(12, 6)});
  CHECK(neededSeams(garment, 0, {}, {}).size() == 1);
}

TEST_CASE("a strip too narrow to sew joins its neighbour where both keep the pattern's own limits") {
  const RestGarment garment =
      restGarment(bentSheet(30, 0.6, [](double x, double y) { return 0.9 * (x * x + y * y); }), {columnSeam(30, 1)});
  FlatSettings settings;
  settings.limits.shear = 1.0;
  settings.limits.thread = 1e-3;
  const Pieces whole = cutIntoPieces(garment.mesh, {});
  while (!tryPiece(garment, whole, 0, settings).keeps) settings.limits.thread *= 1.05;
  REQUIRE_FALSE(tryPiece(garment, whole, 0, strictLimits(settings)).keeps);
  CHECK(neededSeams(garment, 0, settings, {}).empty());
}
