// Membrane of a cloth: energy, stress, Hessian and projective weights of its triangles for the cloth's material.
//
//   psi(F)   energy per rest area, N/m       F   deformation gradient, 3x2
//
// The energy is a sum of elements (stretch.h, shear.h, isotropic.h) that the material chooses. In the solver, only
// MembraneEnergy knows which elements exist. A new element gets a file of its own and one line in each of the functions
// add, hessian and projectiveWeights.
//
// IncrementalPotential multiplies psi of triangle t by the weight s_t a_t: stiffness scale times rest area (cloth.h).
#pragma once

#include <vector>

#include "solver/energy/isotropic.h"
#include "solver/energy/shear.h"
#include "solver/energy/stretch.h"
#include "solver/model/cloth.h"

namespace ease {

/// Rest values c of the conditions (stretch.h, shear.h) in eight triangles: 1, 1 and 0 without damping, which shifts
/// them. The isotropic element does not use them.
struct RestConditions {
  Lanes warp, weft, shear;
};

class MembraneEnergy {
 public:
  explicit MembraneEnergy(const Cloth& cloth) : cloth_(cloth) {}

  /// Starts a time step of length h, s: with damping, stores the conditions at the positions `start`.
  void begin(const Positions& start, double h);
  /// Whether rest conditions depend on the start of the step.
  bool damps() const { return !start_conditions_.empty(); }

  /// Writes the rest conditions of triangle t into lane `lane` of `rest`.
  void setRestConditions(int t, int lane, RestConditions& rest) const;

  /// Returns psi of eight triangles, N/m, and adds d psi / d F, N/m, to `stress`.
  Lanes add(const Deformation<Lanes>& F, const RestConditions& rest, Deformation<Lanes>& stress) const {
    const Material& material = cloth_.material();
    Lanes psi = Lanes::Zero();
    if (has_springs_) {
      psi += addStretch(F.u, stiffness_.warp, rest.warp, stress.u, softening_.warp);
      psi += addStretch(F.v, stiffness_.weft, rest.weft, stress.v, softening_.weft);
      psi += material.shear_form == ShearForm::bw98 ? addBw98Shear(F, stiffness_.shear, rest.shear, stress)
                                                    : addOrthogonalShear(F, stiffness_.shear, rest.shear, stress);
    }
    if (material.membrane == Membrane::isotropic) psi += addIsotropic(F, material.mu, material.lambda, stress);
    return psi;
  }

  /// Second derivative of psi with respect to F in triangle t, N/m.
  FrameHessian hessian(const Mat32& F, int t, HessianKind kind) const;

  /// Weights w_u, w_v along warp and weft, N/m, of the constant matrix that projective dynamics uses in place of the
  /// Hessian H. At rest they bound it: w_u |df_u|^2 + w_v |df_v|^2 >= dFᵀ H dF for every dF. For elements whose energy
  /// is a squared distance to a set they bound it everywhere. Weights that are too small make `pd` halve its
  /// corrections; weights that are too large make every projective method slow.
  Eigen::Vector2d projectiveWeights() const;
  /// Weights for a triangle with deformation gradient F, nearer to its Hessian and no upper bound: a thread that is
  /// compressed at F counts with the geometric mean of the stiffness that it has and the one that it has once
  /// stretched.
  Eigen::Vector2d projectiveWeightsAt(const Mat32& F) const;

 private:
  /// Stiffness of the springs including damping, N/m. All triangles share it.
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
  struct {
    double warp = 0.0, weft = 0.0;
  } softening_;  // under compression (stretch.h), N/m
  bool has_springs_ = false;
  double damping_stretch_ = 0.0, damping_shear_ = 0.0;  // damping divided by h, N/m
  std::vector<Eigen::Vector3d> start_conditions_;       // |f_u|, |f_v| and shear per triangle; empty without damping
};

}  // namespace ease
