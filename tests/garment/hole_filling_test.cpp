#include "garment/hole_filling.h"

#include <catch2/catch.hpp>

#include "tests/collision/bodies.h"

using namespace ease;

TEST_CASE("a hole is found with place and width, and closed without a new vertex so that all triangles face outwards") {
  TriangleMesh ball = bodies::sphere(0.5, 8);
  const double height = 0.5 * std::sin(0.75 * M_PI / 2.0);  // of the ring of vertices that becomes the edge
  std::vector<int> kept;
  for (int t = 0; t < ball.triangles.rows(); ++t) {
    double top = -1.0;
    for (int k = 0; k < 3; ++k) top = std::max(top, ball.positions(ball.triangles(t, k), 1));
    if (top < height + 1e-9) kept.push_back(t);
  }
  ball.triangles = ball.triangles(kept, Eigen::all).eval();
  const std::vector<Hole> holes = holesOf(ball, buildTopology(ball, "ball"));
  REQUIRE(holes.size() == 1);
  CHECK(holes[0].loop.size() == 32);
  CHECK(holes[0].centre.y() == Approx(height));
  const Triangles patch = patchFor(holes[0], ball.positions, "ball");
  CHECK(patch.rows() == 30);
  Triangles closed(ball.triangles.rows() + patch.rows(), 3);
  closed << ball.triangles, patch;
  CHECK(buildTopology({ball.positions, closed}, "closed").boundary_loops.empty());
}
