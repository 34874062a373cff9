#include "adaption/body_contacts.h"

#include <algorithm>
#include <cmath>

namespace ease {

namespace {

constexpr double kLargeTriangle = 0.025;  // m: the samples of smaller ones lie within 1.3 cm of each other
constexpr double kDepthStep = 0.005;      // m: between points of large triangles at which the depth is measured

}  // namespace

BodyContacts::BodyContacts(MovingBody& body, const Cloth& cloth, std::span<const double> offsets,
                           const Schedule& schedule, const Substeps& substeps, double max_recovery)
    : body_(body),
      times_before_(body.times()),
      voxels_before_(body.voxelsOnDemand()),
      cloth_(cloth),
      parts_(substeps.time),
      parts_per_shape_(schedule.steps_per_pose * substeps.time / substeps.interpolation),
      moving_parts_(schedule.poses > 1 ? timeStepsOfMotion(schedule) * schedule.cycles * substeps.time : 0),
      max_recovery_(max_recovery) {
  cloth.samples().values(offsets, offsets_);
}

int BodyContacts::partNumber(const Moment& moment, int part) const {
  return moment.moves ? (moment.done.moving - 1) * parts_ + part : moment.done.moving * parts_;
}

int BodyContacts::shapeAt(int part_number) const {
  return static_cast<int>(std::lround(part_number / static_cast<double>(parts_per_shape_)));
}

double BodyContacts::bodyAt(const Moment& moment, int part) const {
  return partNumber(moment, part) / static_cast<double>(parts_per_shape_);
}

double BodyContacts::bodyAt(const StepsDone& done) const {
  return done.moving * parts_ / static_cast<double>(parts_per_shape_);
}

void BodyContacts::prepareFirst(const StepsDone& done, const Positions& x) {
  const int now = done.moving * parts_, next = std::max(now, std::min(now + 1, moving_parts_));
  samplesAt(x);
  for (int k = shapeAt(now); k <= shapeAt(next); ++k) body_.prepare(k, samples_);
}

void BodyContacts::prepareNext(const Moment& moment, int part, const State& state, double part_s, TaskBeside& beside) {
  const int now = partNumber(moment, part), next = std::min(now + 1, moving_parts_);
  if (!moment.moves || shapeAt(next) == shapeAt(now)) return;
  // Where the samples will be, at their present velocity, half-way through the use of that level set.
  const double ahead_s = part_s * (1.0 + 0.5 * parts_per_shape_);
  cloth_.samples().positions(state.positions + ahead_s * state.velocities, expected_samples_);
  beside.run([this, k = shapeAt(next)] { body_.prepare(k, expected_samples_); });
}

void BodyContacts::find(double s, const Positions& x, Contacts& contacts, std::optional<double> start) {
  BodyMoment before{};
  if (start) before = body_.at(*start);
  finder_.find(body_.at(s), samplesAt(x), offsets_, max_recovery_, contacts, start ? &before : nullptr);
}

void BodyContacts::measure(double s, const Positions& x) {
  finder_.distances(body_.at(s), samplesAt(x), distances_);
}

void BodyContacts::measureSinceFind(const Positions& x) {
  finder_.distancesSinceFind(samplesAt(x), distances_);
}

void BodyContacts::deepen(Penetration& penetration) const {
  penetration.deepen(distances_, cloth_.vertexCount(), static_cast<int>(cloth_.topology().edges.size()));
}

void BodyContacts::deepenLargeTriangles(double s, const Positions& x, Penetration& penetration) {
  const BodyMoment body = body_.at(s);
  const Triangles& triangles = cloth_.triangles();
  std::vector<double> depths(triangles.rows(), 0.0);
  parallelFor(static_cast<int>(triangles.rows()), 64, [&](int t) {
    const Vec3 a = x.row(triangles(t, 0)), b = x.row(triangles(t, 1)), c = x.row(triangles(t, 2));
    const double longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    const double nearest = distances_[cloth_.samples().centroid(t)];
    // No point of the triangle is further than its longest side from the centroid; beyond the band nothing is known.
    if (longest > kLargeTriangle && (nearest < longest || nearest >= body_.band()))
      depths[t] = depthOfTriangle(body, a, b, c, kDepthStep);
  });
  for (const double depth : depths) penetration.triangles = std::max(penetration.triangles, depth);
}

void BodyContacts::recordUse(PassRecord& record) const {
  record.times.interpolation = body_.times().interpolation_s - times_before_.interpolation_s;
  record.times.level_set = body_.times().level_set_s - times_before_.level_set_s;
  record.voxels_on_demand = body_.voxelsOnDemand() - voxels_before_;
  record.contact = finder_.rescues();
}

std::span<const Vec3> BodyContacts::samplesAt(const Positions& x) {
  cloth_.samples().positions(x, samples_);
  return samples_;
}

}  // namespace ease
