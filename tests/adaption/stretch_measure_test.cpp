#include "adaption/stretch_measure.h"

#include <Eigen/SVD>
#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

TEST_CASE("principal stretches are the singular values, and their direction the right singular vector") {
  const Positions random = randomPositions(40, 3);
  for (int i = 0; i < 40; i += 2) {
    const Mat32 F = random.middleRows<2>(i).transpose();
    const Stretch s = principalStretch(F.transpose() * F);
    const Eigen::JacobiSVD<Mat32> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    CHECK(s.sigma_1 == Approx(svd.singularValues()[0]).epsilon(1e-12));
    CHECK(s.sigma_2 == Approx(svd.singularValues()[1]).margin(1e-7));
    CHECK(std::abs(s.direction.dot(svd.matrixV().col(0))) == Approx(1.0).epsilon(1e-9));
    CHECK(s.warp == Approx(F.col(0).norm()));
    CHECK(s.weft == Approx(F.col(1).norm()));
  }
}

TEST_CASE("a rigid motion stretches nothing") {
  const TriangleMesh mesh = makeSheet(6, 5, 0.3, 0.2, 0.3);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  const Mat3 R = Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  std::vector<Stretch> stretch;
  measureStretch(cloth, mesh.positions * R.transpose(), stretch);
  for (const Stretch& s : stretch) {
    CHECK(s.sigma_1 == Approx(1.0).epsilon(1e-7));
    CHECK(s.sigma_2 == Approx(1.0).epsilon(1e-7));
  }
}

TEST_CASE("the share over the limit, the largest and the 99th percentile are counted right") {
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) values.push_back(1.0 + 0.001 * i);
  const StretchStatistics s = stretchStatistics(values, 0.15);
  CHECK(s.max == Approx(1.199));
  CHECK(s.p99 == Approx(1.197));
  CHECK(s.share_over_limit == Approx(49.0 / 200.0));
  CHECK(stretchStatistics({}, 0.1).max == 0.0);
}

TEST_CASE("sheared, compressed cloth with slack threads is crumpled, cloth with a stretched thread is taut") {
  const double shear = 0.25;  // of FᵀF, threads unstretched: sigma_1² = 1 + shear
  const Stretch crumpled = principalStretch((Mat2() << 1.0, shear, shear, 1.0).finished());
  REQUIRE(crumpled.sigma_1 > 1.1);
  CHECK(isCrumpled(crumpled, 0.1));
  CHECK_FALSE(isCrumpled(principalStretch((Mat2() << 1.3, 0.0, 0.0, 0.8).finished()), 0.1));
  CHECK_FALSE(isCrumpled(principalStretch((Mat2() << 1.0, 0.1, 0.1, 1.0).finished()), 0.1));  // within the limit
  const StretchStatistics both = momentStatistics({crumpled, principalStretch(1.5 * Mat2::Identity())}, 0.1);
  CHECK(both.share_over_limit == 1.0);
  CHECK(both.taut_share_over_limit == 0.5);
}
