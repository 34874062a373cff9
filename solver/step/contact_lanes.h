// Contact samples laid out beside the triangles that they lie in, eight side by side.
//
// Each sample has a triangle as its host: a centroid its own, a midpoint the edge's first, a vertex the first around
// it.  Its plane waits in the lane that its host has in the loop over triangles, so that this loop, which has the
// corners' positions and what the membrane does to them, takes contact along without looking anything up.
//
//   x   place of the sample = x0 + w1 (x1 - x0) + w2 (x2 - x0) for corners x0, x1, x2 of the host, m
#pragma once

#include <vector>

#include "solver/energy/element.h"
#include "solver/model/cloth.h"
#include "solver/model/contact.h"

namespace ease {

struct HostedSample {
  int sample, triangle;
};

/// All samples of a cloth (samples.h) in the order of their hosts.  Vertices without a triangle have none: they stand
/// for no area.
std::vector<HostedSample> hostedSamples(const Cloth& cloth);

/// Of eight triangles: where their first corners are and the edges from there to the second and the third, m.
struct TriangleEdges {
  Column<Lanes> first, edge_1, edge_2;
};

struct ContactLanes {
  int block;           // its triangles: 8 block, 8 block + 1, ...
  int sample[kLanes];  // -1: none
  Lanes weight[2];     // w1, w2
  Column<Lanes> normal;
  Lanes offset, give;  // m
  Lanes area;          // m^2 that the sample stands for

  /// No samples.
  explicit ContactLanes(int block_of_triangles);
  void set(int lane, const Cloth& cloth, const HostedSample& hosted, const ContactPlane& plane);

  Vec3 normalOf(int lane) const { return {normal.x[lane], normal.y[lane], normal.z[lane]}; }

  /// m, 0 above.
  Lanes depth(const TriangleEdges& hosts) const {
    const auto along = [&](const Column<Lanes>& a) -> Lanes { return dot(a, normal); };
    return (offset - along(hosts.first) - weight[0] * along(hosts.edge_1) - weight[1] * along(hosts.edge_2)).max(0.0);
  }
};

/// Lanes of all samples that have a plane, by groups of triangles.
class ContactLayout {
 public:
  /// `group`: triangles of a group, a multiple of 8.
  ContactLayout(const Cloth& cloth, int group);

  void set(const Contacts& contacts);

  bool empty() const { return empty_; }
  int sampleCount() const { return static_cast<int>(place_.size()); }
  int groupCount() const { return static_cast<int>(groups_.size()); }
  /// In the order of their blocks.
  const std::vector<ContactLanes>& group(int g) const { return groups_[g]; }

 private:
  struct Second {
    int place;  // in samples_
    ContactPlane plane;
  };
  void setGroup(int g, const Contacts& contacts);

  const Cloth& cloth_;
  std::vector<HostedSample> samples_;
  std::vector<int> place_;       // of each sample in these; -1: no host
  std::vector<int> begin_;       // of each group's samples in these
  std::vector<Second> seconds_;  // in the order of their places
  std::vector<std::vector<ContactLanes>> groups_;
  bool empty_ = true;
};

}  // namespace ease
