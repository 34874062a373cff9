// What is asked of a run (run.h) and of a fit (fit.h).
#pragma once

#include <optional>

#include "adaption/timeline.h"
#include "solver/mesh/triangle_mesh.h"
#include "solver/step/method.h"

namespace ease {

struct RunSettings {
  Schedule schedule;
  MethodOptions method;
  Vec3 gravity = {0.0, -9.81, 0.0};  // m/s^2
  double contact_stiffness = 3e6;    // N/m^3, at least; more where the body is fast
  double friction = 0.0;             // coefficient of friction between garment and body
  double comfort_offset = 0.005;     // m, the garment's general one; that of each vertex is in RunInput
  std::optional<double> limit;       // delta: the cloth may be stretched to 1 + delta; none: without limit or adaption
};

struct FitSettings {
  double target = 0.001;  // share of the triangles that may be over the limit at the worst moment
  int max_passes = 14;
};

}  // namespace ease
