// What a run (run.h) tells those who watch it.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "adaption/garment_pins.h"
#include "adaption/stretch_measure.h"
#include "adaption/timeline.h"
#include "solver/model/rest_shape.h"
#include "solver/step/state.h"

namespace ease {

/// Enough to go on from a moment as if the run had not stopped there.
struct RunState {
  StepsDone done;
  State cloth;
  RestShape rest;
  std::vector<Mat2> wanted_edges;  // of the adaption (rest_adaption.h), m; empty: there was none
  std::vector<PinAnchor> pins;
};

/// The garment and the body at a measured moment.
struct Snapshot {
  const Moment& moment;
  const Cloth& cloth;
  const State& state;
  const std::vector<Stretch>& stretch;  // of every triangle
  const std::vector<int>& pinned;       // vertices
  std::vector<double> gap;              // of every vertex: distance to the body less the comfort offset, m
  std::vector<double> pressure;         // of contact, at every vertex, Pa; as `gap`, empty without a body
  Positions body;                       // empty without a body, m
};

/// Figures of a measured moment.
struct MeasuredMoment {
  double time_s = 0.0;
  StretchStatistics stretch;
  double fastest_m_s = 0.0;  // speed of the fastest vertex
};

/// Who watches a run.  Functions may be empty; those of a moment are called in this order.
struct RunWatch {
  std::function<void(const std::vector<Stretch>&)> on_stretch;  // the moment was measured
  std::function<void(const MeasuredMoment&)> on_measured;       // the moment was measured; called after on_stretch
  std::function<void(const Snapshot&)> on_shown;                // the moment is worth a picture
  std::function<void(const Snapshot&)> on_frame;                // the moment is written
  std::function<void(const RunState&)> on_checkpoint;
  std::function<void(const Moment&)> on_step;      // after every time step
  const std::atomic<bool>* interrupted = nullptr;  // the run ends before the next time step once this is true
};

}  // namespace ease
