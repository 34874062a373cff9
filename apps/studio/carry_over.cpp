#include "apps/studio/carry_over.h"

#include <Eigen/SVD>

#include <cmath>
#include <deque>
#include <map>

#include "collision/body_pins.h"
#include "collision/triangle_tree.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr double kAround = 0.08;  // m: the cloth around a vertex whose motion it shares

/// A rigid motion x -> turn (x - from) + to.
struct Motion {
  Eigen::Matrix3d turn;
  Vec3 from, to;
};

/// The rigid motion nearest to that of the tied vertices around vertex `v`.
Motion motionAround(int v, const Positions& before, const Positions& after, const std::vector<char>& is_tied) {
  Motion motion{Eigen::Matrix3d::Identity(), before.row(v), after.row(v)};
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  std::vector<int> around;
  for (int w = 0; w < before.rows(); ++w) {
    if (!is_tied[w] || (before.row(w) - before.row(v)).norm() > kAround) continue;
    around.push_back(w);
    from += before.row(w);
    to += after.row(w);
  }
  if (around.size() < 4) return motion;
  from /= static_cast<double>(around.size());
  to /= static_cast<double>(around.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const int w : around) spread += (Vec3(after.row(w)) - to) * (Vec3(before.row(w)) - from).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(spread, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) sign(2, 2) = -1.0;
  motion.turn = svd.matrixU() * sign * svd.matrixV().transpose();
  return motion;
}

/// For every vertex the tied vertex that is nearest along the mesh's edges; -1 where there is none.
std::vector<int> nearestTied(const std::vector<char>& is_tied, const Topology& topology) {
  const auto neighbours = vertexNeighbours(topology, static_cast<int>(is_tied.size()));
  std::vector<int> nearest(is_tied.size(), -1);
  std::deque<int> front;
  for (size_t v = 0; v < is_tied.size(); ++v)
    if (is_tied[v]) {
      nearest[v] = static_cast<int>(v);
      front.push_back(static_cast<int>(v));
    }
  while (!front.empty()) {
    const int v = front.front();
    front.pop_front();
    for (const int w : neighbours[v])
      if (nearest[w] < 0) {
        nearest[w] = nearest[v];
        front.push_back(w);
      }
  }
  return nearest;
}

}  // namespace

CarriedCloth carryOver(const TriangleMesh& made, const Positions& now, const Positions& velocities,
                       const std::vector<double>& area_ratio, const TriangleMesh& wanted, const Topology& topology) {
  const int n = static_cast<int>(wanted.positions.rows());
  CarriedCloth carried{wanted.positions, Positions::Zero(n, 3), {}, 0};
  const TriangleTree tree(made.positions, made.triangles);
  std::vector<int> near;
  std::vector<char> is_tied(n, 0);
  for (int v = 0; v < n; ++v) {
    if (tree.closest(wanted.positions.row(v), kSamePlace).triangle < 0) continue;
    is_tied[v] = 1;
    near.push_back(v);
  }
  carried.tied = static_cast<int>(near.size());
  const std::vector<BodyTie> ties = tieToBody(near, wanted.positions, made.positions, made.triangles);
  const BodyMoment old_cloth{nullptr, nullptr, &made.triangles, &now, &now};
  for (size_t i = 0; i < near.size(); ++i) {
    carried.positions.row(near[i]) = placeOf(ties[i], old_cloth);
    carried.velocities.row(near[i]) = velocities.row(made.triangles(ties[i].triangle, 0));
  }
  const std::vector<int> nearest = nearestTied(is_tied, topology);
  std::map<int, Motion> motions;
  for (int v = 0; v < n; ++v) {
    if (is_tied[v] || nearest[v] < 0) continue;
    auto found = motions.find(nearest[v]);
    if (found == motions.end())
      found = motions.emplace(nearest[v], motionAround(nearest[v], wanted.positions, carried.positions, is_tied)).first;
    const Motion& motion = found->second;
    carried.positions.row(v) = motion.turn * (Vec3(wanted.positions.row(v)) - motion.from) + motion.to;
  }
  carried.growth.assign(wanted.triangles.rows(), 1.0);
  parallelFor(static_cast<int>(carried.growth.size()), 256, [&](int t) {
    Vec3 centroid = Vec3::Zero();
    for (int k = 0; k < 3; ++k) centroid += wanted.positions.row(wanted.triangles(t, k)) / 3.0;
    const int under = tree.closest(centroid, kSamePlace).triangle;
    if (under >= 0) carried.growth[t] = std::sqrt(area_ratio[under]);
  });
  return carried;
}

}  // namespace ease
