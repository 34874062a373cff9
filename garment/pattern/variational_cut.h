// Seams found by the program where none, or not enough, are given.
//
//   start     regions that face alike                                             (normal_clusters.h)
//   flow      their lines move to where length and distortion cost least         (cut_flow.h)
//   cut       exactly along the lines                                             (region_cut.h)
//   remove    seams that woven cloth does not need, and pieces too small to sew   (needless_seams.h)
//   straighten  lines as far as woven cloth allows                                (straight_cuts.h)
//   name      after the pieces that a seam joins                                  (seam_names.h)
#pragma once

#include <optional>

#include "garment/pattern/cut_flow.h"
#include "garment/pattern/needless_seams.h"
#include "garment/pattern/straight_cuts.h"

namespace ease {

struct CutSettings {
  FlowSettings flow;
  bool keep = true;    // the garment's own seams are cut first and stay; else they are forgotten
  bool remove = true;  // needless seams
  bool straighten = true;
  bool is_symmetric = false;
  std::optional<double> plane;  // x of the plane between left and right, m; none: the one that halves the garment
  SewableSize size;
};

struct FoundCuts {
  CutUp cut;
  std::vector<double> energies;  // of the flow: at the start and after every step
  double length_before = 0.0;    // of all seams, given and found, before needless ones were removed, m
  double length = 0.0;           // afterwards; neither counts darts and openings
  int pieces_before = 0;         // before needless seams were removed
  double length_weight = 0.0;    // that the lines were straightened with
  double wall_s = 0.0;
  std::vector<std::string> warnings;
};

/// Finds cuts.  Throws InputError where the mesh is no surface or the plane of symmetry misses it, ComputationError
/// where triangles are degenerate.
FoundCuts findCuts(const RestGarment& garment, const CutSettings& settings, const FlatSettings& flat);

}  // namespace ease
