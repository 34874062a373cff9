#include "garment/pattern/piece_trial.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"
#include "tests/tube.h"

using namespace ease;

TEST_CASE("narrow and small pieces are told from others") {
  const RestGarment garment = restGarment(bentSheet(50, 1.0, [](double, double) { return 0.0; }), {columnSeam(50, 1)});
  const Pieces pieces = cutIntoPieces(garment.mesh, garment.seams);
  REQUIRE(pieces.count == 2);
  CHECK(isTooSmall(garment, pieces, 0, {}) != isTooSmall(garment, pieces, 1, {}));
}

TEST_CASE("a tube is tried as it lies when it is cut open, and tells how long the cut is") {
  const RestGarment garment = restGarment(tube(24, 9, 2.0));
  const PieceTrial trial = tryPiece(garment, cutIntoPieces(garment.mesh, {}), 0, {});
  CHECK(trial.is_sound);
  CHECK(trial.keeps);
  CHECK(trial.openings == Approx(2.0));
  CHECK(trial.box.x() == Approx(2.0).epsilon(1e-3));
  CHECK(trial.stretch < 1e-4);
}

TEST_CASE("found seams leave room below the limits of the pattern") {
  const FlatSettings given;
  CHECK(strictLimits(given).limits.thread < given.limits.thread);
  CHECK(strictLimits(given).limits.share > given.limits.share);
}
