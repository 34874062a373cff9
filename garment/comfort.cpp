#include "garment/comfort.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "collision/level_set.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"
#include "solver/mesh/topology.h"
#include "solver/model/samples.h"

namespace ease {
namespace {

constexpr int kSmoothingRounds = 30;
constexpr int kPatience = 25;  // rounds after which samples that still lack distance require half of it
constexpr int kMaxRounds = 300;
constexpr double kDoubt = 1e-3;      // m: in the last rounds, samples with less than this to spare are measured exactly
constexpr double kRoomKept = 0.8;    // share of half the room between two parts of the body that is used
constexpr double kOvershoot = 1e-4;  // m: without it the last micrometres would take many rounds
constexpr double kBand = 0.06;       // m: band of the level set beyond the largest offset; deepest start in the body
constexpr double kVoxel = 0.01;      // m
constexpr double kFarthest = 0.2;    // m: limit of the search for the closest point
constexpr double kOnSurface = 1e-6;  // m: nearer points give no direction by their closest point

/// Lists the vertices that each vertex is smoothed with: its two neighbours on the loop if it lies on one, else all its
/// neighbours.
std::vector<std::vector<int>> smoothingNeighbours(const LoopedMesh& garment, const Topology& topology) {
  std::vector<std::vector<int>> neighbours =
      vertexNeighbours(topology, static_cast<int>(garment.mesh.positions.rows()));
  for (const std::vector<int>& loop : topology.boundary_loops) {
    const size_t n = loop.size();
    for (size_t i = 0; i < n; ++i) neighbours[loop[i]] = {loop[(i + n - 1) % n], loop[(i + 1) % n]};
  }
  return neighbours;
}

class Mover {
 public:
  Mover(const TriangleTree& body, const std::vector<double>& offsets, LoopedMesh& garment)
      : body_(body),
        garment_(garment),
        topology_(buildTopology(garment.mesh, "garment")),
        neighbours_(smoothingNeighbours(garment, topology_)),
        contact_samples_(static_cast<int>(garment.mesh.positions.rows()), topology_.edges, garment.mesh.triangles),
        start_(garment.mesh.positions),
        level_set_({kVoxel, *std::max_element(offsets.begin(), offsets.end()) + kBand}) {}

  /// Moves the garment clear of the body.  Returns the number of vertices whose offset was reduced for lack of room.
  int operator()(std::vector<double> offsets) {
    contact_samples_.positions(garment_.mesh.positions, samples_);
    level_set_.build(body_, samples_, 0.0);
    const int held = limitToRoom(offsets);
    contact_samples_.values(offsets, wanted_);
    for (int round = 0; round < kMaxRounds; ++round) {
      const bool is_last_part = round >= kSmoothingRounds;
      if (!is_last_part) smooth();
      if (!pushOut(is_last_part) && is_last_part) return held;
      if (is_last_part && (round - kSmoothingRounds) % kPatience == kPatience - 1) giveWay();
    }
    throw ComputationError("garment: it does not come clear of the body; more vertices or less offset may help");
  }

 private:
  void smooth() {
    const Positions d = garment_.mesh.positions - start_;
    parallelFor(static_cast<int>(d.rows()), 512, [&](int v) {
      Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
      for (const int w : neighbours_[v]) mean += d.row(w) / static_cast<double>(neighbours_[v].size());
      garment_.mesh.positions.row(v) = start_.row(v) + 0.5 * (d.row(v) + mean);
    });
  }

  /// Reduces the offsets of vertices where two parts of the body face each other with too little room between them.
  /// Returns the number of such vertices.
  ///
  ///   |<- phi_0 ->x------ d ----->y<- phi_1 ->|     x: vertex, y: x moved out by d = offset - phi_0
  ///   part 0                           part 1       c = n_0 . n_1 < 0
  ///
  /// A vertex that moves out by s from x has the distances phi_0 + s to part 0 and phi_1 - d c + s c to part 1.  They
  /// are equal in the middle, where s = (phi_1 - d c - phi_0) / (1 - c).
  int limitToRoom(std::vector<double>& offsets) {
    const int n = static_cast<int>(offsets.size());
    std::vector<LevelSetSample> here(n), there(n);
    std::vector<Vec3> ahead(samples_.begin(), samples_.begin() + n);
    level_set_.sample(ahead, here);
    for (int v = 0; v < n; ++v) ahead[v] += std::max(0.0, offsets[v] - here[v].phi) * here[v].normal;
    level_set_.sample(ahead, there);
    int held = 0;
    for (int v = 0; v < n; ++v) {
      const double d = offsets[v] - here[v].phi, facing = here[v].normal.dot(there[v].normal);
      if (d <= 0.0 || facing >= 0.0) continue;
      const double middle = here[v].phi + (there[v].phi - d * facing - here[v].phi) / (1.0 - facing);
      offsets[v] = std::clamp(kRoomKept * middle, 0.0, offsets[v]);
      ++held;
    }
    return held;
  }

  void lookUp(bool exactly) {
    contact_samples_.positions(garment_.mesh.positions, samples_);
    found_.resize(samples_.size());
    level_set_.sample(samples_, found_);
    if (!exactly) return;
    parallelFor(static_cast<int>(samples_.size()), 64, [&](int s) {
      LevelSetSample& found = found_[s];
      if (found.phi > wanted_[s] + kDoubt) return;
      const ClosestPoint closest = body_.closestOfUnion(samples_[s], kFarthest, found.triangle);
      found.phi = closest.distance;
      const Vec3 away = samples_[s] - closest.point;
      if (away.norm() > kOnSurface) found.normal = std::copysign(1.0, closest.distance) * away.normalized();
    });
  }

  /// Halves the distance required of samples that still lack it: they lie in folds too narrow for their triangles.
  void giveWay() {
    for (size_t s = 0; s < samples_.size(); ++s)
      if (found_[s].phi < wanted_[s]) wanted_[s] *= 0.5;
  }

  /// Moves each vertex out by the largest lack of distance among the samples that depend on it.  Returns false if
  /// nothing had to move.
  bool pushOut(bool exactly) {
    lookUp(exactly);
    std::vector<double> most(garment_.mesh.positions.rows(), 0.0);
    std::vector<Vec3> out(most.size(), Vec3::Zero());
    for (size_t s = 0; s < samples_.size(); ++s) {
      const double lack = wanted_[s] - found_[s].phi;
      const SampleCorners corners = contact_samples_.corners(static_cast<int>(s));
      for (int k = 0; k < corners.count; ++k) {
        const int v = corners.vertex[k];
        if (lack <= most[v]) continue;
        most[v] = lack;
        out[v] = found_[s].normal;
      }
    }
    bool has_moved = false;
    for (size_t v = 0; v < most.size(); ++v) {
      if (most[v] <= 0.0) continue;
      garment_.mesh.positions.row(v) += (most[v] + kOvershoot) * out[v];
      has_moved = true;
    }
    return has_moved;
  }

  const TriangleTree& body_;
  LoopedMesh& garment_;
  Topology topology_;
  std::vector<std::vector<int>> neighbours_;
  ContactSamples contact_samples_;
  Positions start_;
  LevelSet level_set_;
  std::vector<double> wanted_;  // distance required of each sample, m
  std::vector<Vec3> samples_;
  std::vector<LevelSetSample> found_;
};

}  // namespace

std::vector<double> comfortOffsets(const Positions& positions, double offset, const std::vector<Brush>& regions) {
  std::vector<double> offsets(positions.rows(), offset);
  for (size_t r = 0; r < regions.size(); ++r) {
    const Brush& region = regions[r];
    bool touches = false;
    for (size_t v = 0; v < offsets.size(); ++v) {
      const double weight = brushWeight(region, positions.row(v));
      touches = touches || weight > 0.0;
      offsets[v] += weight * (region.value - offsets[v]);
    }
    if (!touches)
      throw InputError(
          fmt::format("comfort.region number {}: at = [{:g}, {:g}, {:g}], radius = {:g}: touches no vertex", r + 1,
                      region.at.x(), region.at.y(), region.at.z(), region.radius));
  }
  return offsets;
}

int moveClear(const TriangleTree& body, const std::vector<double>& offsets, LoopedMesh& garment) {
  return Mover(body, offsets, garment)(offsets);
}

}  // namespace ease
