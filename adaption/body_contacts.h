// The moving body as the cloth meets it: where the body is in each part of a time step, what touches it, and how deep.
//
//   s     how far the body's motion is, in the interpolation steps of MovingBody; a part of a time step ends at
//         s = q / n for part number q of the motion, where an interpolation step has n such parts
//
// While one part is computed, the level set that the next part needs is prepared beside it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "adaption/pass_record.h"
#include "adaption/substeps.h"
#include "collision/moving_body.h"
#include "solver/base/parallel.h"
#include "solver/model/cloth.h"
#include "solver/step/state.h"

namespace ease {

class BodyContacts {
 public:
  /// `offsets`: comfort offset at every vertex, m.  `max_recovery`: how far a sample that is too near to the body may
  /// be moved away from it in a part of a time step, m.
  BodyContacts(MovingBody& body, const Cloth& cloth, std::span<const double> offsets, const Schedule& schedule,
               const Substeps& substeps, double max_recovery);

  /// Place s of the body at the end of part `part` (1 to substeps.time) of this moment's time step; 0: at its start.
  double bodyAt(const Moment& moment, int part) const;
  /// Place s of the body once these time steps are done.
  double bodyAt(const StepsDone& done) const;

  /// Makes the level sets that the first part of the first time step after `done` needs, around the cloth at `x`.
  void prepareFirst(const StepsDone& done, const Positions& x);
  /// Begins to prepare the level set that the part after this one needs, if it is another one, on a thread beside.
  /// `part_s`: length of a part, s.  `beside.wait()` waits for it.
  void prepareNext(const Moment& moment, int part, const State& state, double part_s, TaskBeside& beside);

  /// Contact planes of the cloth at `x`, the body being at s.  `start`: where the body was at the start of the part,
  /// for friction; none: its motion is not needed.
  void find(double s, const Positions& x, Contacts& contacts, std::optional<double> start = {});

  /// Distance of every sample of the cloth at `x` to the body at s, m.  distances() has them until the next call.
  void measure(double s, const Positions& x);
  /// As measure(), to first order and much faster, for cloth that moved little since find() at the same s.
  void measureSinceFind(const Positions& x);
  const std::vector<double>& distances() const { return distances_; }
  /// Raises penetration.triangles to the deepest point of every triangle with an edge longer than 2.5 cm, looked for in
  /// steps of 5 mm, because the samples of such a triangle may miss a limb. Call measure() at the same s first.
  void deepenLargeTriangles(double s, const Positions& x, Penetration& penetration);
  /// Deepens `penetration` by what was measured last.
  void deepen(Penetration& penetration) const;

  /// Makes what follows independent of earlier calls.
  void forget() { finder_.discardHistory(); }

  /// Writes the time that the body has cost since the start, and what had to be rescued.
  void recordUse(PassRecord& record) const;

 private:
  /// Number of the part, from the start of the motion, at whose end this one ends; 0: the start.
  int partNumber(const Moment& moment, int part) const;
  /// Shape of the body whose level set stands for it at the end of a part.
  int shapeAt(int part_number) const;
  std::span<const Vec3> samplesAt(const Positions& x);

  MovingBody& body_;
  const MovingBody::Times times_before_;
  const long voxels_before_;
  const Cloth& cloth_;
  ContactFinder finder_;
  int parts_;                                     // of a time step
  int parts_per_shape_;                           // parts of time steps in an interpolation step
  int moving_parts_;                              // of the whole motion
  double max_recovery_;                           // m
  std::vector<double> offsets_, distances_;       // one a sample, m
  std::vector<Vec3> samples_, expected_samples_;  // m
};

}  // namespace ease
