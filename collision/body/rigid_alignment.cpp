#include "collision/body/rigid_alignment.h"

#include <cmath>

namespace ease {

Standing standingBetween(const Positions& from, const Positions& to) {
  Standing standing;
  standing.from_centre = from.colwise().mean();
  standing.to_centre = to.colwise().mean();
  double along = 0.0, across = 0.0;  // sums of the cosine and sine parts of x' . R x over the horizontal plane
  for (int i = 0; i < from.rows(); ++i) {
    const Vec3 a = from.row(i).transpose() - standing.from_centre, b = to.row(i).transpose() - standing.to_centre;
    along += a.x() * b.x() + a.z() * b.z();
    across += a.z() * b.x() - a.x() * b.z();
  }
  standing.turn_rad = std::atan2(across, along);
  return standing;
}

void standAs(const Standing& standing, Positions& to) {
  const Eigen::Matrix3d back = Eigen::AngleAxisd(-standing.turn_rad, Vec3::UnitY()).toRotationMatrix();
  for (int i = 0; i < to.rows(); ++i)
    to.row(i) = (back * (to.row(i).transpose() - standing.to_centre) + standing.from_centre).transpose();
}

}  // namespace ease
