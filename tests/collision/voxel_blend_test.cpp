#include "collision/voxel_blend.h"

#include <array>
#include <catch2/catch.hpp>
#include <functional>

using namespace ease;

namespace {

constexpr float kFar = 1e3f;

/// A voxel of a distance field from its lowest corner on, sampled at `within`.
VoxelBlend blendOf(const Vec3& low, double voxel, const Vec3& within, const std::function<double(Vec3)>& phi,
                   const std::function<Vec3(Vec3)>& gradient) {
  std::array<VoxelCorner, 8> corners;
  VoxelCorners around;
  for (int axis = 0; axis < 3; ++axis) around.within[axis] = static_cast<float>(within[axis]);
  for (int c = 0; c < 8; ++c) {
    const Vec3 x = low + voxel * Vec3(c >> 2, (c >> 1) & 1, c & 1), g = gradient(x);
    for (int axis = 0; axis < 3; ++axis) corners[c].gradient[axis] = static_cast<float>(g[axis]);
    corners[c].phi = static_cast<float>(phi(x));
    around.corner[c] = &corners[c];
  }
  return blend(around, voxel, kFar);
}

/// Largest error of the distance to a sphere in a voxel beside it.
double sphereError(double voxel) {
  const Vec3 low(0.3, 0.4, 0.5);
  double worst = 0.0;
  for (int i = 0; i < 125; ++i) {
    const Vec3 within = 0.2 * Vec3(i / 25, i / 5 % 5, i % 5) + Vec3::Constant(0.1), x = low + voxel * within;
    const VoxelBlend found = blendOf(
        low, voxel, within, [](const Vec3& p) { return p.norm() - 0.5; }, [](const Vec3& p) { return p.normalized(); });
    CHECK_FALSE(found.folded);
    CHECK((found.normal - x.normalized()).norm() < voxel);
    worst = std::max(worst, std::abs(found.phi - (x.norm() - 0.5)));
  }
  return worst;
}

}  // namespace

TEST_CASE("the distance to a plane is blended exactly") {
  const Vec3 normal = Vec3(1.0, 2.0, -0.5).normalized(), low(0.1, 0.2, 0.3), within(0.7, 0.2, 0.4);
  const VoxelBlend found = blendOf(
      low, 0.01, within, [&](const Vec3& p) { return normal.dot(p) - 0.1; }, [&](const Vec3&) { return normal; });
  CHECK(std::abs(found.phi - (normal.dot(low + 0.01 * within) - 0.1)) < 1e-7);
  CHECK((found.normal - normal).norm() < 1e-6);
  CHECK(found.closest == 4);
}

TEST_CASE("distance and normal are the sums of the formula, for any values at the corners") {
  const auto phi = [](const Vec3& p) { return 0.01 * std::sin(130.0 * p.x() + 210.0 * p.y() - 170.0 * p.z()); };
  const auto gradient = [](const Vec3& p) {
    return Vec3(1.0, 0.3 * std::sin(90.0 * p.y()), 0.3 * std::cos(70.0 * p.x() + p.z())).normalized();
  };
  const Vec3 low(0.02, -0.01, 0.03), within(0.8, 0.3, 0.6);
  double distance = 0.0;
  Vec3 normal = Vec3::Zero();
  for (int c = 0; c < 8; ++c) {
    const Vec3 up(c >> 2, (c >> 1) & 1, c & 1), corner = low + 0.01 * up;
    const double weight = (Vec3::Ones() - (within - up).cwiseAbs()).prod();
    distance += weight * (phi(corner) + 0.5 * 0.01 * gradient(corner).dot(within - up));
    normal += weight * gradient(corner);
  }
  const VoxelBlend found = blendOf(low, 0.01, within, phi, gradient);
  CHECK(std::abs(found.phi - distance) < 1e-8);
  CHECK((found.normal - normal.normalized()).norm() < 1e-6);
  CHECK(found.closest == 5);
}

TEST_CASE("the distance to a sphere is blended to third order") {
  const double order = std::log2(sphereError(0.2) / sphereError(0.1));
  CHECK(order > 2.7);
}

TEST_CASE("a fold shows itself") {
  const auto gradient = [](const Vec3& p) { return Vec3(p.x() > 0.005 ? 1.0 : -1.0, 0.0, 0.0); };
  CHECK(blendOf(
            Vec3::Zero(), 0.01, Vec3(0.5, 0.5, 0.5), [](const Vec3&) { return 0.01; }, gradient)
            .folded);
}

TEST_CASE("a corner beyond the band shows itself, with its sign") {
  const auto phi = [](const Vec3& p) { return p.x() > 0.005 ? -2.0 * kFar : -0.01; };
  const VoxelBlend found =
      blendOf(Vec3::Zero(), 0.01, Vec3(0.5, 0.5, 0.5), phi, [](const Vec3&) { return Vec3(1.0, 0.0, 0.0); });
  CHECK(found.beyond);
  CHECK(found.phi < 0.0);
}
