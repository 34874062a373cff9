// Incremental potential of one backward Euler step. The positions that minimise it are the cloth's next positions.
//
//   E(x) = 1/(2h^2) |x - y|^2_M + sum_t a_t psi(F_t) + 1/2 xᵀ Q x            J
//          + sum_samples [a_s psi_c(depth) + D(u_s)] + damping
//   y    = x_n + h v_n + h^2 g
//
//   x_n, v_n  positions, m, and velocities, m/s, at the start of the step
//   h         time step, s
//   g         gravity, m/s^2
//   M         diagonal matrix of the vertex masses, kg;  |d|^2_M = dᵀ M d
//   a_t       weight of a triangle: stiffness scale times rest area, m^2 (cloth.h)
//   a_s       area that a contact sample stands for, m^2
//   psi       energy of the membrane (membrane.h);  psi_c  energy of contact (energy/contact.h)
//   D         potential of friction; u_s  slip of a sample over the step, m (energy/friction.h)
//   Q         bending matrix (bending_matrix.h)
//
// This class is all that a minimiser knows of the potential. Newton's method uses its Hessian; the projective methods
// use the weights of a constant matrix that bounds the Hessian.
//
// Triangles are computed eight side by side (element.h), from arrays that are laid out once per step.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/energy/contact.h"
#include "solver/energy/membrane.h"
#include "solver/linear/block_matrix.h"
#include "solver/linear/incidence.h"
#include "solver/model/cloth.h"
#include "solver/step/bending_matrix.h"
#include "solver/step/contact_lanes.h"
#include "solver/step/hinge_forces.h"
#include "solver/step/state.h"

namespace ease {

struct StepOptions {
  double h = 0.0025;                 // s
  Vec3 gravity = {0.0, -9.81, 0.0};  // m/s^2
  double contact_stiffness = 3e6;    // N/m^3
  double friction = 0.0;             // coefficient of friction between cloth and body
};

/// Speed below which cloth that touches the body counts as sticking to it, m/s (energy/friction.h). Ten times as much
/// saves a quarter of the iterations of pd-lbfgs on a T-shirt in motion, but held cloth creeps ten times as fast.
constexpr double kSlipSpeed = 1e-3;

/// Twice the kinetic energy of a motion that takes one step, |motion|^2_M / h^2, J.
struct StepMotion {
  double whole = 0.0;   // from x_n to x
  double forced = 0.0;  // part due to forces, from x_n + h v_n to x
};

class IncrementalPotential {
 public:
  explicit IncrementalPotential(const Cloth& cloth);

  /// Starts a step: computes y and the values at the start that damping needs, and removes all contacts.
  void begin(const State& start, const StepOptions& options);

  /// Replaces the contact planes. `normal_forces`: lambda of friction, N, in the order of State::normal_forces;
  /// constant during the minimisation. Empty: no friction.
  void setContacts(const Contacts& contacts, std::span<const double> normal_forces = {});
  /// Whether the cloth may touch something in this step.
  bool mayTouch() const { return !contacts_.empty(); }

  /// Computes the gradient dE/dx, n x 3, N, and, if asked for, the `motion` to x. Returns E, J, up to a constant that
  /// depends on the step alone.
  double gradient(const Positions& x, Positions& gradient, StepMotion* motion = nullptr);

  /// Assembles the Hessian without bending, N/m. `kind` says whether elements are projected to be positive
  /// semi-definite. Also computes the Hessian of bending damping at x, for addBendingProduct().
  void hessian(const Positions& x, HessianKind kind, BlockMatrix& hessian);
  /// Adds the product of the bending Hessian with d, N, to `product`. It is separate from hessian() because bending
  /// couples second neighbours, for which a BlockMatrix has no blocks. Call hessian() first.
  void addBendingProduct(const Positions& d, Positions& product);

  /// Weights of projective dynamics for the membrane, along warp and weft, N/m (membrane.h).
  Eigen::Vector2d projectiveWeights() const { return membrane_.projectiveWeights(); }
  /// Weights of triangle t at x, nearer to its Hessian and no upper bound (membrane.h).
  Eigen::Vector2d projectiveWeightsAt(const Positions& x, int t) const {
    return membrane_.projectiveWeightsAt(cloth_.deformation(x, t));
  }

  /// Lumped contact stiffness per vertex at x, N/m: row sums of the contact Hessian, as if contact were equally stiff
  /// in all directions, and of the bound of friction's Hessian without slip (energy/friction.h), where it is largest.
  /// With `bound`, an upper bound over the whole step: every contact counts as pressed to the depth at which it
  /// stiffens (`give`), or to its present depth if that is larger.
  void contactDiagonal(const Positions& x, bool bound, std::vector<double>& diagonal);

  /// Contact pressure per vertex, Pa: the contact force on the vertex over a third of the area of its triangles at x.
  /// The force comes from the vertex's own sample and from its share of the samples on its edges and triangles.
  void contactPressure(const Positions& x, std::vector<double>& pressure);

  /// Normal force of each contact plane on its sample at x, N, in the order of State::normal_forces.
  void normalForces(const Positions& x, std::vector<double>& forces) const;

  /// Twice the kinetic energy of a displacement d that takes one step, |d|^2_M / h^2, J.
  double kinetic(const Positions& d) const;
  double totalMass() const { return total_mass_; }  // kg

  /// Energy differences below this are round-off, J; `energy` and `motion` are those of a nearby point.
  double roundOff(double energy, const StepMotion& motion) const;

  /// Diagonal entry of a diagonal matrix that bounds the bending matrix from above, N/m.
  double bendingBound(int vertex) const { return bending_.rowBound(vertex); }

  const Cloth& cloth() const { return cloth_; }
  const StepOptions& options() const { return options_; }

 private:
  /// Constants of eight triangles side by side.
  struct TriangleLanes {
    int corners[3][kLanes];
    Lanes inverse[4];  // inverse of the rest edges, D^-1, row by row, 1/m
    Lanes weight;      // a_t, m^2; 0 in lanes beyond the last triangle
    RestConditions rest;

    TriangleEdges edgesAt(const Positions& x) const;
  };
  /// Sums over a group of vertices.
  struct VertexSums {
    double energy;  // J
    StepMotion motion;
  };

  void layOutTriangles();
  double triangleForces(const Positions& x);
  double blockForces(int block, std::span<const ContactLanes> contacts, std::span<const FrictionLanes> frictions,
                     const Positions& x);
  /// Calls add(contact, lane, depth) for each sample of a group that is pressed at x, one after the other; depth in m.
  /// With `bound`, for every sample that has a plane, at a depth of at least its `give`.  All contacts of a sample, and
  /// all those on a triangle, are in one group.
  template <class Add>
  void forPressed(int group, const Positions& x, bool bound, const Add& add) const {
    int block = -1;
    TriangleEdges hosts;
    for (const ContactLanes& contact : contacts_.group(group)) {
      if (contact.block != block) hosts = lanes_[contact.block].edgesAt(x);
      block = contact.block;
      Lanes depth = contact.depth(hosts);
      if (bound) depth = depth.max(contact.give);
      for (int l = 0; l < kLanes; ++l)
        if (contact.sample[l] >= 0 && depth[l] != 0.0) add(contact, l, depth[l]);
    }
  }
  /// Calls add(contact, lane, limit, slip) for each sample of a group on which friction acts, one after the other;
  /// limit, the largest force, in N, slip at x in m.
  template <class Add>
  void forFriction(int group, const Positions& x, const Add& add) const {
    for (size_t k = 0; k < contacts_.friction(group).size(); ++k) {
      const FrictionLanes& friction = contacts_.friction(group)[k];
      const ContactLanes& contact = contacts_.group(group)[k];
      if (!friction.any) continue;
      const Column<Lanes> u = friction.slip(contact, lanes_[contact.block].edgesAt(x));
      for (int l = 0; l < kLanes; ++l)
        if (friction.limit[l] > 0.0) add(contact, l, friction.limit[l], Vec3(u.x[l], u.y[l], u.z[l]));
    }
  }
  double slipLength() const { return kSlipSpeed * options_.h; }
  /// Barycentric weights of a sample at the corners of its host triangle.
  static std::array<double, 3> weightsOf(const ContactLanes& contact, int lane) {
    const double w1 = contact.weight[0][lane], w2 = contact.weight[1][lane];
    return {1.0 - w1 - w2, w1, w2};
  }
  /// Computes contact_hessian_ and pressed_ of all samples at x.
  void contactHessians(const Positions& x, HessianKind kind);
  /// Stiffness of a sample at this depth, N/m.
  double stiffness(const ContactLanes& contact, int lane, double depth) const {
    return contact.area[lane] * contactStiffness(depth, options_.contact_stiffness, contact.give[lane]);
  }

  const Cloth& cloth_;
  MembraneEnergy membrane_;
  int rest_revision_ = -1;  // revision of the cloth's rest shape for which the bending matrix was computed
  StepOptions options_;
  Positions start_;     // x_n
  Positions inertial_;  // y
  ContactLayout contacts_;
  HingeForces hinges_;

  BendingMatrix bending_;
  Incidence triangle_corners_, edge_ends_;
  // Results per element: written by a loop over elements, then gathered by a loop over vertices.
  std::vector<TriangleLanes> lanes_;
  std::vector<Vec3> corner_force_;        // dE/dx at corner a of triangle t, N: corner_force_[3 t + a]
  std::vector<double> corner_stiffness_;  // of contact at corner a of triangle t, N/m: corner_stiffness_[3 t + a]
  std::vector<Mat3> contact_hessian_;     // a_s dp/d(depth) n nᵀ of each sample, and its friction's Hessian, N/m
  std::vector<char> pressed_;             // whether contact_hessian_ of the sample is set; otherwise it counts as zero
  std::vector<FrameHessian> frame_hessian_;
  std::vector<Mat3> hinge_hessian_;
  double total_mass_ = 0.0;              // kg
  double bending_round_off_ = 0.0;       // J
  std::vector<double> partial_;          // energies of groups, added up in a fixed order
  std::vector<VertexSums> vertex_sums_;  // sums of groups of vertices, added up in a fixed order
};

}  // namespace ease
