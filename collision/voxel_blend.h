// Interpolates distance and normal at a sample point from their exact values at the corners of its voxel.
//
//   x_i, phi_i      corners of the voxel that contains the sample x, and their exact signed distances, m
//   g_i             exact unit gradients there: (x_i - closest point) / phi_i
//   w_i             trilinear weights of x
//
//   phi(x) = sum w_i [phi_i + g_i . (x - x_i) / 2],      normal(x) = sum w_i g_i, normalised
//
// To second order the error of trilinear interpolation (phi_i without the g_i term) is opposite to that of blended
// tangent planes (the g_i term without the factor 1/2).  The formula is their mean, whose error is of third order where
// phi is smooth.  In a fold or at a ridge the corners' gradients disagree and no interpolation is right; the result
// then has `folded` set.
#pragma once

#include <cmath>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct VoxelCorner {
  float gradient[3];  // unit length; zero beyond the band
  float phi;          // m
};

/// Position of a sample in its voxel.  Corner 4 i + 2 j + k is i, j, k steps along x, y, z from the lowest corner.
struct VoxelCorners {
  float within[3];  // position of the sample in the voxel along each axis, 0 to 1
  const VoxelCorner* corner[8];
};

struct VoxelBlend {
  double phi;   // m
  Vec3 normal;  // unit
  int closest;  // number (0 to 7) of the corner closest to the sample
  bool beyond;  // whether a corner is beyond the band: only the sign of phi is right
  bool folded;  // whether the corners' gradients disagree: phi and normal are wrong
};

/// Interpolates at the sample.  `voxel` is the side of a voxel, m; `far` is |phi| of a corner beyond the band, m.
inline VoxelBlend blend(const VoxelCorners& around, double voxel, float far) {
  constexpr double kAgreement = 0.9;  // smallest length of the mean gradient without a fold
  using Four = Eigen::Array4f;        // (g, phi)
  const float fx = around.within[0], fy = around.within[1], fz = around.within[2];
  // Interpolates along z, then y, then x.  `along_z`, `along_y` and `along_x` are the differences between the upper and
  // the lower end in that direction.
  Four at_x[2], along_y[2], along_z[2], largest = Four::Zero();
  for (int i = 0; i < 2; ++i) {
    Four at_y[2], along[2];
    for (int j = 0; j < 2; ++j) {
      const Four low = Eigen::Map<const Four>(around.corner[4 * i + 2 * j]->gradient);
      const Four high = Eigen::Map<const Four>(around.corner[4 * i + 2 * j + 1]->gradient);
      largest = largest.max(low.abs()).max(high.abs());
      along[j] = high - low;
      at_y[j] = low + fz * along[j];
    }
    along_z[i] = along[0] + fy * (along[1] - along[0]);
    along_y[i] = at_y[1] - at_y[0];
    at_x[i] = at_y[0] + fy * along_y[i];
  }
  const Four along_x = at_x[1] - at_x[0], sum = at_x[0] + fx * along_x;
  if (largest[3] >= far)
    for (const VoxelCorner* corner : around.corner)
      if (std::abs(corner->phi) >= far) return {corner->phi, Vec3::Zero(), 0, true, false};
  // slope = sum w_i g_i . (x - x_i), in voxels.  Along x, w_i (x - x_i) is fx (1 - fx) at the lower corners and minus
  // that at the upper ones, times the weights along y and z.
  const float slope = -fx * (1.0f - fx) * along_x[0] -
                      fy * (1.0f - fy) * (along_y[0] + fx * (along_y[1] - along_y[0]))[1] -
                      fz * (1.0f - fz) * (along_z[0] + fx * (along_z[1] - along_z[0]))[2];
  const Vec3 normal(sum[0], sum[1], sum[2]);
  const double agreement = normal.norm();
  const int closest = (fx > 0.5f ? 4 : 0) + (fy > 0.5f ? 2 : 0) + (fz > 0.5f ? 1 : 0);
  return {sum[3] + 0.5 * voxel * slope, normal / agreement, closest, false, agreement < kAgreement};
}

}  // namespace ease
