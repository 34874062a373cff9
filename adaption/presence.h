// Whether the garment is still on the body: how far each of its connected parts is from it, and since when.
//
// A garment that fell off or was never near is stretched by nothing, and looks like one that fits. A part counts as on
// the body while its nearest sample is at most `kReach` beyond the comfort offset away from it.
//
//   slid   |mean over the part's vertices of (x - where the vertex would be if it had kept its place on the body)|, m
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "collision/body_pins.h"
#include "solver/model/cloth.h"

namespace ease {

/// One connected part of the garment over the measured moments of a pass.
struct PartPresence {
  int vertex = 0;                                              // one of its vertices
  int vertices = 0;                                            // how many it has
  double area_share = 1.0;                                     // of the garment's rest area
  double nearest_m = std::numeric_limits<double>::infinity();  // distance to the body, at the moment it was smallest
  double last_m = 0.0;                                         // at the last moment
  std::optional<double> off_since_s;                           // off the body from then to the last moment
  double slid_m = 0.0;                                         // at the last moment
};

class Presence {
 public:
  static constexpr double kReach = 0.05;  // m

  Presence(const Cloth& cloth, const std::vector<double>& offsets);

  /// Ties vertices near the body to it, to tell later how far they slid. `body`: its vertices, m.
  void tie(const Positions& x, const Positions& body, const Triangles& triangles);

  /// Adds a moment. `samples`: distance of each sample to the body, m, exact below `exact_below`; `distance` computes
  /// that of a point that is further away.
  void add(double time_s, const Positions& x, const BodyMoment& body, const std::vector<double>& samples,
           double exact_below, const std::function<double(const Vec3&)>& distance);

  /// Largest part first.
  const std::vector<PartPresence>& parts() const { return parts_; }

 private:
  double offset_;  // largest comfort offset, m
  std::vector<PartPresence> parts_;
  std::vector<int> part_of_sample_;
  std::vector<std::vector<int>> vertices_;  // of each part
  std::vector<int> tied_;
  std::vector<BodyTie> ties_;  // of the tied vertices
};

/// Number of the connected part of each vertex; the part with the most area has number 0.
std::vector<int> connectedParts(const Triangles& triangles, const std::vector<double>& areas, int vertex_count);

}  // namespace ease
