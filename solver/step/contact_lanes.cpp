#include "solver/step/contact_lanes.h"

#include <algorithm>

#include "solver/base/parallel.h"

namespace ease {

std::vector<HostedSample> hostedSamples(const Cloth& cloth) {
  const ContactSamples samples = cloth.samples();
  std::vector<HostedSample> hosted;
  std::vector<char> has_host(cloth.vertexCount(), 0);
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    for (int v : cloth.triangles().row(t)) {
      if (!has_host[v]) hosted.push_back({v, t});
      has_host[v] = 1;
    }
    for (int edge : cloth.topology().triangle_edges.row(t))
      if (cloth.topology().edges[edge].triangle[0] == t) hosted.push_back({samples.midpoint(edge), t});
    hosted.push_back({samples.centroid(t), t});
  }
  return hosted;
}

ContactLanes::ContactLanes(int block_of_triangles) : block(block_of_triangles) {
  std::fill(std::begin(sample), std::end(sample), -1);
  weight[0] = weight[1] = normal.x = normal.y = normal.z = offset = area = Lanes::Zero();
  give = Lanes::Ones();
}

void ContactLanes::set(int lane, const Cloth& cloth, const HostedSample& hosted, const ContactPlane& plane) {
  const ContactSamples samples = cloth.samples();
  sample[lane] = hosted.sample;
  for (int k = 0; k < 2; ++k)
    weight[k][lane] = samples.weight(hosted.sample, cloth.triangles()(hosted.triangle, k + 1));
  normal.x[lane] = plane.normal[0];
  normal.y[lane] = plane.normal[1];
  normal.z[lane] = plane.normal[2];
  offset[lane] = plane.offset;
  give[lane] = plane.give;
  area[lane] = samples.area(hosted.sample, cloth.vertexAreas(), cloth.restAreas());
}

FrictionLanes::FrictionLanes() {
  place_without_slip.x = place_without_slip.y = place_without_slip.z = limit = Lanes::Zero();
  std::fill(std::begin(force), std::end(force), -1);
}

void FrictionLanes::set(int lane, const Cloth& cloth, const HostedSample& hosted, const Contacts& contacts,
                        const FrictionStart& start, int second_plane) {
  const bool is_second = second_plane >= 0;
  if (is_second && !contacts.seconds[second_plane].rubs) return;
  const int count = static_cast<int>(contacts.planes.size());
  force[lane] = is_second ? count + hosted.sample : hosted.sample;
  if (start.normal_forces.empty()) return;
  limit[lane] = start.coefficient * start.normal_forces[force[lane]];
  if (limit[lane] == 0.0) return;
  any = true;
  Vec3 place = Vec3::Zero();
  const SampleCorners corners = cloth.samples().corners(hosted.sample);
  for (int k = 0; k < corners.count; ++k) place += Vec3(start.positions.row(corners.vertex[k])) / corners.count;
  if (!contacts.motions.empty()) place += contacts.motions[is_second ? count + second_plane : hosted.sample];
  place_without_slip.x[lane] = place[0];
  place_without_slip.y[lane] = place[1];
  place_without_slip.z[lane] = place[2];
}

ContactLayout::ContactLayout(const Cloth& cloth, int group)
    : cloth_(cloth),
      samples_(hostedSamples(cloth)),
      place_(cloth.samples().count(), -1),
      groups_((cloth.triangleCount() + group - 1) / group),
      frictions_(groups_.size()) {
  for (size_t k = 0; k < samples_.size(); ++k) place_[samples_[k].sample] = static_cast<int>(k);
  for (int g = 0; g <= groupCount(); ++g) {
    const auto first = std::ranges::lower_bound(samples_, g * group, {}, &HostedSample::triangle);
    begin_.push_back(static_cast<int>(first - samples_.begin()));
  }
}

void ContactLayout::set(const Contacts& contacts, const FrictionStart* friction) {
  empty_ = contacts.planes.empty();
  seconds_.clear();
  for (size_t k = 0; k < contacts.seconds.size(); ++k) {
    const Contacts::Second& second = contacts.seconds[k];
    const int place = place_[second.sample];
    if (place >= 0) seconds_.push_back({place, static_cast<int>(k), second.plane});
  }
  std::ranges::stable_sort(seconds_, {}, &Second::place);
  parallelFor(groupCount(), 1, [&](int g) { setGroup(g, contacts, friction); });
}

void ContactLayout::setGroup(int g, const Contacts& contacts, const FrictionStart* friction) {
  std::vector<ContactLanes>& group_lanes = groups_[g];
  group_lanes.clear();
  frictions_[g].clear();
  if (empty_) return;
  size_t first = 0;  // index in `group_lanes` of the current block's first element
  int used[kLanes];  // number of the block's samples placed in each lane so far
  // `second`: index of the plane in Contacts::seconds; -1: it is the sample's first one.
  const auto add = [&](const HostedSample& hosted, const ContactPlane& plane, int second) {
    const int block = hosted.triangle / kLanes, lane = hosted.triangle % kLanes;
    if (group_lanes.empty() || group_lanes.back().block != block) {
      first = group_lanes.size();
      std::fill(std::begin(used), std::end(used), 0);
    }
    const size_t at = first + used[lane]++;
    if (at == group_lanes.size()) group_lanes.emplace_back(block);
    group_lanes[at].set(lane, cloth_, hosted, plane);
    if (!friction) return;
    if (frictions_[g].size() < group_lanes.size()) frictions_[g].resize(group_lanes.size());
    frictions_[g][at].set(lane, cloth_, hosted, contacts, *friction, second);
  };
  auto next = std::ranges::lower_bound(seconds_, begin_[g], {}, &Second::place);
  for (int k = begin_[g]; k < begin_[g + 1]; ++k) {
    const ContactPlane& plane = contacts.planes[samples_[k].sample];
    if (!plane.normal.isZero(0.0)) add(samples_[k], plane, -1);
    for (; next != seconds_.end() && next->place == k; ++next) add(samples_[k], next->plane, next->number);
  }
}

}  // namespace ease
