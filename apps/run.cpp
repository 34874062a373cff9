#include "apps/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "adaption/clip.h"
#include "adaption/stitch.h"
#include "apps/frames.h"
#include "apps/garment_pins.h"
#include "garment/paint.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"
#include "solver/base/stopwatch.h"

namespace ease {

namespace {

constexpr double kRecoverySpeed = 4.0;    // m/s: at most, of cloth that got too near to the body, beside the body's own
constexpr double kBeyondComfort = 0.025;  // m: level sets are exact this far beyond the largest comfort offset
constexpr double kLeastWay = 1e-3;        // m: of cloth that the body meets, however small the offset

MethodOptions methodOptions(const SolverScene& solver) {
  return {methodNamed(solver.method), solver.tolerance, solver.residual, solver.iterations};
}

/// N/m^3.  As the scene says, and at least what brings cloth at rest to the body's speed v within half the offset d:
/// 1/2 k (d/2)^2 >= 1/2 rho v^2.
double contactStiffness(const Scene& scene, const SceneInput& input, const Cloth& cloth) {
  double mass = 0.0, area = 0.0;
  for (double m : cloth.masses()) mass += m;
  for (double a : cloth.restAreas()) area += a;
  const double speed = bodyMotionOfStep(scene, input) / scene.solver.time_step;
  const double way = 0.5 * std::max(kLeastWay, scene.collision.offset);
  return std::max(scene.collision.stiffness, mass / area * std::pow(speed / way, 2));
}

class Run {
 public:
  Run(const Scene& scene, const SceneInput& input, MovingBody* body, Cloth& cloth, const RunOptions& options,
      State& state, PassRecord& record)
      : scene_(scene),
        input_(input),
        body_(body),
        cloth_(cloth),
        options_(options),
        state_(state),
        record_(record),
        ordering_(systemOrdering(cloth.vertexCount(), cloth.triangles())),
        step_(cloth, methodOptions(scene.solver), ordering_),
        vertex_count_(cloth.vertexCount()),
        edge_count_(static_cast<int>(cloth.topology().edges.size())),
        most_recovery_(kRecoverySpeed * scene.solver.time_step + bodyMotionOfStep(scene, input)),
        contact_stiffness_(contactStiffness(scene, input, cloth)) {
    if (!options.adapting || !scene.adaption) return;
    clip_.emplace(cloth, scene.adaption->limit);
    stitcher_.emplace(cloth, ordering_);
  }

  void operator()() {
    const int parts = record_.division.time_steps;
    const StepsDone before = options_.from ? options_.from->done : StepsDone();
    const StepsDone done{before.all * parts, before.moving * parts, before.still * parts};
    const std::vector<Moment> moments = timeline(scene_, options_.adapting, done);
    const double body = done.moving / static_cast<double>(scene_.solver.steps_per_pose);
    record_.contact_stiffness = contact_stiffness_;
    begin(body, moments.empty() ? body : moments.front().body);
    for (const Moment& moment : moments) {
      if (options_.interrupted && *options_.interrupted) return;
      try {
        advance(moment);
      } catch (const ComputationError& error) {
        throw ComputationError(
            fmt::format("time step {} ({:.4f} s): {}", (moment.done.all - 1) / parts + 1, moment.time_s, error.what()));
      }
      if (moment.measured) measure(moment);
      if (moment.adapts) adapt();
      if (moment.written && options_.series) write(moment);
      if (moment.kept && options_.keep) keep(moment);
      if (options_.on_step) options_.on_step(moment);
    }
  }

 private:
  /// `body` and `next_body`: s now and after the first step.
  void begin(double body, double next_body) {
    state_ = {input_.garment.positions, Positions::Zero(vertex_count_, 3)};
    if (options_.from) goOn(*options_.from);
    if (body_) {
      sampleOffsets(input_.offsets, cloth_.triangles(), cloth_.topology().edges, sample_offsets_);
      sampleCloth(state_.positions, cloth_.triangles(), cloth_.topology().edges, samples_);
      for (long k = std::lround(body); k <= std::lround(next_body); ++k) body_->prepare(static_cast<int>(k), samples_);
    }
    pin(body);
    if (options_.from) return;
    const Moment start{{}, 0.0, 0.0, -1, body_ ? 0 : -1, false, false, true, options_.series != nullptr, false};
    measure(start);
    if (options_.series) write(start);
    if (options_.keep) keep(start);
  }

  void goOn(const Checkpoint& from) {
    state_ = from.state;
    std::optional<Stitcher> for_paint;
    Stitcher& stitcher = stitcher_ ? *stitcher_ : for_paint.emplace(cloth_, ordering_);  // of the first rest shape
    cloth_.setRest(from.rest.positions, from.rest.edges);
    stitcher.restore(from.wanted_edges.empty() ? from.rest.edges : from.wanted_edges);
    if (const auto more = paintBetween(from.paint, input_.paint); !more.empty()) stitcher.rescale(cloth_, more);
  }

  /// Where vertices are pinned that a run before did not pin: on the first pose, or where they are while going on.
  void pin(double body) {
    Positions surface;
    if (body_) body_->positions(body, surface);
    pins_.set(scene_, input_, options_.from ? options_.from->pins : std::vector<PinAnchor>(), state_.positions,
              surface);
  }

  void keep(const Moment& moment) {
    const Stopwatch watch(record_.output_s);
    const int parts = record_.division.time_steps;
    Checkpoint checkpoint;
    checkpoint.done = {moment.done.all / parts, moment.done.moving / parts, moment.done.still / parts};
    checkpoint.time_step_s = scene_.solver.time_step * parts;
    checkpoint.steps_per_pose = scene_.solver.steps_per_pose * record_.division.interpolation_steps / parts;
    checkpoint.interpolation_steps = scene_.body ? scene_.body->steps / record_.division.interpolation_steps : 0;
    checkpoint.state = state_;
    checkpoint.paint = input_.paint;
    checkpoint.rest = {cloth_.restPositions(), cloth_.restEdges()};
    if (stitcher_) checkpoint.wanted_edges = stitcher_->wanted();
    checkpoint.pins = pins_.anchors();
    options_.keep(std::move(checkpoint));
    step_.forget();
    contacts_.discardHistory();
  }

  void advance(const Moment& moment) {
    TaskBeside ahead;
    if (moment.next_level_set >= 0) {
      // Where the samples will be, by the body's clock, while that level set is in use.
      const double until = scene_.solver.time_step * (1.0 + 0.5 * scene_.solver.steps_per_pose);
      sampleCloth(state_.positions + until * state_.velocities, cloth_.triangles(), cloth_.topology().edges,
                  expected_samples_);
      ahead.run([&] { body_->prepare(moment.next_level_set, expected_samples_); });
    }
    takeStep(moment);
    ahead.wait();
  }

  void takeStep(const Moment& moment) {
    const Stopwatch watch(record_.step_s);
    const StepOptions options{scene_.solver.time_step, scene_.solver.gravity, contact_stiffness_};
    const StepSummary step = step_.step(state_, options, pinsAt(moment), [&](const Positions& x, Contacts& contacts) {
      findContacts(moment, x, contacts);
    });
    if (moment.done.all % record_.division.time_steps == 0) {
      ++record_.steps;
      if (moment.settles) ++record_.settle_steps;
    }
    record_.contact = contacts_.rescues();
    record_.newton_iterations += step.newton_iterations;
    record_.projective_iterations += step.projective_iterations;
    record_.contact_rounds += step.contact_rounds;
    record_.handed_over += step.handed_over ? 1 : 0;
    record_.cg_iterations += step.cg_iterations;
    record_.factorisations += step.factorisations;
    record_.halvings += step.halvings;
    record_.short_of_tolerance += step.converged ? 0 : 1;
    if (body_) {
      sampleCloth(state_.positions, cloth_.triangles(), cloth_.topology().edges, samples_);
      contacts_.distancesSinceFind(samples_, distances_);
      record_.penetration.deepen(distances_, vertex_count_, edge_count_);
    }
  }

  const Pins& pinsAt(const Moment& moment) {
    if (!body_) return pins_.at(nullptr);
    const BodyMoment body = body_->at(moment.body);
    return pins_.at(&body);
  }

  void findContacts(const Moment& moment, const Positions& x, Contacts& contacts) {
    if (!body_) return;
    sampleCloth(x, cloth_.triangles(), cloth_.topology().edges, samples_);
    contacts_.find(body_->at(moment.body), samples_, sample_offsets_, most_recovery_, contacts);
  }

  void measure(const Moment& moment) {
    const Stopwatch watch(record_.adaption_s);
    measureStretch(cloth_, state_.positions, stretch_);
    const double limit = scene_.adaption ? scene_.adaption->limit : std::numeric_limits<double>::infinity();
    const StretchStatistics statistics = stretchStatistics(firstStretches(stretch_), limit);
    record_.stretch.measured(statistics);
    if (moment.pose >= 0) {
      record_.stretch.poses.resize(std::max<size_t>(record_.stretch.poses.size(), moment.pose + 1));
      record_.stretch.poses[moment.pose] = statistics;
    }
    record_.final_speed_m_s = state_.velocities.rowwise().norm().maxCoeff();
    if (!body_) return;
    sampleCloth(state_.positions, cloth_.triangles(), cloth_.topology().edges, samples_);
    contacts_.distances(body_->at(moment.body), samples_, distances_);
    if (moment.done.all > 0) record_.penetration.deepen(distances_, vertex_count_, edge_count_);
  }

  void adapt() {
    const Stopwatch watch(record_.adaption_s);
    const bool grows = clip_->clip(cloth_, stretch_, growth_);
    record_.fully_grown = clip_->fullyGrown();
    if (!grows) return;
    stitcher_->stitch(cloth_, growth_);
    ++record_.adaptions;
  }

  void write(const Moment& moment) {
    const Stopwatch watch(record_.output_s);
    gap_.clear();
    if (body_) {
      gap_.assign(distances_.begin(), distances_.begin() + vertex_count_);
      for (int v = 0; v < vertex_count_; ++v) gap_[v] -= input_.offsets[v];
      step_.potential().contactPressure(state_.positions, pressure_);
      Frame body_frame;
      body_->positions(moment.body, body_frame.positions);
      options_.series->writeBody(moment.time_s, body_frame);
    }
    const GarmentFields fields{stretch_, *options_.first_areas, gap_, pressure_, pins_.vertices()};
    options_.series->write(moment.time_s, garmentFrame(cloth_, state_, fields),
                           restFrame(cloth_, *options_.first_areas));
  }

  const Scene& scene_;
  const SceneInput& input_;
  MovingBody* body_;
  Cloth& cloth_;
  const RunOptions& options_;
  State& state_;
  PassRecord& record_;

  std::vector<int> ordering_;  // of all systems on the garment's mesh
  TimeStep step_;
  ContactFinder contacts_;
  std::optional<StretchClip> clip_;
  std::optional<Stitcher> stitcher_;
  int vertex_count_, edge_count_;
  double most_recovery_;      // m in a time step
  double contact_stiffness_;  // N/m^3
  GarmentPins pins_;
  std::vector<Vec3> samples_, expected_samples_;
  std::vector<double> sample_offsets_, distances_, gap_, pressure_;
  std::vector<Stretch> stretch_;
  std::vector<Mat2> growth_;
};

}  // namespace

MovingBody movingBody(const Scene& scene, const SceneInput& input) {
  const Scene fine = divided(scene, divisionFor(scene, input));
  const double largest_offset = *std::max_element(input.offsets.begin(), input.offsets.end());
  return MovingBody(input.body_triangles, input.poses, fine.body->steps,
                    LevelSetOptions{scene.collision.voxel, kBeyondComfort + largest_offset});
}

void runMotion(const Scene& scene, const SceneInput& input, MovingBody* body, Cloth& cloth, const RunOptions& options,
               State& state, PassRecord& record) {
  const Stopwatch watch(record.wall_s);
  const MovingBody::Times before = body ? body->times() : MovingBody::Times();
  const long voxels_before = body ? body->voxelsOnDemand() : 0;
  const auto finish = [&] {
    if (!body) return;
    record.voxels_on_demand = body->voxelsOnDemand() - voxels_before;
    record.interpolation_s = body->times().interpolation_s - before.interpolation_s;
    record.level_set_s = body->times().level_set_s - before.level_set_s;
    record.level_set_MB = static_cast<double>(body->levelSetBytes()) / 1e6;
  };
  record.division = divisionFor(scene, input);
  const Scene fine = divided(scene, record.division);
  RunOptions fine_options = options;
  if (options.on_step)
    fine_options.on_step = [&](const Moment& moment) {
      if (moment.done.all % record.division.time_steps == 0) options.on_step(moment);
    };
  Run one(fine, input, body, cloth, fine_options, state, record);
  try {
    one();
  } catch (...) {
    finish();
    throw;
  }
  finish();
}

}  // namespace ease
