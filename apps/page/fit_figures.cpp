#include "apps/page/fit_figures.h"

#include <algorithm>
#include <cmath>

namespace ease {

namespace {

constexpr double kApart = 0.05;  // m: between places that are told apart

}  // namespace

std::vector<AreaFigures> areaFigures(const GarmentAreas& areas, const SceneInput& input, const ShownMoment& moment,
                                     const std::vector<double>& first_areas, const std::vector<double>& growth) {
  const size_t count = areas.names.size();
  std::vector<AreaFigures> figures(count + 1);
  std::vector<double> triangles(count + 1, 0.0), corners(count + 1, 0.0), grown(count + 1, 0.0);
  for (int t = 0; t < input.garment.triangles.rows(); ++t) {
    for (const size_t a : {static_cast<size_t>(areas.of_triangle[t]), count}) {
      AreaFigures& area = figures[a];
      if (std::isfinite(moment.sigma_1[t])) area.max_stretch = std::max<double>(area.max_stretch, moment.sigma_1[t]);
      area.share_over_limit += moment.over[t];
      area.cloth_m2 += first_areas[t];
      grown[a] += first_areas[t] * growth[t];
      triangles[a] += 1.0;
      if (moment.distance.empty()) continue;
      for (int corner = 0; corner < 3; ++corner) {
        const int v = input.garment.triangles(t, corner);
        if (!moment.pressure.empty()) area.max_pressure_Pa = std::max<double>(area.max_pressure_Pa, moment.pressure[v]);
        area.mean_distance_m += moment.distance[v];
        corners[a] += 1.0;
      }
    }
  }
  for (size_t a = 0; a <= count; ++a) {
    figures[a].share_over_limit /= std::max(1.0, triangles[a]);
    figures[a].mean_distance_m /= std::max(1.0, corners[a]);
    figures[a].cloth_growth = figures[a].cloth_m2 > 0.0 ? grown[a] / figures[a].cloth_m2 : 1.0;
  }
  return figures;
}

std::vector<TightPlace> tightestPlaces(const MotionAlbum& album, const SceneInput& input, size_t count) {
  std::vector<TightPlace> all(input.garment.triangles.rows());
  for (int t = 0; t < input.garment.triangles.rows(); ++t) all[t].triangle = t;
  for (const ShownMoment& moment : album.moments)
    for (size_t t = 0; t < all.size(); ++t)
      if (moment.sigma_1[t] > all[t].stretch) all[t] = {moment.sigma_1[t], moment.time_s, all[t].triangle};
  std::sort(all.begin(), all.end(), [](const TightPlace& a, const TightPlace& b) {
    return a.stretch != b.stretch ? a.stretch > b.stretch : a.triangle < b.triangle;
  });
  const auto corner = [&](const TightPlace& place) {
    return input.garment.positions.row(input.garment.triangles(place.triangle, 0));
  };
  std::vector<TightPlace> places;
  for (const TightPlace& place : all) {
    if (places.size() == count || place.stretch <= 1.0) break;
    const bool is_new = std::all_of(places.begin(), places.end(), [&](const TightPlace& other) {
      return (corner(place) - corner(other)).norm() > kApart;
    });
    if (is_new) places.push_back(place);
  }
  return places;
}

}  // namespace ease
