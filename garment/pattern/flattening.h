// Flattening of pattern pieces for woven cloth, whose threads resist stretch while the angle between them yields.
//
//   F_t = S_t R_t     2x2 gradient from rest edges to the plane; R rotation, S symmetric, in the axes of the paper,
//                     which are warp and weft of the cloth that the piece is cut from
//   E = sum_t a_t [k_u (S_uu - 1)^2 + k_v (S_vv - 1)^2 + 2 k_s S_uv^2],   |e_a| = |e_b| for every pair
//
// k_u, k_v, k_s are the stiffnesses along warp and weft and in shear over the largest of them; e_a, e_b are edges that
// are sewn together.  Local and global steps alternate (after Liu et al. 2008, "A local/global approach to mesh
// parameterization"): the gradient system finds the positions nearest to the targets
//
//   T_t = F_t - (stress of F_t) R_t,    stress = [[k_u (S_uu - 1), k_s S_uv], [k_s S_uv, k_v (S_vv - 1)]]
//
// and its matrix is the same in every step.  Shear above the limit counts as stiff as the threads.  Every tenth step
// turns each piece so that its threads follow the garment's grain in the mean, in closed form.
//
// Springs draw the edges of a pair to their mean length, and what is left of their difference adds up and is drawn as
// well (the alternating direction method of multipliers, Boyd et al. 2011), so that in the end the lengths are equal
// however soft the springs are.
//
// Pieces can be let out.  `excess`, 0 to 1, is the weight of cloth that is larger on the paper than at rest, over that
// of cloth that is smaller; with the eigenvalues s_1, s_2 of S,
//
//   E_out = excess E + (1 - excess) sum_t a_t [min(0, s_1 - 1)^2 + min(0, s_2 - 1)^2]
//
// Nothing in that keeps triangles from flipping.  Pieces with a flipped triangle are flattened again from a convex
// start, with a barrier and steps that end before a triangle flips (Smith and Schaefer 2015); they are counted.
#pragma once

#include "garment/pattern/flat_start.h"

namespace ease {

/// Edges a0-a1 and b0-b1 of outlines that are sewn together, a0 onto b0.
struct SewnPair {
  int a0, a1, b0, b1;
};

struct WovenSettings {
  double warp = 1.0, weft = 1.0, shear = 0.25;  // stiffnesses over the largest of them
  double shear_limit = 0.24;                    // rad
  double seam_weight = 15.0;                    // of the springs of pairs, in units of the membrane's stiffness
  double excess = 1.0;                          // weight of cloth that is larger on the paper than at rest
  int max_iterations = 400;
  double tolerance = 1e-7;  // m: the steps end once no vertex moves further
  bool mends = true;        // flatten pieces with flipped triangles again; else leave them
};

struct Flattened {
  Positions x;          // (warp, weft, 0), m
  int mended = 0;       // pieces that were flattened again, without flips
  double energy = 0.0;  // E without the pairs, m^2
};

/// Flattens all pieces together.  `start`: positions to begin from; null: conformal ones.  `shear_of_piece`: a
/// stiffness in shear for every piece; `excess_of_triangle`: for every triangle the weight of cloth larger than at
/// rest; empty: those of the settings.
Flattened flatten(const FlatPieces& pieces, const std::vector<SewnPair>& pairs, const WovenSettings& settings,
                  const Positions* start = nullptr, const std::vector<double>& shear_of_piece = {},
                  const std::vector<double>& excess_of_triangle = {});

}  // namespace ease
