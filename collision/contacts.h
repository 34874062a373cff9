// Contacts of a cloth with the level set of a moving body.
//
//   gap = phi(x) - offset, m     offset: comfort, the least distance that the garment keeps from the body there
//
// A level set stands for its pose; between poses it is carried along with the body's motion: at time tau after it, a
// point x is looked up where the body's surface near it came from, x - tau u.
//
// Where two parts of the body are nearer to each other than twice the offset (an armpit), a plane of one of them would
// throw the cloth into the other one, step after step.  There a sample has a plane of each.  If the parts face each
// other, no point is an offset away from both: both planes are then put in the middle.
#pragma once

#include <span>
#include <vector>

#include "collision/level_set.h"
#include "solver/model/contact.h"
#include "solver/model/samples.h"

namespace ease {

/// The body around the pose that a level set was made of.
struct BodyMoment {
  LevelSet* level_set;
  const TriangleTree* tree;    // of the same pose
  const Triangles* triangles;  // of the body
  const Positions* at;         // the pose of the level set
  const Positions* towards;    // the pose before or after it, towards which tau counts
  double tau = 0.0;            // how far the body has moved from `at` to `towards`, 0 to 1
};

/// How deep the cloth is in the body, m; 0 where outside.
struct Penetration {
  double vertices = 0.0, edge_midpoints = 0.0, centroids = 0.0;
  void deepen(const std::vector<double>& sample_distances, int vertex_count, int edge_count);
};

/// Samples, over all calls of find(), whose plane is not simply the offset away from the body.
struct ContactRescues {
  long held = 0;     // between two parts of the body
  long limited = 0;  // too deep to be moved out in one step
};

class ContactFinder {
 public:
  /// Planes for each of the samples that touches the body or nearly does; `offsets`, m, one a sample.  A plane lies at
  /// most `most_recovery` (m) above its sample.
  void find(const BodyMoment& body, std::span<const Vec3> samples, std::span<const double> offsets,
            double most_recovery, Contacts& contacts);

  /// Signed distance of each sample to the body, m; exact where it is below 2 mm.
  void distances(const BodyMoment& body, std::span<const Vec3> samples, std::vector<double>& distances);

  /// The same to first order and for nothing, where the samples have moved a little since the last find() at this
  /// moment.
  void distancesSinceFind(std::span<const Vec3> samples, std::vector<double>& distances) const;

  /// Makes the next find() independent of earlier ones.
  void forget() { found_.clear(); }

  const ContactRescues& rescues() const { return rescues_; }

 private:
  /// Fills found_; samples further than `near` (m) from the body need not be right.
  void lookUp(const BodyMoment& body, std::span<const Vec3> samples, double near);
  /// Looks up once more the samples that choose(s, point) wants to, at `point`: chosen_ and ahead_.
  template <class Choose>
  void lookAhead(const BodyMoment& body, const Choose& choose);
  void makeRoom(const BodyMoment& body, std::span<const double> offsets, Contacts& contacts);

  std::vector<LevelSetSample> found_, ahead_;
  std::vector<Vec3> points_, carried_, ahead_points_;
  std::vector<int> carried_from_;  // triangle whose motion carried the sample
  std::vector<char> is_chosen_;
  std::vector<int> chosen_;  // samples looked up a second time
  ContactRescues rescues_;
};

}  // namespace ease
