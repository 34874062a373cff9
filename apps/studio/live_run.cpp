#include "apps/studio/live_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "apps/painted_rest.h"
#include "apps/run_pictures.h"
#include "apps/scene_run.h"
#include "apps/studio/carry_over.h"
#include "garment/paint.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr double kRoomForComfort = 0.02;  // m: comfort offset up to which the body need not be made anew
constexpr double kEnoughTied = 0.3;       // share of the new vertices on the old mesh; with fewer it is another garment
constexpr int kPaintIterations = 60;      // they move vertices by less than .1 mm by then; starting over makes them all

double sumOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

LiveRun::LiveRun(std::shared_ptr<const MadeGarment> made) : made_(std::move(made)) {
  startOver();
}

double LiveRun::limit() const {
  return shownLimit(made_->scene);
}

double LiveRun::largestOffset() const {
  const std::vector<double>& offsets = made_->input.offsets;
  return std::max(kRoomForComfort, *std::max_element(offsets.begin(), offsets.end()));
}

void LiveRun::makeCloth() {
  const Scene& scene = made_->scene;
  paint_ = first_paint_ = made_->input.paint;
  cloth_.emplace(made_->input.garment, scene.garment.grain, scene.material);
  if (!paint_.empty()) paintFirstRest(paint_, *cloth_);
  ordering_ = systemOrdering(cloth_->vertexCount(), cloth_->triangles());
}

void LiveRun::makeStep() {
  settings_ = runSettings(made_->scene, replaySchedule(made_->scene));
  step_ = std::make_unique<TimeStep>(*cloth_, settings_->method, ordering_);
  adaption_ = std::make_unique<RestAdaption>(*cloth_, limit(), ordering_);
}

void LiveRun::startOver() {
  makeCloth();
  makeStep();
  state_ = {startOf(made_->input), Positions::Zero(cloth_->vertexCount(), 3)};
  penetration_ = {};
  steps_ = 0;
  let_out_ = 0.0;
  pose_ = 0;
  if (!made_->input.poses.empty()) {
    stand(made_->input.poses.front());
  } else {
    part_s_ = settings_->schedule.time_step;
    stiffness_ = settings_->contact_stiffness;
  }
  setPins({});
  measureStretch(*cloth_, state_.positions, stretch_);
}

void LiveRun::stand(const Positions& body) {
  leaveFor({body});
}

/// The body goes from the first of these poses to the second, or stays on the only one.
void LiveRun::leaveFor(const std::vector<Positions>& poses) {
  Schedule& schedule = settings_->schedule;
  schedule.poses = static_cast<int>(poses.size());
  schedule.cycles = 1;
  body_motion_ =
      poses.size() > 1 ? bodyMotionPerStep(schedule, made_->input.body_triangles, poses, state_.positions) : 0.0;
  const Substeps substeps =
      poses.size() > 1 ? chooseSubsteps(schedule, body_motion_, settings_->comfort_offset) : Substeps();
  band_ = largestOffset();
  contacts_.reset();
  body_ = std::make_unique<MovingBody>(
      made_->input.body_triangles, poses, schedule.interpolation_steps * substeps.interpolation,
      LevelSetOptions{made_->scene.collision.voxel, kBeyondComfort + band_},
      std::make_shared<const InterpolatedPoses>(made_->input.body_triangles, poses, made_->input.way->ordering));
  substeps_ = substeps;
  way_steps_ = poses.size() > 1 ? timeStepsOfMotion(schedule) : 0;
  moving_ = 0;
  meetBody();
}

/// Contact of the present cloth with the present body.
void LiveRun::meetBody() {
  part_s_ = settings_->schedule.time_step / substeps_.time;
  const double motion = body_motion_ / substeps_.time;
  stiffness_ = contactStiffness(*settings_, motion / part_s_, *cloth_);
  contacts_ = std::make_unique<BodyContacts>(*body_, *cloth_, made_->input.offsets, settings_->schedule, substeps_,
                                             kRecoverySpeed * part_s_ + motion);
  contacts_->prepareFirst({moving_, moving_, 0}, state_.positions);
  state_.normal_forces.clear();
}

Positions LiveRun::bodyNow() const {
  Positions body;
  if (body_) body_->positions(contacts_->bodyAt(StepsDone{moving_, moving_, 0}), body);
  return body;
}

void LiveRun::goTo(int pose) {
  if (!body_ || pose < 0 || pose >= static_cast<int>(made_->input.poses.size())) return;
  const std::vector<PinAnchor> anchors = pins_.anchors();
  leaveFor({bodyNow(), made_->input.poses[pose]});
  pose_ = pose;
  setPins(anchors);
}

void LiveRun::setPins(const std::vector<PinAnchor>& earlier) {
  std::vector<PinnedVertices> pins;
  for (size_t k = 0; k < made_->input.pins.size(); ++k)
    pins.push_back({made_->input.pins[k], made_->scene.garment.pins[k].to_body});
  pins_.set(pins, earlier, state_.positions, bodyNow(), made_->input.body_triangles);
  step_->forget();
}

Moment LiveRun::nextMoment() const {
  Moment moment;
  moment.moves = moving_ < way_steps_;
  moment.done = {moving_ + (moment.moves ? 1 : 0), moving_ + (moment.moves ? 1 : 0), 0};
  return moment;
}

void LiveRun::step() {
  const Moment moment = nextMoment();
  for (int part = 1; part <= substeps_.time; ++part) {
    TaskBeside beside;
    if (contacts_) contacts_->prepareNext(moment, part, state_, part_s_, beside);
    stepPart(moment, part);
    beside.wait();
  }
  moving_ = moment.done.moving;
  ++steps_;
  if (!adapts_ || steps_ % measureEvery() != 0) return;
  measureStretch(*cloth_, state_.positions, stretch_);
  const double before = sumOf(cloth_->restAreas());
  if (adaption_->adapt(stretch_)) let_out_ += sumOf(cloth_->restAreas()) - before;
}

void LiveRun::stepPart(const Moment& moment, int part) {
  const StepOptions options{part_s_, settings_->gravity, stiffness_, settings_->friction};
  if (!contacts_) {
    step_->step(state_, options, pins_.at(nullptr), [](const Positions&, Contacts&) {});
    return;
  }
  const double s = contacts_->bodyAt(moment, part);
  const std::optional<double> start =
      settings_->friction > 0.0 ? std::optional(contacts_->bodyAt(moment, part - 1)) : std::nullopt;
  const BodyMoment body = body_->at(s);
  step_->step(state_, options, pins_.at(&body),
              [&](const Positions& x, Contacts& contacts) { contacts_->find(s, x, contacts, start); });
  contacts_->measureSinceFind(state_.positions);
  contacts_->deepen(penetration_);
}

std::string LiveRun::change(std::shared_ptr<const MadeGarment> made) {
  const std::shared_ptr<const MadeGarment> before = std::exchange(made_, std::move(made));
  const Triangles &old_triangles = before->input.garment.triangles, &triangles = made_->input.garment.triangles;
  const bool same_mesh = old_triangles.rows() == triangles.rows() && old_triangles == triangles &&
                         before->scene.garment.grain == made_->scene.garment.grain;
  return same_mesh ? changeInPlace(*before) : changeMesh(*before);
}

std::string LiveRun::changeInPlace(const MadeGarment& before) {
  const std::vector<PinAnchor> anchors = pins_.anchors();
  const bool same_material = before.scene.material == made_->scene.material;
  const bool same_settings = same_material && shownLimit(before.scene) == shownLimit(made_->scene) &&
                             before.scene.collision.friction == made_->scene.collision.friction &&
                             before.scene.collision.offset == made_->scene.collision.offset;
  if (!same_material) {  // the rest shapes stay
    const RestShape first = cloth_->first(), rest = cloth_->rest();
    cloth_.emplace(made_->input.garment, made_->scene.garment.grain, made_->scene.material);
    cloth_->setFirst(first);
    cloth_->setRest(rest);
  }
  if (!same_settings) {
    const std::vector<Mat2> wanted = adaption_->wantedEdges();
    const Schedule on_the_way = settings_->schedule;
    makeStep();
    settings_->schedule = on_the_way;
    adaption_->resume(wanted);
  }
  const std::vector<double> more = paintBetween(paint_, made_->input.paint);
  if (!more.empty()) adaption_->rescale(more, kPaintIterations);
  paint_ = made_->input.paint;
  const bool meets_anew = !same_settings || before.input.offsets != made_->input.offsets;
  if (body_ && meets_anew) {
    if (largestOffset() > band_) {  // the level sets do not reach that far
      if (moving_ < way_steps_)
        leaveFor({bodyNow(), made_->input.poses[pose_]});
      else
        stand(bodyNow());
    } else {
      meetBody();
    }
  }
  setPins(anchors);
  measureStretch(*cloth_, state_.positions, stretch_);
  return "change taken in";
}

std::vector<double> LiveRun::paintedAreas() const {
  const std::vector<double> painted = paintBetween(first_paint_, paint_);
  std::vector<double> areas(cloth_->triangleCount());
  for (int t = 0; t < cloth_->triangleCount(); ++t)
    areas[t] = 0.5 * cloth_->first().edges[t].determinant() * (painted.empty() ? 1.0 : painted[t] * painted[t]);
  return areas;
}

std::string LiveRun::changeMesh(const MadeGarment& before) {
  std::vector<double> ratio = paintedAreas();
  for (int t = 0; t < cloth_->triangleCount(); ++t) ratio[t] = cloth_->restAreas()[t] / ratio[t];
  const TriangleMesh& mesh = made_->input.garment;
  const CarriedCloth carried =
      carryOver(before.input.garment, state_.positions, state_.velocities, ratio, mesh, buildTopology(mesh, "garment"));
  if (carried.tied < kEnoughTied * static_cast<double>(mesh.positions.rows())) {
    startOver();
    return "another garment: started over on the first pose";
  }
  const Schedule on_the_way = settings_->schedule;
  contacts_.reset();
  makeCloth();
  makeStep();
  settings_->schedule = on_the_way;
  if (std::any_of(carried.growth.begin(), carried.growth.end(), [](double g) { return std::abs(g - 1.0) > 1e-6; }))
    adaption_->rescale(carried.growth);
  state_ = {carried.positions, carried.velocities};
  if (body_) meetBody();
  setPins({});
  measureStretch(*cloth_, state_.positions, stretch_);
  return fmt::format("change taken in: where the old garment was, {:.0f} % of the new one, it keeps place and motion",
                     100.0 * static_cast<double>(carried.tied) / static_cast<double>(mesh.positions.rows()));
}

LiveFrame LiveRun::frame(bool all) {
  LiveFrame frame;
  frame.made = made_;
  frame.garment = state_.positions;
  frame.body = bodyNow();
  frame.rest = cloth_->restPositions();
  measureStretch(*cloth_, state_.positions, stretch_);
  frame.stretch = stretch_;
  frame.statistics = momentStatistics(stretch_, limit());
  for (int t = 0; t < cloth_->triangleCount(); ++t)
    frame.growth.push_back(cloth_->restAreas()[t] / (0.5 * cloth_->first().edges[t].determinant()));
  frame.let_out = let_out_ / sumOf(paintedAreas());
  if (all && contacts_) {
    contacts_->measure(contacts_->bodyAt(StepsDone{moving_, moving_, 0}), state_.positions);
    for (int v = 0; v < cloth_->vertexCount(); ++v)
      frame.gap.push_back(contacts_->distances()[v] - made_->input.offsets[v]);
    if (steps_ > 0) step_->potential().contactPressure(state_.positions, frame.pressure);
  }
  frame.deepest = std::max({penetration_.vertices, penetration_.edge_midpoints, penetration_.centroids});
  frame.steps = steps_;
  frame.time_s = static_cast<double>(steps_) * settings_->schedule.time_step;
  frame.pose = pose_;
  frame.way = way_steps_ > 0 ? static_cast<double>(moving_) / way_steps_ : 1.0;
  return frame;
}

}  // namespace ease
