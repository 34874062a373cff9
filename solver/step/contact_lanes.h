// Contact samples in the memory order of the triangles that they lie in, eight side by side.
//
//   x = x0 + w1 (x1 - x0) + w2 (x2 - x0)   position of a sample, m; x0, x1, x2 are the corners of its host triangle
//
// Each sample has one host triangle: a centroid has its own triangle, an edge midpoint the first triangle at the edge,
// a vertex the first triangle around it. The contact plane of the sample is stored in the lane that its host has in the
// loop over triangles. That loop has already loaded the corner positions for the membrane, so it computes contact with
// no further lookup.
#pragma once

#include <span>
#include <vector>

#include "solver/energy/element.h"
#include "solver/model/cloth.h"
#include "solver/model/contact.h"

namespace ease {

/// A contact sample and its host triangle, as indices.
struct HostedSample {
  int sample, triangle;
};

/// All samples of a cloth (samples.h), ordered by host triangle. A vertex without a triangle has no host and is left
/// out, because it stands for no area.
std::vector<HostedSample> hostedSamples(const Cloth& cloth);

/// First corner of eight triangles, and the edges from it to the second and the third corner, m.
struct TriangleEdges {
  Column<Lanes> first, edge_1, edge_2;
};

/// At most one contact sample with its plane for each of eight consecutive triangles.
struct ContactLanes {
  int block;           // the triangles are 8 block, 8 block + 1, ..., 8 block + 7
  int sample[kLanes];  // index of the sample; -1: the lane is empty
  Lanes weight[2];     // barycentric weights w1, w2
  Column<Lanes> normal;
  Lanes offset, give;  // m
  Lanes area;          // area that the sample stands for, m^2

  /// All lanes are empty.
  explicit ContactLanes(int block_of_triangles);
  void set(int lane, const Cloth& cloth, const HostedSample& hosted, const ContactPlane& plane);

  Vec3 normalOf(int lane) const { return {normal.x[lane], normal.y[lane], normal.z[lane]}; }

  /// Depth of the samples below their planes, m; 0 above.
  Lanes depth(const TriangleEdges& hosts) const {
    const auto along = [&](const Column<Lanes>& a) -> Lanes { return dot(a, normal); };
    return (offset - along(hosts.first) - weight[0] * along(hosts.edge_1) - weight[1] * along(hosts.edge_2)).max(0.0);
  }
};

/// What friction in a step depends on besides the contacts.
struct FrictionStart {
  double coefficient;                     // mu
  const Positions& positions;             // x_n, m
  std::span<const double> normal_forces;  // lambda, N, as in State
};

/// Friction of the samples of a ContactLanes, lane by lane (energy/friction.h).
struct FrictionLanes {
  Column<Lanes>
      place_without_slip;  // where the sample would be without slip, m: its start plus the motion of the body's surface
  Lanes limit;             // mu lambda, N: the largest force of friction
  int force[kLanes];       // index of the plane's force in State::normal_forces; -1: no friction acts on the plane
  bool any = false;        // whether a limit is above 0

  /// All lanes are without friction.
  FrictionLanes();
  /// `second_plane`: index of the plane in Contacts::seconds; -1: it is the sample's first one.
  void set(int lane, const Cloth& cloth, const HostedSample& hosted, const Contacts& contacts,
           const FrictionStart& start, int second_plane);

  /// Slip of the samples on their hosts: the part of x - place_without_slip that is tangential to the plane, m.
  Column<Lanes> slip(const ContactLanes& contact, const TriangleEdges& hosts) const {
    const auto moved = [&](const Lanes& x, const Lanes& e1, const Lanes& e2, const Lanes& start) -> Lanes {
      return x + contact.weight[0] * e1 + contact.weight[1] * e2 - start;
    };
    Column<Lanes> u{moved(hosts.first.x, hosts.edge_1.x, hosts.edge_2.x, place_without_slip.x),
                    moved(hosts.first.y, hosts.edge_1.y, hosts.edge_2.y, place_without_slip.y),
                    moved(hosts.first.z, hosts.edge_1.z, hosts.edge_2.z, place_without_slip.z)};
    addScaled(u, Lanes(-dot(u, contact.normal)), contact.normal);
    return u;
  }
};

/// Lanes of all samples that have a plane, in groups of consecutive triangles.
class ContactLayout {
 public:
  /// `group`: number of triangles in a group, a multiple of 8.
  ContactLayout(const Cloth& cloth, int group);

  /// Replaces the contacts. `friction`: null for contact without friction.
  void set(const Contacts& contacts, const FrictionStart* friction = nullptr);

  bool empty() const { return empty_; }
  int sampleCount() const { return static_cast<int>(place_.size()); }
  int groupCount() const { return static_cast<int>(groups_.size()); }
  /// Lanes of group g, ordered by block.
  const std::vector<ContactLanes>& group(int g) const { return groups_[g]; }
  /// Friction of each of the group's lanes; empty without friction.
  const std::vector<FrictionLanes>& friction(int g) const { return frictions_[g]; }

 private:
  /// A second plane of a sample.
  struct Second {
    int place;   // index in samples_
    int number;  // index in Contacts::seconds
    ContactPlane plane;
  };
  void setGroup(int g, const Contacts& contacts, const FrictionStart* friction);

  const Cloth& cloth_;
  std::vector<HostedSample> samples_;
  std::vector<int> place_;       // index in samples_ by sample; -1: the sample has no host
  std::vector<int> begin_;       // index in samples_ of each group's first sample
  std::vector<Second> seconds_;  // ordered by place
  std::vector<std::vector<ContactLanes>> groups_;
  std::vector<std::vector<FrictionLanes>> frictions_;
  bool empty_ = true;
};

}  // namespace ease
