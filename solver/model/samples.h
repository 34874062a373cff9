// Contact samples: the points of the cloth at which contact with the body is evaluated.
//
//   sample                 index        corners   weight of each   area that the sample represents
//   vertex i               i            1         1                a_i / 3
//   midpoint of edge e     n + e        2         1/2              sum of a_t / 9 over the edge's triangles t
//   centroid of triangle t n + e_n + t  3         1/3              a_t / 3
//
//   n, e_n   number of vertices and of edges
//   a_i      a third of the rest area of the triangles around vertex i, m^2
//   a_t      rest area of triangle t, m^2
//
// Vertices, midpoints and centroids each represent a third of the cloth.  Vertices alone are not enough: an edge could
// pass through an arm while both of its ends stay outside.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/mesh/topology.h"

namespace ease {

/// Vertices whose mean the sample is; entries from `count` on are unused.
struct SampleCorners {
  int count;
  std::array<int, 3> vertex;
};

/// The samples of one mesh.  It refers to the mesh's edges and triangles, which must outlive it; making one costs
/// nothing.
class ContactSamples {
 public:
  ContactSamples(int vertex_count, const std::vector<Edge>& edges, const Triangles& triangles)
      : vertex_count_(vertex_count), edges_(edges), triangles_(triangles) {}

  int count() const { return centroid(static_cast<int>(triangles_.rows())); }
  /// Indices of the samples on edge e and on triangle t.
  int midpoint(int e) const { return vertex_count_ + e; }
  int centroid(int t) const { return vertex_count_ + static_cast<int>(edges_.size()) + t; }

  SampleCorners corners(int sample) const {
    if (sample < vertex_count_) return {1, {sample, -1, -1}};
    if (sample < centroid(0)) {
      const auto [i, j] = edges_[sample - vertex_count_].vertex;
      return {2, {i, j, -1}};
    }
    const auto t = triangles_.row(sample - centroid(0));
    return {3, {t[0], t[1], t[2]}};
  }

  /// Barycentric weight of a vertex in the sample; 0 where the vertex is none of its corners.
  double weight(int sample, int vertex) const;

  /// Area that the sample represents, m^2, from a third of the area around each vertex and the area of each triangle.
  double area(int sample, std::span<const double> vertex_areas, std::span<const double> triangle_areas) const;

  /// Positions of all samples, m, for vertices at x.
  void positions(const Positions& x, std::vector<Vec3>& samples) const;

  /// Means of the vertices' values at all samples.
  void values(std::span<const double> vertex_values, std::vector<double>& sample_values) const;

 private:
  int vertex_count_;
  const std::vector<Edge>& edges_;
  const Triangles& triangles_;
};

}  // namespace ease
