#include "viz/camera.h"

#include <algorithm>
#include <cmath>

namespace ease {

namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kDegreesPerPixel = 0.4;
constexpr double kMaxPitch = 89.0;                          // degrees
constexpr double kMinDistance = 0.05, kMaxDistance = 60.0;  // m

}  // namespace

Vec3 Camera::right() const {
  return {std::cos(yaw_deg * kDegree), 0.0, -std::sin(yaw_deg * kDegree)};
}

Vec3 Camera::towardsEye() const {
  const double flat = std::cos(pitch_deg * kDegree);
  return {flat * std::sin(yaw_deg * kDegree), std::sin(pitch_deg * kDegree), flat * std::cos(yaw_deg * kDegree)};
}

Vec3 Camera::up() const {
  return towardsEye().cross(right());
}

double Camera::metresPerPixel(double depth, const PictureSize& size) const {
  return 2.0 * depth * std::tan(view_angle_deg / 2 * kDegree) / size.height;
}

Ray Camera::through(double x, double y, const PictureSize& size) const {
  const double scale = metresPerPixel(1.0, size);
  const Vec3 direction =
      (x - size.width / 2.0) * scale * right() - (y - size.height / 2.0) * scale * up() - towardsEye();
  return {eye(), direction.normalized()};
}

Projected Camera::project(const Vec3& point, const PictureSize& size) const {
  const Vec3 from_eye = point - eye();
  const double depth = -from_eye.dot(towardsEye());
  const double scale = 1.0 / std::max(1e-9, metresPerPixel(std::max(depth, 1e-9), size));
  return {size.width / 2.0 + scale * from_eye.dot(right()), size.height / 2.0 - scale * from_eye.dot(up()), depth};
}

void Camera::orbit(double dx, double dy) {
  yaw_deg = std::remainder(yaw_deg - kDegreesPerPixel * dx, 360.0);
  pitch_deg = std::clamp(pitch_deg + kDegreesPerPixel * dy, -kMaxPitch, kMaxPitch);
}

void Camera::pan(double dx, double dy, const PictureSize& size) {
  const double scale = metresPerPixel(distance, size);
  focus += -dx * scale * right() + dy * scale * up();
}

void Camera::zoom(double factor, double x, double y, const PictureSize& size) {
  const double before = distance;
  distance = std::clamp(distance * factor, kMinDistance, kMaxDistance);
  const double moved = metresPerPixel(before, size) - metresPerPixel(distance, size);
  focus += moved * ((x - size.width / 2.0) * right() - (y - size.height / 2.0) * up());
}

void Camera::frame(const Vec3& lower, const Vec3& upper, const PictureSize& size) {
  constexpr double kMargin = 1.15;
  focus = (lower + upper) / 2;
  const Vec3 extent = upper - lower;
  const double across = std::hypot(extent.x() * std::cos(yaw_deg * kDegree), extent.z() * std::sin(yaw_deg * kDegree));
  const double half = kMargin * std::max(extent.y(), across * size.height / size.width) / 2;
  const double behind = std::hypot(extent.x() * std::sin(yaw_deg * kDegree), extent.z() * std::cos(yaw_deg * kDegree));
  distance = std::clamp(half / std::tan(view_angle_deg / 2 * kDegree) + behind / 2, kMinDistance, kMaxDistance);
}

}  // namespace ease
