#include "collision/contacts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kGrain = 2048;
constexpr double kReach = 1e-3;           // m beyond the offset: planes that a correction of the step may yet meet
constexpr double kGive = 0.4;             // of the room there is: how far the cloth may easily sink in
constexpr double kLeastGive = 2e-4;       // m
constexpr double kExactBelow = 2e-3;      // m
constexpr double kFarthest = 0.1;         // m: nothing of the cloth is deeper in the body
constexpr double kStill = 1e-4;           // m: an error in the motion of the body too small for a second look
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

void ContactFinder::lookUp(const BodyMoment& body, std::span<const Vec3> samples, double near) {
  const int count = static_cast<int>(samples.size());
  if (found_.size() != samples.size()) found_.assign(count, {0.0, Vec3::Zero(), -1});
  // Where the surface near a sample came from: by the motion of the triangle that was nearest to it the last time.
  points_.resize(count);
  carried_.resize(count);
  carried_from_.resize(count);
  parallelFor(count, kGrain, [&](int s) {
    points_[s] = carried_[s] = samples[s];
    carried_from_[s] = found_[s].triangle;
    if (body.tau > 0.0 && found_[s].triangle >= 0) carried_[s] -= body.tau * motionOf(body, found_[s].triangle);
  });
  body.level_set->sample(carried_, found_);
  if (body.tau == 0.0) return;

  // Again where that is not how the surface near it moves.
  lookAhead(body, [&](int s, Vec3& point) {
    const int triangle = found_[s].triangle;
    if (triangle < 0 || triangle == carried_from_[s]) return false;
    point = points_[s] - body.tau * motionOf(body, triangle);
    const double off = (point - carried_[s]).norm();
    return off >= kStill && found_[s].phi <= near + off;
  });
  for (size_t c = 0; c < chosen_.size(); ++c) found_[chosen_[c]] = ahead_[c];
}

template <class Choose>
void ContactFinder::lookAhead(const BodyMoment& body, const Choose& choose) {
  const int count = static_cast<int>(points_.size());
  is_chosen_.resize(count);
  ahead_points_.resize(count);
  parallelFor(count, kGrain, [&](int s) { is_chosen_[s] = choose(s, ahead_points_[s]); });
  chosen_.clear();
  for (int s = 0; s < count; ++s)
    if (is_chosen_[s]) {
      ahead_points_[chosen_.size()] = ahead_points_[s];
      chosen_.push_back(s);
    }
  ahead_.resize(chosen_.size());
  body.level_set->sample(std::span(ahead_points_).first(chosen_.size()), ahead_);
}

void ContactFinder::distances(const BodyMoment& body, std::span<const Vec3> samples, std::vector<double>& distances) {
  lookUp(body, samples, std::numeric_limits<double>::infinity());
  distances.resize(samples.size());
  parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) {
    const LevelSetSample& found = found_[s];
    distances[s] = found.phi;
    if (found.phi > kExactBelow) return;
    const Vec3 motion = found.triangle < 0 ? Vec3(Vec3::Zero()) : motionOf(body, found.triangle);
    distances[s] = body.tree->signedDistance(points_[s] - body.tau * motion, kFarthest);
  });
}

void ContactFinder::distancesSinceFind(std::span<const Vec3> samples, std::vector<double>& distances) const {
  distances.resize(samples.size());
  parallelFor(static_cast<int>(samples.size()), kGrain,
              [&](int s) { distances[s] = found_[s].phi + found_[s].normal.dot(samples[s] - points_[s]); });
}

void Penetration::deepen(const std::vector<double>& sample_distances, int vertex_count, int edge_count) {
  for (int s = 0; s < static_cast<int>(sample_distances.size()); ++s) {
    double& deepest = s < vertex_count ? vertices : s < vertex_count + edge_count ? edge_midpoints : centroids;
    deepest = std::max(deepest, -sample_distances[s]);
  }
}

void ContactFinder::find(const BodyMoment& body, std::span<const Vec3> samples, std::span<const double> offsets,
                         double most_recovery, Contacts& contacts) {
  lookUp(body, samples, *std::max_element(offsets.begin(), offsets.end()) + kReach);
  contacts.planes.resize(samples.size());
  parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) {
    const LevelSetSample& here = found_[s];
    ContactPlane& plane = contacts.planes[s];
    plane = {};
    if (here.triangle < 0 || here.phi > offsets[s] + kReach) return;
    plane.normal = here.normal;
    plane.offset = here.normal.dot(points_[s]) + offsets[s] - here.phi;
    plane.give = std::max(kLeastGive, kGive * offsets[s]);
  });
  makeRoom(body, offsets, contacts);
  // No plane asks for more in one step than this: cloth that got too deep is moved out, not shot out.
  std::atomic<long> limited = 0;
  const auto limit = [&](int s, ContactPlane& plane) {
    const double excess = plane.depth(samples[s]) - most_recovery;
    if (excess <= 0.0) return;
    plane.offset -= excess;
    ++limited;
  };
  parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) { limit(s, contacts.planes[s]); });
  for (auto& [sample, plane] : contacts.seconds) limit(sample, plane);
  rescues_.limited += limited;
}

void ContactFinder::makeRoom(const BodyMoment& body, std::span<const double> offsets, Contacts& contacts) {
  // Samples that must move out by d = offset - phi: would they get there, or meet another part of the body?
  lookAhead(body, [&](int s, Vec3& point) {
    const LevelSetSample& here = found_[s];
    if (here.triangle < 0 || here.phi > offsets[s] - kRidgeTolerance) return false;
    point = points_[s] - body.tau * motionOf(body, here.triangle) + (offsets[s] - here.phi) * here.normal;
    return true;
  });
  contacts.seconds.clear();
  for (size_t c = 0; c < chosen_.size(); ++c) {
    const int s = chosen_[c];
    const LevelSetSample &here = found_[s], &there = ahead_[c];
    const double offset = offsets[s], d = offset - here.phi;
    if (there.triangle < 0 || there.phi > offset - kRidgeTolerance - 0.1 * d) continue;
    // How far the sample is from the other part now, which moves in its own way.
    const double along = here.normal.dot(there.normal);
    const Vec3 apart = body.tau * (motionOf(body, here.triangle) - motionOf(body, there.triangle));
    const double other = there.phi - d * along + there.normal.dot(apart);
    // The room for both planes: half of what there is between the parts, and what there is more of it an offset
    // further out, between the two.
    const double opening = std::sqrt(std::max(0.0, 0.5 * (1.0 + along)));
    const double room = std::clamp(0.5 * (here.phi + other) + offset * opening, 0.0, offset);
    const double give = std::max(kLeastGive, kGive * room);
    const Vec3& x = points_[s];
    ContactPlane& first = contacts.planes[s];
    first.offset = first.normal.dot(x) + room - here.phi;
    first.give = give;
    contacts.seconds.push_back({s, {there.normal, there.normal.dot(x) + room - other, give}});
    ++rescues_.held;
  }
}

}  // namespace ease
