// A piece by itself, cut along darts that are tried and flattened from where it is.
#pragma once

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// One piece by itself, with its vertices' numbers in the garment.
struct PieceMesh {
  TriangleMesh mesh;
  std::vector<Mat2> rest_edges;
  std::vector<int> garment_vertex;
  Positions x;        // of the vertices in the plane, m; each of a dart's lies on one of its sides
  Positions corners;  // of corner k of triangle t in row 3 t + k, m: on either side of darts; empty: not flat yet
};

constexpr double kEnergyWeight = 0.2;  // of the energy beside the area over the limits

/// How bad a flattening is: area over a limit and energy, m^2.
struct Badness {
  double over = 0.0, energy = 0.0;
  double all() const { return over + kEnergyWeight * energy; }
};

/// A part cut along some darts, flattened from where the part is now.
struct Trial {
  Badness badness;
  StrainSummary strain;
  bool is_sound = true;  // neither flipped nor across itself, as where a dart would need more cloth, not less
  Positions x, corners;  // as in PieceMesh
};

/// Flattens a part along darts, given by its own vertices, in at most so many iterations.
Trial flattenPart(const PieceMesh& part, const std::vector<Seam>& darts, const FlatSettings& settings, int iterations);

/// The triangles of one piece of a garment.
PieceMesh partOf(const RestGarment& garment, const Pieces& pieces, int piece);

}  // namespace ease
