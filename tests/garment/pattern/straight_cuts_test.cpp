#include "garment/pattern/straight_cuts.h"

#include <catch2/catch.hpp>

#include "garment/pattern/region_chains.h"
#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

namespace {

/// A sheet of 0.5 m with a line of waves down its middle between two regions.
struct Waved {
  RestGarment garment;
  Pieces pieces;
  RestSurface surface;
  LevelCut cut;

  explicit Waved(double bend)
      : garment(restGarment(bentSheet(20, 0.5, [&](double x, double y) { return bend * (x * x + y * y); }))),
        pieces(cutIntoPieces(garment.mesh, {})),
        surface(restSurface(pieces.mesh, garment.rest_edges)) {
    RegionLevels levels{2, std::vector<double>(2 * static_cast<size_t>(surface.vertexCount()))};
    for (int v = 0; v < surface.vertexCount(); ++v) {
      const Vec3 x = surface.mesh.positions.row(v);
      levels.of(0)[v] = x.x() - 0.05 * std::sin(20.0 * x.y());
      levels.of(1)[v] = -levels.of(0)[v];
    }
    cut = {levels, cutAlongRegions(garment, pieces, surface, mapOf(surface, levels)), 5.0};
  }

  CutPlace place() const { return {garment, pieces, surface}; }
};

double lengthIn(const LevelCut& cut) {
  return lengthOfSeams(cut.cut.garment.seams, cut.cut.garment.mesh.positions);
}

}  // namespace

TEST_CASE("a waved line on flat cloth becomes straight") {
  const Waved waved(0.0);
  CHECK(lengthIn(waved.cut) > 0.59);
  const LevelCut straight = straightest(waved.place(), waved.cut, {}, {}, {}, nullptr);
  CHECK(lengthIn(straight) < 0.505);
  CHECK(cutIntoPieces(straight.cut.garment.mesh, straight.cut.garment.seams).count == 2);
  CHECK(straight.length_weight > 5.0);
}

TEST_CASE("lines stay as they are where the pieces are beyond the limits") {
  const Waved waved(2.5);
  const LevelCut straight = straightest(waved.place(), waved.cut, {}, {}, {}, nullptr);
  CHECK(straight.length_weight == 5.0);
  CHECK(straight.cut.vertices.size() == waved.cut.cut.vertices.size());
}

TEST_CASE("levels of pieces have a label for each piece, and forget the lines of seams that were removed") {
  const Waved waved(0.0);
  const RegionMap before = mapOf(waved.surface, waved.cut.levels),
                  kept = mapOf(waved.surface, levelsOfPieces(waved.place(), waved.cut.levels, waved.cut.cut));
  for (const Edge& edge : waved.surface.topology.edges) CHECK(isCrossed(before, edge) == isCrossed(kept, edge));
  CutUp removed = waved.cut.cut;
  removed.garment.seams.clear();
  const RegionLevels whole = levelsOfPieces(waved.place(), waved.cut.levels, removed);
  CHECK(whole.labels == 1);
}
