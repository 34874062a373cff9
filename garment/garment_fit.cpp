#include "garment/garment_fit.h"

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"
#include "solver/base/parallel.h"
#include "solver/mesh/topology.h"

namespace ease {
namespace {

/// Finds the plane in which a boundary loop lies: the one with the smallest sum of distances to the loop's vertices.
const Plane& cutOf(const std::vector<Plane>& cuts, const std::vector<int>& loop, const Positions& positions) {
  const auto deviation = [&](const Plane& cut) {
    double sum = 0.0;
    for (int v : loop) sum += std::abs(planeDistance(cut, positions.row(v)));
    return sum;
  };
  const auto closer = [&](const Plane& p, const Plane& q) { return deviation(p) < deviation(q); };
  return *std::min_element(cuts.begin(), cuts.end(), closer);
}

Vec3 intoPlane(const Plane& plane, const Vec3& x) {
  return x - planeDistance(plane, x) * plane.normal;
}

/// Projects the unit vector `direction` into the plane and lengthens it, so that a step along the result still advances
/// by 1 along `direction`.  Where the plane is nearly normal to `direction` the length is limited.
Vec3 alongPlane(const Plane& plane, const Vec3& direction) {
  const Vec3 along = direction - plane.normal.dot(direction) * plane.normal;
  return along / std::max(along.squaredNorm(), 0.1);
}

/// Moves `x` within the plane onto the curve where the field is zero.
Vec3 ontoCurve(const DistanceField& field, const Plane& plane, const Vec3& x) {
  Vec3 y = intoPlane(plane, x);
  for (int i = 0; i < 6; ++i) {
    const Distance d = field(y);
    y -= d.value * alongPlane(plane, d.gradient);
    if (std::abs(d.value) < 1e-7) break;
  }
  return y;
}

void settleLoop(const DistanceField& field, const Plane& cut, const std::vector<int>& loop, int passes,
                Positions& positions) {
  const int count = static_cast<int>(loop.size());
  std::vector<Vec3> points(count), glided(count);
  for (int i = 0; i < count; ++i) points[i] = ontoCurve(field, cut, positions.row(loop[i]));
  for (int pass = 0; pass < passes; ++pass) {
    parallelFor(count, 64, [&](int i) {
      const Vec3 &before = points[(i + count - 1) % count], &after = points[(i + 1) % count];
      const Vec3 along = (after - before).normalized();
      const Vec3 glide = 0.5 * along.dot(0.5 * (before + after) - points[i]) * along;
      glided[i] = ontoCurve(field, cut, points[i] + glide);
    });
    points.swap(glided);
  }
  for (int i = 0; i < count; ++i) positions.row(loop[i]) = points[i];
}

/// Computes how much clearance the sample `x` lacks, m, and the direction out of the body there.
Distance lack(const DistanceField& body, double clearance, const Vec3& x) {
  const Distance d = body(x);
  return {clearance - d.value, d.gradient.normalized()};
}

/// Makes one round of keepClear().  Returns false if nothing had to move.
bool pushOut(const DistanceField& body, const std::vector<const Plane*>& plane_of, double clearance,
             TriangleMesh& mesh) {
  const int triangles = static_cast<int>(mesh.triangles.rows());
  constexpr int kSamples = 7;  // corners, midpoints, centroid
  static const double kWeights[kSamples][3] = {
      {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {.5, .5, 0}, {0, .5, .5}, {.5, 0, .5}, {1. / 3, 1. / 3, 1. / 3}};
  std::vector<Distance> lacks(kSamples * triangles);
  parallelFor(kSamples * triangles, 512, [&](int i) {
    Vec3 x = Vec3::Zero();
    for (int k = 0; k < 3; ++k) x += kWeights[i % kSamples][k] * mesh.positions.row(mesh.triangles(i / kSamples, k));
    lacks[i] = lack(body, clearance, x);
  });

  // Each vertex moves out by the largest lack of clearance among the samples that depend on it.
  std::vector<Distance> worst(mesh.positions.rows(), {0.0, Vec3::Zero()});
  for (int i = 0; i < kSamples * triangles; ++i)
    for (int k = 0; k < 3; ++k) {
      Distance& known = worst[mesh.triangles(i / kSamples, k)];
      if (kWeights[i % kSamples][k] > 0.0 && lacks[i].value > known.value) known = lacks[i];
    }
  constexpr double kOvershoot = 1e-4;  // m: without it the last micrometres would take many rounds
  bool has_moved = false;
  for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) {
    if (worst[v].value <= 0.0) continue;
    const Vec3 out = plane_of[v] ? alongPlane(*plane_of[v], worst[v].gradient) : worst[v].gradient;
    mesh.positions.row(v) += (worst[v].value + kOvershoot) * out;
    has_moved = true;
  }
  return has_moved;
}

}  // namespace

void settleOnSurface(const DistanceField& field, const std::vector<Plane>& cuts, TriangleMesh& mesh) {
  // If edges are about as long as an arm is thick, evening them out would cut through the arm.
  constexpr double kCoarse = 0.04;  // m
  const Topology topology = buildTopology(mesh, "garment");
  const bool is_coarse = meanEdgeLength(topology, mesh.positions) > kCoarse;
  for (const std::vector<int>& loop : topology.boundary_loops)
    settleLoop(field, cutOf(cuts, loop, mesh.positions), loop, is_coarse ? 0 : 30, mesh.positions);
  if (!is_coarse) relaxOnSurface(field, 12, mesh);
}

void keepClear(const DistanceField& body, const std::vector<Plane>& cuts, double clearance, TriangleMesh& mesh) {
  constexpr int kRounds = 50;
  constexpr double kMargin = 0.001;  // m: in hollows the body's mesh protrudes from the exact surface by up to this
  std::vector<const Plane*> plane_of(mesh.positions.rows(), nullptr);
  for (const std::vector<int>& loop : buildTopology(mesh, "garment").boundary_loops) {
    const Plane& cut = cutOf(cuts, loop, mesh.positions);
    for (int v : loop) plane_of[v] = &cut;
  }
  for (int round = 0; round < kRounds; ++round)
    if (!pushOut(body, plane_of, clearance + kMargin, mesh)) return;
  throw ComputationError("built-in garment: its triangles are too large to stay clear of the body");
}

}  // namespace ease
