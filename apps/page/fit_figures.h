// The figures of a fit by area of the garment and pose, and its tightest places.
#pragma once

#include <string>
#include <vector>

#include "apps/page/garment_areas.h"
#include "apps/page/motion_album.h"

namespace ease {

/// One area of the garment at one moment.
struct AreaFigures {
  double max_stretch = 0.0;       // largest principal stretch of triangles that are not crumpled
  double share_over_limit = 0.0;  // of the area's triangles
  double max_pressure_Pa = 0.0;   // on a vertex
  double mean_distance_m = 0.0;   // to the body, over the corners of the area's triangles
  double cloth_m2 = 0.0;          // of the first rest shape
  double cloth_growth = 1.0;      // area of the rest shape over that of the first
};

/// Figures of every area at a moment, and of the whole garment as the last entry.  `first_areas`: of the triangles of
/// the first rest shape, m^2; `growth`: area of each rest triangle over that.
std::vector<AreaFigures> areaFigures(const GarmentAreas& areas, const SceneInput& input, const ShownMoment& moment,
                                     const std::vector<double>& first_areas, const std::vector<double>& growth);

struct TightPlace {
  double stretch = 0.0;
  double time_s = 0.0;
  int triangle = 0;
};

/// The triangles with the largest stretch over all moments of the album, largest first, no two of them within 5 cm of
/// each other on the first pose.
std::vector<TightPlace> tightestPlaces(const MotionAlbum& album, const SceneInput& input, size_t count);

}  // namespace ease
