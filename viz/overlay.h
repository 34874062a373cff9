// Text and plain boxes over a picture, placed in pixels from its lower left corner.
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
  /// `scale`: pixels rendered for one of the picture's.
  explicit Overlay(int scale);

  /// Text whose baseline stands at (x, y).
  void text(double x, double y, Align align, const std::string& words, const TextStyle& style);

  /// Boxes side by side or anywhere, each of one colour.
  void boxes(const std::vector<Box>& boxes, const std::vector<Rgb>& colors);

  vtkRenderer* renderer() const { return renderer_; }

 private:
  int scale_;
  vtkSmartPointer<vtkRenderer> renderer_;
};

/// A horizontal scale bar in `box`: the scale's colours, numbers below, `label` beneath them, and the limit above.
void drawScaleBar(Overlay& overlay, const ColorScale& scale, const std::string& label, const Box& box);

}  // namespace ease
