#include "collision/contacts.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kGrain = 2048;
constexpr double kReach = 1e-3;           // m beyond the offset: corrections within a step may still meet these planes
constexpr double kGive = 0.4;             // depth to which contact is soft, as a share of the room that there is
constexpr double kMinGive = 2e-4;         // m: smallest such depth
constexpr double kExactBelow = 2e-3;      // m: smaller distances are computed from the triangles, not the level set
constexpr double kMaxDistance = 0.1;      // m: limit of that search; no cloth is deeper in the body
constexpr double kStill = 1e-4;           // m: smaller errors in the body's motion need no second lookup
constexpr double kRidgeTolerance = 2e-4;  // m: interpolation error of the level set, not to be taken for a ridge
constexpr double kMinShortfall = 0.1;     // share of the way out by which its end must be too near to be a second part

}  // namespace

void ContactFinder::lookUp(const BodyMoment& body, std::span<const Vec3> samples, double near) {
  const int count = static_cast<int>(samples.size());
  if (found_.size() != samples.size()) found_.assign(count, {0.0, Vec3::Zero(), -1});
  // Carry each sample back to the pose of the level set, by the motion of the triangle that was nearest to it last
  // time.
  points_.resize(count);
  carried_.resize(count);
  carried_from_.resize(count);
  parallelFor(count, kGrain, [&](int s) {
    points_[s] = carried_[s] = samples[s];
    carried_from_[s] = found_[s].triangle;
    if (body.tau > 0.0 && found_[s].triangle >= 0) carried_[s] -= body.tau * body.motionOfTriangle(found_[s].triangle);
  });
  body.level_set->sample(carried_, found_);
  if (body.tau == 0.0) return;

  // Repeat the lookup where another triangle turned out to be nearest and moves differently.
  lookAhead(body, [&](int s, Vec3& point) {
    const int triangle = found_[s].triangle;
    if (triangle < 0 || triangle == carried_from_[s]) return false;
    point = points_[s] - body.tau * body.motionOfTriangle(triangle);
    const double error = (point - carried_[s]).norm();
    return error >= kStill && found_[s].phi <= near + error;
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
    const Vec3 motion = found.triangle < 0 ? Vec3(Vec3::Zero()) : body.motionOfTriangle(found.triangle);
    distances[s] = body.tree->signedDistance(points_[s] - body.tau * motion, kMaxDistance);
  });
}

void ContactFinder::distancesSinceFind(std::span<const Vec3> samples, std::vector<double>& distances) const {
  distances.resize(samples.size());
  parallelFor(static_cast<int>(samples.size()), kGrain,
              [&](int s) { distances[s] = found_[s].phi + found_[s].normal.dot(samples[s] - points_[s]); });
}

double distanceTo(const BodyMoment& body, const Vec3& x) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const ClosestPoint near = body.tree->closest(x, kAny);
  if (near.triangle < 0 || body.tau == 0.0) return near.distance;
  const Vec3 carried = x - body.tau * body.motionOfTriangle(near.triangle);
  return body.tree->closest(carried, kAny, near.triangle).distance;
}

double depthOfTriangle(const BodyMoment& body, const Vec3& a, const Vec3& b, const Vec3& c, double step) {
  // Between two points the distance to the body changes by at most their distance. A point is therefore skipped if an
  // earlier one, at distance d from the body, is within d + deepest of it: it cannot be deeper than `deepest`.
  struct Measured {
    Vec3 at;
    double distance;  // m
  };
  constexpr int kKept = 32;
  std::array<Measured, kKept> measured;
  int count = 0;
  const double longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const int n = std::max(1, static_cast<int>(std::ceil(longest / step)));
  double deepest = 0.0;
  const auto isHigher = [&](const Vec3& x) {
    return std::any_of(measured.begin(), measured.begin() + std::min(count, kKept), [&](const Measured& m) {
      const double way = m.distance + deepest;
      return way > 0.0 && (x - m.at).squaredNorm() <= way * way;
    });
  };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const Vec3 x = a + (b - a) * (static_cast<double>(i) / n) + (c - a) * (static_cast<double>(j) / n);
      if (isHigher(x)) continue;
      Vec3 carried = x;
      if (body.tau > 0.0) {
        const ClosestPoint near = body.tree->closest(x, kMaxDistance);
        if (near.triangle >= 0) carried -= body.tau * body.motionOfTriangle(near.triangle);
      }
      const double distance = body.tree->signedDistance(carried, kMaxDistance);
      measured[count++ % kKept] = {x, distance};
      deepest = std::max(deepest, -distance);
    }
  return deepest;
}

void Penetration::deepen(const std::vector<double>& sample_distances, int vertex_count, int edge_count) {
  const auto deepest = [&](size_t begin, size_t end, double& depth) {
    for (size_t s = begin; s < end; ++s) depth = std::max(depth, -sample_distances[s]);
    triangles = std::max(triangles, depth);
  };
  const size_t edges = vertex_count, centroids_from = edges + edge_count;
  deepest(0, edges, vertices);
  deepest(edges, centroids_from, edge_midpoints);
  deepest(centroids_from, sample_distances.size(), centroids);
}

void ContactFinder::find(const BodyMoment& body, std::span<const Vec3> samples, std::span<const double> offsets,
                         double max_recovery, Contacts& contacts, const BodyMoment* start) {
  lookUp(body, samples, *std::max_element(offsets.begin(), offsets.end()) + kReach);
  contacts.planes.resize(samples.size());
  parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) {
    const LevelSetSample& nearest = found_[s];
    ContactPlane& plane = contacts.planes[s];
    plane = {};
    if (nearest.triangle < 0 || nearest.phi > offsets[s] + kReach) return;
    plane.normal = nearest.normal;
    plane.offset = nearest.normal.dot(points_[s]) + offsets[s] - nearest.phi;
    plane.give = std::max(kMinGive, kGive * offsets[s]);
  });
  contacts.motions.clear();
  if (start) {
    contacts.motions.resize(samples.size(), Vec3::Zero());
    parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) {
      if (!contacts.planes[s].normal.isZero(0.0))
        contacts.motions[s] = carriedMotion(points_[s], found_[s].triangle, *start, body);
    });
  }
  makeRoom(body, offsets, contacts, start);
  // Limit how far a step moves a sample out, so that cloth deep in the body is not thrown out.
  std::atomic<long> limited = 0;
  const auto limit = [&](int s, ContactPlane& plane) {
    const double excess = plane.depth(samples[s]) - max_recovery;
    if (excess <= 0.0) return;
    plane.offset -= excess;
    ++limited;
  };
  parallelFor(static_cast<int>(samples.size()), kGrain, [&](int s) { limit(s, contacts.planes[s]); });
  for (Contacts::Second& second : contacts.seconds) limit(second.sample, second.plane);
  rescues_.limited += limited;
}

void ContactFinder::makeRoom(const BodyMoment& body, std::span<const double> offsets, Contacts& contacts,
                             const BodyMoment* start) {
  // Look ahead from each sample that must move out by d = offset - phi: is the end of that way clear of other parts?
  lookAhead(body, [&](int s, Vec3& point) {
    const LevelSetSample& nearest = found_[s];
    if (nearest.triangle < 0 || nearest.phi > offsets[s] - kRidgeTolerance) return false;
    point =
        points_[s] - body.tau * body.motionOfTriangle(nearest.triangle) + (offsets[s] - nearest.phi) * nearest.normal;
    return true;
  });
  contacts.seconds.clear();
  for (size_t c = 0; c < chosen_.size(); ++c) {
    const int s = chosen_[c];
    const LevelSetSample &nearest = found_[s], &ahead = ahead_[c];
    const double offset = offsets[s], d = offset - nearest.phi;
    if (ahead.triangle < 0 || ahead.phi > offset - kRidgeTolerance - kMinShortfall * d) continue;
    // Distance of the sample, where it is now, from the other part, which has a motion of its own.
    const double along = nearest.normal.dot(ahead.normal);
    const Vec3 apart = body.tau * (body.motionOfTriangle(nearest.triangle) - body.motionOfTriangle(ahead.triangle));
    const double other = ahead.phi - d * along + ahead.normal.dot(apart);
    // Room for each plane: half the space between the parts here, plus what half the space grows by an offset further
    // out along the bisector of the two normals.
    const double opening = std::sqrt(std::max(0.0, 0.5 * (1.0 + along)));
    const double room = std::clamp(0.5 * (nearest.phi + other) + offset * opening, 0.0, offset);
    const double give = std::max(kMinGive, kGive * room);
    const Vec3& x = points_[s];
    ContactPlane& first = contacts.planes[s];
    first.offset = first.normal.dot(x) + room - nearest.phi;
    first.give = give;
    contacts.seconds.push_back({s, {ahead.normal, ahead.normal.dot(x) + room - other, give}});
    if (start) contacts.motions.push_back(carriedMotion(x, ahead.triangle, *start, body));
    ++rescues_.held;
  }
}

}  // namespace ease
