#include "collision/body/body_size.h"

#include <catch2/catch.hpp>

#include "collision/body/mannequin.h"
#include "solver/mesh/topology.h"

using namespace ease;

TEST_CASE("the mannequin has the measures that it is said to have") {
  const TriangleMesh body = mannequin("t");
  CHECK(body.positions.col(1).maxCoeff() == Approx(BodySize::kHeight).margin(1e-3));
  for (size_t k = 0; k < 3; ++k) CHECK(girth(body, BodySize::kLevels[k]) == Approx(BodySize::kGirths[k]).margin(1e-3));
}

TEST_CASE("the mannequin takes a person's measures, which a tape round it finds again") {
  const BodyMeasures measures{1.80, 1.02, 0.90, 1.05};
  const TriangleMesh body = mannequin("t", measures);
  const double scale = 1.80 / BodySize::kHeight;
  CHECK(body.positions.col(1).maxCoeff() == Approx(1.80).margin(2e-3));
  CHECK(girth(body, scale * BodySize::kLevels[0], 0.4) == Approx(1.05).margin(2e-3));
  CHECK(girth(body, scale * BodySize::kLevels[1], 0.4) == Approx(0.90).margin(2e-3));
  CHECK(girth(body, scale * BodySize::kLevels[2], 0.4) == Approx(1.02).margin(2e-3));
  CHECK(body.triangles == mannequin("t").triangles);
}

TEST_CASE("without measures the mannequin is as it was, to the last bit") {
  CHECK(mannequin("up", {}).positions == mannequin("up").positions);
  const BodySize own{BodyMeasures()};
  for (const Vec3& x : {Vec3(0.1, 1.2, 0.05), Vec3(-0.5, 1.385, 0.0), Vec3(0.0, 1.6, -0.1)}) CHECK(own.warped(x) == x);
  CHECK(own.minScale() == 1.0);
}

TEST_CASE("in every size and pose the body is closed and no triangle is turned over") {
  for (const BodyMeasures& measures :
       {BodyMeasures{1.5, 0.7, 0.55, 0.75}, BodyMeasures{1.9, 1.3, 1.05, 1.3}, BodyMeasures{{}, 1.1, {}, {}}})
    for (const std::string& pose : mannequinPoses()) {
      const TriangleMesh body = mannequin(pose, measures);
      double volume = 0.0;
      for (int t = 0; t < body.triangles.rows(); ++t) {
        const Vec3 a = body.positions.row(body.triangles(t, 0)), b = body.positions.row(body.triangles(t, 1)),
                   c = body.positions.row(body.triangles(t, 2));
        volume += a.dot(b.cross(c)) / 6.0;
      }
      CHECK(volume > 0.02);  // m^3
      const TriangleMesh own = mannequin(pose);
      int turned = 0;
      for (int t = 0; t < body.triangles.rows(); ++t) {
        const auto v = body.triangles.row(t);
        const auto normal = [&](const Positions& x) { return doubleAreaNormal(x.row(v[0]), x.row(v[1]), x.row(v[2])); };
        turned += normal(body.positions).dot(normal(own.positions)) < 0.0;
      }
      CHECK(turned == 0);
    }
}

TEST_CASE("a measure's range follows the height") {
  const MeasureRange own = BodySize::range({}, "chest"), tall = BodySize::range({2.0, {}, {}, {}}, "chest");
  CHECK(own.low < BodySize::kGirths[2]);
  CHECK(own.high > BodySize::kGirths[2]);
  CHECK(tall.low == Approx(own.low * 2.0 / BodySize::kHeight));
}
