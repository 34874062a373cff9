// One run of a garment through the body's motion: the loop that moves the body, steps the cloth, measures it, and lets
// its rest shape out.  run.cpp is the picture in the README as code.
//
// A run knows neither files nor a command line: it is given meshes and numbers, and tells those who watch.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "adaption/body_contacts.h"
#include "adaption/garment_pins.h"
#include "adaption/pass_record.h"
#include "adaption/presence.h"
#include "adaption/rest_adaption.h"
#include "adaption/timeline.h"
#include "solver/model/rest_shape.h"
#include "solver/step/time_step.h"

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

/// Contact stiffness, N/m^3: as the settings say, and at least what brings cloth at rest to the body's speed v (m/s)
/// within half the comfort offset d:  1/2 k (d/2)^2 >= 1/2 rho v^2.
double contactStiffness(const RunSettings& settings, double body_speed, const Cloth& cloth);

constexpr double kRecoverySpeed = 4.0;  // m/s, beside the body's own: of cloth moved out of the body, at most

/// What a run is given; must outlive it.
struct RunInput {
  Positions start;              // of the garment, n x 3, m
  std::vector<double> offsets;  // comfort offset at every vertex, m
  std::vector<PinnedVertices> pins;
  MovingBody* body = nullptr;  // null: no body
  double body_motion = 0.0;    // of the body's surface in a time step, at most, m (substeps.h)
};

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

/// What a measured moment comes to.
struct MeasuredMoment {
  double time_s = 0.0;
  StretchStatistics stretch;
  double fastest_m_s = 0.0;  // speed of the fastest vertex
};

/// Who watches a run.  Functions may be empty; those of a moment are called in this order.
struct RunWatch {
  std::function<void(const std::vector<Stretch>&)> on_stretch;  // the moment was measured
  std::function<void(const MeasuredMoment&)> on_measured;       // the same moment
  std::function<void(const Snapshot&)> on_shown;                // the moment is worth a picture
  std::function<void(const Snapshot&)> on_frame;                // the moment is written
  std::function<void(const RunState&)> on_checkpoint;
  std::function<void(const Moment&)> on_step;      // after every time step
  const std::atomic<bool>* interrupted = nullptr;  // the run ends before the next time step once this is true
};

class Run {
 public:
  /// Begins with the cloth's present rest shape; growth counts from its first.
  Run(const RunSettings& settings, const RunInput& input, Cloth& cloth);

  /// Takes the place of the start shape.  Must come before run().
  void resume(const RunState& from);

  /// Carries the cloth through all moments of the schedule.  Throws ComputationError with the time step at which the
  /// computation failed; state and record are then as they were before it.
  void run(const RunWatch& watch = {});

  const State& state() const { return state_; }
  const PassRecord& record() const { return record_; }

 private:
  StepsDone done() const { return resumed_from_ ? resumed_from_->done : StepsDone(); }
  void begin(const RunWatch& watch);
  void step(const Moment& moment);
  void stepPart(const Moment& moment, int part);
  void measure(const Moment& moment, const RunWatch& watch);
  void adapt();
  void tell(const Moment& moment, const RunWatch& watch);
  Snapshot snapshot(const Moment& moment);
  RunState stateToGoOn(const Moment& moment) const;

  const RunSettings settings_;
  const RunInput& input_;
  Cloth& cloth_;
  const std::vector<int> ordering_;  // of all linear systems on the garment's mesh
  const double part_s_;              // length of a part of a time step, s
  TimeStep step_;
  GarmentPins pins_;
  std::optional<BodyContacts> contacts_;  // none without a body
  std::optional<Presence> presence_;      // none without a body
  std::optional<RestAdaption> adaption_;  // none where the rest shape stays
  State state_;
  std::optional<RunState> resumed_from_;
  std::vector<Stretch> stretch_;  // measured last
  PassRecord record_;
};

}  // namespace ease
