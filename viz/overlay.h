// Text and plain boxes drawn over a picture.  Positions are in pixels from the picture's lower left corner.
#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "viz/color_scale.h"

namespace ease {

struct Box {
  double x, y, width, height;  // pixels
};

enum class Align { left, center };

struct TextStyle {
  int size;  // pixels
  Rgb color = {40, 44, 48};
  bool bold = false;
};

class Overlay {
 public:
  /// `scale`: rendered pixels per pixel of the final picture, in each direction.
  explicit Overlay(int scale);

  /// Adds a text.  (x, y) is the left end or the centre of its baseline, as `align` says.
  void text(double x, double y, Align align, const std::string& words, const TextStyle& style);

  /// Adds filled boxes; `colors` has one colour per box.
  void boxes(const std::vector<Box>& boxes, const std::vector<Rgb>& colors);

  vtkRenderer* renderer() const { return renderer_; }

 private:
  int scale_;
  vtkSmartPointer<vtkRenderer> renderer_;
};

/// Draws a horizontal scale bar: the scale's colours in `box`, the limit above it, and below it the numbers and then
/// `label`.
void drawScaleBar(Overlay& overlay, const ColorScale& scale, const std::string& label, const Box& box);

}  // namespace ease
