#include "adaption/run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/error.h"
#include "solver/base/joined.h"
#include "solver/base/parallel.h"
#include "solver/base/stopwatch.h"

namespace ease {

namespace {

constexpr double kMinOffset = 1e-3;  // m: smaller comfort offsets count as this one in the contact's stiffness

Substeps substepsFor(const RunSettings& settings, const RunInput& input) {
  return chooseSubsteps(settings.schedule, input.body_motion, settings.comfort_offset);
}

}  // namespace

double contactStiffness(const RunSettings& settings, double body_speed, const Cloth& cloth) {
  double mass = 0.0, area = 0.0;
  for (double m : cloth.masses()) mass += m;
  for (double a : cloth.restAreas()) area += a;
  const double way = 0.5 * std::max(kMinOffset, settings.comfort_offset);
  return std::max(settings.contact_stiffness, mass / area * std::pow(body_speed / way, 2));
}

Run::Run(const RunSettings& settings, const RunInput& input, Cloth& cloth)
    : settings_(settings),
      input_(input),
      cloth_(cloth),
      ordering_(input.ordering.empty() ? systemOrdering(cloth.vertexCount(), cloth.triangles()) : input.ordering),
      part_s_(settings.schedule.time_step / substepsFor(settings, input).time),
      step_(cloth, settings.method, ordering_),
      state_{input.start, Positions::Zero(cloth.vertexCount(), 3)} {
  record_.substeps = substepsFor(settings, input);
  const double body_motion = input.body_motion / record_.substeps.time;
  record_.contact_stiffness = contactStiffness(settings, body_motion / part_s_, cloth);
  if (input.body)
    contacts_.emplace(*input.body, cloth, input.offsets, settings.schedule, record_.substeps,
                      kRecoverySpeed * part_s_ + body_motion);
  if (input.body) presence_.emplace(cloth, input.offsets);
  if (settings.limit && settings.schedule.adapt_every > 0) adaption_.emplace(cloth, *settings.limit, ordering_);
}

void Run::resume(const RunState& from) {
  resumed_from_ = from;
  state_ = from.cloth;
  cloth_.setRest(from.rest);
  if (adaption_) adaption_->resume(from.wanted_edges.empty() ? from.rest.edges : from.wanted_edges);
}

void Run::run(const RunWatch& watch) {
  const Stopwatch stopwatch(record_.times.total);
  begin(watch);
  for (const Moment& moment : timeline(settings_.schedule, done())) {
    if (watch.interrupted && *watch.interrupted) break;
    step(moment);
    if (moment.measured) measure(moment, watch);
    if (moment.adapts) adapt();
    tell(moment, watch);
    if (watch.on_step) watch.on_step(moment);
  }
  if (contacts_) record_.level_set_MB = static_cast<double>(input_.body->levelSetBytes()) / 1e6;
}

void Run::begin(const RunWatch& watch) {
  Positions body;
  if (contacts_) {
    contacts_->prepareFirst(done(), state_.positions);
    input_.body->positions(contacts_->bodyAt(done()), body);
  }
  pins_.set(input_.pins, resumed_from_ ? resumed_from_->pins : std::vector<PinAnchor>(), state_.positions, body,
            input_.body ? input_.body->triangles() : Triangles());
  if (presence_) presence_->tie(state_.positions, body, input_.body->triangles());
  if (resumed_from_) return;
  const Moment start = startMoment(settings_.schedule);
  measure(start, watch);
  tell(start, watch);
}

void Run::step(const Moment& moment) {
  try {
    for (int part = 1; part <= record_.substeps.time; ++part) {
      TaskBeside beside;
      if (contacts_) contacts_->prepareNext(moment, part, state_, part_s_, beside);
      stepPart(moment, part);
      beside.wait();
    }
  } catch (const ComputationError& error) {
    if (contacts_) contacts_->recordUse(record_);
    throw ComputationError(joined("time step ", moment.done.total, " (", moment.time_s, " s): ", error.what()));
  }
  if (contacts_) contacts_->recordUse(record_);
  ++record_.steps;
  if (moment.settles) ++record_.settle_steps;
}

void Run::stepPart(const Moment& moment, int part) {
  const Stopwatch stopwatch(record_.times.step);
  const StepOptions options{part_s_, settings_.gravity, record_.contact_stiffness, settings_.friction};
  if (!contacts_) {
    record_.solver += step_.step(state_, options, pins_.at(nullptr), [](const Positions&, Contacts&) {});
    return;
  }
  const double s = contacts_->bodyAt(moment, part);
  const std::optional<double> start =
      settings_.friction > 0.0 ? std::optional(contacts_->bodyAt(moment, part - 1)) : std::nullopt;
  const BodyMoment body = input_.body->at(s);
  record_.solver += step_.step(state_, options, pins_.at(&body),
                               [&](const Positions& x, Contacts& contacts) { contacts_->find(s, x, contacts, start); });
  contacts_->measureSinceFind(state_.positions);
  contacts_->deepen(record_.penetration);
}

void Run::measure(const Moment& moment, const RunWatch& watch) {
  const Stopwatch stopwatch(record_.times.adaption);
  measureStretch(cloth_, state_.positions, stretch_);
  const double limit = settings_.limit.value_or(std::numeric_limits<double>::infinity());
  const StretchStatistics statistics = momentStatistics(stretch_, limit);
  record_.stretch.add(statistics, moment.pose);
  Fastest now{0.0, moment.time_s, 0};
  now.speed_m_s = record_.final_speed_m_s = state_.velocities.rowwise().norm().maxCoeff(&now.vertex);
  if (now.speed_m_s > record_.fastest.speed_m_s) record_.fastest = now;
  if (watch.on_stretch) watch.on_stretch(stretch_);
  if (watch.on_measured) watch.on_measured({moment.time_s, statistics, now.speed_m_s});
  if (!contacts_) return;
  const double s = contacts_->bodyAt(moment.done);
  contacts_->measure(s, state_.positions);
  const BodyMoment body = input_.body->at(s);
  presence_->add(moment.time_s, state_.positions, body, contacts_->distances(), input_.body->band(),
                 [&](const Vec3& x) { return distanceTo(body, x); });
  record_.on_body = presence_->parts();
  if (moment.done.total == 0) return;
  contacts_->deepen(record_.penetration);
  contacts_->deepenLargeTriangles(s, state_.positions, record_.penetration);
}

void Run::adapt() {
  const Stopwatch stopwatch(record_.times.adaption);
  if (adaption_->adapt(stretch_)) ++record_.adaptions;
  record_.fully_grown = adaption_->fullyGrown();
}

void Run::tell(const Moment& moment, const RunWatch& watch) {
  const Stopwatch stopwatch(record_.times.output);
  const bool writes = moment.written && watch.on_frame, shows = moment.shown && watch.on_shown;
  if (writes || shows) {
    const Snapshot shot = snapshot(moment);
    if (shows) watch.on_shown(shot);
    if (writes) watch.on_frame(shot);
  }
  if (!moment.checkpoint || !watch.on_checkpoint) return;
  watch.on_checkpoint(stateToGoOn(moment));
  // From here on this run and one that goes on from the checkpoint must do the same to the last bit: what is remembered
  // only to be faster is forgotten.
  step_.forget();
  if (contacts_) contacts_->forget();
}

Snapshot Run::snapshot(const Moment& moment) {
  Snapshot shot{moment, cloth_, state_, stretch_, pins_.vertices(), {}, {}, {}};
  if (!contacts_) return shot;
  const BodyMoment body = input_.body->at(contacts_->bodyAt(moment.done));
  shot.gap.resize(cloth_.vertexCount());
  parallelFor(cloth_.vertexCount(), 64, [&](int v) {
    const double known = contacts_->distances()[v];
    shot.gap[v] = (known < input_.body->band() ? known : distanceTo(body, state_.positions.row(v))) - input_.offsets[v];
  });
  step_.potential().contactPressure(state_.positions, shot.pressure);
  input_.body->positions(contacts_->bodyAt(moment.done), shot.body);
  return shot;
}

RunState Run::stateToGoOn(const Moment& moment) const {
  return {moment.done, state_, cloth_.rest(), adaption_ ? adaption_->wantedEdges() : std::vector<Mat2>(),
          pins_.anchors()};
}

}  // namespace ease
