#include "adaption/presence.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "solver/mesh/disjoint_sets.h"

namespace ease {

namespace {

constexpr int kTiesPerPart = 200;  // so many vertices tell how far a part slid

}  // namespace

std::vector<int> connectedParts(const Triangles& triangles, const std::vector<double>& areas, int vertex_count) {
  DisjointSets sets(vertex_count);
  for (int t = 0; t < triangles.rows(); ++t)
    for (const int k : {1, 2}) sets.join(triangles(t, 0), triangles(t, k));
  std::map<int, double> area_of;  // by the lowest vertex of the part
  for (int v = 0; v < vertex_count; ++v) area_of[sets.find(v)];
  for (int t = 0; t < triangles.rows(); ++t) area_of[sets.find(triangles(t, 0))] += areas[t];
  std::vector<std::pair<double, int>> order;
  for (const auto& [lowest, area] : area_of) order.emplace_back(-area, lowest);
  std::sort(order.begin(), order.end());
  std::map<int, int> number;
  for (const auto& [area, lowest] : order) number.emplace(lowest, static_cast<int>(number.size()));
  std::vector<int> part(vertex_count);
  for (int v = 0; v < vertex_count; ++v) part[v] = number[sets.find(v)];
  return part;
}

Presence::Presence(const Cloth& cloth, const std::vector<double>& offsets)
    : offset_(*std::max_element(offsets.begin(), offsets.end())) {
  const std::vector<int> part = connectedParts(cloth.triangles(), cloth.restAreas(), cloth.vertexCount());
  parts_.resize(*std::max_element(part.begin(), part.end()) + 1);
  vertices_.resize(parts_.size());
  for (int v = 0; v < cloth.vertexCount(); ++v) vertices_[part[v]].push_back(v);
  const double area = std::accumulate(cloth.vertexAreas().begin(), cloth.vertexAreas().end(), 0.0);
  for (size_t p = 0; p < parts_.size(); ++p) {
    parts_[p].vertex = vertices_[p].front();
    parts_[p].vertices = static_cast<int>(vertices_[p].size());
    parts_[p].area_share = 0.0;
    for (const int v : vertices_[p]) parts_[p].area_share += cloth.vertexAreas()[v] / area;
  }
  const ContactSamples samples = cloth.samples();
  for (int s = 0; s < samples.count(); ++s) part_of_sample_.push_back(part[samples.corners(s).vertex[0]]);
}

void Presence::tie(const Positions& x, const Positions& body, const Triangles& triangles) {
  tied_.clear();
  for (const std::vector<int>& part : vertices_) {
    const size_t stride = 1 + part.size() / kTiesPerPart;
    for (size_t k = 0; k < part.size(); k += stride) tied_.push_back(part[k]);
  }
  ties_ = tieToBody(tied_, x, body, triangles);
  // What begins far from the body swings about without sliding.
  std::vector<int> near;
  std::vector<BodyTie> near_ties;
  for (size_t k = 0; k < ties_.size(); ++k) {
    if (std::abs(ties_[k].local.z()) > offset_ + kReach) continue;
    near.push_back(tied_[k]);
    near_ties.push_back(ties_[k]);
  }
  tied_ = std::move(near);
  ties_ = std::move(near_ties);
}

void Presence::add(double time_s, const Positions& x, const BodyMoment& body, const std::vector<double>& samples,
                   double exact_below, const std::function<double(const Vec3&)>& distance) {
  std::vector<double> nearest(parts_.size(), std::numeric_limits<double>::infinity());
  for (size_t s = 0; s < samples.size(); ++s)
    nearest[part_of_sample_[s]] = std::min(nearest[part_of_sample_[s]], samples[s]);
  std::vector<Vec3> slid(parts_.size(), Vec3::Zero());
  std::vector<int> tied(parts_.size(), 0);
  for (size_t k = 0; k < ties_.size(); ++k) {
    const int part = part_of_sample_[tied_[k]];  // sample v is vertex v
    slid[part] += x.row(tied_[k]).transpose() - placeOf(ties_[k], body);
    ++tied[part];
  }
  for (size_t p = 0; p < parts_.size(); ++p) {
    PartPresence& part = parts_[p];
    if (nearest[p] >= exact_below) {
      nearest[p] = std::numeric_limits<double>::infinity();
      for (const int v : vertices_[p]) nearest[p] = std::min(nearest[p], distance(x.row(v)));
    }
    part.last_m = nearest[p];
    part.nearest_m = std::min(part.nearest_m, nearest[p]);
    if (nearest[p] <= offset_ + kReach)
      part.off_since_s.reset();
    else if (!part.off_since_s)
      part.off_since_s = time_s;
    if (tied[p] > 0) part.slid_m = (slid[p] / tied[p]).norm();
  }
}

}  // namespace ease
