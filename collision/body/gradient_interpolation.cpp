#include "collision/body/gradient_interpolation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <queue>

#include "solver/base/error.h"
#include "solver/base/parallel.h"
#include "solver/mesh/disjoint_sets.h"

namespace ease {

namespace {

/// Rotation matrix of a rotation vector (axis times angle, rad).
Mat3 rotationMatrix(const Vec3& vector) {
  const double angle = vector.norm();
  if (angle == 0.0) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

/// Completes the orthonormal basis of a plane by its normal.
Mat3 basis(const Mat32& frame) {
  Mat3 complete;
  complete << frame, frame.col(0).cross(frame.col(1));
  return complete;
}

/// Among the rotation vectors of the same rotation as `vector`, returns the one nearest to `other`.
Vec3 nearestBranch(const Vec3& vector, const Vec3& other) {
  const double angle = vector.norm();
  const Vec3 axis = angle > 0.0 ? Vec3(vector / angle) : Vec3(other.normalized());
  const double turns = std::round((axis.dot(other) - angle) / (2.0 * M_PI));
  return vector + turns * 2.0 * M_PI * axis;
}

/// Finds the neighbours of each triangle across its edges; -1: there is none.
std::vector<std::array<int, 3>> triangleNeighbours(const Triangles& triangles) {
  struct HalfEdge {
    int low, high, triangle, corner;
    auto operator<=>(const HalfEdge&) const = default;
  };
  std::vector<HalfEdge> half_edges;
  for (int t = 0; t < triangles.rows(); ++t)
    for (int a = 0; a < 3; ++a) {
      const auto [low, high] = std::minmax({triangles(t, a), triangles(t, (a + 1) % 3)});
      half_edges.push_back({low, high, t, a});
    }
  std::sort(half_edges.begin(), half_edges.end());
  std::vector<std::array<int, 3>> neighbours(triangles.rows(), {-1, -1, -1});
  for (size_t k = 0; k + 1 < half_edges.size(); ++k) {
    const HalfEdge &a = half_edges[k], &b = half_edges[k + 1];
    if (a.low != b.low || a.high != b.high) continue;
    neighbours[a.triangle][a.corner] = b.triangle;
    neighbours[b.triangle][b.corner] = a.triangle;
  }
  return neighbours;
}

/// Numbers the connected parts; returns the number of each vertex's part.
std::vector<int> connectedParts(int vertices, const Triangles& triangles) {
  DisjointSets sets(vertices);
  for (int t = 0; t < triangles.rows(); ++t)
    for (int a = 1; a < 3; ++a) sets.join(triangles(t, 0), triangles(t, a));
  std::vector<int> part(vertices);
  int count = 0;
  for (int v = 0; v < vertices; ++v) part[v] = sets.find(v) == v ? count++ : part[sets.find(v)];
  return part;
}

}  // namespace

GradientInterpolation::GradientInterpolation(const Triangles& triangles, const Positions& from, const Positions& to,
                                             std::span<const int> ordering)
    : triangles_(triangles), from_(from), to_(to), system_(static_cast<int>(from.rows()), triangles, ordering) {
  const int m = static_cast<int>(triangles.rows());
  std::vector<Mat2> rest_inverse(m);
  std::vector<double> weights(m), diagonal(from.rows(), 0.0);
  frames_.resize(m);
  double mean_weight = 0.0;
  for (int t = 0; t < m; ++t) {
    const Mat32 edges = edgeMatrix(from, triangles, t);
    frames_[t] = planeFrame(edges, edges.col(0));
    const Mat2 flat = frames_[t].transpose() * edges;
    rest_inverse[t] = flat.inverse();
    weights[t] = 0.5 * flat.determinant();
    mean_weight += weights[t] * rest_inverse[t].squaredNorm() / m;
  }
  findParts(from, to);
  // One vertex fixes the position of a part.  The stiffness that holds it affects the conditioning, not the shape.
  for (const Part& part : parts_) diagonal[part.anchor] = mean_weight;
  if (!system_.factor(rest_inverse, weights, diagonal))
    throw ComputationError("pose interpolation: the body's Laplacian is not positive definite");

  findRotations(to, rest_inverse);
  unwindRotations(triangles);
  targets_.resize(m);
  anchors_.setZero(from.rows(), 3);
}

void GradientInterpolation::findParts(const Positions& from, const Positions& to) {
  part_of_ = connectedParts(static_cast<int>(from.rows()), triangles_);
  parts_.resize(*std::max_element(part_of_.begin(), part_of_.end()) + 1);
  for (int v = 0; v < from.rows(); ++v) parts_[part_of_[v]].steady.push_back(v);
  // Motions are stored, not computed in the comparison: the compiler may fuse operations differently on its two sides,
  // and equal motions would compare as different.
  std::vector<std::pair<double, int>> motion(from.rows());
  for (int v = 0; v < from.rows(); ++v) motion[v] = {(to.row(v) - from.row(v)).squaredNorm(), v};
  for (Part& part : parts_) {
    std::sort(part.steady.begin(), part.steady.end(), [&](int a, int b) { return motion[a] < motion[b]; });
    part.steady.resize((part.steady.size() + 1) / 2);
    part.anchor = part.steady.front();
    part.from = part.to = Vec3::Zero();
    for (int v : part.steady) {
      part.from += from.row(v).transpose() / part.steady.size();
      part.to += to.row(v).transpose() / part.steady.size();
    }
  }
}

void GradientInterpolation::findRotations(const Positions& to, std::span<const Mat2> rest_inverse) {
  const int m = static_cast<int>(triangles_.rows());
  rotations_.resize(m);
  stretches_.resize(m);
  parallelFor(m, 256, [&](int t) {
    const Mat32 edges = edgeMatrix(to, triangles_, t), gradient = edges * rest_inverse[t];
    const Mat32 frame = planeFrame(edges, edges.col(0));
    // Normal maps to normal, so that there is never a reflection; the nearest rotation in the plane has a closed form.
    const Mat2 flat = frame.transpose() * gradient;
    const double angle = std::atan2(flat(1, 0) - flat(0, 1), flat(0, 0) + flat(1, 1));
    const Mat3 R = basis(frame * Eigen::Rotation2Dd(angle).toRotationMatrix()) * basis(frames_[t]).transpose();
    const Eigen::AngleAxisd turn(R);
    rotations_[t] = turn.angle() * turn.axis();
    stretches_[t] = R.transpose() * gradient;
  });
}

void GradientInterpolation::unwindRotations(const Triangles& triangles) {
  const std::vector<std::array<int, 3>> neighbours = triangleNeighbours(triangles);
  const int m = static_cast<int>(triangles.rows());
  std::vector<int> by_angle(m);
  std::iota(by_angle.begin(), by_angle.end(), 0);
  std::stable_sort(by_angle.begin(), by_angle.end(),
                   [&](int a, int b) { return rotations_[a].squaredNorm() < rotations_[b].squaredNorm(); });
  struct Step {
    double difference;
    int triangle;
    Vec3 rotation;
    bool operator<(const Step& other) const {  // the smallest difference first
      return std::pair(-difference, -triangle) < std::pair(-other.difference, -other.triangle);
    }
  };
  std::vector<char> done(m, 0);
  for (int seed : by_angle) {
    std::priority_queue<Step> front;
    if (!done[seed]) front.push({0.0, seed, rotations_[seed]});
    while (!front.empty()) {
      const Step step = front.top();
      front.pop();
      if (done[step.triangle]) continue;
      done[step.triangle] = 1;
      rotations_[step.triangle] = step.rotation;
      for (int next : neighbours[step.triangle]) {
        if (next < 0 || done[next]) continue;
        const Vec3 rotation = nearestBranch(rotations_[next], step.rotation);
        front.push({(rotation - step.rotation).norm(), next, rotation});
      }
    }
  }
}

double GradientInterpolation::largestTurn() const {
  double largest = 0.0;
  for (const Vec3& rotation : rotations_) largest = std::max(largest, rotation.norm());
  return largest;
}

void GradientInterpolation::at(double s, Positions& x) {
  if (s == 0.0 || s == 1.0) {
    x = s == 0.0 ? from_ : to_;
    return;
  }
  parallelFor(static_cast<int>(triangles_.rows()), 512, [&](int t) {
    targets_[t] = rotationMatrix(s * rotations_[t]) * ((1.0 - s) * frames_[t] + s * stretches_[t]);
  });
  for (const Part& part : parts_)
    anchors_.row(part.anchor) = (1.0 - s) * from_.row(part.anchor) + s * to_.row(part.anchor);
  system_.solve(targets_, anchors_, x);

  std::vector<Vec3> shift(parts_.size());
  for (size_t p = 0; p < parts_.size(); ++p) {
    shift[p] = (1.0 - s) * parts_[p].from + s * parts_[p].to;
    for (int v : parts_[p].steady) shift[p] -= x.row(v).transpose() / parts_[p].steady.size();
  }
  parallelFor(static_cast<int>(x.rows()), 4096, [&](int v) { x.row(v) += shift[part_of_[v]].transpose(); });
}

}  // namespace ease
