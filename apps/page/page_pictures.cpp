#include "apps/page/page_pictures.h"

#include <cmath>

#include "viz/jpeg.h"

namespace ease {

namespace {

constexpr PictureSize kSideSize = {360, 460}, kFrameSize = {520, 620};  // pixels
constexpr std::array<double, 4> kYaw = {0.0, 180.0, 90.0, -90.0};       // degrees, as kSides
constexpr double kFrameYaw = 25.0;                                      // degrees

}  // namespace

PagePictures::PagePictures(const SceneInput& input)
    : input_(input),
      origin_(input.garment.positions.row(0).array().round().matrix().transpose()),
      view_(Renderer::software_first) {
  view_.setGarment({startOf(input).rowwise() - origin_.transpose(), input.garment.triangles});
  if (!input.poses.empty()) view_.setBody({input.poses.front().rowwise() - origin_.transpose(), input.body_triangles});
}

std::string PagePictures::draw(const ShownMoment& moment, const std::vector<float>& values, const ColorScale& scale,
                               size_t side) {
  return drawn(moment, values, scale, moment.garment.colwise().minCoeff(), moment.garment.colwise().maxCoeff(),
               kYaw[side], kSideSize);
}

std::vector<std::string> PagePictures::drawFrames(const MotionAlbum& album, const ColorScale& scale) {
  Vec3 lower = album.moments.front().garment.row(0), upper = lower;
  for (const ShownMoment& each : album.moments) {
    lower = lower.cwiseMin(each.garment.colwise().minCoeff().transpose());
    upper = upper.cwiseMax(each.garment.colwise().maxCoeff().transpose());
  }
  std::vector<std::string> frames;
  for (const ShownMoment& moment : album.moments)
    frames.push_back(drawn(moment, moment.sigma_1, scale, lower, upper, kFrameYaw, kFrameSize));
  return frames;
}

std::string PagePictures::drawn(const ShownMoment& moment, const std::vector<float>& values, const ColorScale& scale,
                                const Vec3& lower, const Vec3& upper, double yaw_deg, const PictureSize& size) {
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
  camera.frame(lower - origin_, upper - origin_, size);
  return jpegDataUri(view_.draw(camera, size));
}

}  // namespace ease
