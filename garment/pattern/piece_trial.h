// A piece flattened by itself, to judge the seams around it.
#pragma once

#include "garment/pattern/dart_trial.h"
#include "garment/pattern/rest_surface.h"

namespace ease {

struct SewableSize {
  double area = 0.004;   // m^2: least area of a piece
  double width = 0.04;   // m: least diameter of the largest circle in it
  double widest = 1.36;  // m: largest width of a piece across the grain
};

/// A piece flattened by itself, opened along the shortest ways where it is no disk, with softer shear where it is far
/// below that limit, as in the pattern itself.  Its energy is that with the shear of the settings.
struct PieceTrial {
  Badness badness;
  double openings = 0.0;    // length of these ways, m
  double area = 0.0;        // m^2
  double stretch = 0.0;     // of the threads, times area, m^2
  bool is_sound = false;    // a disk that lies flat without flips and without crossing itself
  bool keeps = false;       // the limits
  Vec2 box = Vec2::Zero();  // height along and width across the grain, m
};

/// Flattens one piece by itself; where it cannot be made a disk the trial is not sound.
PieceTrial tryPiece(const RestGarment& garment, const Pieces& pieces, int piece, const FlatSettings& settings);

/// Settings with the limits for seams that the program finds: three fifths of the threads' limit, on 99 % of the area.
FlatSettings strictLimits(FlatSettings settings);

/// Whether a piece is too small or too narrow to sew.
bool isTooSmall(const RestGarment& garment, const Pieces& pieces, int piece, const SewableSize& size);

}  // namespace ease
