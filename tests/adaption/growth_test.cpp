#include "adaption/growth.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("the smallest growth above two others holds both, and only just") {
  const Eigen::Vector2d diagonal = Eigen::Vector2d(1.0, 1.0).normalized();
  const Mat2 a = growthTensor(1.3, 1.0, Eigen::Vector2d::UnitX()), b = growthTensor(1.2, 1.1, diagonal);
  const Mat2 both = smallestAboveBoth(a, b);
  CHECK((both - smallestAboveBoth(b, a)).norm() < 1e-12);
  CHECK((both - both.transpose()).norm() < 1e-12);
  double nearest_a = 1.0, nearest_b = 1.0;
  for (int k = 0; k < 360; ++k) {
    const Eigen::Vector2d direction(std::cos(k * M_PI / 360.0), std::sin(k * M_PI / 360.0));
    nearest_a = std::min(nearest_a, (both * direction).norm() / (a * direction).norm() - 1.0);
    nearest_b = std::min(nearest_b, (both * direction).norm() / (b * direction).norm() - 1.0);
  }
  CHECK(nearest_a > -1e-12);
  CHECK(nearest_b > -1e-12);
  CHECK(nearest_a < 1e-4);  // it touches each of them
  CHECK(nearest_b < 1e-4);
}
