// Lines between regions made shorter, and so straighter, as long as woven cloth allows.
//
// The flow weighs length against a conformal measure of distortion, which asks for more than woven cloth does, so that
// its lines bend where they need not, and a bend is left where a seam was removed.  So the flow goes on with length
// weighing more and more, by a seventh each time, and ends before a piece leaves the limits of found seams
// (piece_trial.h), threads stretch by more than a fifth of their limit in the mean, or a piece becomes too small.
#pragma once

#include "garment/pattern/cut_flow.h"
#include "garment/pattern/piece_trial.h"
#include "garment/pattern/region_cut.h"

namespace ease {

/// A garment cut along the lines of levels.
struct LevelCut {
  RegionLevels levels;
  CutUp cut;
  double length_weight = 0.0;  // that the lines were found with
};

/// What the lines belong to.
struct CutPlace {
  const RestGarment& garment;
  const Pieces& pieces;  // of the garment, cut along the seams that it has
  const RestSurface& surface;
};

/// Levels with one label for each piece of the cut garment, whose lines are those of its seams.
RegionLevels levelsOfPieces(const CutPlace& place, const RegionLevels& levels, const CutUp& cut);

/// The straightest lines that were found; `given` itself where none are straighter.  `mirror` as in followFlow().
LevelCut straightest(const CutPlace& place, LevelCut given, const FlowSettings& flow, const FlatSettings& flat,
                     const SewableSize& size, const MirrorLevels* mirror);

}  // namespace ease
