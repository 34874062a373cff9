#include "viz/camera.h"

#include <catch2/catch.hpp>

namespace ease {
namespace {

constexpr PictureSize kSize{800, 600};

TEST_CASE("a point appears where the ray through that pixel meets it") {
  Camera camera;
  camera.yaw_deg = 37;
  camera.pitch_deg = -12;
  const Vec3 point(0.3, 1.2, -0.1);
  const Projected seen = camera.project(point, kSize);
  const Ray ray = camera.through(seen.x, seen.y, kSize);
  CHECK((point - ray.from).cross(ray.direction).norm() < 1e-9);
  CHECK((point - ray.from).dot(ray.direction) > 0.0);
}

TEST_CASE("from the front the wearer's left is on the right, and up is up") {
  const Camera camera;
  CHECK(camera.project({0.1, 1.0, 0.0}, kSize).x > 400.0);
  CHECK(camera.project({0.0, 1.1, 0.0}, kSize).y < 300.0);
  CHECK(camera.project({0.0, 1.0, 100.0}, kSize).depth < 0.0);
}

TEST_CASE("turning keeps the horizon level, and the focus where it is") {
  Camera camera;
  camera.orbit(500, 2000);
  CHECK(camera.right().y() == 0.0);
  CHECK(camera.pitch_deg < 90.0);
  const Projected focus = camera.project(camera.focus, kSize);
  CHECK(focus.x == Approx(400.0));
  CHECK(focus.y == Approx(300.0));
}

TEST_CASE("zooming keeps what lies under the pointer there") {
  Camera camera;
  const Vec3 point = camera.focus + 0.2 * camera.right() + 0.1 * camera.up();
  const Projected before = camera.project(point, kSize);
  camera.zoom(0.5, before.x, before.y, kSize);
  const Projected after = camera.project(point, kSize);
  CHECK(after.x == Approx(before.x));
  CHECK(after.y == Approx(before.y));
}

TEST_CASE("framing shows the whole of a box") {
  Camera camera;
  camera.yaw_deg = 70;
  const Vec3 lower(-0.8, 0.0, -0.2), upper(0.8, 1.8, 0.2);
  camera.frame(lower, upper, kSize);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point(corner & 1 ? lower.x() : upper.x(), corner & 2 ? lower.y() : upper.y(),
                     corner & 4 ? lower.z() : upper.z());
    const Projected seen = camera.project(point, kSize);
    CHECK((seen.x > 0 && seen.x < 800 && seen.y > 0 && seen.y < 600));
  }
}

}  // namespace
}  // namespace ease
