// What is on show: body and cloth where they are now, the camera, and what lies under the pointer.
//
// A place on a surface is a triangle with barycentric weights.  So a click in any pose, and on moving cloth, is known
// on the first pose and on the garment as it was made, where the tools work.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "apps/studio/garment_maker.h"
#include "garment/surface_place.h"
#include "viz/camera.h"

namespace ease {

/// Where the place is when the mesh's vertices are there, m.
Vec3 placeOn(const SurfacePlace& place, const Positions& positions, const Triangles& triangles);
/// The place nearest to a point, m.
SurfacePlace nearestPlace(const Vec3& point, const Positions& positions, const Triangles& triangles);
/// The nearest triangle that the ray meets, with its distance (m) from the start of the ray; triangle -1: none.
std::pair<SurfacePlace, double> firstHit(const Ray& ray, const Positions& positions, const Triangles& triangles);

/// What the pointer points at.
struct Hit {
  SurfacePlace place;
  Vec3 at, normal;  // as shown, m
  Vec3 made;        // on the first pose, or on the garment as it was made, m
  double distance;  // from the eye, m
};

/// A boundary loop of the garment under the pointer.
struct LoopHit {
  int loop;  // in MadeGarment::edges
  Vec3 at;   // as shown, m
};

class Stage {
 public:
  Camera camera;
  PictureSize size;

  void setBody(const Triangles& triangles, const Positions& first_pose);
  void moveBody(const Positions& positions) { body_ = positions; }
  void setCloth(std::shared_ptr<const MadeGarment> made, const Positions& positions);
  void removeCloth();

  bool hasBody() const { return body_.rows() > 0; }
  bool hasCloth() const { return made_ != nullptr; }
  const Positions& body() const { return body_; }
  const Positions& firstPose() const { return first_pose_; }
  const Triangles& bodyTriangles() const { return body_triangles_; }
  const Positions& cloth() const { return cloth_; }
  const TriangleMesh& clothAsMade() const { return made_->input.garment; }
  const MadeGarment& made() const { return *made_; }

  /// The body under the pointer, as if it were naked, and the cloth.
  std::optional<Hit> hitBody(double x, double y) const;
  std::optional<Hit> hitCloth(double x, double y) const;
  /// The boundary loop of the garment that is seen nearest to the pointer, within kNearPixels.
  std::optional<LoopHit> hitLoop(double x, double y) const;
  /// The seam under the pointer in the same way: its number.
  std::optional<int> hitSeam(double x, double y) const;
  /// Whether a point (as shown, m) is under the pointer: near it in the picture, and not behind what is seen there.
  bool isAt(const Vec3& point, double x, double y) const;

  Projected project(const Vec3& point) const { return camera.project(point, size); }

  static constexpr double kNearPixels = 12.0;

 private:
  /// Distance from the eye of what is seen at a pixel, m; infinite: nothing.
  double seenAt(double x, double y) const;
  /// The place of a line of the garment's edges that is seen nearest to a pixel, and nearer than `distance` (pixels),
  /// which becomes its own.
  std::optional<Vec3> seenOn(const std::vector<int>& line, bool is_closed, double x, double y, double& distance) const;

  Triangles body_triangles_;
  Positions first_pose_, body_, cloth_;
  std::shared_ptr<const MadeGarment> made_;
};

}  // namespace ease
