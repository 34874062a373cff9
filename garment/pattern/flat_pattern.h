// From a garment at rest to the flat pieces that it can be sewn from.
//
//   cut        along the seams, and along the shortest way where a piece is no disk     (cut_garment.h)
//              and in two where a piece overlaps itself in the plane                    (overlap.h)
//   turn       the grain of each piece, where it may be free                            (free_grain.h)
//   darts      where a piece would have to stretch or shear beyond the limits           (darts.h)
//   slide      darts and openings onto smooth lines, as they are drawn and sewn         (slid_lines.h)
//   flatten    all pieces together, sides of a seam equally long; pieces far below the limit of shear once more, with
//              softer shear, which spares their threads                                 (flattening.h)
//   name       after the loops around a piece and the side of the wearer                (piece_names.h)
#pragma once

#include <functional>
#include <limits>

#include "garment/pattern/cut_garment.h"
#include "garment/pattern/flattening.h"
#include "garment/pattern/rest_garment.h"
#include "garment/pattern/thread_strain.h"

namespace ease {

/// A name for the piece nearest to a point, m.
struct PieceName {
  std::string name;
  Vec3 at;
};

struct FlatSettings {
  StrainLimits limits;
  WovenSettings woven;
  int max_darts = 12;
  bool free_grain = false;                                  // turn each piece's grain to where threads stretch least
  double widest = std::numeric_limits<double>::infinity();  // m: width that a turned grain may give a piece
  std::vector<PieceName> names;
};

struct FlatPiece {
  std::string name;
  StrainSummary strain;
  int darts = 0;
  double grain = 0.0;        // rad, from the garment's warp to the piece's, counter-clockwise seen from outside
  bool upside_down = false;  // whether the warp points up the wearer's body; usually it points down
  bool is_back = false;      // whether it faces backwards, by more than a sleeve does
  bool crosses_itself = false;
};

/// Two edges that are sewn together.
struct SeamSides {
  int line;                                      // of FlatPattern::lines
  int left, right;                               // of CutGarment::edges
  double rest_length = 0.0;                      // m, of the seam in the garment
  double left_length = 0.0, right_length = 0.0;  // m, on the paper
};

struct FlatPattern {
  std::vector<CutLine> lines;
  CutUp slid;  // the garment whose pieces these are, with its own grain
  CutGarment cut;
  FlatPieces flat;
  Positions x;  // of the cut mesh's vertices in the plane: (warp, weft, 0), m
  std::vector<ThreadStrain> strains;
  std::vector<FlatPiece> pieces;
  std::vector<SeamSides> seams;
  // By edge of the cut, by its vertex: how far along the edge it lies in the garment, 0 to 1.
  std::vector<std::vector<double>> shares;
  std::vector<double> shear;  // stiffness in shear by piece, as in WovenSettings
  int mended = 0;             // pieces that were flattened again, without flips
  std::vector<std::string> warnings;
};

/// Cuts and flattens.  Throws InputError where the seams leave a piece that cannot be opened or a name meets no piece,
/// ComputationError where triangles are degenerate.
FlatPattern flattenGarment(const RestGarment& garment, const FlatSettings& settings);

/// The stiffness in shear that spares the threads of a piece with this strain and keeps it below the limit of shear.
double softerShear(const StrainSummary& strain, const FlatSettings& settings);

/// Flattens the pieces again for another rest shape, starting from where they lie.  `excess_of_triangle`: for every
/// triangle the weight of cloth larger than at rest (flattening.h); empty: that of the settings.  The strains stay
/// those of `pattern`; areas and flips are those of the new rest shape.
FlatPattern flattenAgain(const FlatPattern& pattern, const std::vector<Mat2>& rest_edges, const FlatSettings& settings,
                         const std::vector<double>& excess_of_triangle = {});

/// Flat edges of the garment's triangles if it is sewn from these pieces, m: what its rest shape is then.
std::vector<Mat2> sewnEdges(const FlatPattern& pattern);

/// The edges of both sides of all seams, one by one.
std::vector<SewnPair> sewnPairs(const CutGarment& cut);

/// Length of a chain of vertices, m.
double lengthOf(const std::vector<int>& vertices, const Positions& x);

/// Whether an edge is a leg of a dart: sewn to the edge beside it.
bool isDartLeg(const CutGarment& cut, int edge);

/// Whether a piece would need the same cloth twice, its darts drawn straight: its outline crosses itself, or the legs
/// of a dart do not open.
bool overlapsItself(const CutGarment& cut, int piece, const Positions& x);

/// The vertices of a piece's outline in order.
std::vector<int> outlineOf(const CutGarment& cut, int piece);

}  // namespace ease
