// Frames of the written series: the positions of a garment or rest shape and its arrays (output_arrays.h).
#pragma once

#include <optional>
#include <vector>

#include "adaption/stretch_measure.h"
#include "apps/scene.h"
#include "solver/mesh/numbering.h"
#include "solver/model/cloth.h"
#include "solver/step/state.h"
#include "viz/series.h"

namespace ease {

/// Data from which the arrays of a garment's frame are computed, in addition to the cloth and its state.
struct GarmentFields {
  const std::vector<Stretch>& stretch;
  const std::vector<double>& first_areas;  // areas of the first rest shape's triangles, m^2
  const std::vector<double>& gap;          // per vertex, m; empty without a body
  const std::vector<double>& pressure;     // per vertex, Pa; empty without a body
  const std::vector<int>& pinned;          // vertices
  std::optional<double> limit;             // delta; none: without limit
};

/// Makes the frame of the garment at one moment, with all arrays of a run.  Arrays about contact are left out if there
/// is no body.
Frame garmentFrame(const Cloth& cloth, const State& state, const GarmentFields& fields);

/// Makes the frame of the rest shape, embedded in space, with the arrays that belong to it.
Frame restFrame(const Cloth& cloth, const std::vector<double>& first_areas);

/// Returns the frame with one entry per vertex of the garment's file.  The garment may have fewer vertices, since some
/// were welded or unused; unused ones keep their place in the file and get 0 in every array.
Frame asRead(const Frame& frame, const std::optional<GarmentAsRead>& file);

/// The garment's triangles as its file numbers their vertices.
const Triangles& trianglesAsRead(const SceneInput& input);

/// The numbers of these vertices of the garment in its file: of the first ones that became them.
std::vector<int> verticesAsRead(const SceneInput& input, std::vector<int> vertices);

/// Undoes the renumbering of a mesh: returns positions and arrays in their original order.
Frame restored(const Frame& frame, const Numbering& numbering);

}  // namespace ease
