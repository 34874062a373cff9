#include "solver/model/cloth.h"

#include <cmath>

#include "solver/base/error.h"
#include "solver/base/joined.h"
#include "solver/model/warp.h"

namespace ease {

namespace {

/// Flat edges of a triangle seen from `corner`: [p_(c+1) - p_c, p_(c+2) - p_c] for corners p_0, p_1, p_2, m.
Mat2 edgesFrom(const Mat2& rest_edges, int corner) {
  Eigen::Matrix<double, 2, 3> p;
  p << Eigen::Vector2d::Zero(), rest_edges;
  Mat2 edges;
  edges.col(0) = p.col((corner + 1) % 3) - p.col(corner);
  edges.col(1) = p.col((corner + 2) % 3) - p.col(corner);
  return edges;
}

}  // namespace

Cloth::Cloth(const TriangleMesh& mesh, const Vec3& grain, const Material& material)
    : triangles_(mesh.triangles), topology_(buildTopology(mesh, "garment")), material_(material), density_(1.0) {
  RestShape first{mesh.positions, std::vector<Mat2>(triangles_.rows())};
  const std::vector<Vec3> warp = warpDirections(mesh, topology_, grain);
  double area = 0.0;
  for (int t = 0; t < triangles_.rows(); ++t) {
    const Mat32 edges = edgeMatrix(mesh.positions, triangles_, t);
    first.edges[t] = planeFrame(edges, warp[t]).transpose() * edges;
    area += 0.5 * first.edges[t].determinant();
  }
  density_ = material.total_mass ? *material.total_mass / area : material.density;
  setFirst(first);
}

void Cloth::setFirst(const RestShape& first) {
  first_ = first;
  setRest(first_);
}

void Cloth::setRest(const RestShape& rest) {
  ++rest_revision_;
  rest_ = rest;
  rest_inverse_.resize(rest_.edges.size());
  rest_areas_.resize(rest_.edges.size());
  vertex_areas_.assign(vertexCount(), 0.0);
  for (int t = 0; t < triangleCount(); ++t) {
    rest_inverse_[t] = rest_.edges[t].inverse();
    rest_areas_[t] = 0.5 * rest_.edges[t].determinant();
    for (int a = 0; a < 3; ++a) vertex_areas_[triangles_(t, a)] += rest_areas_[t] / 3.0;
  }
  weighMembrane();
  masses_.resize(vertexCount());
  for (int i = 0; i < vertexCount(); ++i) masses_[i] = density_ * vertex_areas_[i];

  if (material_.bending <= 0.0 && material_.damping_bending <= 0.0) return;
  hinges_.clear();
  for (const Edge& edge : topology_.edges) {
    if (edge.isBoundary()) continue;
    const auto [x0, x1] = edge.vertex;
    const auto [t0, t1] = edge.triangle;
    hinges_.push_back(makeHinge({x0, x1, edge.opposite[0], edge.opposite[1]},
                                edgesFrom(rest_.edges[t0], cornerOf(triangles_, t0, x0)),
                                edgesFrom(rest_.edges[t1], cornerOf(triangles_, t1, x1))));
  }
}

void Cloth::setStiffnessScale(const std::vector<double>& scale) {
  if (!scale.empty() && static_cast<int>(scale.size()) != triangleCount())
    throw InputError(joined("stiffness scale: ", scale.size(), " factors for ", triangleCount(), " triangles"));
  for (size_t t = 0; t < scale.size(); ++t)
    if (!(scale[t] > 0.0 && std::isfinite(scale[t])))
      throw InputError(joined("stiffness scale of triangle ", t, " is ", scale[t], ": expected a positive number"));
  ++rest_revision_;
  stiffness_scale_ = scale;
  weighMembrane();
}

void Cloth::weighMembrane() {
  membrane_weights_.resize(stiffness_scale_.size());
  for (size_t t = 0; t < stiffness_scale_.size(); ++t) membrane_weights_[t] = stiffness_scale_[t] * rest_areas_[t];
}

}  // namespace ease
