#include "solver/step/hinge_forces.h"

#include <algorithm>
#include <numeric>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kBlocksPerGroup = 64;  // of eight hinges, that one thread computes in order

std::vector<int> cornersOf(const std::vector<Hinge>& hinges) {
  std::vector<int> corners;
  for (const Hinge& hinge : hinges) corners.insert(corners.end(), hinge.vertices.begin(), hinge.vertices.end());
  return corners;
}

}  // namespace

HingeForces::HingeForces(const Cloth& cloth)
    : cloth_(cloth),
      corners_(cloth.vertexCount(), cornersOf(cloth.hinges())),
      lanes_((cloth.hinges().size() + kLanes - 1) / kLanes),
      stencils_(4 * cloth.hinges().size()),
      vectors_(kLanes * lanes_.size()),
      partial_((lanes_.size() + kBlocksPerGroup - 1) / kBlocksPerGroup) {}

void HingeForces::layOut() {
  const std::vector<Hinge>& hinges = cloth_.hinges();
  for (int e = 0; e < static_cast<int>(kLanes * lanes_.size()); ++e) {
    HingeLanes& lanes = lanes_[e / kLanes];
    const int l = e % kLanes;
    const Hinge& hinge = hinges[std::min(e, count() - 1)];
    for (int p = 0; p < 4; ++p) {
      lanes.vertices[p][l] = hinge.vertices[p];
      lanes.stencil[p][l] = hinge.stencil[p];
    }
    lanes.stiffness[l] = e < count() ? cloth_.material().bending * hinge.inverse_area : 0.0;
  }
  for (int v = 0; v < cloth_.vertexCount(); ++v) {
    int k = corners_.before(v);
    for (const int corner : corners_.of(v)) stencils_[k++] = hinges[corner / 4].stencil[corner % 4];
  }
}

void HingeForces::begin(const Positions& start, double h) {
  const Material& material = cloth_.material();
  empty_ = cloth_.hinges().empty() || (material.bending == 0.0 && material.damping_bending == 0.0);
  damps_ = !empty_ && material.damping_bending > 0.0;
  if (empty_) return;
  if (rest_revision_ != cloth_.restRevision()) {
    rest_revision_ = cloth_.restRevision();
    layOut();
  }
  parallelFor(static_cast<int>(lanes_.size()), kBlocksPerGroup, [&](int block) {
    HingeLanes& lanes = lanes_[block];
    lanes.damper.start = length(lanes.vectorAt(start));
    for (int l = 0; l < kLanes; ++l) {
      const int e = kLanes * block + l;
      lanes.damper.damping_over_h[l] =
          e < count() ? material.damping_bending / h * cloth_.hinges()[e].inverse_area : 0.0;
    }
  });
}

Column<Lanes> HingeForces::HingeLanes::vectorAt(const Positions& x) const {
  Column<Lanes> at[4];
  for (int p = 0; p < 4; ++p)
    for (int l = 0; l < kLanes; ++l) {
      const double* position = x.data() + 3 * vertices[p][l];
      at[p].x[l] = position[0];
      at[p].y[l] = position[1];
      at[p].z[l] = position[2];
    }
  // The stencil sums to zero.  Differences of positions have less round-off than positions.
  Column<Lanes> b{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
  for (int p = 1; p < 4; ++p)
    addScaled(b, stencil[p], Column<Lanes>{at[p].x - at[0].x, at[p].y - at[0].y, at[p].z - at[0].z});
  return b;
}

double HingeForces::evaluate(const Positions& x) {
  parallelFor(static_cast<int>(partial_.size()), 1, [&](int group) {
    const int end = std::min((group + 1) * kBlocksPerGroup, static_cast<int>(lanes_.size()));
    Lanes energy = Lanes::Zero();
    for (int block = group * kBlocksPerGroup; block < end; ++block) {
      const HingeLanes& lanes = lanes_[block];
      const Column<Lanes> b = lanes.vectorAt(x);
      const Lanes bending = length(b), weight = lanes.stiffness + lanes.damper.weight(bending);
      energy += 0.5 * lanes.stiffness * bending * bending + lanes.damper.energy(bending);
      Vec3* out = vectors_.data() + static_cast<size_t>(kLanes) * block;
      const Column<Lanes> g{weight * b.x, weight * b.y, weight * b.z};
      for (int l = 0; l < kLanes; ++l) out[l] = Vec3(g.x[l], g.y[l], g.z[l]);
    }
    partial_[group] = energy.sum();
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

}  // namespace ease
