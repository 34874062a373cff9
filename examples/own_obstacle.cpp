// A square of cloth falls on a ball.  The solver knows no ball: a function of this program tells it, for samples of the
// cloth, which plane they have to stay above.  Anything that you can compute a distance to can be an obstacle like
// this.
#include <ease/solver/linear/gradient_system.h>
#include <ease/solver/step/time_step.h>

#include <algorithm>
#include <cstdio>

#include "square_sheet.h"

namespace {

const ease::Vec3 kCentre(0.0, -0.35, 0.0);  // m
constexpr double kRadius = 0.3;             // m
constexpr double kNear = 0.05;              // m: samples further away than this cannot reach the ball in a time step

/// The tangent plane of the ball at its point nearest to x: normal . x = offset.
ease::ContactPlane planeBelow(const ease::Vec3& x) {
  const ease::Vec3 from_centre = x - kCentre;
  const double distance = from_centre.norm();
  ease::ContactPlane plane;  // by default: nothing is near
  if (distance > kRadius + kNear) return plane;
  plane.normal = from_centre / distance;
  plane.offset = plane.normal.dot(kCentre) + kRadius;
  return plane;
}

}  // namespace

int main() {
  const ease::TriangleMesh sheet = squareSheet(30, 1.0, {1, 0, 0}, {0, 0, -1});
  ease::Material material;
  material.bending = 1e-5;  // N m
  const ease::Cloth cloth(sheet, {0, 0, 1}, material);
  const std::vector<int> ordering = ease::systemOrdering(cloth.vertexCount(), cloth.triangles());
  ease::TimeStep time_step(cloth, ease::MethodOptions(), ordering);

  // One plane for each vertex, each edge's midpoint and each triangle's centroid, in this order.
  const auto find_contacts = [&](const ease::Positions& x, ease::Contacts& contacts) {
    contacts.planes.clear();
    contacts.seconds.clear();
    for (int i = 0; i < x.rows(); ++i) contacts.planes.push_back(planeBelow(x.row(i)));
    for (const ease::Edge& edge : cloth.topology().edges)
      contacts.planes.push_back(planeBelow((x.row(edge.vertex[0]) + x.row(edge.vertex[1])) / 2.0));
    for (int t = 0; t < cloth.triangleCount(); ++t) {
      const auto corner = cloth.triangles().row(t);
      contacts.planes.push_back(planeBelow((x.row(corner[0]) + x.row(corner[1]) + x.row(corner[2])) / 3.0));
    }
  };

  ease::State state{sheet.positions, ease::Positions::Zero(cloth.vertexCount(), 3)};
  ease::StepOptions options;
  options.h = 0.005;  // s
  for (int step = 1; step <= 160; ++step) {
    time_step.step(state, options, ease::Pins(), find_contacts);
    if (step % 40 != 0) continue;
    const auto distances = (state.positions.rowwise() - kCentre.transpose()).rowwise().norm();
    std::printf("%.1f s: lowest vertex at y = %.3f m, nearest %.2f mm from the ball\n", step * options.h,
                state.positions.col(1).minCoeff(), 1e3 * (distances.minCoeff() - kRadius));
  }
}
