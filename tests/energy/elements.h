// All elements of the membrane behind one interface (energy, stress and Hessian as functions of F), so that a test can
// run over all of them.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/energy/isotropic.h"
#include "solver/energy/shear.h"
#include "solver/energy/stretch.h"

namespace ease {

template <class Real>
Deformation<Real> deformationOf(const Mat32& F) {
  return {{Real(F(0, 0)), Real(F(1, 0)), Real(F(2, 0))}, {Real(F(0, 1)), Real(F(1, 1)), Real(F(2, 1))}};
}

struct Element {
  std::string name;
  bool rests = true;  // without stress where warp and weft are orthogonal and as long as at rest
  std::function<double(const Deformation<double>&, Deformation<double>&)> add;
  std::function<Lanes(const Deformation<Lanes>&, Deformation<Lanes>&)> addLanes;
  std::function<FrameHessian(const Mat32&, HessianKind)> hessian;

  double energy(const Mat32& F) const {
    Deformation<double> stress = deformationOf<double>(Mat32::Zero());
    return add(deformationOf<double>(F), stress);
  }
  Mat32 stress(const Mat32& F) const {
    Deformation<double> s = deformationOf<double>(Mat32::Zero());
    add(deformationOf<double>(F), s);
    Mat32 P;
    P << s.u.x, s.v.x, s.u.y, s.v.y, s.u.z, s.v.z;
    return P;
  }
  /// Hessian with respect to (f_u, f_v) as one 6 x 6 matrix.
  Eigen::Matrix<double, 6, 6> whole(const Mat32& F, HessianKind kind) const {
    const FrameHessian h = hessian(F, kind);
    Eigen::Matrix<double, 6, 6> H;
    H << h.uu, h.uv, h.uv.transpose(), h.vv;
    return H;
  }
};

/// A sheared deformation gradient; `scale` makes it stretched, about as long as at rest, or compressed.
inline Mat32 someGradient(double scale) {
  Mat32 F;
  F << 0.9, 0.5, 0.1, 0.8, -0.4, 0.3;
  return scale * F;
}

inline std::vector<Element> elements() {
  const Spring damped_stretch = damped({800.0, 1.0}, 300.0, 1.2), shear{200.0, 0.0};
  const Spring damped_shear = damped(shear, 100.0, 0.9);
  std::vector<Element> all;
  const auto addStretches = [&all](const std::string& name, const Spring& stretch, double softening = 0.0) {
    all.push_back({name, stretch.c == 1.0,
                   [=](const auto& F, auto& P) { return addStretch(F.u, stretch.k, stretch.c, P.u, softening); },
                   [=](const auto& F, auto& P) {
                     return addStretch(F.u, stretch.k, Lanes(Lanes::Constant(stretch.c)), P.u, softening);
                   },
                   [=](const Mat32& F, HessianKind kind) {
                     FrameHessian h;
                     h.uu = stretchHessian(F.col(0), stretch, kind, softening);
                     return h;
                   }});
  };
  addStretches("stretch", {800.0, 1.0});
  for (const Spring& spring : {shear, damped_shear}) {
    const std::string damping = spring.c == 0.0 ? "" : "damped ";
    all.push_back(
        {damping + "orthogonal shear", spring.c == 0.0,
         [=](const auto& F, auto& P) { return addOrthogonalShear(F, spring.k, spring.c, P); },
         [=](const auto& F, auto& P) { return addOrthogonalShear(F, spring.k, Lanes(Lanes::Constant(spring.c)), P); },
         [=](const Mat32& F, HessianKind kind) { return orthogonalShearHessian(F, spring, kind); }});
    all.push_back(
        {damping + "bw98 shear", spring.c == 0.0,
         [=](const auto& F, auto& P) { return addBw98Shear(F, spring.k, spring.c, P); },
         [=](const auto& F, auto& P) { return addBw98Shear(F, spring.k, Lanes(Lanes::Constant(spring.c)), P); },
         [=](const Mat32& F, HessianKind kind) { return bw98ShearHessian(F, spring, kind); }});
  }
  addStretches("damped stretch", damped_stretch);
  addStretches("damped soft stretch", damped_stretch, 700.0);
  for (const double lambda : {0.0, 300.0})
    all.push_back({lambda > 0.0 ? "isotropic" : "isotropic, lambda 0", true,
                   [=](const auto& F, auto& P) { return addIsotropic(F, 400.0, lambda, P); },
                   [=](const auto& F, auto& P) { return addIsotropic(F, 400.0, lambda, P); },
                   [=](const Mat32& F, HessianKind kind) { return isotropicHessian(F, 400.0, lambda, kind); }});
  return all;
}

inline Element elementNamed(const std::string& name) {
  for (const Element& element : elements())
    if (element.name == name) return element;
  throw std::out_of_range(name);
}

}  // namespace ease
