#include "garment/pattern/mirror_levels.h"

#include <algorithm>
#include <numeric>

#include "garment/surface_place.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr double kMinShare = 0.1;  // of the corners that an image is taken from

}  // namespace

MirrorLevels::MirrorLevels(const RestSurface& surface, double plane, double reach) {
  const Positions& x = surface.mesh.positions;
  const SurfacePlaces places(surface.mesh);
  std::vector<Image> images(surface.vertexCount(), {-1, {}, Vec3::Zero()});
  parallelFor(surface.vertexCount(), 64, [&](int v) {
    if (x(v, 0) >= plane) return;
    const Vec3 image(2.0 * plane - x(v, 0), x(v, 1), x(v, 2));
    const SurfacePlace place = places.nearest(image, reach);
    if (place.triangle < 0) return;
    const auto corner = surface.mesh.triangles.row(place.triangle);
    images[v] = {v, {corner[0], corner[1], corner[2]}, place.share};
  });
  for (Image image : images) {
    if (image.vertex < 0) continue;
    for (int k = 0; k < 3; ++k)
      if (images[image.from[k]].vertex >= 0) image.share[k] = 0.0;
    if (image.share.sum() < kMinShare) continue;
    image.share /= image.share.sum();
    images_.push_back(image);
  }
}

void MirrorLevels::operator()(RegionLevels& levels) const {
  for (int k = 0; k < levels.labels; ++k) {
    double* phi = levels.of(k);
    std::vector<double> mirrored;
    for (const Image& image : images_)
      mirrored.push_back(image.share[0] * phi[image.from[0]] + image.share[1] * phi[image.from[1]] +
                         image.share[2] * phi[image.from[2]]);
    for (size_t i = 0; i < images_.size(); ++i) phi[images_[i].vertex] = mirrored[i];
  }
}

void MirrorLevels::gather(int labels, std::vector<double>& derivative) const {
  const size_t n = derivative.size() / static_cast<size_t>(labels);
  for (size_t k = 0; k < static_cast<size_t>(labels); ++k) {
    double* by = derivative.data() + k * n;
    std::vector<double> right;
    for (const Image& image : images_) {
      right.push_back(by[image.vertex]);
      by[image.vertex] = 0.0;
    }
    for (size_t i = 0; i < images_.size(); ++i)
      for (int c = 0; c < 3; ++c) by[images_[i].from[c]] += images_[i].share[c] * right[i];
  }
}

double middlePlane(const RestSurface& surface) {
  std::vector<std::pair<double, double>> places;  // x and area of the triangles
  for (int t = 0; t < surface.triangleCount(); ++t) {
    double x = 0.0;
    for (int k = 0; k < 3; ++k) x += surface.mesh.positions(surface.mesh.triangles(t, k), 0) / 3.0;
    places.emplace_back(x, surface.area[t]);
  }
  std::sort(places.begin(), places.end());
  double so_far = 0.0;
  for (const auto& [x, area] : places) {
    so_far += area;
    if (so_far >= 0.5 * surface.side * surface.side) return x;
  }
  return 0.0;
}

}  // namespace ease
