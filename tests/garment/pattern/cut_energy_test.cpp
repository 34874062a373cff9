#include "garment/pattern/cut_energy.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

namespace {

/// A flat sheet that is treated as if it had curvature G everywhere.
RestSurface withCurvature(int n, double size, double g) {
  RestSurface sheet = flatSheet(n, size);
  for (double& curvature : sheet.curvature) curvature = g;
  return sheet;
}

}  // namespace

TEST_CASE("the derivative of the energy by the levels agrees with finite differences, also where three regions meet") {
  const RestSurface surface = cap(12);
  RegionLevels levels = discLevels(surface, 0.043, 0.011, -0.017);
  levels.labels = 3;
  for (int v = 0; v < surface.vertexCount(); ++v)
    levels.phi.push_back(0.6 * surface.mesh.positions(v, 0) + 0.9 * surface.mesh.positions(v, 1) + 0.0123);
  CutEnergy energy(surface, {});
  energy(levels);
  const std::vector<double> derivative = energy.derivative();
  int checked = 0;
  constexpr double kStep = 1e-7;
  for (size_t i = 0; i < derivative.size(); i += 3) {
    if (derivative[i] == 0.0) continue;
    RegionLevels moved = levels;
    moved.phi[i] += kStep;
    const double ahead = energy(moved);
    moved.phi[i] -= 2.0 * kStep;
    CHECK(derivative[i] == Approx((ahead - energy(moved)) / (2.0 * kStep)).epsilon(1e-4).margin(1e-4));
    ++checked;
  }
  CHECK(checked > 20);
}

TEST_CASE("distortion of a disk and its derivative by the radius approach their closed forms") {
  constexpr double kG = 3.0, kR = 0.31, kSize = 1.0;
  double last_value = 1.0, last_slope = 1.0;
  for (const int n : {24, 48}) {
    const RestSurface sheet = withCurvature(n, kSize, kG);
    const double c = 1000.0 * 10.0 / (kSize * kSize);
    // u = G (r^2 - R^2) / 4, so that  c integral u^2 = pi c G^2 R^6 / 48,  c G^2 R^4 / 16 along its border.
    CutEnergy energy(sheet, {10.0, 0.0});
    // Only the disk's part: outside, curvature is 0.
    RestSurface inside = sheet;
    for (int t = 0; t < inside.triangleCount(); ++t) {
      Vec3 middle = Vec3::Zero();
      for (int k = 0; k < 3; ++k) middle += inside.mesh.positions.row(inside.mesh.triangles(t, k)).transpose() / 3.0;
      if (middle.norm() > kR + 1.5 * inside.mean_edge) inside.curvature[t] = 0.0;
    }
    CutEnergy of_disk(inside, {10.0, 0.0});
    const double all = of_disk(discLevels(inside, kR));
    const std::vector<double> by_level = of_disk.derivative();
    double slope = 0.0;  // both levels move as the radius grows
    for (int v = 0; v < inside.vertexCount(); ++v) slope += by_level[v] - by_level[inside.vertexCount() + v];
    const double value = M_PI * c * kG * kG * std::pow(kR, 6) / 48.0,
                 by_radius = 2.0 * M_PI * kR * c * kG * kG * std::pow(kR, 4) / 16.0;
    const double value_error = std::abs(all / value - 1.0), slope_error = std::abs(slope / by_radius - 1.0);
    INFO(n << ": " << value_error << ", " << slope_error);
    CHECK(value_error < 0.06);
    CHECK(slope_error < 0.12);
    CHECK(value_error < last_value);
    CHECK(slope_error < last_slope);
    last_value = value_error;
    last_slope = slope_error;
  }
}

TEST_CASE("the length of a straight line is exact, and a closed surface without lines costs infinitely much") {
  const RestSurface sheet = flatSheet(10, 1.0);
  CutEnergy energy(sheet, {0.0, 5.0});
  CHECK(energy(halves(sheet, 0.113)) == Approx(2.0 * 5.0 * 1.0));
  CHECK(energy.length() == Approx(1.0));

  TriangleMesh tetrahedron{Positions(4, 3), Triangles(4, 3)};
  tetrahedron.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  tetrahedron.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  const RestSurface closed = restSurface(tetrahedron, restGarment(tetrahedron, {}, {0.3, -0.8, 0.2}).rest_edges);
  CutEnergy of_closed(closed, {});
  const double without = of_closed({1, std::vector<double>(4, -1.0)});
  CHECK((std::isinf(without) || without > 1e6));
}
