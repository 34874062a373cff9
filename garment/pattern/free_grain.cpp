#include "garment/pattern/free_grain.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "garment/pattern/dart_trial.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr int kCoarse = 15, kFine = 5;  // degrees
constexpr double kGain = 0.95;          // of the mean stretch of the threads, at most
constexpr double kMinGain = 5e-4;       // of that stretch, at least
constexpr double kTolerance = 1e-9;     // m^2, of areas over the limits that are compared
constexpr int kIterations = 120;        // of a trial

/// One piece whose grain is turned.
class Turning {
 public:
  Turning(const PieceMesh& part, const FlatSettings& settings) : part_(part), settings_(settings) {
    given_ = flattenPart(part_, {}, settings_, kIterations);
    part_.x = given_.x;
    part_.corners = given_.corners;
  }

  /// The best angle, rad.
  double best() const {
    const bool is_even = settings_.woven.warp == settings_.woven.weft;  // then a quarter turn changes nothing
    const int half = is_even ? 45 : 90;
    int best = 0;
    const double given = given_.strain.thread_mean;
    double least = std::min(kGain * given, given - kMinGain);
    const auto attempt = [&](int degrees) {
      const double reached = stretchAt(degrees);
      if (reached >= least) return;
      least = reached;
      best = degrees;
    };
    for (int degrees = -half + kCoarse; degrees <= half; degrees += kCoarse)
      if (degrees != 0) attempt(degrees);
    for (const int degrees : {best - kFine, best + kFine})
      if (best != 0) attempt(degrees);
    return best * kDegree;
  }

 private:
  /// Mean stretch of the threads; infinite where the grain cannot be so.
  double stretchAt(int degrees) const {
    const Mat2 turn = Eigen::Rotation2D<double>(-degrees * kDegree).toRotationMatrix();
    PieceMesh turned = part_;
    for (Mat2& edges : turned.rest_edges) edges = turn * edges;
    turned.x.leftCols<2>() = part_.x.leftCols<2>() * turn.transpose();
    turned.corners.leftCols<2>() = part_.corners.leftCols<2>() * turn.transpose();
    const Trial trial = flattenPart(turned, {}, settings_, kIterations);
    const double width = trial.x.col(1).maxCoeff() - trial.x.col(1).minCoeff();
    const bool is_possible =
        trial.is_sound && trial.badness.over <= given_.badness.over + kTolerance && width <= settings_.widest;
    return is_possible ? trial.strain.thread_mean : INFINITY;
  }

  PieceMesh part_;
  const FlatSettings& settings_;
  Trial given_;  // with the garment's grain
};

}  // namespace

std::vector<double> freeGrain(const RestGarment& garment, const Pieces& pieces, const FlatSettings& settings) {
  std::vector<double> angles(pieces.count, 0.0);
  parallelFor(pieces.count, 1, [&](int p) { angles[p] = Turning(partOf(garment, pieces, p), settings).best(); });
  return angles;
}

RestGarment withGrain(const RestGarment& garment, const Pieces& pieces, const std::vector<double>& angle_of_piece) {
  RestGarment turned = garment;
  for (size_t t = 0; t < turned.rest_edges.size(); ++t) {
    const double angle = angle_of_piece[pieces.piece[t]];
    if (angle != 0.0)
      turned.rest_edges[t] = Eigen::Rotation2D<double>(-angle).toRotationMatrix() * turned.rest_edges[t];
  }
  return turned;
}

}  // namespace ease
