#include "solver/model/samples.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "solver/model/cloth.h"
#include "tests/sheet.h"

using namespace ease;

TEST_CASE("a sample's position and value are the weighted means of its corners'") {
  const TriangleMesh sheet = makeSheet(4, 3, 0.4, 0.3, 0.2);
  const Topology topology = buildTopology(sheet, "sheet");
  const int n = static_cast<int>(sheet.positions.rows()), e = static_cast<int>(topology.edges.size());
  const ContactSamples samples(n, topology.edges, sheet.triangles);
  REQUIRE(samples.count() == n + e + sheet.triangles.rows());
  const Positions x = sheet.positions + 0.1 * randomPositions(n, 5);
  std::vector<Vec3> positions;
  samples.positions(x, positions);
  std::vector<double> heights(n), values;
  for (int v = 0; v < n; ++v) heights[v] = x(v, 2);
  samples.values(heights, values);
  REQUIRE(static_cast<int>(positions.size()) == samples.count());
  REQUIRE(static_cast<int>(values.size()) == samples.count());
  for (int s = 0; s < samples.count(); ++s) {
    CHECK(samples.corners(s).count == (s < samples.midpoint(0) ? 1 : s < samples.centroid(0) ? 2 : 3));
    Vec3 mean = Vec3::Zero();
    double weights = 0.0;
    for (int v = 0; v < n; ++v) {
      mean += samples.weight(s, v) * x.row(v).transpose();
      weights += samples.weight(s, v);
    }
    CHECK(weights == Approx(1.0).epsilon(1e-15));
    CHECK((positions[s] - mean).norm() < 1e-15);
    CHECK(values[s] == Approx(mean[2]).margin(1e-15));
  }
}

TEST_CASE("a midpoint lies on its edge and a centroid in its triangle") {
  const TriangleMesh sheet = makeSheet(2, 2, 0.2, 0.2);
  const Topology topology = buildTopology(sheet, "sheet");
  const ContactSamples samples(static_cast<int>(sheet.positions.rows()), topology.edges, sheet.triangles);
  const SampleCorners edge = samples.corners(samples.midpoint(3)), triangle = samples.corners(samples.centroid(5));
  for (int k = 0; k < 2; ++k) CHECK(edge.vertex[k] == topology.edges[3].vertex[k]);
  for (int k = 0; k < 3; ++k) CHECK(triangle.vertex[k] == sheet.triangles(5, k));
}

TEST_CASE("vertices, midpoints and centroids represent a third of the cloth's area each") {
  const Cloth cloth(makeSheet(5, 4, 0.5, 0.4, 0.2), Vec3(0.0, -1.0, 0.0), Material());
  const ContactSamples samples = cloth.samples();
  double area[3] = {};
  for (int s = 0; s < samples.count(); ++s)
    area[samples.corners(s).count - 1] += samples.area(s, cloth.vertexAreas(), cloth.restAreas());
  for (const double third : area) CHECK(third == Approx(0.5 * 0.4 / 3.0));
}
