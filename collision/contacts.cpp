#include "collision/contacts.h"

#include <limits>

#include "solver/linear/parallel.h"

namespace ease {

namespace {

constexpr int kGrain = 2048;
constexpr double kReach = 2e-3;           // m beyond the offset: planes that a correction of the step may yet meet
constexpr double kGive = 0.4;             // of the room there is: how far the cloth may easily sink in
constexpr double kLeastGive = 2e-4;       // m
constexpr double kExactBelow = 2e-3;      // m
constexpr double kFarthest = 0.1;         // m: nothing of the cloth is deeper in the body
constexpr double kStill = 1e-5;           // m: motion of the body too small to be worth a second look
constexpr double kRidgeTolerance = 2e-4;  // m: error of the level set's interpolation, not to be taken for a ridge

// Motion of the body's triangle from the pose of the level set towards the other, m.
Vec3 motionOf(const BodyMoment& body, int triangle) {
  Vec3 motion = Vec3::Zero();
  for (int a = 0; a < 3; ++a) {
    const int v = (*body.triangles)(triangle, a);
    motion += (body.towards->row(v) - body.at->row(v)).transpose();
  }
  return motion / 3.0;
}

}  // namespace

void sampleCloth(const Positions& x, const Triangles& triangles, const std::vector<Edge>& edges,
                 std::vector<Vec3>& samples) {
  const int n = static_cast<int>(x.rows()), e = static_cast<int>(edges.size());
  samples.resize(n + e + triangles.rows());
  parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) {
    if (s < n) {
      samples[s] = x.row(s);
    } else if (s < n + e) {
      const auto [i, j] = edges[s - n].vertex;
      samples[s] = 0.5 * (x.row(i) + x.row(j));
    } else {
      const int t = s - n - e;
      samples[s] = (x.row(triangles(t, 0)) + x.row(triangles(t, 1)) + x.row(triangles(t, 2))) / 3.0;
    }
  });
}

void ContactFinder::lookUp(const BodyMoment& body, std::span<const Vec3> samples, double near) {
  found_.resize(samples.size());
  body.level_set->sample(samples, found_);
  if (body.tau == 0.0) return;

  // The body has moved on: look again at where the surface near a sample came from.
  chosen_.clear();
  chosen_points_.clear();
  for (int s = 0; s < static_cast<int>(samples.size()); ++s) {
    if (found_[s].triangle < 0) continue;
    const Vec3 motion = body.tau * motionOf(body, found_[s].triangle);
    const double moved = motion.norm();
    if (moved < kStill || found_[s].phi > near + moved) continue;
    chosen_.push_back(s);
    chosen_points_.push_back(samples[s] - motion);
  }
  ahead_.resize(chosen_.size());
  body.level_set->sample(chosen_points_, ahead_);
  for (size_t k = 0; k < chosen_.size(); ++k) found_[chosen_[k]] = ahead_[k];
}

void ContactFinder::distances(const BodyMoment& body, std::span<const Vec3> samples, std::vector<double>& distances) {
  lookUp(body, samples, std::numeric_limits<double>::infinity());
  distances.resize(samples.size());
  parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) {
    distances[s] = found_[s].phi;
    if (found_[s].triangle < 0 || found_[s].phi > kExactBelow) return;
    distances[s] = body.tree->signedDistance(samples[s] - body.tau * motionOf(body, found_[s].triangle), kFarthest);
  });
}

void ContactFinder::distancesSinceFind(std::span<const Vec3> samples, std::vector<double>& distances) const {
  distances.resize(samples.size());
  for (size_t s = 0; s < samples.size(); ++s)
    distances[s] = found_[s].phi + found_[s].normal.dot(samples[s] - found_at_[s]);
}

void Penetration::deepen(const std::vector<double>& sample_distances, int vertex_count, int edge_count) {
  for (int s = 0; s < static_cast<int>(sample_distances.size()); ++s) {
    double& deepest = s < vertex_count ? vertices : s < vertex_count + edge_count ? edge_midpoints : centroids;
    deepest = std::max(deepest, -sample_distances[s]);
  }
}

void ContactFinder::find(const BodyMoment& body, std::span<const Vec3> samples, double offset, double most_recovery,
                         std::vector<ContactPlane>& planes) {
  lookUp(body, samples, offset + kReach);
  found_at_.assign(samples.begin(), samples.end());
  planes.resize(samples.size());
  parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) {
    const LevelSetSample& here = found_[s];
    planes[s] = {};
    if (here.triangle < 0 || here.phi > offset + kReach) return;
    planes[s].normal = here.normal;
    planes[s].offset = here.normal.dot(samples[s]) + offset - here.phi;
    planes[s].give = std::max(kLeastGive, kGive * offset);
  });
  makeRoom(body, samples, offset, planes);
  // No plane asks for more in one step than this: cloth that got too deep is moved out, not shot out.
  for (size_t s = 0; s < samples.size(); ++s) {
    const double excess = planes[s].depth(samples[s]) - most_recovery;
    if (excess <= 0.0) continue;
    planes[s].offset -= excess;
    ++rescues_.limited;
  }
}

void ContactFinder::makeRoom(const BodyMoment& body, std::span<const Vec3> samples, double offset,
                             std::vector<ContactPlane>& planes) {
  // Samples that must move out by d = offset - phi: would they get there, or meet another part of the body?
  chosen_.clear();
  chosen_points_.clear();
  for (int s = 0; s < static_cast<int>(samples.size()); ++s) {
    const LevelSetSample& here = found_[s];
    if (here.triangle < 0 || here.phi > offset - kRidgeTolerance) continue;
    chosen_.push_back(s);
    chosen_points_.push_back(samples[s] - body.tau * motionOf(body, here.triangle) + (offset - here.phi) * here.normal);
  }
  ahead_.resize(chosen_.size());
  body.level_set->sample(chosen_points_, ahead_);
  for (size_t k = 0; k < chosen_.size(); ++k) {
    const LevelSetSample &here = found_[chosen_[k]], &there = ahead_[k];
    const double d = offset - here.phi;
    if (there.phi > offset - kRidgeTolerance - 0.1 * d) continue;
    // Along the normal the distance to this part grows by 1, that to the other one by c <= 0: where do they meet?  Not
    // before the surface, which is -phi away.  Near the middle itself the normal may point along it, c > 0: with
    // c = 0 the way is what distance there is to gain.
    const double c = std::min(0.0, there.normal.dot(here.normal));
    const double middle = (there.phi - d * c - here.phi) / (1.0 - c);
    const double way = std::clamp(middle, std::max(0.0, -here.phi), d);
    planes[chosen_[k]].offset += way - d;
    planes[chosen_[k]].give = std::max(kLeastGive, kGive * (here.phi + way));
    planes[chosen_[k]].held = true;
    ++rescues_.held;
  }
}

}  // namespace ease
