// The garment: its mesh, what it is made of, and its rest shape, with all that follows from them.
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

namespace ease {

class Cloth {
 public:
  /// The mesh is start shape and first rest shape.  `grain`: warp direction.
  Cloth(const TriangleMesh& mesh, const Vec3& grain, const Material& material);

  /// A new rest shape: its mesh in space, and its triangles' flat edges (which carry the grain).
  void setRest(const Positions& rest_positions, const std::vector<Mat2>& rest_edges);

  const Triangles& triangles() const { return triangles_; }
  const Topology& topology() const { return topology_; }
  const Material& material() const { return material_; }
  int vertexCount() const { return static_cast<int>(rest_positions_.rows()); }
  int triangleCount() const { return static_cast<int>(triangles_.rows()); }

  const Positions& restPositions() const { return rest_positions_; }
  const std::vector<Mat2>& restEdges() const { return rest_edges_; }
  const std::vector<Mat2>& restInverse() const { return rest_inverse_; }
  const std::vector<double>& restAreas() const { return rest_areas_; }
  const std::vector<double>& vertexAreas() const { return vertex_areas_; }  // a third of the rest area around, m^2
  const std::vector<double>& masses() const { return masses_; }
  const std::vector<Hinge>& hinges() const { return hinges_; }  // empty without bending
  int restRevision() const { return rest_revision_; }           // how many rest shapes there have been

  /// Deformation gradient of triangle t.
  Mat32 deformation(const Positions& x, int t) const { return edgeMatrix(x, triangles_, t) * rest_inverse_[t]; }

 private:
  Triangles triangles_;
  Topology topology_;
  Material material_;
  double density_;  // kg/m^2
  Positions rest_positions_;
  std::vector<Mat2> rest_edges_, rest_inverse_;
  std::vector<double> rest_areas_, vertex_areas_, masses_;
  std::vector<Hinge> hinges_;
  int rest_revision_ = 0;
};

}  // namespace ease
