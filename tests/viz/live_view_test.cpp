#include "viz/live_view.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"

namespace ease {
namespace {

constexpr PictureSize kSize{80, 60};

/// A square of side 0.4 m at z, seen from the front.
TriangleMesh square(double z) {
  TriangleMesh mesh{Positions(4, 3), Triangles(2, 3)};
  mesh.positions << -0.2, 0.8, z, 0.2, 0.8, z, 0.2, 1.2, z, -0.2, 1.2, z;
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  return mesh;
}

Rgb pixel(const Picture& picture, int x, int y) {
  const size_t first = 4 * (static_cast<size_t>(picture.size.height - 1 - y) * picture.size.width + x);
  return {picture.pixels[first], picture.pixels[first + 1], picture.pixels[first + 2]};
}

TEST_CASE("cloth hides the body behind it, moves, takes colours, and a line is in front of it") {
  std::unique_ptr<LiveView> view;
  try {
    view = std::make_unique<LiveView>();
  } catch (const ComputationError& error) {
    WARN("skipped: " << error.what());
    return;
  }
  Camera camera;
  camera.pitch_deg = 0;
  const Rgb air = pixel(view->draw(camera, kSize), 40, 30);
  CHECK(air[0] > 230);

  view->setBody(square(0.0));
  const Rgb body = pixel(view->draw(camera, kSize), 40, 30);
  CHECK(std::abs(body[0] - body[2]) < 20);
  CHECK(body[0] < 220);

  view->setGarment(square(0.05));
  const Rgb cloth = pixel(view->draw(camera, kSize), 40, 30);
  CHECK(cloth[2] > cloth[0] + 20);

  view->colorGarment({{200, 20, 20}, {200, 20, 20}});
  const Rgb red = pixel(view->draw(camera, kSize), 40, 30);
  CHECK(red[0] > red[1] + 60);

  view->setMarks({{{{-0.2, 1.0, 0.05}, {0.2, 1.0, 0.05}}, false, {0, 200, 0}, 5.0}}, {});
  const Rgb line = pixel(view->draw(camera, kSize), 40, 30);
  CHECK(line[1] > line[0] + 60);

  view->setMarks({}, {});
  Positions away = square(0.05).positions;
  away.col(0).array() += 5.0;
  view->moveGarment(away);
  CHECK(pixel(view->draw(camera, kSize), 40, 30) == body);
}

}  // namespace
}  // namespace ease
