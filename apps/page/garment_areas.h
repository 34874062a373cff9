// Parts of a garment by names that its wearer knows, and where on them a triangle lies.
//
//   with seams      the pieces between them, as in the sewing pattern: "front", "left sleeve"
//   without seams   "front" and "back", and what lies next to another loop than neck and hem: "at left"
#pragma once

#include <string>
#include <vector>

#include "apps/scene.h"

namespace ease {

struct GarmentAreas {
  std::vector<int> of_triangle;
  std::vector<std::string> names;
  std::vector<NamedLoop> loops;  // boundary loops of the garment
};

/// The garment's boundary loops: those of its tools, else named by where they lie.
std::vector<NamedLoop> loopsOf(const SceneInput& input);

/// Divides the scene's garment into named areas.
GarmentAreas garmentAreas(const Scene& scene, const SceneInput& input);

/// Where a triangle lies, in words: its area, and the nearest loop or seam with its distance through space on the first
/// pose, in cm.
std::string placeInWords(const GarmentAreas& areas, const SceneInput& input, int triangle);

}  // namespace ease
