#include "garment/pattern/region_levels.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("levels become distances again, and their lines stay") {
  const RestSurface sheet = flatSheet(20, 1.0);
  RegionLevels levels = halves(sheet, 0.113);
  for (double& phi : levels.phi) phi *= 7.0;  // no distances any more
  const RegionLevels again = redistanced(sheet, mapOf(sheet, levels), 2);
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const double distance = 0.113 - sheet.mesh.positions(v, 0);
    if (std::abs(distance) > 0.2) continue;  // beyond the band
    CHECK(again.of(1)[v] == Approx(distance).margin(1e-6));
    CHECK(again.of(0)[v] == Approx(-distance).margin(1e-6));
  }
}

TEST_CASE("distances from a point are nearly those over the surface") {
  const RestSurface sheet = flatSheet(40, 1.0);
  std::vector<double> distance(sheet.vertexCount(), std::numeric_limits<double>::infinity());
  const int middle = 20 * 41 + 20;
  distance[middle] = 0.0;
  marchDistances(sheet, 10.0, distance);
  double worst = 0.0;
  for (int v = 0; v < sheet.vertexCount(); ++v)
    worst = std::max(worst, std::abs(distance[v] - sheet.mesh.positions.row(v).norm()));
  CHECK(worst < 0.03);
}

TEST_CASE("a crossing lies where both levels are equal") {
  const RestSurface sheet = flatSheet(10, 1.0);
  const RegionMap map = mapOf(sheet, halves(sheet, 0.13));
  int crossed = 0;
  for (size_t e = 0; e < sheet.topology.edges.size(); ++e) {
    const Edge& edge = sheet.topology.edges[e];
    if (!isCrossed(map, edge)) continue;
    ++crossed;
    const double a = sheet.mesh.positions(edge.vertex[0], 0), b = sheet.mesh.positions(edge.vertex[1], 0);
    CHECK((1.0 - map.crossing[e]) * a + map.crossing[e] * b == Approx(0.13));
  }
  CHECK(crossed > 10);
}
