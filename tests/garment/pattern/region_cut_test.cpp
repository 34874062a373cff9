#include "garment/pattern/region_cut.h"

#include <catch2/catch.hpp>

#include "garment/pattern/region_chains.h"
#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

namespace {

/// Cut where x = at, m.
CutUp cutAt(const RestGarment& garment, double at) {
  const Pieces pieces = cutIntoPieces(garment.mesh, garment.seams);
  const RestSurface surface = restSurface(pieces.mesh, garment.rest_edges);
  return cutAlongRegions(garment, pieces, surface, mapOf(surface, halves(surface, at)));
}

double restArea(const RestGarment& garment) {
  double area = 0.0;
  for (const Mat2& edges : garment.rest_edges) {
    CHECK(edges.determinant() > 0.0);
    area += 0.5 * edges.determinant();
  }
  return area;
}

}  // namespace

TEST_CASE("the cut runs exactly along the line and leaves no slivers") {
  const RestGarment garment = restGarment(bentSheet(10, 1.0, [](double, double) { return 0.0; }));
  for (const double at : {0.0, 0.003, 0.02, 0.05, 0.0999})  // a crossing keeps a thousandth of its edge from the ends
  {
    const CutUp cut = cutAt(garment, at);
    REQUIRE(cut.garment.seams.size() == 1);
    for (const int v : cut.garment.seams.front().vertices)
      CHECK(cut.garment.mesh.positions(v, 0) == Approx(at).margin(1.01e-4));
    CHECK(restArea(cut.garment) == Approx(1.0));
    for (size_t t = 0; t < cut.source.size(); ++t) {
      const Mat2& d = cut.garment.rest_edges[t];
      const double longest = edgeLengths(d).maxCoeff();
      CHECK(d.determinant() / longest > 0.09 * 0.1);  // heights, beside edges of 0.1 m
      CHECK(
          d.isApprox(planeFrame(edgeMatrix(cut.garment.mesh.positions, cut.garment.mesh.triangles, static_cast<int>(t)),
                                {0.0, -1.0, 0.0})
                             .transpose() *
                         edgeMatrix(cut.garment.mesh.positions, cut.garment.mesh.triangles, static_cast<int>(t)),
                     1e-9));  // flat, so that the rest shape is that of the mesh, along the same grain
    }
  }
}

TEST_CASE("loops get the new vertices on them, and every vertex is a mean of the garment's") {
  RestGarment garment = restGarment(bentSheet(4, 1.0, [](double, double) { return 0.0; }));
  garment.loops = {{"edge", buildTopology(garment.mesh, "sheet").boundary_loops.front()}};
  const CutUp cut = cutAt(garment, 0.12);
  CHECK(cut.garment.loops.front().vertices.size() == garment.loops.front().vertices.size() + 2);
  for (const CutVertex& vertex : cut.vertices) CHECK(vertex.share.sum() == Approx(1.0));
}

TEST_CASE("lines end on seams that the garment has, and these stay whole") {
  RestGarment garment = restGarment(bentSheet(8, 1.0, [](double, double) { return 0.0; }));
  Seam seam{"waist", {}, false};
  for (int i = 0; i <= 8; ++i) seam.vertices.push_back(4 * 9 + i);
  garment.seams = {seam};
  const CutUp cut = cutAt(garment, 0.07);
  REQUIRE(cut.garment.seams.size() == 3);
  CHECK(cut.garment.seams.front().vertices == seam.vertices);
  CHECK(cutIntoPieces(cut.garment.mesh, cut.garment.seams).count == 4);
  CHECK(restArea(cut.garment) == Approx(1.0));
}
