// Frames of the written series: which arrays a garment, a body and a rest shape bear.
#pragma once

#include <vector>

#include "adaption/stretch_measure.h"
#include "solver/mesh/numbering.h"
#include "solver/model/cloth.h"
#include "solver/step/state.h"
#include "viz/series.h"

namespace ease {

/// What a frame of the garment shows beside its positions.
struct GarmentFields {
  const std::vector<Stretch>& stretch;
  const std::vector<double>& first_areas;  // of the first rest shape, m^2
  const std::vector<double>& gap;          // per vertex, m; empty without a body
  const std::vector<double>& pressure;     // per vertex, Pa; empty without a body
  const std::vector<int>& pinned;          // vertices
};

/// Per triangle: sigma_1, sigma_2, stretch_warp, stretch_weft, rest_area_ratio.  Per vertex: velocity_m_s, pinned,
/// and on a body gap_m (distance less the comfort offset), contact_pressure_Pa.
Frame garmentFrame(const Cloth& cloth, const State& state, const GarmentFields& fields);

/// The rest shape in space, with rest_area_ratio.
Frame restFrame(const Cloth& cloth, const std::vector<double>& first_areas);

/// The frame of a mesh as it was before it was renumbered.
Frame restored(const Frame& frame, const Numbering& numbering);

}  // namespace ease
