#include "solver/energy/element.h"

#include <Eigen/Eigenvalues>

namespace ease {

FrameHessian projected(const FrameHessian& hessian) {
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  Mat6 H;
  H << hessian.uu, hessian.uv, hessian.uv.transpose(), hessian.vv;
  const Eigen::SelfAdjointEigenSolver<Mat6> eigen(H);
  H = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
  return {H.topLeftCorner<3, 3>(), H.topRightCorner<3, 3>(), H.bottomRightCorner<3, 3>()};
}

}  // namespace ease
