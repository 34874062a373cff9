#include "garment/pieces.h"

#include <catch2/catch.hpp>

#include "tests/garment/tools.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// A square sheet with 5 x 5 vertices, numbered row by row.
const TriangleMesh kSheet = makeSheet(4, 4, 1.0, 1.0);
const Seam kAcross{"across", {10, 11, 12, 13, 14}, false};

}  // namespace

TEST_CASE("a seam from side to side makes two pieces, which glue back") {
  const Pieces pieces = cutIntoPieces(kSheet, {kAcross});
  CHECK(pieces.count == 2);
  CHECK(pieces.mesh.positions.rows() == 25 + 5);
  CHECK(buildTopology(pieces.mesh, "pieces").boundary_loops.size() == 2);
  CHECK(areaOf(pieces.mesh) == Approx(1.0).epsilon(1e-12));
  REQUIRE(pieces.mesh.triangles.rows() == kSheet.triangles.rows());
  for (int t = 0; t < kSheet.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) CHECK(pieces.glue[pieces.mesh.triangles(t, k)] == kSheet.triangles(t, k));
  for (size_t v = 0; v < pieces.glue.size(); ++v)
    CHECK(pieces.mesh.positions.row(v) == kSheet.positions.row(pieces.glue[v]));
}

TEST_CASE("seams that meet make as many pieces as there are fields") {
  const Seam half{"half", {2, 7, 12}, false};  // from the sheet's lower side to the middle of the other seam
  const Pieces pieces = cutIntoPieces(kSheet, {kAcross, half});
  CHECK(pieces.count == 3);
  CHECK(pieces.mesh.positions.rows() == 25 + 5 + 3);
}

TEST_CASE("a closed seam cuts out a patch, one that ends within is a slit") {
  CHECK(cutIntoPieces(kSheet, {{"patch", {6, 7, 8, 13, 18, 17, 16, 11}, true}}).count == 2);
  const Pieces slit = cutIntoPieces(kSheet, {{"slit", {2, 7, 12}, false}});
  CHECK(slit.count == 1);
  CHECK(slit.mesh.positions.rows() == 25 + 2);
}

TEST_CASE("without seams the garment is one piece") {
  const Pieces whole = cutIntoPieces(kSheet, {});
  CHECK(whole.count == 1);
  CHECK(whole.mesh.positions.rows() == 25);
}
