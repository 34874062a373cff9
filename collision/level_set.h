// Level set of one pose of the body, filled only where the garment can be.
//
// A sparse grid holds exact distances at the corners of voxels; voxel_blend.h interpolates between the eight corners
// around a sample.  Corners that were not filled hold NaN, which reveals a sample that needs one.  Distances at corners
// are exact up to band + sqrt(3) voxels, so that all eight corners of a sample within the band are exact.  In a fold or
// at a ridge, where interpolation fails, the sample's distance is computed from the triangles.
//
// The body is the union of everything that its surface encloses, also where the surface passes through itself.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "collision/triangle_tree.h"

namespace ease {

struct LevelSetOptions {
  double voxel = 0.01;  // m
  double band = 0.03;   // m: larger distances are reported as +-band
};

struct LevelSetSample {
  double phi;    // signed distance to the body, m, negative inside; +-band beyond the band
  Vec3 normal;   // unit, away from the body; zero beyond the band
  int triangle;  // of the body, nearest to the voxel corner that is nearest to the sample; -1 beyond the band
};

struct KnownCorners;  // known_corners.h

class LevelSet {
 public:
  /// Throws InputError naming the option that is out of range and its value.
  explicit LevelSet(const LevelSetOptions& options);
  ~LevelSet();
  LevelSet(LevelSet&&) noexcept;
  LevelSet& operator=(LevelSet&&) noexcept;

  /// Computes distances to `body` at the corners of all voxels within `margin` (m) of the points.  Replaces all earlier
  /// content.  The tree must not change for as long as this level set is sampled.  `known`: corners that a level set of
  /// the same body in the same pose has filled; they are taken over.  Throws ComputationError if a point is not finite.
  void build(const TriangleTree& body, std::span<const Vec3> points, double margin, const KnownCorners& known);
  void build(const TriangleTree& body, std::span<const Vec3> points, double margin);

  /// All corners that have been filled, to be taken over by another level set of this pose.
  KnownCorners known() const;

  /// Samples the points in parallel.  Corners that build() did not foresee are filled first, with the values that
  /// build() would have given them.  Must not be called by two threads at once, nor before build().  Throws
  /// ComputationError if a point is not finite.
  void sample(std::span<const Vec3> points, std::span<LevelSetSample> samples);

  size_t memoryBytes() const;
  long filledVoxels() const;          // number of corners that hold a distance
  long filledOnDemand() const;        // number of corners that sample() had to fill since build()
  long overlappingTriangles() const;  // number of triangles near the points that cross others or lie within the body

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace ease
