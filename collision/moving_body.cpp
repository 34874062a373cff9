#include "collision/moving_body.h"

#include <cassert>
#include <chrono>
#include <cmath>

#include "solver/base/stopwatch.h"

namespace ease {

namespace {

/// Number of the interpolated pose nearest to s.
int nearestPose(double s) {
  return static_cast<int>(std::lround(s));
}

constexpr size_t kMaxKnownBytes = 400'000'000;
constexpr double kMarginVoxels = 0.4;  // how far samples move away from the points a level set was prepared around

}  // namespace

MovingBody::MovingBody(const Triangles& triangles, const std::vector<Positions>& poses, int steps,
                       const LevelSetOptions& options, std::shared_ptr<const InterpolatedPoses> way)
    : triangles_(triangles),
      steps_(steps),
      margin_(kMarginVoxels * options.voxel),
      band_(options.band),
      first_(poses.front()),
      way_(way ? std::move(way) : std::make_shared<const InterpolatedPoses>(triangles, poses)) {
  for (int i = 0; i < 2; ++i) prepared_.push_back({TriangleTree(first_, triangles_), LevelSet(options)});
  known_.resize(motionSteps() + 1);
}

int MovingBody::folded(int k) const {
  const int n = motionSteps();
  if (n == 0) return 0;
  const int once = std::abs(k) % (2 * n);
  return once <= n ? once : 2 * n - once;
}

void MovingBody::interpolate(int k) {
  Slot& slot = poses_[(k + 4) % 4];
  const int folded_k = folded(k);
  if (slot.k == folded_k && slot.positions.rows() > 0) return;
  slot.k = folded_k;
  const std::vector<PoseInterpolation>& interpolations = way_->interpolations;
  if (interpolations.empty()) {
    slot.positions = first_;
    return;
  }
  const int pair = std::min(folded_k / steps_, static_cast<int>(interpolations.size()) - 1);
  interpolations[pair].at(static_cast<double>(folded_k - pair * steps_) / steps_, slot.positions);
}

const Positions& MovingBody::pose(int k) const {
  const Slot& slot = poses_[(k + 4) % 4];
  assert(slot.k == folded(k));
  return slot.positions;
}

void MovingBody::prepare(int k, std::span<const Vec3> points) {
  auto start = std::chrono::steady_clock::now();
  for (int i = k - 1; i <= k + 1; ++i) interpolate(i);
  times_.interpolation_s += secondsSince(start);

  start = std::chrono::steady_clock::now();
  Prepared& prepared = prepared_[k % 2];
  voxels_on_demand_ += prepared.level_set.filledOnDemand();
  remember(prepared);
  prepared.k = folded(k);
  prepared.tree.refit(pose(k));
  prepared.level_set.build(prepared.tree, points, margin_, known_[prepared.k]);
  times_.level_set_s += secondsSince(start);
}

void MovingBody::remember(const Prepared& prepared) {
  if (prepared.k < 0 || motionSteps() == 0) return;
  KnownCorners& known = known_[prepared.k];
  if (prepared.level_set.filledVoxels() == std::ssize(known.values)) return;
  KnownCorners grown = prepared.level_set.known();
  const size_t bytes = known_bytes_ - known.memoryBytes() + grown.memoryBytes();
  if (bytes > kMaxKnownBytes) return;
  known_bytes_ = bytes;
  known = std::move(grown);
}

BodyMoment MovingBody::motionAt(double s) const {
  const int k = nearestPose(s);
  const double tau = s - k;
  return {nullptr, nullptr, &triangles_, &pose(k), &pose(tau < 0.0 ? k - 1 : k + 1), std::abs(tau)};
}

BodyMoment MovingBody::at(double s) {
  BodyMoment moment = motionAt(s);
  Prepared& prepared = prepared_[nearestPose(s) % 2];
  moment.level_set = &prepared.level_set;
  moment.tree = &prepared.tree;
  return moment;
}

void MovingBody::positions(double s, Positions& x) const {
  motionAt(s).positions(x);
}

long MovingBody::voxelsOnDemand() const {
  long voxels = voxels_on_demand_;
  for (const Prepared& prepared : prepared_) voxels += prepared.level_set.filledOnDemand();
  return voxels;
}

size_t MovingBody::levelSetBytes() const {
  size_t bytes = 0;
  for (const Prepared& prepared : prepared_) bytes += prepared.level_set.memoryBytes();
  return bytes;
}

}  // namespace ease
