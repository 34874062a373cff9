// The rest shape of a run with paint: scale factors of its triangles.
#pragma once

#include <vector>

#include "adaption/run_watch.h"

namespace ease {

/// Scales the triangles of the cloth's rest shape by `paint`, one factor each, and makes the result the first one.
void paintFirstRest(const std::vector<double>& paint, Cloth& cloth);

/// Returns the state of a run with its rest shape scaled by `more`; empty: as it is.  Changes the cloth's rest shape.
RunState withPaint(const RunState& state, const std::vector<double>& more, Cloth& cloth);

}  // namespace ease
