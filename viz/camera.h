// A camera that turns around a point and keeps the horizon level, as a turntable does.
//
//   pixels    (x, y) from the upper left corner of a picture, y downwards
//   depth     distance from the eye along the direction of view, m
#pragma once

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct PictureSize {
  int width = 1, height = 1;  // pixels
  bool operator==(const PictureSize&) const = default;
};

/// A half-line in space; `direction` is a unit vector.
struct Ray {
  Vec3 from, direction;
};

/// Where a point appears in the picture; it lies behind the eye if depth <= 0.
struct Projected {
  double x, y, depth;
};

struct Camera {
  Vec3 focus = {0.0, 1.0, 0.0};  // the point that it turns around, m
  double distance = 4.0;         // of the eye from the focus, m
  double yaw_deg = 0.0;          // 0: from the front (+z); 90: from the wearer's left (+x)
  double pitch_deg = 5.0;        // above the horizon
  double view_angle_deg = 25.0;  // over the picture's height

  bool operator==(const Camera&) const = default;

  /// Unit vectors: to the right and up in the picture, and towards the eye.
  Vec3 right() const;
  Vec3 up() const;
  Vec3 towardsEye() const;
  Vec3 eye() const { return focus + distance * towardsEye(); }

  Ray through(double x, double y, const PictureSize& size) const;
  Projected project(const Vec3& point, const PictureSize& size) const;
  /// Size of a pixel at this depth, m.
  double metresPerPixel(double depth, const PictureSize& size) const;

  /// Turns by a drag over that many pixels.
  void orbit(double dx, double dy);
  /// Moves so that what lies at the focus follows the pointer.
  void pan(double dx, double dy, const PictureSize& size);
  /// Scales the distance by `factor`, and keeps the point that appears at (x, y) at the depth of the focus there.
  void zoom(double factor, double x, double y, const PictureSize& size);
  /// Shows the whole of a box.
  void frame(const Vec3& lower, const Vec3& upper, const PictureSize& size);
};

}  // namespace ease
