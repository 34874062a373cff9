#include "apps/page/page_pictures.h"

#include <cmath>

#include "solver/base/parallel.h"
#include "viz/jpeg.h"

namespace ease {

namespace {

constexpr PictureSize kSideSize = {360, 460}, kFrameSize = {520, 620};  // pixels
constexpr std::array<double, 4> kYaw = {0.0, 180.0, 90.0, -90.0};       // degrees, as kSides
constexpr double kFrameYaw = 25.0;                                      // degrees

void extend(Eigen::AlignedBox3d& box, const Positions& x) {
  box.extend(x.colwise().minCoeff().transpose()).extend(x.colwise().maxCoeff().transpose());
}

std::vector<std::string> encoded(const std::vector<Picture>& pictures) {
  std::vector<std::string> uris(pictures.size());
  parallelFor(static_cast<int>(pictures.size()), 1, [&](int k) { uris[k] = jpegDataUri(pictures[k]); });
  return uris;
}

}  // namespace

PagePictures::PagePictures(const SceneInput& input)
    : input_(input),
      origin_(input.garment.positions.row(0).array().round().matrix().transpose()),
      view_(Renderer::software_first) {
  view_.setGarment({startOf(input).rowwise() - origin_.transpose(), input.garment.triangles});
  if (!input.poses.empty()) view_.setBody({input.poses.front().rowwise() - origin_.transpose(), input.body_triangles});
}

// Side by side rather than row by row: while camera and body stay as they are, the view reuses its image of the body.
std::vector<SidePictures> PagePictures::drawSides(const std::vector<PictureRow>& rows) {
  Eigen::AlignedBox3d extent;
  for (const PictureRow& row : rows) extend(extent, row.moment->garment);
  std::vector<Picture> pictures;
  for (double yaw_deg : kYaw)
    for (const PictureRow& row : rows)
      pictures.push_back(draw(*row.moment, *row.values, row.value.scale, extent, yaw_deg, kSideSize));
  std::vector<std::string> uris = encoded(pictures);
  std::vector<SidePictures> sides(rows.size());
  for (size_t k = 0; k < uris.size(); ++k) sides[k % rows.size()][k / rows.size()] = std::move(uris[k]);
  return sides;
}

std::vector<std::string> PagePictures::drawFrames(const MotionAlbum& album, const ColorScale& scale) {
  Eigen::AlignedBox3d extent;
  for (const ShownMoment& moment : album.moments) extend(extent, moment.garment);
  std::vector<Picture> pictures;
  for (const ShownMoment& moment : album.moments)
    pictures.push_back(draw(moment, moment.sigma_1, scale, extent, kFrameYaw, kFrameSize));
  return encoded(pictures);
}

const Picture& PagePictures::draw(const ShownMoment& moment, const std::vector<float>& values, const ColorScale& scale,
                                  const Eigen::AlignedBox3d& extent, double yaw_deg, const PictureSize& size) {
  const Triangles& triangles = input_.garment.triangles;
  const bool of_vertices = static_cast<long>(values.size()) == moment.garment.rows();
  std::vector<Rgb> colors(triangles.rows());
  for (int t = 0; t < triangles.rows(); ++t) {
    const auto corners = triangles.row(t);
    const double value = of_vertices ? (values[corners[0]] + values[corners[1]] + values[corners[2]]) / 3.0 : values[t];
    colors[t] = scale.color(value);
  }
  view_.colorGarment(colors);
  view_.moveGarment(moment.garment.rowwise() - origin_.transpose());
  if (moment.body.rows() > 0) view_.moveBody(moment.body.rowwise() - origin_.transpose());
  Camera camera;
  camera.yaw_deg = yaw_deg;
  camera.frame(extent.min() - origin_, extent.max() - origin_, size);
  return view_.draw(camera, size);
}

}  // namespace ease
