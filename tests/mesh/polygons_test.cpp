#include "solver/mesh/polygons.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"

using namespace ease;
using Catch::Contains;

namespace {

/// One polygon in the plane z = x / 2, whose corners are the points in their order.
Polygons polygonOf(const std::vector<std::pair<double, double>>& points) {
  Polygons polygons;
  polygons.points.resize(static_cast<long>(points.size()), 3);
  for (size_t i = 0; i < points.size(); ++i) {
    polygons.points.row(static_cast<long>(i)) << points[i].first, points[i].second, 0.5 * points[i].first;
    polygons.corners.push_back(static_cast<int>(i));
  }
  polygons.ends.push_back(static_cast<int>(points.size()));
  return polygons;
}

/// Area seen along z; checks that every triangle counts with the same sign and none is flat.
double checkedArea(const Polygons& polygons) {
  const Triangles triangles = trianglesOf(polygons, cutPolygons(polygons, "panel.obj"));
  CHECK(triangles.rows() == static_cast<long>(polygons.corners.size()) - 2);
  double sum = 0.0;
  for (int t = 0; t < triangles.rows(); ++t) {
    const auto x = [&](int k) { return Vec3(polygons.points.row(triangles(t, k))); };
    const double area = 0.5 * doubleAreaNormal(x(0), x(1), x(2)).z();
    CHECK(area > 1e-9);
    sum += area;
  }
  return sum;
}

}  // namespace

TEST_CASE("a concave polygon is cut into triangles that all face its way and cover its area") {
  CHECK(checkedArea(polygonOf({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}})) == Approx(7.0));
  CHECK(checkedArea(polygonOf({{0, 0}, {4, 0}, {1, 1}, {0, 4}})) == Approx(4.0));
  CHECK(checkedArea(polygonOf({{1, 1}, {0, 4}, {0, 0}, {4, 0}})) == Approx(4.0));
}

TEST_CASE("corners in a line are no error, wherever the polygon begins") {
  CHECK(checkedArea(polygonOf({{0, 0}, {1, 0}, {2, 0}, {0, 2}})) == Approx(2.0));
  CHECK(checkedArea(polygonOf({{1, 0}, {2, 0}, {0, 2}, {0, 0}})) == Approx(2.0));
  CHECK(checkedArea(polygonOf({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {0, 2}, {0, 1}})) == Approx(6.0));
}

TEST_CASE("a polygon around a hole, joined to it by an edge there and back, keeps the hole") {
  Polygons ring = polygonOf({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 3}, {3, 3}, {3, 1}});
  ring.corners = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
  ring.ends = {10};
  CHECK(checkedArea(ring) == Approx(12.0));
}

TEST_CASE("a quadrilateral is cut from its first corner where that is fair, and a triangle is what it is") {
  const Polygons square = polygonOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(cutPolygons(square, "a") == (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished());
  CHECK(cutPolygons(polygonOf({{0, 0}, {1, 0}, {1, 1}}), "a") == (Triangles(1, 3) << 0, 1, 2).finished());
}

TEST_CASE("a polygon of a thousand corners is cut") {
  std::vector<std::pair<double, double>> star;
  for (int i = 0; i < 1000; ++i) {
    const double radius = i % 2 == 0 ? 1.0 : 0.5, angle = 2.0 * M_PI * i / 1000;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  CHECK(checkedArea(polygonOf(star)) == Approx(1000 * 0.5 * 0.5 * std::sin(2.0 * M_PI / 1000)));
}

TEST_CASE("a polygon that crosses itself or has no area is refused with what to do") {
  CHECK_THROWS_WITH(cutPolygons(polygonOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), "panel.obj"),
                    Contains("panel.obj: polygon 0 of 4 corners") && Contains("triangulate it"));
  CHECK_THROWS_AS(cutPolygons(polygonOf({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}), "a"), InputError);
}
