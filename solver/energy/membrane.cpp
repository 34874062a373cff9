#include "solver/energy/membrane.h"

#include <cmath>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kGrain = 512;

}  // namespace

void MembraneEnergy::begin(const Positions& start, double h) {
  const Material& material = cloth_.material();
  damping_stretch_ = material.damping_stretch / h;
  damping_shear_ = material.damping_shear / h;
  if (damping_stretch_ > 0.0 || damping_shear_ > 0.0) {
    start_conditions_.resize(cloth_.triangleCount());
    parallelFor(cloth_.triangleCount(), kGrain, [&](int t) {
      const Mat32 F = cloth_.deformation(start, t);
      start_conditions_[t] = {F.col(0).norm(), F.col(1).norm(), shearCondition(F)};
    });
  }
  const Springs s = springs(0);
  stiffness_ = {s.warp.k, s.weft.k, s.shear.k};
  if (material.membrane == Membrane::woven)
    softening_ = {(1.0 - material.compression) * material.stretch_warp,
                  (1.0 - material.compression) * material.stretch_weft};
  has_springs_ = s.warp.k > 0.0 || s.weft.k > 0.0 || s.shear.k > 0.0;
}

double MembraneEnergy::shearCondition(const Mat32& F) const {
  return cloth_.material().shear_form == ShearForm::bw98 ? bw98Shear(F) : orthogonalShear(F);
}

MembraneEnergy::Springs MembraneEnergy::springs(int t) const {
  const Material& material = cloth_.material();
  Springs s{{0.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}};
  if (material.membrane == Membrane::woven)
    s = {{material.stretch_warp, 1.0}, {material.stretch_weft, 1.0}, {material.shear, 0.0}};
  if (start_conditions_.empty()) return s;
  const Eigen::Vector3d& start = start_conditions_[t];
  s.warp = damped(s.warp, damping_stretch_, start[0]);
  s.weft = damped(s.weft, damping_stretch_, start[1]);
  s.shear = damped(s.shear, damping_shear_, start[2]);
  return s;
}

void MembraneEnergy::setRestConditions(int t, int lane, RestConditions& rest) const {
  const Springs s = springs(t);
  rest.warp[lane] = s.warp.c;
  rest.weft[lane] = s.weft.c;
  rest.shear[lane] = s.shear.c;
}

FrameHessian MembraneEnergy::hessian(const Mat32& F, int t, HessianKind kind) const {
  const Material& material = cloth_.material();
  const Springs s = springs(t);
  FrameHessian h;
  if (material.membrane == Membrane::isotropic) h += isotropicHessian(F, material.mu, material.lambda, kind);
  if (s.shear.k > 0.0)
    h += material.shear_form == ShearForm::bw98 ? bw98ShearHessian(F, s.shear, kind)
                                                : orthogonalShearHessian(F, s.shear, kind);
  h.uu += stretchHessian(F.col(0), s.warp, kind, softening_.warp);
  h.vv += stretchHessian(F.col(1), s.weft, kind, softening_.weft);
  return h;
}

Eigen::Vector2d MembraneEnergy::projectiveWeights() const {
  const Material& material = cloth_.material();
  const double isotropic = material.membrane == Membrane::isotropic ? 2.0 * (material.mu + material.lambda) : 0.0;
  return Eigen::Vector2d(stiffness_.warp, stiffness_.weft).array() + 2.0 * stiffness_.shear + isotropic;
}

Eigen::Vector2d MembraneEnergy::projectiveWeightsAt(const Mat32& F) const {
  Eigen::Vector2d weights = projectiveWeights();
  const auto soften = [](double stiffness, double softening, const Vec3& thread, double& weight) {
    if (softening > 0.0 && thread.norm() < 1.0) weight -= stiffness - std::sqrt(stiffness * (stiffness - softening));
  };
  soften(stiffness_.warp, softening_.warp, F.col(0), weights[0]);
  soften(stiffness_.weft, softening_.weft, F.col(1), weights[1]);
  return weights;
}

}  // namespace ease
