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
  const TriangleMesh body = makeSheet(3, 3, 0.6, 0.6);  // wider: drawn once and kept behind the garment
  input.body_triangles = body.triangles;
  input.poses = {body.positions};
  std::unique_ptr<PagePictures> pictures;
  try {
    pictures = std::make_unique<PagePictures>(input);
  } catch (const ComputationError& error) {
    WARN("skipped: " << error.what());
    return;
  }
  ShownMoment moment;
  moment.garment = input.garment.positions;
  moment.body = body.positions.rowwise() - Eigen::RowVector3d(0.1, 0.1, 0.1);
  moment.sigma_1.assign(input.garment.triangles.rows(), 1.0F);
  const ShownValue value{"", "", 1.0, ColorScale(1.0, 1.2, 1.1), {}};
  const std::vector<float> over(input.garment.positions.rows(), 1.15F);
  const auto drawn = pictures->drawSides({{"within", value, &moment, &moment.sigma_1},
                                          {"over", value, &moment, &over},
                                          {"within again", value, &moment, &moment.sigma_1}});
  for (const SidePictures& row : drawn)
    for (const std::string& picture : row) CHECK_THAT(picture, StartsWith("data:image/jpeg;base64,"));
  CHECK(drawn[0][0] != drawn[1][0]);
  CHECK(drawn[0][0] != drawn[0][2]);  // a sheet seen along its plane
  CHECK(drawn[0] == drawn[2]);
  CHECK_THAT(pictures->drawFrames({{moment}, {}, {}}, value.scale).front(), StartsWith("data:image/jpeg;base64,"));
}
