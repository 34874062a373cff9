// Distance and normal of a sample from exact ones at the corners of its voxel.
//
//   x_i, phi_i      corners of the voxel around x and their exact signed distances, m
//   g_i             exact unit gradients there: (x_i - closest point) / phi_i
//   w_i             trilinear weights of x
//
//   phi(x) = sum w_i [phi_i + g_i . (x - x_i) / 2],      normal(x) = sum w_i g_i, normalised
//
// The errors of trilinear interpolation (phi_i alone) and of blended tangent planes (the whole of g_i) are equal and
// opposite to second order; their mean is of third order where phi is smooth.  Where the corners' gradients disagree,
// in a fold or at a ridge, nothing blended is right.
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
  float within[3];  // where the sample lies between the lowest corner, 0, and the highest, 1
  const VoxelCorner* corner[8];
};

struct VoxelBlend {
  double phi;   // m
  Vec3 normal;  // unit
  int closest;  // of the corners, to the sample
  bool beyond;  // a corner is beyond the band: phi has the right sign, and that is all
  bool folded;  // the corners' gradients disagree: phi and normal are wrong
};

/// `voxel`: its side, m; `far`: |phi| of a corner beyond the band, m.
inline VoxelBlend blend(const VoxelCorners& around, double voxel, float far) {
  constexpr double kAgreement = 0.9;  // of the corners' gradients, as the length of their mean: below, a fold
  const float* f = around.within;
  const float along_x[2] = {1.0f - f[0], f[0]}, along_y[2] = {1.0f - f[1], f[1]}, along_z[2] = {1.0f - f[2], f[2]};
  Eigen::Array4f sum = Eigen::Array4f::Zero();  // of w_i (g_i, phi_i)
  float slope = 0.0f;
  for (int c = 0; c < 8; ++c) {
    const int i = c >> 2, j = (c >> 1) & 1, k = c & 1;
    const VoxelCorner& corner = *around.corner[c];
    const float* g = corner.gradient;
    if (std::abs(corner.phi) >= far) return {corner.phi, Vec3::Zero(), c, true, false};
    const float weight = along_x[i] * along_y[j] * along_z[k];
    sum += weight * Eigen::Map<const Eigen::Array4f>(g);
    slope += weight * (g[0] * (f[0] - i) + g[1] * (f[1] - j) + g[2] * (f[2] - k));
  }
  const Vec3 normal(sum[0], sum[1], sum[2]);
  const double agreement = normal.norm();
  const int closest = (f[0] > 0.5f ? 4 : 0) + (f[1] > 0.5f ? 2 : 0) + (f[2] > 0.5f ? 1 : 0);
  return {sum[3] + 0.5 * voxel * slope, normal / agreement, closest, false, agreement < kAgreement};
}

}  // namespace ease
