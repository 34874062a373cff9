// The flow of the lines between regions to where they cost least: Sharp and Crane 2018, with a line search.
//
//   minimise E over the levels phi     (cut_energy.h, region_levels.h)
//   step      phi_k -= alpha d_k,   (M + r^2 K) d_k = dE/dphi_k
//
// M holds the vertices' areas, K is the cotangent stiffness, r a few edges: the derivative, which is not zero beside
// the lines only, is carried off the lines and smoothed along them, in one implicit step with one factor for all labels
// and steps.  It is downhill in any case, and the length falls as under the published implicit curve shortening, which
// this step is with the exact derivative of the length in place of K phi.  alpha is halved until the energy falls
// enough (Armijo), and grows again after every step that is taken.  After each step the levels become distances again,
// if the energy does not rise above that of the step before.
#pragma once

#include "garment/pattern/cut_energy.h"
#include "garment/pattern/mirror_levels.h"

namespace ease {

struct FlowSettings {
  CutWeights weights;
  int steps = 500;          // at most
  double tolerance = 1e-4;  // ends where the energy falls by less than this share in ten steps
  bool joins = true;        // small regions to others, where that lowers the energy
};

struct FlowResult {
  RegionLevels levels;
  std::vector<double> energies;  // at the start and after every step: they fall
};

/// Follows the flow from these levels.  `mirror`: keeps the levels symmetric, as the start must be; may be null.
FlowResult followFlow(const RestSurface& surface, const RegionLevels& start, const FlowSettings& settings,
                      const MirrorLevels* mirror = nullptr);

}  // namespace ease
