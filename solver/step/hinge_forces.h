// Bending of all hinges and its damping (energy/bending.h), eight hinges side by side.
//
//   E(b) = w/2 |b|^2 + w_d/(2h) (|b| - |b_start|)^2       J; b = sum_i K_i x_i, the hinge vector (model/hinge.h)
//   g(b) = (w + w_d/h (1 - |b_start|/|b|)) b              its derivative, N; corner i feels K_i g
//
// A loop over hinges writes g, and each vertex then adds up what it gets from its hinges.
#pragma once

#include <vector>

#include "solver/energy/bending.h"
#include "solver/energy/element.h"
#include "solver/linear/incidence.h"
#include "solver/model/cloth.h"

namespace ease {

class HingeForces {
 public:
  explicit HingeForces(const Cloth& cloth);

  /// Starts a step of length `h`, s, at these positions, m, with the cloth's present rest shape.
  void begin(const Positions& start, double h);

  /// Whether bending neither costs energy nor is damped; the other functions must then not be called.
  bool empty() const { return empty_; }
  bool damps() const { return damps_; }

  /// Computes g of every hinge, N, at x and returns the energy of all, J.
  double evaluate(const Positions& x);

  int count() const { return static_cast<int>(cloth_.hinges().size()); }
  /// A vector of each hinge, N: g, or what the caller has written there.
  std::vector<Vec3>& vectors() { return vectors_; }
  /// Sum of K_i times the hinge's vector over the hinges of a vertex, N.
  Vec3 sumAt(int vertex) const {
    Vec3 sum = Vec3::Zero();
    const double* stencil = stencils_.data() + corners_.before(vertex);
    for (const int corner : corners_.of(vertex)) sum += *stencil++ * vectors_[corner / 4];
    return sum;
  }

  /// The damper of hinge `e` in this step.
  HingeDamper<double> damper(int e) const {
    const HingeDamper<Lanes>& eight = lanes_[e / kLanes].damper;
    return {eight.damping_over_h[e % kLanes], eight.start[e % kLanes]};
  }

 private:
  /// Constants of eight hinges; the last hinge is repeated, without stiffness, in lanes beyond it.
  struct HingeLanes {
    int vertices[4][kLanes];
    Lanes stencil[4];  // K
    Lanes stiffness;   // w, N/m
    HingeDamper<Lanes> damper;

    Column<Lanes> vectorAt(const Positions& x) const;
  };
  void layOut();

  const Cloth& cloth_;
  Incidence corners_;
  int rest_revision_ = -1;  // of the cloth's rest shape for which the hinges were laid out
  bool empty_ = true, damps_ = false;
  std::vector<HingeLanes> lanes_;
  std::vector<double> stencils_;  // K of each corner, in the order in which vertices add up
  std::vector<Vec3> vectors_;     // N
  std::vector<double> partial_;   // energies of groups, added up in a fixed order, J
};

}  // namespace ease
