#include "solver/mesh/segment.h"

#include <Eigen/Core>
#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("the nearest point of a segment lies across from a point, or is the nearer end") {
  const Eigen::Vector2d a(1, 0), b(3, 0);
  CHECK(nearestOnSegment(a, b, Eigen::Vector2d(2.5, 7)) == Eigen::Vector2d(2.5, 0));
  CHECK(nearestOnSegment(a, b, Eigen::Vector2d(-5, 1)) == a);
  CHECK(distanceToSegment(a, b, Eigen::Vector2d(6, 4)) == Approx(5.0));
  const Eigen::Vector3d p(0, 0, 2);
  CHECK(distanceToSegment(p, p, Eigen::Vector3d(0, 2, 2)) == Approx(2.0));  // no length
}
