// Level set of one pose of the body, filled only where the garment can be.
//
// A sparse grid holds the exact distances at the corners of voxels, and voxel_blend.h says what they make of a sample;
// its unfilled corners are NaN, so that a sample that needs one shows itself.  Corners are searched as far as
// band + sqrt(3) voxels, so that all eight of a sample within the band are exact.  In a fold or at a ridge the sample
// is computed exactly.  The body is the union of all that its surface encloses.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "collision/triangle_tree.h"

namespace ease {

struct LevelSetOptions {
  double voxel = 0.01;  // m
  double band = 0.03;   // m: distances are exact up to here; beyond, +-band
};

struct LevelSetSample {
  double phi;    // signed distance to the body, m, negative inside; +-band where further
  Vec3 normal;   // unit, away from the body; zero where beyond the band
  int triangle;  // of the body, nearest to a corner of the sample's voxel; -1 beyond the band
};

class LevelSet {
 public:
  /// Throws InputError naming the option that is out of range and its value.
  explicit LevelSet(const LevelSetOptions& options);
  ~LevelSet();
  LevelSet(LevelSet&&) noexcept;
  LevelSet& operator=(LevelSet&&) noexcept;

  /// Distances to `body` at the corners of all voxels within `margin` (m) of the points.  Replaces what was there; the
  /// tree must stay as it is for as long as this level set is sampled.  Throws ComputationError where a point is not
  /// finite.
  void build(const TriangleTree& body, std::span<const Vec3> points, double margin);

  /// Samples the points in parallel; voxels that build() did not foresee are filled first, to the same values.  Not to
  /// be called from two threads at once, nor before build().  Throws ComputationError where a point is not finite.
  void sample(std::span<const Vec3> points, std::span<LevelSetSample> samples);

  size_t memoryBytes() const;
  long filledVoxels() const;          // corners that hold a distance
  long filledOnDemand() const;        // of these, those that sample() had to fill since build()
  long overlappingTriangles() const;  // of the body near the points: they cross others or lie within the body

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace ease
