#include "solver/energy/isotropic.h"

#include <Eigen/SVD>
#include <catch2/catch.hpp>

#include "tests/energy/elements.h"

using namespace ease;

TEST_CASE("the isotropic membrane has the modulus and Poisson ratio of its constants") {
  // The cloth is pulled along u and free along v. The stress along v must vanish at a strain of -nu times that along u.
  const double mu = 400.0, lambda = 300.0, strain = 1e-6;
  const Element element = elementNamed("isotropic");
  const double nu = lambda / (2.0 * mu + lambda), modulus = 4.0 * mu * (mu + lambda) / (2.0 * mu + lambda);
  Mat32 F = Mat32::Zero();
  F(0, 0) = 1.0 + strain;
  F(1, 1) = 1.0 - nu * strain;
  const Mat32 stress = element.stress(F);
  CHECK(std::abs(stress(1, 1)) < 1e-9);
  CHECK(stress(0, 0) == Approx(modulus * strain).epsilon(1e-6));
}

TEST_CASE("the isotropic membrane's energy and stress are those of the singular values") {
  const double mu = 400.0, lambda = 300.0;
  const Element element = elementNamed("isotropic");
  for (const double scale : {0.4, 1.0, 1.6}) {
    const Mat32 F = someGradient(scale);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(F, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Mat32 R = svd.matrixU() * svd.matrixV().transpose();
    const double excess = svd.singularValues().sum() - 2.0;
    CHECK(element.energy(F) == Approx(mu * (F - R).squaredNorm() + 0.5 * lambda * excess * excess).epsilon(1e-12));
    const Mat32 stress = 2.0 * mu * (F - R) + lambda * excess * R;
    CHECK((element.stress(F) - stress).norm() < 1e-12 * mu);
  }
}

TEST_CASE("the isotropic membrane is the same in every direction of the cloth") {
  const Mat2 turn = Eigen::Rotation2Dd(0.6).toRotationMatrix();
  const Element element = elementNamed("isotropic");
  const Mat32 F = someGradient(1.0);
  CHECK(element.energy(F * turn) == Approx(element.energy(F)).epsilon(1e-12));
  CHECK((element.stress(F * turn) - element.stress(F) * turn).norm() < 1e-10);
}
