#include "collision/body/body_size.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "collision/body/mannequin.h"

using namespace ease;

namespace {

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a - o).x() * (b - o).y() - (a - o).y() * (b - o).x();
}

/// Length of a tape around the trunk at height y, m: the convex hull of the section within `reach` of x = 0.
double girth(const TriangleMesh& body, double y, double reach = 0.2) {
  std::vector<Eigen::Vector2d> section;
  for (int t = 0; t < body.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = body.positions.row(body.triangles(t, k)), b = body.positions.row(body.triangles(t, (k + 1) % 3));
      if ((a.y() - y) * (b.y() - y) >= 0.0) continue;
      const Vec3 x = a + (b - a) * (y - a.y()) / (b.y() - a.y());
      if (std::abs(x.x()) < reach) section.emplace_back(x.x(), x.z());
    }
  if (section.size() < 3) return 0.0;
  std::sort(section.begin(), section.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  // Andrew's monotone chain: the lower half of the hull from left to right, then the upper one back.
  std::vector<Eigen::Vector2d> hull;
  for (int half = 0; half < 2; ++half) {
    const size_t begin = hull.size();
    for (const Eigen::Vector2d& x : section) {
      while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), x) <= 0.0) hull.pop_back();
      hull.push_back(x);
    }
    hull.pop_back();
    std::reverse(section.begin(), section.end());
  }
  double length = 0.0;
  for (size_t k = 0; k < hull.size(); ++k) length += (hull[(k + 1) % hull.size()] - hull[k]).norm();
  return length;
}

}  // namespace

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
