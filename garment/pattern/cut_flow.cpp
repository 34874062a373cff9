#include "garment/pattern/cut_flow.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <span>

#include "solver/base/error.h"

namespace ease {
namespace {

constexpr double kSmoothing = 1.0 / 30.0;  // r, sides of a square as large as the garment
constexpr double kFurthest = 1.0 / 60.0;   // largest change of a level in a step, in the same unit
constexpr double kArmijo = 1e-4;           // share of the decrease that the derivative promises
constexpr double kGrowth = 1.6;            // of alpha after a step
constexpr int kHalvings = 12;              // of alpha in a step
constexpr double kSmall = 0.1;             // share of the garment: only smaller regions are joined to others
constexpr double kEarly = 10.0;            // times the tolerance: from then on regions are joined
constexpr size_t kStandstill = 10;         // steps over which the decrease is measured

/// The implicit step: smooths a derivative by the levels.
class Smoothing {
 public:
  explicit Smoothing(const RestSurface& surface) : matrix_(surface.vertexCount(), surface.mesh.triangles) {
    const double r = kSmoothing * surface.side;
    for (int t = 0; t < surface.triangleCount(); ++t) {
      matrix_.add(t, r * r * stiffnessBlock(surface.rest_edges[t]));
      for (int k = 0; k < 3; ++k) matrix_.addDiagonal(surface.mesh.triangles(t, k), surface.area[t] / 3.0);
    }
    if (!matrix_.factor()) throw ComputationError("the garment cannot be cut: its triangles are degenerate");
  }

  void apply(std::vector<double>& direction) const { matrix_.solve(direction); }

 private:
  VertexMatrix matrix_;
};

bool standsStill(const std::vector<double>& energies, size_t since, double tolerance) {
  if (energies.size() <= since + kStandstill) return false;
  const double before = energies[energies.size() - 1 - kStandstill];
  return before - energies.back() < tolerance * before;
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double x : values) most = std::max(most, std::abs(x));
  return most;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Turns steepest descents into conjugate ones (Polak and Ribiere 1969), which cross long valleys in fewer steps.
class Conjugate {
 public:
  /// `direction`: the smoothed derivative; it is left as it is where the turned one would hardly lead downhill.
  void turn(const std::vector<double>& derivative, std::vector<double>& direction) {
    const double now = dot(derivative, direction);
    std::vector<double> smoothed = direction;
    if (!before_.empty()) {
      const double beta = (now - dot(derivative, smoothed_before_)) / dot(before_, smoothed_before_);
      for (size_t i = 0; beta > 0.0 && i < direction.size(); ++i) direction[i] += beta * turned_before_[i];
      if (dot(derivative, direction) < kDownhill * now) direction = smoothed;
    }
    before_ = derivative;
    smoothed_before_ = std::move(smoothed);
    turned_before_ = direction;
  }

  void forget() { before_.clear(); }

 private:
  static constexpr double kDownhill = 0.2;  // of the steepest descent's slope

  std::vector<double> before_, smoothed_before_, turned_before_;
};

/// The levels with one small region joined to a neighbour, where that lowers the energy most; nothing where no such
/// step lowers it.  A region that shrinks to a vertex stays there, because u = 0 on its border holds the surface flat
/// around it: the flow alone cannot pass this bar.
std::optional<RegionLevels> joined(const RestSurface& surface, const RegionLevels& levels, double now,
                                   CutEnergy& energy, const MirrorLevels* mirror) {
  const RegionMap map = mapOf(surface, levels);
  const Regions regions = connectedRegions(surface, map);
  std::set<std::pair<int, int>> choices;  // region and the label that it would take
  const double whole = surface.side * surface.side;
  for (const Edge& edge : surface.topology.edges)
    for (const int side : {0, 1}) {
      const int own = edge.vertex[side], other = edge.vertex[1 - side];
      if (isCrossed(map, edge) && regions.area[regions.of[own]] < kSmall * whole)
        choices.insert({regions.of[own], map.label[other]});
    }
  std::optional<RegionLevels> best;
  for (const auto& [region, label] : choices) {
    RegionMap trial = map;
    for (int v = 0; v < surface.vertexCount(); ++v)
      if (regions.of[v] == region) trial.label[v] = label;
    RegionLevels next = redistanced(surface, trial, levels.labels);
    if (mirror) (*mirror)(next);
    const double reached = energy(next);
    if (reached >= now) continue;
    now = reached;
    best = std::move(next);
  }
  return best;
}

/// Halves `alpha` until the levels phi - alpha direction lower the energy from `now` enough (Armijo's condition), and
/// writes them to `next`.  Returns the energy reached; nothing where no step is short enough.
std::optional<double> searchAlong(const std::vector<double>& direction, double slope, double now,
                                  const RegionLevels& levels, CutEnergy& energy, const MirrorLevels* mirror,
                                  double& alpha, RegionLevels& next) {
  next = levels;
  for (int halving = 0; halving <= kHalvings; ++halving) {
    if (halving > 0) alpha *= 0.5;
    for (size_t i = 0; i < next.phi.size(); ++i) next.phi[i] = levels.phi[i] - alpha * direction[i];
    if (mirror) (*mirror)(next);
    const double reached = energy(next);
    if (reached < now && reached <= now - kArmijo * alpha * slope) return reached;
  }
  return std::nullopt;
}

}  // namespace

FlowResult followFlow(const RestSurface& surface, const RegionLevels& start, const FlowSettings& settings,
                      const MirrorLevels* mirror) {
  CutEnergy energy(surface, settings.weights);
  const Smoothing smoothing(surface);
  FlowResult result{start, {}};
  result.energies.push_back(energy(result.levels));
  double alpha = 0.0;
  Conjugate conjugate;
  size_t since = 0;  // number of energies when the last region was joined to another
  const auto join = [&] {
    if (!settings.joins) return false;
    std::optional<RegionLevels> next = joined(surface, result.levels, result.energies.back(), energy, mirror);
    const double reached = energy(next ? *next : result.levels);
    if (!next) return false;
    result.levels = std::move(*next);
    result.energies.push_back(reached);
    since = result.energies.size();
    alpha = 0.0;
    conjugate.forget();
    return true;
  };
  for (int step = 0; step < settings.steps; ++step) {
    if (standsStill(result.energies, since, kEarly * settings.tolerance) && !join()) {
      if (standsStill(result.energies, 0, settings.tolerance)) break;
      since = result.energies.size();
    }
    const double now = result.energies.back();
    std::vector<double> derivative = energy.derivative();
    if (mirror) mirror->gather(result.levels.labels, derivative);
    std::vector<double> direction = derivative;
    smoothing.apply(direction);
    conjugate.turn(derivative, direction);
    const double slope = dot(derivative, direction);
    const double most = largest(direction);
    if (!(most > 0.0) || !(slope > 0.0)) break;
    const double bound = kFurthest * surface.side / most;
    alpha = alpha > 0.0 ? std::min(kGrowth * alpha, bound) : bound;
    RegionLevels next;
    std::optional<double> reached = searchAlong(direction, slope, now, result.levels, energy, mirror, alpha, next);
    if (!reached) {
      if (!join()) break;
      continue;
    }
    result.levels = next;
    RegionLevels distances = redistanced(surface, mapOf(surface, next), next.labels);
    if (mirror) (*mirror)(distances);
    if (const double at_distances = energy(distances); at_distances < now) {
      result.levels = distances;
      reached = at_distances;
    } else {
      energy(next);  // whose derivative is asked for next
    }
    result.energies.push_back(*reached);
  }
  return result;
}

}  // namespace ease
