// Finds contact planes between the cloth's samples and a moving body.
//
//   gap = phi(x - tau u) - offset, m
//
//   phi      signed distance to the body in the pose of the level set, m
//   u        motion of the body's surface near x from that pose to the next one, m
//   tau      how far the body has moved between the two poses, 0 to 1 (body_moment.h)
//   offset   comfort: the smallest distance that the garment keeps from the body, m
//
// Looking a point up at x - tau u carries the level set along with the body, so that one level set serves a pose and
// the time around it.
//
// Where two parts of the body are nearer to each other than twice the offset (an armpit), a single plane would push the
// cloth away from one part into the other, step after step.  There a sample gets a plane for each part.  If the parts
// face each other, no point is an offset away from both: both planes are then put halfway between them.
#pragma once

#include <span>
#include <vector>

#include "collision/body_moment.h"
#include "solver/model/contact.h"
#include "solver/model/samples.h"

namespace ease {

/// Distance of a point to the body's surface, m, without limit and without sign. Slow: for points beyond the level set.
double distanceTo(const BodyMoment& body, const Vec3& x);

/// Depth of a triangle's deepest point in the body, m, 0 outside: looked for in steps of at most `step` (m).
double depthOfTriangle(const BodyMoment& body, const Vec3& a, const Vec3& b, const Vec3& c, double step);

/// Largest depth of the cloth inside the body by kind of sample, m; 0 if no sample is inside.
struct Penetration {
  double vertices = 0.0, edge_midpoints = 0.0, centroids = 0.0;
  double triangles = 0.0;  // largest depth at any point of the cloth: the samples and the inside of large triangles
  /// Raises each depth to that of the deepest sample of its kind.  `sample_distances`: signed, one per sample, m.
  void deepen(const std::vector<double>& sample_distances, int vertex_count, int edge_count);
};

/// Counts, over all calls of find(), the samples whose plane does not simply lie the offset away from the body.
struct ContactRescues {
  long held = 0;     // samples between two parts of the body, which got a plane for each part
  long limited = 0;  // planes of samples too deep in the body to be moved out in one step
};

/// Finds contact planes and distances.  Remembers the body's triangle nearest to each sample as a starting guess.
class ContactFinder {
 public:
  /// Finds a plane, or two, for each sample that touches the body or nearly does.  `offsets`: one a sample, m.  No
  /// plane asks a sample to move out by more than `max_recovery` (m).  `start`: the body at the start of the step, from
  /// which its surface has moved (Contacts::motions); null: not needed.
  void find(const BodyMoment& body, std::span<const Vec3> samples, std::span<const double> offsets, double max_recovery,
            Contacts& contacts, const BodyMoment* start = nullptr);

  /// Computes the signed distance of each sample to the body, m; exact where it is below 2 mm.
  void distances(const BodyMoment& body, std::span<const Vec3> samples, std::vector<double>& distances);

  /// Cheap estimate of distances(): phi + normal . (x - x_0) from the last find(), which saw the sample at x_0.  Valid
  /// only right after a find() at the same moment, for samples that moved little since.
  void distancesSinceFind(std::span<const Vec3> samples, std::vector<double>& distances) const;

  /// Discards what earlier calls found, so that the next result does not depend on them.
  void discardHistory() { found_.clear(); }

  const ContactRescues& rescues() const { return rescues_; }

 private:
  /// Fills found_.  Samples further than `near` (m) from the body may keep an inexact result.
  void lookUp(const BodyMoment& body, std::span<const Vec3> samples, double near);
  /// Looks up at a second point each sample s for which choose(s, point) returns true and sets `point`.  Lists those
  /// samples in chosen_ and their results in ahead_.
  template <class Choose>
  void lookAhead(const BodyMoment& body, const Choose& choose);
  /// Adds a second plane to samples between two parts of the body, and moves both planes to the middle.
  void makeRoom(const BodyMoment& body, std::span<const double> offsets, Contacts& contacts, const BodyMoment* start);

  std::vector<LevelSetSample> found_, ahead_;
  std::vector<Vec3> points_;   // the samples, m
  std::vector<Vec3> carried_;  // the samples carried back to the pose of the level set, m
  std::vector<Vec3> ahead_points_;
  std::vector<int> carried_from_;  // triangle whose motion carried the sample back
  std::vector<char> is_chosen_;
  std::vector<int> chosen_;  // samples looked up at a second point
  ContactRescues rescues_;
};

}  // namespace ease
