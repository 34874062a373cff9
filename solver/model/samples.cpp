#include "solver/model/samples.h"

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kGrain = 2048;  // samples computed by one task

}  // namespace

double ContactSamples::weight(int sample, int vertex) const {
  const SampleCorners c = corners(sample);
  for (int k = 0; k < c.count; ++k)
    if (c.vertex[k] == vertex) return 1.0 / c.count;
  return 0.0;
}

double ContactSamples::area(int sample, std::span<const double> vertex_areas,
                            std::span<const double> triangle_areas) const {
  if (sample < vertex_count_) return vertex_areas[sample] / 3.0;
  if (sample >= centroid(0)) return triangle_areas[sample - centroid(0)] / 3.0;
  double area = 0.0;
  for (const int t : edges_[sample - vertex_count_].triangle)
    if (t >= 0) area += triangle_areas[t] / 9.0;
  return area;
}

void ContactSamples::positions(const Positions& x, std::vector<Vec3>& samples) const {
  const int first_centroid = centroid(0);
  samples.resize(count());
  parallelFor(count(), kGrain, [&](int s) {
    if (s < vertex_count_) {
      samples[s] = x.row(s);
    } else if (s < first_centroid) {
      const auto [i, j] = edges_[s - vertex_count_].vertex;
      samples[s] = 0.5 * (x.row(i) + x.row(j));
    } else {
      const int t = s - first_centroid;
      samples[s] = (x.row(triangles_(t, 0)) + x.row(triangles_(t, 1)) + x.row(triangles_(t, 2))) / 3.0;
    }
  });
}

void ContactSamples::values(std::span<const double> vertex_values, std::vector<double>& sample_values) const {
  sample_values.assign(vertex_values.begin(), vertex_values.end());
  for (const Edge& edge : edges_)
    sample_values.push_back(0.5 * (vertex_values[edge.vertex[0]] + vertex_values[edge.vertex[1]]));
  for (const auto& t : triangles_.rowwise())
    sample_values.push_back((vertex_values[t[0]] + vertex_values[t[1]] + vertex_values[t[2]]) / 3.0);
}

}  // namespace ease
