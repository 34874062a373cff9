// Incremental potential of one backward Euler step: its minimiser is the cloth's next position.
//
//   E(x) = 1/(2h^2) |x - y|^2_M + sum_t a_t psi(F_t) + sum_hinges bending + sum_samples a_s psi_c(depth),   J
//   y    = x_n + h v_n + h^2 g
//
//   h    time step, s        g    gravity, m/s^2
//   a_t  rest area of a triangle;  a_s  area that a contact sample stands for, m^2
//
// Damping is part of it (stretch.h).  Every minimiser sees the potential through this class alone.
#pragma once

#include <span>
#include <vector>

#include "solver/energy/bending.h"
#include "solver/energy/contact.h"
#include "solver/energy/shear.h"
#include "solver/linear/block_matrix.h"
#include "solver/linear/incidence.h"
#include "solver/model/cloth.h"
#include "solver/model/contact.h"
#include "solver/step/state.h"

namespace ease {

struct StepOptions {
  double h = 0.0025;                 // s
  Vec3 gravity = {0.0, -9.81, 0.0};  // m/s^2
  double contact_stiffness = 3e6;    // N/m^3
};

class IncrementalPotential {
 public:
  explicit IncrementalPotential(const Cloth& cloth);

  /// Fixes what a step starts from: y, and the conditions whose rate is damped.  Forgets contacts.
  void begin(const State& start, const StepOptions& options);

  /// A plane for each sample (contact.h); empty: no contact.  Referred to, not copied.
  void setContacts(std::span<const ContactPlane> planes) { contacts_ = planes; }

  /// E, J, up to a constant of the step.
  double value(const Positions& x) const;

  /// dE/dx, n x 3, N.
  void gradient(const Positions& x, Positions& gradient);

  /// Second derivative without the negative parts of its elements, N/m; bending apart, since it reaches to the second
  /// ring: see multiplyBending.
  void hessian(const Positions& x, BlockMatrix& hessian);

  /// Prepares the bending part of the Hessian at x, then adds it times `d` to `product`.  Nothing without hinges.
  void prepareBending(const Positions& x);
  void addBending(const Positions& d, Positions& product);
  bool bends() const { return !cloth_.hinges().empty(); }

  /// Contact force on each vertex over its area, Pa, at x: from its own sample and its share of those around.
  void contactPressure(const Positions& x, std::vector<double>& pressure);

 private:
  struct TriangleSprings {
    Spring warp, weft, shear;
  };
  TriangleSprings springs(int t) const;
  HingeSpring hingeSpring(int e) const;
  double contactArea(int sample) const;
  ContactSpring contactSpring(int sample) const { return {options_.contact_stiffness, contacts_[sample].give}; }
  Vec3 contactPoint(const Positions& x, int sample) const;
  void contactForces(const Positions& x);
  Vec3 gatherContact(int vertex) const;

  const Cloth& cloth_;
  StepOptions options_;
  Positions inertial_;                             // y
  std::vector<Eigen::Vector3d> start_conditions_;  // |f_u|, |f_v|, shear at the start, where damped
  std::vector<double> start_bending_;              // |b| at the start, where damped
  std::span<const ContactPlane> contacts_;

  Incidence triangle_corners_, edge_ends_, hinge_corners_;
  // Per element, between the loop over elements and the gathering loop over vertices.
  std::vector<Mat32> stress_;              // a_t dpsi/dF, N m
  std::vector<Vec3> contact_force_;        // -a_s p n, N: its negative pushes the cloth out
  std::vector<double> contact_stiffness_;  // a_s dp/d depth, N/m
  std::vector<FrameHessian> frame_hessian_;
  std::vector<Mat3> hinge_hessian_;
  std::vector<Vec3> hinge_force_;
};

}  // namespace ease
