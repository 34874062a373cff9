// A picture of a body, a garment and marks that is drawn again and again: the view of an editor.
//
// It renders to memory without a display, on the graphics card where there is one and that is asked for, otherwise in
// software.  Meshes keep their buffers from picture to picture; only what has changed is handed over.
#pragma once

#include <memory>
#include <vector>

#include "solver/mesh/triangle_mesh.h"
#include "viz/camera.h"
#include "viz/color_scale.h"
#include "viz/renderer.h"

namespace ease {

/// A line on the body or the garment, in front of both but not of what hides it.
struct MarkLine {
  std::vector<Vec3> points;  // m
  bool is_closed = false;
  Rgb color = {0, 0, 0};
  double width = 3.0;  // pixels
  bool operator==(const MarkLine&) const = default;
};

/// A round mark at a point.
struct MarkDot {
  Vec3 at;  // m
  Rgb color;
  bool operator==(const MarkDot&) const = default;
};

/// Pixels, four bytes each (red, green, blue, 255), rows from the lowest to the highest.
struct Picture {
  PictureSize size;
  std::vector<unsigned char> pixels;
};

class LiveView {
 public:
  /// Throws ComputationError if no OpenGL context can be made.
  explicit LiveView(Renderer renderer = Renderer::hardware_first);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  /// Shows these meshes; one without triangles is not shown.
  void setBody(const TriangleMesh& body);
  void setGarment(const TriangleMesh& garment);
  /// Moves the vertices of the mesh shown.
  void moveBody(const Positions& positions);
  void moveGarment(const Positions& positions);
  /// Colours for every triangle; empty: the cloth's own colour.
  void colorGarment(const std::vector<Rgb>& colors);
  /// Colours for every triangle of the body; empty: grey.
  void colorBody(const std::vector<Rgb>& colors);
  void setMarks(const std::vector<MarkLine>& lines, const std::vector<MarkDot>& dots);
  void showBody(bool is_shown);
  void showEdges(bool are_shown);  // of the garment's triangles

  /// Draws.  The result stays until the next call.
  const Picture& draw(const Camera& camera, const PictureSize& size);

  /// Colours that pixels of body and cloth are shaded from.
  static constexpr Rgb kBodyColor = {196, 192, 188}, kClothColor = {118, 168, 204};

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ease
