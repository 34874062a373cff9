// fit.html: what a wearer, a tailor and a researcher want to see of a run, in one page that needs no other file and no
// network.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/page/motion_album.h"
#include "apps/report.h"

namespace ease {

/// What the page is made from, all in the numbering of the scene's garment.
struct FitPage {
  const Scene& scene;
  const SceneInput& input;
  const Report& report;
  const MotionAlbum& before;              // on the first rest shape; empty where there was no such replay
  const MotionAlbum& after;               // on the rest shape that is delivered
  const std::vector<double> first_areas;  // of the triangles of the first rest shape, m^2
  const std::vector<double> rest_areas;   // of those of the rest shape, m^2
};

/// Writes fit.html into the directory, without pictures where OpenGL cannot render.  Throws ComputationError naming the
/// file.
void writeFitPage(const FitPage& page, const std::filesystem::path& directory);

}  // namespace ease
