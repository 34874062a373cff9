#include "garment/pattern/free_grain.h"

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// A saddle, which threads along its diagonals fit without stretch, with threads turned from there by an angle, rad.
RestGarment saddle(double angle) {
  const RestGarment along = restGarment(bentSheet(14, 0.5, [](double x, double y) { return 2.5 * x * y; }));
  Pieces whole;
  whole.count = 1;
  whole.piece.assign(along.rest_edges.size(), 0);
  return withGrain(along, whole, {angle});
}

double stretchOf(const FlatPattern& pattern) {
  return pattern.pieces.front().strain.thread_mean;
}

}  // namespace

TEST_CASE("a free grain is turned to where threads stretch least, and the piece tells by how much") {
  FlatSettings settings;
  settings.max_darts = 0;
  const FlatPattern along = flattenGarment(saddle(0.0), settings),
                    across = flattenGarment(saddle(45.0 * M_PI / 180.0), settings);
  const bool is_along_best = stretchOf(along) < stretchOf(across);
  const double off = (is_along_best ? 30.0 : 15.0) * M_PI / 180.0;  // so that the best grain is 30 degrees away
  FlatSettings free = settings;
  free.free_grain = true;
  const FlatPattern given = flattenGarment(saddle(off), settings), turned = flattenGarment(saddle(off), free);
  CHECK(given.pieces.front().grain == 0.0);
  CHECK(std::abs(turned.pieces.front().grain) * 180.0 / M_PI == Approx(30.0).margin(5.1));
  CHECK(stretchOf(turned) < 0.9 * stretchOf(given));
  CHECK(stretchOf(turned) == Approx(std::min(stretchOf(along), stretchOf(across))).epsilon(0.1));
}

TEST_CASE("the grain stays the garment's where turning it spares nothing") {
  FlatSettings free;
  free.free_grain = true;
  const FlatPattern flat = flattenGarment(restGarment(bentSheet(8, 0.5, [](double, double) { return 0.0; })), free);
  CHECK(flat.pieces.front().grain == 0.0);
}

TEST_CASE("a grain across which the piece is wider than the cloth is not taken") {
  FlatSettings free;
  free.free_grain = true;
  free.max_darts = 0;
  const RestGarment garment = saddle(30.0 * M_PI / 180.0);
  const FlatPattern turned = flattenGarment(garment, free);
  free.widest = 0.1;
  CHECK(turned.pieces.front().grain != 0.0);
  CHECK(flattenGarment(garment, free).pieces.front().grain == 0.0);
}

TEST_CASE("threads that are turned keep the lengths of edges") {
  const RestGarment given = saddle(0.0), turned = saddle(0.7);
  for (size_t t = 0; t < given.rest_edges.size(); ++t)
    CHECK((edgeLengths(given.rest_edges[t]) - edgeLengths(turned.rest_edges[t])).norm() < 1e-12);
}
