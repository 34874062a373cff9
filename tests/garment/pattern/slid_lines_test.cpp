#include "garment/pattern/slid_lines.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

constexpr int kCells = 16;
constexpr double kCell = 0.02;  // m

int vertex(int i, int j) {
  return j * (kCells + 1) + i;
}

/// A flat sheet whose cloth is longer at rest along the warp and shorter along the weft than in space.
RestGarment sheet() {
  RestGarment garment = restGarment(bentSheet(kCells, kCells * kCell, [](double, double) { return 0.0; }));
  for (Mat2& edges : garment.rest_edges) edges.row(0) *= 1.1, edges.row(1) *= 0.9;
  return garment;
}

/// Up from the lower edge, to the right and back on every row.
CutLine zigzag() {
  CutLine line{{"dart", {}, false}, LineKind::dart};
  for (int j = 0; j <= 8; ++j) line.seam.vertices.push_back(vertex(8 + j % 2, j));
  return line;
}

}  // namespace

TEST_CASE("a dart that zigzags along edges runs straight after its vertices slid, in cloth that is the same") {
  const RestGarment garment = sheet();
  std::vector<CutLine> lines = {zigzag()};
  const CutUp slid = slideLines(garment, lines);
  CHECK(lines.front().seam.vertices == zigzag().seam.vertices);
  const Positions& x = slid.garment.mesh.positions;
  for (const int v : lines.front().seam.vertices) CHECK(std::abs(x(v, 0)) < 0.15 * kCell);
  CHECK(x.row(vertex(8, 0)) == garment.mesh.positions.row(vertex(8, 0)));
  CHECK(x.row(vertex(8, 8)) == garment.mesh.positions.row(vertex(8, 8)));
  CHECK(slid.garment.mesh.triangles == garment.mesh.triangles);
  double area = 0.0;
  for (size_t t = 0; t < slid.garment.rest_edges.size(); ++t) {
    const Mat32 edges = edgeMatrix(x, garment.mesh.triangles, static_cast<int>(t));
    Mat2 rest = planeFrame(edges, {0.0, -1.0, 0.0}).transpose() * edges;
    rest.row(0) *= 1.1;
    rest.row(1) *= 0.9;
    CHECK((slid.garment.rest_edges[t] - rest).norm() < 1e-12);
    area += 0.5 * rest.determinant();
  }
  CHECK(area == Approx(0.99 * kCells * kCells * kCell * kCell));
}

TEST_CASE("every vertex that slid is told as a mean of those that were there") {
  const RestGarment garment = sheet();
  std::vector<CutLine> lines = {zigzag()};
  const CutUp slid = slideLines(garment, lines);
  REQUIRE(slid.vertices.size() == static_cast<size_t>(garment.mesh.positions.rows()));
  for (size_t v = 0; v < slid.vertices.size(); ++v) {
    Vec3 mean = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      mean += slid.vertices[v].share[k] * garment.mesh.positions.row(slid.vertices[v].from[k]).transpose();
    CHECK((mean - slid.garment.mesh.positions.row(static_cast<int>(v)).transpose()).norm() < 1e-12);
    CHECK(slid.vertices[v].share.minCoeff() > -1e-9);
  }
}

TEST_CASE("seams and the garment's edge stay while a line beside them slides") {
  const RestGarment garment = sheet();
  std::vector<CutLine> lines = {{columnSeam(kCells, 7), LineKind::seam}, zigzag()};
  const CutUp slid = slideLines(garment, lines);
  const Positions &before = garment.mesh.positions, &x = slid.garment.mesh.positions;
  CHECK(before != x);
  for (int k = 0; k <= kCells; ++k)
    for (const int v : {vertex(7, k), vertex(k, 0), vertex(k, kCells)}) CHECK(x.row(v) == before.row(v));
}

TEST_CASE("nothing slides where all lines are seams") {
  const RestGarment garment = sheet();
  std::vector<CutLine> lines = {{columnSeam(kCells, 7), LineKind::seam}};
  const CutUp slid = slideLines(garment, lines);
  CHECK(slid.garment.mesh.positions == garment.mesh.positions);
  CHECK(slid.garment.rest_edges == garment.rest_edges);
}

TEST_CASE("a dart goes around a seam that lies on the straight way to its tip") {
  const RestGarment garment = sheet();
  CutLine dart{{"dart",
                {vertex(8, 0), vertex(9, 1), vertex(10, 2), vertex(10, 3), vertex(10, 4), vertex(9, 4), vertex(8, 4),
                 vertex(8, 5)},
                false},
               LineKind::dart};
  CutLine slit{{"slit", {vertex(7, 3), vertex(8, 3), vertex(9, 3)}, false}, LineKind::seam};
  std::vector<CutLine> lines = {slit, dart};
  const CutUp slid = slideLines(garment, lines);
  CHECK(slid.garment.mesh.positions(vertex(10, 3), 0) > garment.mesh.positions(vertex(9, 3), 0));
  for (const Mat2& edges : slid.garment.rest_edges) CHECK(edges.determinant() > 0.0);
}
