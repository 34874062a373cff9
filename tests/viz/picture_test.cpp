#include "viz/picture.h"

#include "tests/viz/fixtures.h"
#include "tests/viz/png_pixels.h"

using Catch::Matchers::Contains;

TEST_CASE("a picture shows both sides of the limit, on white, at its size, and nothing is printed") {
  const test::Directory directory;
  const auto file = directory.path() / "stretch.png";
  const ease::TriangleMesh mesh = test::gridMesh(20), body = test::gridMesh(5);
  std::vector<float> before(mesh.triangles.rows(), 1.08f), after = before;
  for (std::size_t t = 0; t < before.size() / 2; ++t) before[t] = 1.2f;
  std::string reason;
  const auto draw = [&] {
    reason = ease::drawStretch(file, {{"before", &mesh, before, &body}, {"after", &mesh, after, nullptr}},
                               "largest principal stretch", 0.95, 1.3, 1.1);
  };
  CHECK(test::printedBytes(draw) == 0);
  if (!reason.empty()) {
    WARN("skipped: " << reason);
    return;
  }
  const test::Pixels counts(file);
  CHECK(counts.width == 1600);
  CHECK(counts.height == 1000);
  CHECK(counts.white > 400'000);
  CHECK(counts.blue > 40'000);
  CHECK(counts.orange > 20'000);
  CHECK(std::filesystem::file_size(file) < 300'000);
  CHECK(!std::filesystem::exists(directory.path() / "stretch.png.part"));

  ease::drawStretch(file, {{"after", &mesh, after, nullptr}}, "largest principal stretch", 0.95, 1.1, 1.1);
  CHECK(test::Pixels(file).orange == 0);
}

TEST_CASE("a picture that cannot be made returns the reason and leaves no file") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(4);
  const std::vector<float> values(mesh.triangles.rows(), 1.0f);
  const auto file = directory.path() / "stretch.png";
  CHECK_THAT(ease::drawStretch(file, {{"before", &mesh, {1.0f}, nullptr}}, "", 0.9, 1.2, 1.1),
             Contains("before: 1 values for 18 triangles"));
  CHECK_THAT(ease::drawStretch(file, {}, "", 0.9, 1.2, 1.1), Contains("nothing to draw"));
  CHECK_THAT(ease::drawStretch(file, {{"before", &mesh, values, nullptr}}, "", 1.2, 1.2, 1.1),
             Contains("empty range of colours"));
  CHECK(ease::drawStretch(directory.path() / "gone" / "stretch.png", {{"before", &mesh, values, nullptr}}, "", 0.9, 1.2,
                          1.1) != "");
  CHECK(std::filesystem::is_empty(directory.path()));
}
