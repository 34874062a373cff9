// Pictures of a run: the garment on the body, coloured by its larger principal stretch.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adaption/stretch_measure.h"
#include "apps/scene.h"

namespace ease {

/// The stretch that pictures mark, and beyond which the editor lets cloth out: the scene's limit, or 0.1 without one.
double shownLimit(const Scene& scene);

/// A garment to be drawn in a picture.
struct ShownGarment {
  TriangleMesh mesh;
  std::vector<Stretch> stretch;  // of every triangle
};

/// The garment at the start and at the end of a replay.
struct ShownReplay {
  ShownGarment start, end;
};

/// Returns the cloth at positions `x`, with its stretch relative to the current rest shape.
ShownGarment showGarment(const Cloth& cloth, const Positions& x);

/// A column of a picture.
struct ShownColumn {
  const char* title;
  const ShownGarment* garment;
};

/// Draws the garments side by side, each on `body`, which may be empty.  The colour scale ends at twice `limit` and
/// shows the limit; crumpled triangles (stretch_measure.h) are grey.  The first of the `doubts` (doubts.h) stands where
/// the largest stretch would.  Returns an empty string, or the reason why no picture could be made.
std::string drawGarments(const std::filesystem::path& file, const std::vector<ShownColumn>& columns,
                         const TriangleMesh& body, double limit, const std::vector<std::string>& doubts);

/// Draws how two replays ended, stretch.png, and began, stretch_first_pose.png, each on the body of that moment.
/// Returns the reasons why pictures could not be made.
std::vector<std::string> drawReplays(const std::filesystem::path& directory, const ShownReplay& before,
                                     const ShownReplay& after, const TriangleMesh& last_body,
                                     const TriangleMesh& first_body, double limit,
                                     const std::vector<std::string>& doubts);

}  // namespace ease
