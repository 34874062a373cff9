#include "apps/page/page_pictures.h"

#include <catch2/catch.hpp>
#include <memory>

#include "solver/base/error.h"
#include "tests/sheet.h"

using namespace ease;
using Catch::Matchers::StartsWith;

TEST_CASE("a moment is drawn from four sides, coloured by a value of triangles or of vertices") {
  SceneInput input;
  input.garment = makeSheet(3, 3, 0.3, 0.3);
  std::unique_ptr<PagePictures> pictures;
  try {
    pictures = std::make_unique<PagePictures>(input);
  } catch (const ComputationError& error) {
    WARN("skipped: " << error.what());
    return;
  }
  ShownMoment moment;
  moment.garment = input.garment.positions;
  moment.sigma_1.assign(input.garment.triangles.rows(), 1.0F);
  const ColorScale scale(1.0, 1.2, 1.1);
  const std::vector<float> over(input.garment.positions.rows(), 1.15F);
  const std::string within = pictures->draw(moment, moment.sigma_1, scale, 0);
  CHECK_THAT(within, StartsWith("data:image/jpeg;base64,"));
  CHECK(pictures->draw(moment, over, scale, 0) != within);
  CHECK(pictures->draw(moment, moment.sigma_1, scale, 2) != within);  // a sheet seen along its plane
  CHECK(pictures->draw(moment, moment.sigma_1, scale, 0) == within);
  CHECK_THAT(pictures->drawFrames({{moment}, {}, {}}, scale).front(), StartsWith("data:image/jpeg;base64,"));
}
