// Files of a sewing pattern.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/resewn.h"
#include "garment/pattern/flat_pattern.h"
#include "garment/pattern/variational_cut.h"

namespace ease {

/// A pattern with its drawing and what was measured.
struct MadePattern {
  std::optional<FoundCuts> cuts;  // where the program looked for seams
  FlatPattern flat;
  std::vector<int> file_vertex;  // of the garment's file, for each vertex of the cut mesh
  std::vector<DrawnPiece> pieces;
  Drawing sheet;
  double cloth_length_mm = 0.0;  // all pieces, mirrored ones twice
  std::optional<Resewn> resewn;
  double wall_s = 0.0;  // without the replay
};

/// All warnings of the pattern: about its pieces, then about seams that were looked for.
std::vector<std::string> warningsOf(const MadePattern& made);

/// Draws the pieces and lays them out; the lengths of seam sides become those of the drawn lines.  Throws InputError
/// where a piece is wider than the cloth.
void drawPattern(const Scene& scene, MadePattern& made);

/// Writes the files that the scene asks for, pattern.vtp and the pictures into the directory, and the figures into its
/// report.json.  Returns a summary of a few lines.  Throws ComputationError naming a file that could not be written.
std::string writePattern(const Scene& scene, const SceneInput& input, const MadePattern& made,
                         const std::filesystem::path& directory);

}  // namespace ease
