#include "garment/pattern/dart_trial.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

TEST_CASE("a cone lies flat along a dart to its tip, and not without") {
  const TriangleMesh mesh = cone(24, 5, 0.5, 0.3, true);
  const PieceMesh part{mesh, restGarment(mesh).rest_edges, {}, {}, {}};
  Seam dart{"", {}, false};
  for (int r = 4; r >= 0; --r) dart.vertices.push_back(1 + 24 * r);
  dart.vertices.push_back(0);
  const FlatSettings settings;
  const Trial without = flattenPart(part, {}, settings, 200), with = flattenPart(part, {dart}, settings, 200);
  CHECK(without.badness.over > 0.01);
  CHECK(with.badness.over == 0.0);
  CHECK(with.badness.all() < 0.01 * without.badness.all());
  CHECK(with.is_sound);
  CHECK(keeps(with.strain, settings.limits));
  CHECK(with.x.rows() == mesh.positions.rows());
}

TEST_CASE("a part has its piece's triangles and knows its vertices in the garment") {
  Seam middle{"middle", {}, false};
  for (int j = 0; j <= 4; ++j) middle.vertices.push_back(5 * j + 2);
  const RestGarment garment = restGarment(bentSheet(4, 0.4, [](double, double) { return 0.0; }), {middle});
  const Pieces pieces = cutIntoPieces(garment.mesh, garment.seams);
  REQUIRE(pieces.count == 2);
  int triangles = 0;
  for (int p = 0; p < 2; ++p) {
    const PieceMesh part = partOf(garment, pieces, p);
    CHECK(part.mesh.positions.rows() == 15);
    CHECK(part.rest_edges.size() == static_cast<size_t>(part.mesh.triangles.rows()));
    triangles += static_cast<int>(part.mesh.triangles.rows());
    for (size_t v = 0; v < part.garment_vertex.size(); ++v)
      CHECK(part.mesh.positions.row(static_cast<int>(v)) == garment.mesh.positions.row(part.garment_vertex[v]));
  }
  CHECK(triangles == garment.mesh.triangles.rows());
}
