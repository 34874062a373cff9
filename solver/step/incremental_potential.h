// Incremental potential of one backward Euler step: its minimiser is the cloth's next position.
//
//   E(x) = 1/(2h^2) |x - y|^2_M + sum_t a_t psi(F_t) + 1/2 xᵀ Q x + sum_samples a_s psi_c(depth) + damping,   J
//   y    = x_n + h v_n + h^2 g
//
//   h    time step, s        g    gravity, m/s^2        Q    bending (bending_matrix.h)
//   a_t  rest area of a triangle;  a_s  area that a contact sample stands for, m^2
//
// Every minimiser sees the potential through this class alone: so do the Newton methods, which want its Hessian, and
// the projective ones, for which it has the constant matrix that bounds it.
//
// Triangles are computed eight side by side (lanes.h), from a structure of arrays laid out once a step.
#pragma once

#include <span>
#include <vector>

#include "solver/energy/bending.h"
#include "solver/energy/contact.h"
#include "solver/energy/membrane.h"
#include "solver/linear/block_matrix.h"
#include "solver/linear/incidence.h"
#include "solver/model/cloth.h"
#include "solver/step/bending_matrix.h"
#include "solver/step/contact_lanes.h"
#include "solver/step/state.h"

namespace ease {

struct StepOptions {
  double h = 0.0025;                 // s
  Vec3 gravity = {0.0, -9.81, 0.0};  // m/s^2
  double contact_stiffness = 3e6;    // N/m^3
};

/// Twice the kinetic energy of moving within a step, J.
struct StepMotion {
  double all = 0.0;     // from x_n to x
  double forced = 0.0;  // from x_n + h v_n to x: what forces add
};

class IncrementalPotential {
 public:
  explicit IncrementalPotential(const Cloth& cloth);

  /// Fixes what a step starts from: y, and the conditions whose rate is damped.  Forgets contacts.
  void begin(const State& start, const StepOptions& options);

  void setContacts(const Contacts& contacts);
  bool mayTouch() const { return !contacts_.empty(); }

  /// Gradient dE/dx, n x 3, N, and `motion` to x; returns E, J, up to a constant of the step.
  double gradient(const Positions& x, Positions& gradient, StepMotion* motion = nullptr);

  /// Assembles the Hessian without bending, N/m; `kind` says whether elements are projected to be positive
  /// semi-definite.  Bending couples second neighbours, which `hessian` has no blocks for: addBendingProduct() adds its
  /// product with d.  Call hessian() first, which also computes the damping of bending at x.
  void hessian(const Positions& x, HessianKind kind, BlockMatrix& hessian);
  void addBendingProduct(const Positions& d, Positions& product);

  /// Weights of projective dynamics for the membrane, along warp and weft, N/m (membrane.h).
  Eigen::Vector2d projectiveWeights() const { return membrane_.projectiveWeights(); }

  /// Lumped contact stiffness per vertex at x, N/m: row sums of its Hessian.  With `bound`, an upper bound over the
  /// whole step: every contact counts as if pressed to the depth at which it stiffens, or deeper where it is deeper.
  void contactDiagonal(const Positions& x, bool bound, std::vector<double>& diagonal);

  /// Contact force on each vertex over a third of the area around it, stretched as at x, Pa: from its own sample and
  /// its share of those around.
  void contactPressure(const Positions& x, std::vector<double>& pressure);

  /// Twice the kinetic energy of a displacement within the step, J.
  double kinetic(const Positions& d) const;
  double totalMass() const;  // kg

  /// Energy differences below this are round-off, J; `energy` and `motion` are those of a nearby point.
  double roundOff(double energy, const StepMotion& motion) const;

  /// Diagonal entry of a diagonal matrix that bounds the bending matrix from above, N/m.
  double bendingBound(int vertex) const { return bending_.rowBound(vertex); }

  const Cloth& cloth() const { return cloth_; }
  const StepOptions& options() const { return options_; }

 private:
  struct TriangleLanes {
    int corners[3][kLanes];
    Lanes inverse[4];  // D^-1, row by row, 1/m
    Lanes weight;      // of the membrane (cloth.h), m^2; 0 beyond the last triangle
    RestConditions rest;

    TriangleEdges edgesAt(const Positions& x) const;
  };
  struct VertexSums {
    double energy;  // J
    StepMotion motion;
  };

  HingeDamper hingeDamper(int e) const;
  void layOutTriangles();
  double triangleForces(const Positions& x);
  double blockForces(int block, std::span<const ContactLanes> contacts, const Positions& x);
  double hingeDampingForces(const Positions& x);
  /// Calls add(contact, lane, depth) for each sample that is pressed at x, or (bound) could be, one after the other; m.
  template <class Add>
  void forPressed(const Positions& x, bool bound, const Add& add) const {
    int block = 0;
    TriangleEdges hosts = lanes_[block].edgesAt(x);
    for (int g = 0; g < contacts_.groupCount(); ++g)
      for (const ContactLanes& contact : contacts_.group(g)) {
        if (contact.block != block) hosts = lanes_[contact.block].edgesAt(x);
        block = contact.block;
        Lanes depth = contact.depth(hosts);
        if (bound) depth = depth.max(contact.give);
        for (int l = 0; l < kLanes; ++l)
          if (contact.sample[l] >= 0 && depth[l] != 0.0) add(contact, l, depth[l]);
      }
  }
  /// Calls add(vertex, weight) for the corners of a sample.
  template <class Add>
  void forCorners(const ContactLanes& contact, int lane, const Add& add) const {
    const double w1 = contact.weight[0][lane], w2 = contact.weight[1][lane], weights[3] = {1.0 - w1 - w2, w1, w2};
    for (int a = 0; a < 3; ++a) add(lanes_[contact.block].corners[a][lane], weights[a]);
  }
  double stiffness(const ContactLanes& contact, int lane, double depth) const {  // N/m
    return contact.area[lane] * contactStiffness(depth, options_.contact_stiffness, contact.give[lane]);
  }

  const Cloth& cloth_;
  MembraneEnergy membrane_;
  int rest_revision_ = -1;  // of the cloth's, that the bending matrix has
  StepOptions options_;
  Positions start_;                    // x_n
  Positions inertial_;                 // y
  std::vector<double> start_bending_;  // |b| at the start, where damped
  ContactLayout contacts_;

  BendingMatrix bending_;
  Incidence triangle_corners_, edge_ends_, hinge_corners_;
  // Per element, between the loop over elements and the gathering loop over vertices.
  std::vector<TriangleLanes> lanes_;
  std::vector<Vec3> corner_force_;     // of triangle t, corner a: corner_force_[3 t + a]; dE/dx, N
  std::vector<Mat3> contact_hessian_;  // of the samples: a_s dp/d depth n nᵀ, N/m
  std::vector<char> pressed_;          // whether that is not zero
  std::vector<FrameHessian> frame_hessian_;
  std::vector<Mat3> hinge_hessian_;
  std::vector<Vec3> hinge_force_;
  double bending_round_off_ = 0.0;       // J
  std::vector<double> partial_;          // energies, summed in their order
  std::vector<VertexSums> vertex_sums_;  // of groups of vertices, likewise
};

}  // namespace ease
