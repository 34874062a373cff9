#include "adaption/presence.h"

#include <catch2/catch.hpp>

#include "collision/contacts.h"
#include "tests/collision/bodies.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// Two sheets side by side: one of four times the area of the other.
TriangleMesh twoSheets() {
  const TriangleMesh large = makeSheet(4, 4, 0.4, 0.4), small = makeSheet(2, 2, 0.2, 0.2);
  TriangleMesh both{Positions(large.positions.rows() + small.positions.rows(), 3),
                    Triangles(large.triangles.rows() + small.triangles.rows(), 3)};
  both.positions << small.positions, large.positions;
  both.triangles << small.triangles, large.triangles.array() + static_cast<int>(small.positions.rows());
  return both;
}

}  // namespace

TEST_CASE("connected parts are numbered by their area, the largest first") {
  const TriangleMesh both = twoSheets();
  std::vector<double> areas;
  for (int t = 0; t < both.triangles.rows(); ++t) areas.push_back(triangleArea(both.positions, both.triangles, t));
  const std::vector<int> part = connectedParts(both.triangles, areas, static_cast<int>(both.positions.rows()));
  CHECK(part.front() == 1);
  CHECK(part.back() == 0);
}

TEST_CASE("a part that leaves the body is off it since then, one that comes back is not, and both know how far") {
  const TriangleMesh both = twoSheets();
  const Cloth cloth(both, Vec3(0, -1, 0), Material());
  const std::vector<double> offsets(cloth.vertexCount(), 0.005);
  const TriangleMesh body = bodies::box(Vec3(-1, -1, -1.02), Vec3(1, 1, -0.02));  // its face is 2 cm behind the sheets
  const TriangleTree tree(body.positions, body.triangles);
  const BodyMoment moment{nullptr, &tree, &body.triangles, &body.positions, &body.positions};
  Presence presence(cloth, offsets);
  presence.tie(both.positions, body.positions, body.triangles);
  const auto add = [&](double time_s, double small_away, double large_away) {
    Positions x = both.positions;
    x.topRows(9).col(2).array() += small_away;
    x.bottomRows(25).col(2).array() += large_away;
    std::vector<Vec3> samples;
    cloth.samples().positions(x, samples);
    std::vector<double> distances;
    for (const Vec3& sample : samples) distances.push_back(std::min(tree.signedDistance(sample, 1.0), 0.03));
    presence.add(time_s, x, moment, distances, 0.03, [&](const Vec3& p) { return distanceTo(moment, p); });
  };
  add(0.0, 0.0, 0.0);
  CHECK_FALSE(presence.parts()[0].off_since_s);
  add(0.1, 2.0, 0.5);
  add(0.2, 3.0, 0.0);
  const PartPresence &large = presence.parts()[0], &small = presence.parts()[1];
  CHECK_FALSE(large.off_since_s);
  CHECK(large.area_share == Approx(0.8));
  CHECK(large.nearest_m == Approx(0.02));
  CHECK(large.slid_m == Approx(0.0).margin(1e-12));
  CHECK(small.off_since_s == 0.1);
  CHECK(small.last_m == Approx(3.02));
  CHECK(small.slid_m == Approx(3.0));
}
