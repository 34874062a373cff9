#include "garment/pattern/thread_strain.h"

#include <catch2/catch.hpp>

using namespace ease;

namespace {

/// Two triangles of a square of 1 m at rest, from (0, 0) to (1, 1).
FlatPieces square() {
  FlatPieces pieces{Triangles(2, 3), {}, {{0, 1, 2, 3}}, 4};
  pieces.triangles << 0, 1, 2, 0, 2, 3;
  Mat2 lower, upper;
  lower << 1, 1, 0, 1;
  upper << 1, 0, 1, 1;
  pieces.rest_edges = {lower, upper};
  return pieces;
}

/// The square mapped to the paper.
Positions onPaper(const Mat2& map) {
  Positions x = Positions::Zero(4, 3);
  x.row(1).head<2>() = map * Eigen::Vector2d(1, 0);
  x.row(2).head<2>() = map * Eigen::Vector2d(1, 1);
  x.row(3).head<2>() = map * Eigen::Vector2d(0, 1);
  return x;
}

StrainSummary summary(const Positions& x) {
  const FlatPieces pieces = square();
  return strainOf(pieces, x, threadStrains(pieces, x), {0, 0}, 0, StrainLimits());
}

}  // namespace

TEST_CASE("cloth cut 10 % too short along the warp stretches its warp by a ninth, and its weft not") {
  const std::vector<ThreadStrain> strains = threadStrains(square(), onPaper(Eigen::Vector2d(0.9, 1.0).asDiagonal()));
  for (const ThreadStrain& strain : strains) {
    CHECK(strain.warp == Approx(1.0 / 0.9));
    CHECK(strain.weft == Approx(1.0));
    CHECK(strain.shear == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("cloth whose threads must meet at another angle shears by as much") {
  Mat2 to_rest;  // weft turned by 0.2 rad towards the warp, as long as before
  to_rest << 1.0, std::sin(0.2), 0.0, std::cos(0.2);
  for (const ThreadStrain& strain : threadStrains(square(), onPaper(to_rest.inverse()))) {
    CHECK(strain.warp == Approx(1.0));
    CHECK(strain.weft == Approx(1.0));
    CHECK(std::abs(strain.shear) == Approx(0.2));
  }
}

TEST_CASE("a piece keeps the limits while its threads, its shear and its orientation do") {
  const StrainSummary flat = summary(onPaper(Mat2::Identity()));
  CHECK(flat.area == Approx(1.0));
  CHECK(flat.thread_mean == Approx(0.0).margin(1e-12));
  CHECK(keeps(flat, StrainLimits()));
  const StrainSummary short_warp = summary(onPaper(Eigen::Vector2d(0.9, 1.0).asDiagonal()));
  CHECK(short_warp.thread_over_share == Approx(1.0));
  CHECK_FALSE(keeps(short_warp, StrainLimits()));
  const StrainSummary flipped = summary(onPaper(Eigen::Vector2d(-1.0, 1.0).asDiagonal()));
  CHECK(flipped.flipped == 2);
  CHECK_FALSE(keeps(flipped, StrainLimits()));
}
