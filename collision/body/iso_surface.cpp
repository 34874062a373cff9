#include "collision/body/iso_surface.h"

#include <openvdb/tools/VolumeToMesh.h>

#include <cmath>

#include "collision/body/surface_relaxation.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr int kLeaf = 8;  // voxels along the edge of a leaf of the grid

using Leaf = openvdb::FloatTree::LeafNodeType;

/// Position of a voxel's sample, m.
Vec3 toWorld(const openvdb::Coord& voxel, double size) {
  // Samples lie half a voxel off the planes x = 0 and y = 0, so that a symmetric shape is sampled symmetrically.
  return size * Vec3(voxel.x() + 0.5, voxel.y() + 0.5, voxel.z() + 0.5);
}

/// Finds the leaves of the box that the surface may pass through; the other leaves become tiles of constant sign in
/// `grid`.
std::vector<openvdb::Coord> findLeaves(const DistanceField& field, const Vec3& lower, const Vec3& upper, double voxel,
                                       openvdb::FloatGrid& grid) {
  const double size = kLeaf * voxel;
  const Eigen::Vector3i first = (lower / size).array().floor().cast<int>();
  const Eigen::Vector3i count = (upper / size).array().ceil().cast<int>() - first.array();
  const auto corner = [&](int i) {
    return openvdb::Coord(kLeaf * (first.x() + i % count.x()), kLeaf * (first.y() + i / count.x() % count.y()),
                          kLeaf * (first.z() + i / (count.x() * count.y())));
  };
  std::vector<double> distances(count.prod());
  parallelFor(static_cast<int>(distances.size()), 32,
              [&](int i) { distances[i] = field(toWorld(corner(i).offsetBy(kLeaf / 2), voxel)).value; });

  // Half the diagonal of a leaf, plus two voxels for samples of neighbouring leaves, times 1.3 for slopes above one.
  const double reach = 1.3 * (0.5 * std::sqrt(3.0) * kLeaf + 2.0) * voxel;
  std::vector<openvdb::Coord> leaves;
  for (size_t i = 0; i < distances.size(); ++i) {
    const openvdb::Coord origin = corner(static_cast<int>(i));
    if (std::abs(distances[i]) < reach)
      leaves.push_back(origin);
    else if (distances[i] < 0.0)
      grid.tree().addTile(1, origin, -grid.background(), false);
  }
  return leaves;
}

/// Samples the field in all leaves that the surface may pass through.
openvdb::FloatGrid::Ptr sampleField(const DistanceField& field, const Vec3& lower, const Vec3& upper, double voxel) {
  auto grid = openvdb::FloatGrid::create(static_cast<float>(kLeaf * voxel));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  const std::vector<openvdb::Coord> origins = findLeaves(field, lower, upper, voxel, *grid);
  std::vector<Leaf*> leaves;
  for (const openvdb::Coord& origin : origins) leaves.push_back(grid->tree().touchLeaf(origin));
  parallelFor(static_cast<int>(leaves.size()), 4, [&](int l) {
    for (openvdb::Index i = 0; i < Leaf::SIZE; ++i) {
      const Vec3 x = toWorld(leaves[l]->offsetToGlobalCoord(i), voxel);
      leaves[l]->setValueOn(i, static_cast<float>(field(x).value));
    }
  });
  return grid;
}

/// Squared length of the diagonal of a quad from corner k, m^2.
double diagonal(const Positions& positions, const openvdb::Vec4I& quad, int k) {
  return (positions.row(quad[k]) - positions.row(quad[k + 2])).squaredNorm();
}

}  // namespace

TriangleMesh isoSurface(const DistanceField& field, const Vec3& lower, const Vec3& upper, double voxel) {
  const openvdb::FloatGrid::Ptr grid = sampleField(field, lower, upper, voxel);
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(*grid, points, quads, 0.0);

  TriangleMesh mesh;
  mesh.positions.resize(points.size(), 3);
  parallelFor(static_cast<int>(points.size()), 256, [&](int i) {
    const Vec3 x = voxel * (Vec3(points[i].x(), points[i].y(), points[i].z()).array() + 0.5).matrix();
    mesh.positions.row(i) = ontoSurface(field, x);
  });
  // volumeToMesh winds its quads clockwise from outside.
  mesh.triangles.resize(2 * quads.size(), 3);
  for (size_t q = 0; q < quads.size(); ++q) {
    const openvdb::Vec4I& quad = quads[q];
    const int s = diagonal(mesh.positions, quad, 0) <= diagonal(mesh.positions, quad, 1) ? 0 : 1;
    const auto corner = [&](int i) { return static_cast<int>(quad[(s + i) % 4]); };
    mesh.triangles.row(2 * q) << corner(0), corner(2), corner(1);
    mesh.triangles.row(2 * q + 1) << corner(0), corner(3), corner(2);
  }
  relaxOnSurface(field, 12, mesh);
  return mesh;
}

}  // namespace ease
