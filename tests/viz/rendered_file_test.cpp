#include "viz/rendered_file.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

#include "solver/base/error.h"
#include "tests/viz/fixtures.h"
#include "tests/viz/png_pixels.h"

TEST_CASE("what is composed is written at its size, an unwritable file is named") {
  const test::Directory directory;
  const auto orange = [](vtkRenderWindow* window, ease::Overlay&) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1.0, 0.5, 0.0);
    window->AddRenderer(renderer);
  };
  const auto file = directory.path() / "orange.png";
  try {
    ease::renderToFile(file, 60, 40, orange);
  } catch (const ease::ComputationError& error) {
    WARN("skipped: " << error.what());
    return;
  }
  const test::Pixels pixels(file);
  CHECK(pixels.width == 60);
  CHECK(pixels.height == 40);
  CHECK(pixels.orange == 2400);
  CHECK_THROWS_AS(ease::renderToFile(directory.path() / "none" / "orange.png", 60, 40, orange), ease::ComputationError);
}
