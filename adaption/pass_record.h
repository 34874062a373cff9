// What is recorded of one pass: the cloth carried once through its schedule.
#pragma once

#include <optional>
#include <vector>

#include "adaption/presence.h"
#include "adaption/stretch_measure.h"
#include "adaption/substeps.h"
#include "collision/contacts.h"
#include "solver/step/method.h"

namespace ease {

/// Largest principal stretch over all measured moments, and in every pose that was reached.
struct StretchRecord {
  StretchStatistics overall;  // the largest of each statistic
  int moments = 0;            // measured so far
  std::vector<std::optional<StretchStatistics>> poses;

  /// Adds a measured moment.  `pose`: the one that the body has reached, -1: none.
  void add(const StretchStatistics& moment, int pose);
};

/// Wall time, s.
struct PassTimes {
  double total = 0.0;          // of the whole pass
  double step = 0.0;           // minimising, and finding contacts
  double interpolation = 0.0;  // of poses, on the thread beside the steps
  double level_set = 0.0;      // on the thread beside the steps
  double adaption = 0.0;       // measuring, clipping, stitching
  double output = 0.0;         // frames and checkpoints

  PassTimes& operator+=(const PassTimes& other);
};

/// The fastest vertex over all measured moments.
struct Fastest {
  double speed_m_s = 0.0, time_s = 0.0;
  int vertex = 0;
};

struct PassRecord {
  int steps = 0;         // time steps done
  int settle_steps = 0;  // among them, those after the motion
  int adaptions = 0;     // how often the rest shape was let out
  // Triangles over the limit that may not grow further: in passes at any moment (growth_demand.h), in sequential
  // adaption at the last one (clip.h).
  int fully_grown = 0;
  Substeps substeps;
  StretchRecord stretch;
  Penetration penetration;
  double final_speed_m_s = 0.0;  // of the fastest vertex
  Fastest fastest;
  std::vector<PartPresence> on_body;  // the garment's connected parts, largest first; empty without a body
  double contact_stiffness = 0.0;     // used, N/m^3
  StepSummary solver;                 // sum over all steps
  ContactRescues contact;
  long voxels_on_demand = 0;  // that no level set had foreseen
  double level_set_MB = 0.0;
  PassTimes times;

  /// Adds another pass: sums of counts and times, the largest stretch and depth of both, and what the later one found
  /// at its end.
  PassRecord& operator+=(const PassRecord& later);
};

}  // namespace ease
