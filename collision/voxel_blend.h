// Interpolates distance and normal at a sample from the exact ones at the corners of its voxel.
//
//   x_i, phi_i      corners of the voxel around x and their exact signed distances, m
//   g_i             exact unit gradients there: (x_i - closest point) / phi_i
//   w_i             trilinear weights of x
//
//   phi(x) = sum w_i [phi_i + g_i . (x - x_i) / 2],      normal(x) = sum w_i g_i, normalised
//
// The errors of trilinear interpolation (phi_i alone) and of blended tangent planes (the whole of g_i) are equal and
// opposite to second order; the error of their mean is of third order where phi is smooth.  Where the corners'
// gradients disagree, in a fold or at a ridge, no interpolation is right, and the result says so.
#pragma once

#include <cmath>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct VoxelCorner {
  float gradient[3];  // unit; zero beyond the band
  float phi;          // m
};

/// Corner 4 i + 2 j + k is i, j, k steps up along x, y, z from the lowest.
struct VoxelCorners {
  float within[3];  // position of the sample in the voxel by axis, 0 to 1
  const VoxelCorner* corner[8];
};

struct VoxelBlend {
  double phi;   // m
  Vec3 normal;  // unit
  int closest;  // number of the corner closest to the sample
  bool beyond;  // a corner is beyond the band: only the sign of phi is right
  bool folded;  // the corners' gradients disagree: phi and normal are wrong
};

/// `voxel`: its side, m; `far`: |phi| of a corner beyond the band, m.
inline VoxelBlend blend(const VoxelCorners& around, double voxel, float far) {
  constexpr double kAgreement = 0.9;  // length of the mean gradient; below this there is a fold
  using Four = Eigen::Array4f;        // (g, phi)
  const float fx = around.within[0], fy = around.within[1], fz = around.within[2];
  // Interpolate along z, then along y, then along x.  `along_z`, `along_y`, `along_x`: differences between the upper
  // and the lower end in that direction.
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
