#include "solver/energy/isotropic.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace ease {

FrameHessian isotropicHessian(const Mat32& F, double mu, double lambda, HessianKind kind) {
  Eigen::SelfAdjointEigenSolver<Mat2> eigen;
  eigen.computeDirect(F.transpose() * F);
  const double least = 1e-12;
  const double s1 = std::sqrt(std::max(least, eigen.eigenvalues()[1]));
  const double s2 = std::sqrt(std::max(least, eigen.eigenvalues()[0]));
  const Eigen::RowVector2d v1 = eigen.eigenvectors().col(1).transpose(), v2 = eigen.eigenvectors().col(0).transpose();
  const Vec3 along = F * v1.transpose();
  const Vec3 u1 = along.norm() > 1e-9 ? Vec3(along.normalized()) : Vec3::UnitX();
  Vec3 u2 = F * v2.transpose();
  u2 -= u1.dot(u2) * u1;
  u2 = u2.norm() > 1e-9 ? u2.normalized() : u1.unitOrthogonal();
  const Vec3 n = u1.cross(u2);

  const double p1 = 2.0 * mu * (s1 - 1.0) + lambda * (s1 + s2 - 2.0);
  const double p2 = 2.0 * mu * (s2 - 1.0) + lambda * (s1 + s2 - 2.0);
  FrameHessian hessian;
  const auto add = [&](double eigenvalue, const Mat32& mode) {
    hessian.addMode(keptEigenvalue(eigenvalue, kind), mode);
  };
  add((p1 + p2) / (s1 + s2), (u2 * v1 - u1 * v2) * M_SQRT1_2);  // rotation in the plane
  add(2.0 * mu, (u2 * v1 + u1 * v2) * M_SQRT1_2);               // shear; 2 mu = (p1 - p2)/(s1 - s2)
  add(p1 / s1, n * v1);                                         // rotation out of the plane, two modes
  add(p2 / s2, n * v2);
  add(2.0 * (mu + lambda), (u1 * v1 + u2 * v2) * M_SQRT1_2);  // growth in both directions
  add(2.0 * mu, (u1 * v1 - u2 * v2) * M_SQRT1_2);             // growth along u1, shrinking along u2
  return hessian;
}

}  // namespace ease
