#include "garment/mesh_quality.h"

#include <catch2/catch.hpp>

#include "tests/garment/tools.h"

using namespace ease;

namespace {

TriangleMesh square(double z) {
  return bodies::meshOf({{0, 0, z}, {0.1, 0, z}, {0.1, 0.1, z}, {0, 0.1, z}}, {{0, 1, 2}, {0, 2, 3}});
}

const TriangleMesh kBody = bodies::box({-1, -1, -1}, {1, 1, 0});

}  // namespace

TEST_CASE("angles, edges and distances of a square above a box") {
  const TriangleTree body(kBody.positions, kBody.triangles);
  const MeshQuality quality = meshQuality(square(0.02), body, std::vector<double>(4, 0.02));
  CHECK(quality.vertices == 4);
  CHECK(quality.triangles == 2);
  CHECK(quality.smallest_angle_deg == Approx(45.0));
  CHECK(quality.largest_angle_deg == Approx(90.0));
  CHECK(quality.share_from_20_deg == 1.0);
  CHECK(quality.shortest_edge_m == Approx(0.1));
  CHECK(quality.longest_edge_m == Approx(0.1 * std::sqrt(2.0)));
  CHECK(quality.mean_edge_m == Approx((0.4 + 0.1 * std::sqrt(2.0)) / 5.0));
  CHECK(quality.self_intersections == 0);
  CHECK(quality.vertex_distance_m == Approx(0.02));
  CHECK(quality.midpoint_distance_m == Approx(0.02));
  CHECK(quality.centroid_distance_m == Approx(0.02));
  CHECK(quality.too_near == 0);
}

TEST_CASE("every vertex, midpoint and centroid nearer than its offset is counted") {
  const TriangleTree body(kBody.positions, kBody.triangles);
  CHECK(meshQuality(square(0.019), body, std::vector<double>(4, 0.02)).too_near == 4 + 5 + 2);
}

TEST_CASE("flaws are told with their figures, and none of a sound mesh") {
  const TriangleTree body(kBody.positions, kBody.triangles);
  MeshQuality quality = meshQuality(square(0.02), body, std::vector<double>(4, 0.02));
  CHECK(flawsOf(quality).empty());
  quality.smallest_angle_deg = 3.21;
  quality.too_near = 7;
  quality.centroid_distance_m = 0.004;
  CHECK(flawsOf(quality) ==
        std::vector<std::string>{"its smallest angle has 3.2 degrees",
                                 "7 of its vertices, edge midpoints and centroids are nearer to the body than comfort "
                                 "asks for, the nearest 4.00 mm away"});
}

TEST_CASE("two triangles that cross are counted") {
  const TriangleTree body(kBody.positions, kBody.triangles);
  const TriangleMesh upright =
      bodies::meshOf({{0.05, 0.02, 0.01}, {0.09, 0.02, 0.01}, {0.07, 0.02, 0.06}}, {{0, 1, 2}});
  const MeshQuality quality = meshQuality(joined(square(0.03), upright), body, std::vector<double>(7, 0.001));
  CHECK(quality.self_intersections == 1);
  CHECK(flawsOf(quality) == std::vector<std::string>{"1 pair of its triangles crosses each other"});
}
