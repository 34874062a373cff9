#include "garment/pattern/mirror_levels.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr double kMinShare = 0.1;  // of the corners that an image is taken from

/// Barycentric coordinates of the point of a triangle's plane nearest to x, moved into the triangle.
Vec3 sharesNear(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x) {
  const Vec3 n = doubleAreaNormal(a, b, c);
  const double n2 = std::max(n.squaredNorm(), 1e-300);
  Vec3 share(n.dot(doubleAreaNormal(x, b, c)), n.dot(doubleAreaNormal(x, c, a)), 0.0);
  share /= n2;
  share[2] = 1.0 - share[0] - share[1];
  share = share.cwiseMax(0.0);
  return share / share.sum();
}

}  // namespace

MirrorLevels::MirrorLevels(const RestSurface& surface, double plane, double reach) {
  const Positions& x = surface.mesh.positions;
  std::vector<Image> images(surface.vertexCount(), {-1, {}, Vec3::Zero()});
  parallelFor(surface.vertexCount(), 64, [&](int v) {
    if (x(v, 0) >= plane) return;
    const Vec3 image(2.0 * plane - x(v, 0), x(v, 1), x(v, 2));
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int w = 0; w < surface.vertexCount(); ++w)
      if (const double d2 = (x.row(w).transpose() - image).squaredNorm(); d2 < least) {
        least = d2;
        nearest = w;
      }
    if (least > reach * reach) return;
    least = std::numeric_limits<double>::infinity();
    for (const int t : surface.triangles_around[nearest]) {
      const std::array<int, 3> corners = {surface.mesh.triangles(t, 0), surface.mesh.triangles(t, 1),
                                          surface.mesh.triangles(t, 2)};
      const Vec3 share = sharesNear(x.row(corners[0]), x.row(corners[1]), x.row(corners[2]), image);
      const Vec3 at = share[0] * x.row(corners[0]) + share[1] * x.row(corners[1]) + share[2] * x.row(corners[2]);
      if (const double d2 = (at - image).squaredNorm(); d2 < least) {
        least = d2;
        images[v] = {v, corners, share};
      }
    }
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
