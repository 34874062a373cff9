// The garment: its mesh, its material and its rest shape, with the quantities computed from them.
//
//   D_t   2x2 rest edges of triangle t in the material's plane (rows: warp, weft), m
//   a_t   rest area, m^2
//   M     lumped masses: areal density times a third of the rest area around a vertex, kg
//
// The material's frame is the same for the whole garment: warp is the grain direction projected into each triangle.
#pragma once

#include <vector>

#include "solver/mesh/topology.h"
#include "solver/model/hinge.h"
#include "solver/model/material.h"
#include "solver/model/rest_shape.h"
#include "solver/model/samples.h"

namespace ease {

class Cloth {
 public:
  /// The mesh is both the start shape and the first rest shape.  `grain`: warp direction.  Throws InputError if the
  /// mesh is not a manifold (topology.h) or the grain gives a connected part no direction (warp.h).
  Cloth(const TriangleMesh& mesh, const Vec3& grain, const Material& material);

  /// Replaces the rest shape and everything computed from it.  The flat edges carry the grain.
  void setRest(const RestShape& rest);

  /// Replaces the rest shape, and makes it the one from which growth is counted.
  void setFirst(const RestShape& first);

  /// Multiplies the membrane's stiffness and damping in each triangle by a factor of its own, > 0; empty: 1 everywhere.
  /// For users of the library: scenes have no key for it.
  /// Throws InputError where there is not one factor a triangle, or one is not a positive number.
  void setStiffnessScale(const std::vector<double>& scale);

  const RestShape& rest() const { return rest_; }
  /// The rest shape before any growth.
  const RestShape& first() const { return first_; }

  const Triangles& triangles() const { return triangles_; }
  const Topology& topology() const { return topology_; }
  const Material& material() const { return material_; }
  int vertexCount() const { return static_cast<int>(rest_.positions.rows()); }
  int triangleCount() const { return static_cast<int>(triangles_.rows()); }
  /// Refers to this cloth, which must outlive it.
  ContactSamples samples() const { return {vertexCount(), topology_.edges, triangles_}; }

  const Positions& restPositions() const { return rest_.positions; }
  const std::vector<Mat2>& restEdges() const { return rest_.edges; }
  const std::vector<Mat2>& restInverse() const { return rest_inverse_; }
  const std::vector<double>& restAreas() const { return rest_areas_; }
  /// Rest area times stiffness scale of each triangle: what its membrane counts with, m^2.
  const std::vector<double>& membraneWeights() const {
    return stiffness_scale_.empty() ? rest_areas_ : membrane_weights_;
  }
  const std::vector<double>& vertexAreas() const { return vertex_areas_; }  // a third of the rest area around, m^2
  const std::vector<double>& masses() const { return masses_; }
  const std::vector<Hinge>& hinges() const { return hinges_; }  // empty without bending stiffness and damping
  int restRevision() const { return rest_revision_; }           // number of rest shapes and stiffness scales so far

  /// Deformation gradient of triangle t.
  Mat32 deformation(const Positions& x, int t) const { return edgeMatrix(x, triangles_, t) * rest_inverse_[t]; }

 private:
  void weighMembrane();

  Triangles triangles_;
  Topology topology_;
  Material material_;
  double density_;  // kg/m^2
  RestShape first_, rest_;
  std::vector<Mat2> rest_inverse_;
  std::vector<double> rest_areas_, vertex_areas_, masses_;
  std::vector<double> stiffness_scale_, membrane_weights_;
  std::vector<Hinge> hinges_;
  int rest_revision_ = 0;
};

}  // namespace ease
