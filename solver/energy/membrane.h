// The membrane of a cloth: energy, stress, Hessian and projective weight of its triangles, by the cloth's material.
//
//   psi(F)   energy per rest area, N/m       F   deformation gradient, 3x2
//
// A material's membrane is a sum of elements (stretch.h, shear.h, isotropic.h).  They are put together here and nowhere
// else: who uses MembraneEnergy does not know which elements there are.  A new element has a file of its own with these
// three functions, and a line in each function below.
//
// The membrane of triangle t counts with weight s_t a_t: its rest area times its stiffness scale (cloth.h).
#pragma once

#include <vector>

#include "solver/energy/isotropic.h"
#include "solver/energy/shear.h"
#include "solver/energy/stretch.h"
#include "solver/model/cloth.h"

namespace ease {

/// Values of the conditions at rest of eight triangles (stretch.h, shear.h), damping included.
struct RestConditions {
  Lanes warp, weft, shear;
};

class MembraneEnergy {
 public:
  explicit MembraneEnergy(const Cloth& cloth) : cloth_(cloth) {}

  /// Takes the conditions whose rate is damped from the start of a time step of length h, s.
  void begin(const Positions& start, double h);

  /// Sets lane `lane` to triangle t.
  void setRestConditions(int t, int lane, RestConditions& rest) const;

  /// psi of eight triangles, N/m; adds d psi / d F, N/m, to `stress`.
  Lanes add(const Deformation<Lanes>& F, const RestConditions& rest, Deformation<Lanes>& stress) const {
    const Material& material = cloth_.material();
    Lanes psi = Lanes::Zero();
    if (has_springs_) {
      psi += addStretch(F.u, stiffness_.warp, rest.warp, stress.u);
      psi += addStretch(F.v, stiffness_.weft, rest.weft, stress.v);
      psi += material.shear_form == ShearForm::bw98 ? addBw98Shear(F, stiffness_.shear, rest.shear, stress)
                                                    : addOrthogonalShear(F, stiffness_.shear, rest.shear, stress);
    }
    if (material.membrane == Membrane::isotropic) psi += addIsotropic(F, material.mu, material.lambda, stress);
    return psi;
  }

  /// Second derivative of psi by F in triangle t, N/m.
  FrameHessian hessian(const Mat32& F, int t, HessianKind kind) const;

  /// Weights of the constant matrix that projective dynamics has in place of the Hessian, along warp and weft, N/m:
  /// exact for elements that are a squared distance to a set, a bound near the rest shape for the others.
  Eigen::Vector2d projectiveWeights() const;

 private:
  /// Stiffness of the springs with their damping, N/m: the same in all triangles.
  struct Stiffness {
    double warp = 0.0, weft = 0.0, shear = 0.0;
  };
  struct Springs {
    Spring warp, weft, shear;
  };
  Springs springs(int t) const;
  double shearCondition(const Mat32& F) const;

  const Cloth& cloth_;
  Stiffness stiffness_;
  bool has_springs_ = false;
  double damping_stretch_ = 0.0, damping_shear_ = 0.0;  // over h, N/m
  std::vector<Eigen::Vector3d> start_conditions_;  // |f_u|, |f_v|, shear of each triangle; empty: nothing is damped
};

}  // namespace ease
