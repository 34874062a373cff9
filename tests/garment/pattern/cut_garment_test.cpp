#include "garment/pattern/cut_garment.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/garment/pattern/shapes.h"
#include "tests/tube.h"

using namespace ease;

namespace {

std::vector<CutLine> asLines(const std::vector<Seam>& seams) {
  std::vector<CutLine> lines;
  for (const Seam& seam : seams) lines.push_back({seam, LineKind::seam});
  return lines;
}

}  // namespace

TEST_CASE("outlines run counter-clockwise and are divided where a seam begins") {
  const TriangleMesh sheet = bentSheet(4, 1.0, [](double, double) { return 0.0; });
  const CutGarment cut = cutGarment(sheet, asLines({{"across", {10, 11, 12, 13, 14}, false}}),
                                    {{"rim", buildTopology(sheet, "sheet").boundary_loops.front()}});
  REQUIRE(cut.pieces.count == 2);
  for (int p = 0; p < 2; ++p) {
    REQUIRE(cut.outlines[p].size() == 2);
    double area = 0.0;
    const std::vector<int> outline = outlineOf(cut, p);
    for (size_t i = 0; i < outline.size(); ++i) {
      const Vec3 a = cut.pieces.mesh.positions.row(outline[i]),
                 b = cut.pieces.mesh.positions.row(outline[(i + 1) % outline.size()]);
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    CHECK(area == Approx(0.5).epsilon(1e-12));
    for (const int e : cut.outlines[p]) {
      const PieceEdge& edge = cut.edges[e];
      CHECK(edge.name == (edge.line < 0 ? "rim" : "across"));
      if (edge.line < 0) continue;
      const PieceEdge& other = cut.edges[edge.partner];
      CHECK(other.partner == e);
      REQUIRE(other.vertices.size() == edge.vertices.size());
      for (size_t i = 0; i < edge.vertices.size(); ++i)
        CHECK(cut.pieces.glue[edge.vertices[i]] == cut.pieces.glue[other.vertices[edge.vertices.size() - 1 - i]]);
    }
  }
}

TEST_CASE("a tube is opened along its length, which is told as a line of its own") {
  const TriangleMesh mesh = tube(12, 5, 0.5);
  const std::vector<CutLine> lines = makeDisks(mesh, restGarment(mesh).rest_edges, {}, {});
  REQUIRE(lines.size() == 1);
  CHECK(lines.front().kind == LineKind::opened);
  CHECK(lines.front().seam.vertices.size() == 5);  // straight up
  CHECK(cutGarment(mesh, lines, {}).pieces.count == 1);
}

TEST_CASE("a piece that no path opens is refused with the loops around it") {
  const TriangleMesh ring = tube(12, 2, 0.5);  // every edge across is fine, but without any there is no opening
  CHECK_THROWS_AS(cutGarment(ring, {}, {}), InputError);
}

TEST_CASE("both legs of a dart end at its tip") {
  const TriangleMesh sheet = bentSheet(4, 1.0, [](double, double) { return 0.0; });
  const CutGarment cut = cutGarment(sheet, asLines({{"dart", {2, 7, 12}, false}}), {});
  REQUIRE(cut.outlines.front().size() == 3);
  int legs = 0;
  for (const int e : cut.outlines.front()) legs += isDartLeg(cut, e) ? 1 : 0;
  CHECK(legs == 2);
}
