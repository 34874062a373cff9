// A simulation whose garment, paint, pins and pose change while it runs: one time step after the other, changes between
// them.  The steps are those of Run (adaption/run.h); the way of the body is decided step by step.
//
// Such a run is a preview: nobody can repeat it.  What counts is what `ease run` makes of the scene.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "adaption/run.h"
#include "apps/studio/garment_maker.h"

namespace ease {

/// What there is to see after a time step.
struct LiveFrame {
  std::shared_ptr<const MadeGarment> made;
  Positions garment, body, rest;  // m
  std::vector<Stretch> stretch;   // one a triangle
  std::vector<double> growth;     // of every triangle: rest area over that of the garment as it was made
  std::vector<double> gap;        // of every vertex: distance to the body less the comfort offset, m; empty: no body
  std::vector<double> pressure;   // of the body at every vertex, Pa; empty: no body
  StretchStatistics statistics;
  double deepest = 0.0;  // of the cloth in the body so far, m
  long steps = 0;        // since the start
  double time_s = 0.0;   // since the start
  int pose = 0;          // where the body is or goes to
  double way = 1.0;      // share of the way to that pose
  double let_out = 0.0;  // area that was let out so far, over that of the first rest shape with its paint
};

class LiveRun {
 public:
  /// Starts on the first pose with the garment as it was made.  Throws as Run does.
  explicit LiveRun(std::shared_ptr<const MadeGarment> made);

  /// One time step.  Throws ComputationError, and has not changed then.
  void step();

  /// The body goes to this pose from where it is now.
  void goTo(int pose);
  /// Whether the rest shape is let out where it is stretched beyond the limit.
  void setAdapting(bool adapts) { adapts_ = adapts; }

  /// Goes on with another state of the scene; returns in words what was done.  Paint, pins, comfort, material and limit
  /// change where the cloth is.  Another mesh is carried over (carry_over.h), or started over if too little of it lies
  /// where the old one was.
  std::string change(std::shared_ptr<const MadeGarment> made);
  void startOver();

  /// `all`: with gap and pressure, which cost more than the rest.
  LiveFrame frame(bool all);
  const MadeGarment& made() const { return *made_; }

 private:
  void makeCloth();
  void makeStep();
  void stand(const Positions& body);
  void leaveFor(const std::vector<Positions>& poses);
  void meetBody();
  void setPins(const std::vector<PinAnchor>& earlier);
  void stepPart(const Moment& moment, int part);
  Positions bodyNow() const;
  Moment nextMoment() const;
  std::string changeInPlace(const MadeGarment& before);
  std::string changeMesh(const MadeGarment& before);
  /// Areas of the first rest shape's triangles with today's paint, m^2.
  std::vector<double> paintedAreas() const;
  int measureEvery() const { return made_->scene.adaption ? made_->scene.adaption->every : 4; }
  double limit() const;
  double largestOffset() const;

  std::shared_ptr<const MadeGarment> made_;
  std::vector<double> paint_;        // in the rest shape; empty: none
  std::vector<double> first_paint_;  // in the first one
  std::optional<Cloth> cloth_;
  std::vector<int> ordering_;
  std::optional<RunSettings> settings_;
  std::unique_ptr<TimeStep> step_;
  std::unique_ptr<RestAdaption> adaption_;
  GarmentPins pins_;
  std::unique_ptr<MovingBody> body_;  // from the pose left to the one chosen; null: no body
  Substeps substeps_;
  double part_s_ = 0.0, body_motion_ = 0.0, stiffness_ = 0.0, band_ = 0.0;
  std::unique_ptr<BodyContacts> contacts_;
  State state_;
  std::vector<Stretch> stretch_;
  Penetration penetration_;
  bool adapts_ = false;
  int pose_ = 0, moving_ = 0, way_steps_ = 0;
  double let_out_ = 0.0;  // m^2
  long steps_ = 0;
};

}  // namespace ease
