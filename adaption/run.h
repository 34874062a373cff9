// One run of a garment through the body's motion: the loop that moves the body, steps the cloth, measures it, and lets
// its rest shape out.  run.cpp is the picture in the README as code.
//
// A run knows neither files nor a command line: it is given meshes and numbers, and tells those who watch.
#pragma once

#include <optional>
#include <vector>

#include "adaption/body_contacts.h"
#include "adaption/pass_record.h"
#include "adaption/presence.h"
#include "adaption/rest_adaption.h"
#include "adaption/run_settings.h"
#include "adaption/run_watch.h"
#include "solver/step/time_step.h"

namespace ease {

/// Contact stiffness k, N/m^3: that of the settings, or more if a slower spring could not bring cloth at rest to the
/// body's speed v, m/s, within half the comfort offset d, m:  1/2 k (d/2)^2 >= 1/2 rho v^2, rho in kg/m^2.
double contactStiffness(const RunSettings& settings, double body_speed, const Cloth& cloth);

/// Contact moves cloth out of the body at most this much faster than the body itself moves, m/s.
constexpr double kRecoverySpeed = 4.0;

/// What a run is given; must outlive it.
struct RunInput {
  Positions start;              // of the garment, n x 3, m
  std::vector<double> offsets;  // comfort offset at every vertex, m
  std::vector<PinnedVertices> pins;
  MovingBody* body = nullptr;   // null: no body
  double body_motion = 0.0;     // of the body's surface in a time step, at most, m (substeps.h)
  std::vector<int> ordering{};  // systemOrdering() of the garment's mesh; empty: found anew
};

class Run {
 public:
  /// Begins with the cloth's present rest shape; growth counts from its first.
  Run(const RunSettings& settings, const RunInput& input, Cloth& cloth);

  /// Goes on from `from` instead of the start shape.  Must come before run().
  void resume(const RunState& from);

  /// Carries the cloth through all moments of the schedule.  If a time step fails, throws ComputationError, which names
  /// the step and its time.  state() is then that after the last part (substeps.h) that succeeded.  Steps counted in
  /// record() are complete ones; its other figures include the parts of the failed step.
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
