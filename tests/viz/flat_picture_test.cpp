#include "viz/flat_picture.h"

#include "tests/viz/fixtures.h"
#include "tests/viz/png_pixels.h"

using Catch::Matchers::Contains;

TEST_CASE("a picture of flat pieces shows both sides of the limit, or says why there is none") {
  const test::Directory directory;
  const auto file = directory.path() / "pattern.png";
  ease::FlatView view;
  view.pieces = test::gridMesh(12);
  view.values.assign(view.pieces.triangles.rows(), 0.045f);
  for (std::size_t t = 0; t < view.values.size() / 2; ++t) view.values[t] = 0.09f;
  view.labels = {{ease::Vec3(0.5, 0.5, 0.0), "front"}};
  view.title = "pattern";
  const std::string reason = ease::drawFlat(file, view, "stretch of threads", 0.0, 0.1, 0.05);
  if (!reason.empty()) {
    WARN("skipped: " << reason);
    return;
  }
  const test::Pixels pixels(file);
  CHECK(pixels.blue > 10'000);
  CHECK(pixels.orange > 10'000);
  CHECK(pixels.white > 100'000);

  view.values.pop_back();
  CHECK_THAT(ease::drawFlat(file, view, "", 0.0, 0.1, 0.05), Contains("241 values for 242 triangles"));
}
