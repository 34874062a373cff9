#include "apps/pattern_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "apps/pattern_json.h"
#include "apps/pattern_pictures.h"
#include "apps/words.h"
#include "garment/pattern/dxf_file.h"
#include "garment/pattern/paper_tiles.h"
#include "garment/pattern/sew_line.h"
#include "garment/pattern/sheet.h"
#include "garment/pattern/svg_file.h"
#include "solver/base/whole_file.h"

namespace ease {

namespace {

bool asksFor(const Scene& scene, const char* format) {
  const std::vector<std::string>& formats = scene.pattern.formats;
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

/// "allowances are drawn: 10 mm; hem 30 mm", as many as a line has room for: the pieces tell them, too.
std::string allowanceWords(const Allowances& allowances) {
  constexpr size_t kRoom = 90;  // letters
  const std::string others = "; others stand on the pieces";
  std::string words = fmt::format("allowances are drawn: {:.3g} mm", 1e3 * allowances.all);
  for (const auto& [name, width] : allowances.by_name) {
    if (width == allowances.all) continue;
    const std::string more = fmt::format("; {} {:.3g} mm", name, 1e3 * width);
    if (words.size() + more.size() + others.size() > kRoom) return words + others;
    words += more;
  }
  return words;
}

std::string summaryOf(const Scene& scene, const MadePattern& made) {
  const FlatPattern& flat = made.flat;
  double seams = 0.0, worst_side = 0.0;
  int darts = 0;
  for (const SeamSides& sides : flat.seams) {
    seams += sides.rest_length;
    worst_side = std::max(worst_side, std::abs(sides.left_length - sides.right_length));
  }
  std::string text;
  for (const FlatPiece& piece : flat.pieces) {
    darts += piece.darts;
    text += fmt::format(
        "{:<22} {:.3f} m^2; threads up to {:.1f} % on 98 % of it, over {:g} % on {:.2f} %; "
        "shear up to {:.1f} deg on 99 %; {}{}\n",
        piece.name, piece.strain.area, 100.0 * piece.strain.thread_p98, 100.0 * scene.pattern.limits.thread,
        100.0 * piece.strain.thread_over_share, piece.strain.shear_p99 * 180.0 / M_PI, counted(piece.darts, "dart"),
        piece.grain == 0.0 ? "" : fmt::format(", grain turned by {:+.0f} deg", piece.grain * 180.0 / M_PI));
  }
  text += fmt::format(
      "pattern   {}, {}, {:.2f} m to sew, sides equal within {:.2f} mm; {:.2f} m of cloth {:g} m wide; "
      "{:.1f} s\n",
      counted(static_cast<long>(flat.pieces.size()), "piece"), counted(darts, "dart"), seams, 1e3 * worst_side,
      1e-3 * made.cloth_length_mm, scene.pattern.fabric_width, made.wall_s);
  if (made.cuts)
    text += fmt::format(
        "cuts      found in {} steps in {:.1f} s: {} pieces, {:.2f} m of seams, and {:.2f} m without needless ones\n",
        made.cuts->energies.size() - 1, made.cuts->wall_s, made.cuts->pieces_before, made.cuts->length_before,
        made.cuts->length);
  if (!made.resewn) return text;
  const Resewn& resewn = *made.resewn;
  const auto line = [&](const ResewnPose& pose) {
    text += fmt::format("sewn      pose {}: {:.1f} mm from the design (RMS), {:.1f} mm at most\n", pose.pose,
                        1e3 * pose.rms_m, 1e3 * pose.max_m);
  };
  if (!resewn.own.pose.empty()) line(resewn.own);
  for (const ResewnPose& pose : resewn.poses)
    if (resewn.own.pose.empty() || resewn.poses.size() > 1 || pose.pose != resewn.own.pose) line(pose);
  if (resewn.has_limit)
    text += fmt::format(
        "          over the limit: {:.2f} % of the triangles, {:.2f} % as designed; let out {}, cloth {:+.2f} %\n",
        100.0 * resewn.over_limit, 100.0 * resewn.designed_over_limit, counted(resewn.rounds, "time"),
        100.0 * (resewn.area_ratio - 1.0));
  return text;
}

}  // namespace

std::vector<std::string> warningsOf(const MadePattern& made) {
  std::vector<std::string> warnings = made.flat.warnings;
  for (std::string& warning : warnings)  // seams of the scene's own end the search unless it is asked for
    if (made.cuts && warning.find("[[garment.seam]]") != std::string::npos)
      warning += ", and [pattern.cuts] method = 'variational', so that the others are still looked for";
  if (made.cuts) warnings.insert(warnings.end(), made.cuts->warnings.begin(), made.cuts->warnings.end());
  return warnings;
}

void drawPattern(const Scene& scene, MadePattern& made) {
  made.pieces = drawPieces(made.flat, scene.pattern.allowances);
  const std::vector<double> lengths = drawnLengths(made.flat.cut, sewLines(made.flat, scene.pattern.allowances));
  for (SeamSides& sides : made.flat.seams) {
    sides.left_length = 1e-3 * lengths[sides.left];
    sides.right_length = 1e-3 * lengths[sides.right];
  }
  const double width = 1e3 * scene.pattern.fabric_width;
  made.cloth_length_mm = clothLength(made.pieces, width);
  made.sheet = drawSheet(scene.name, made.pieces, width,
                         {allowanceWords(scene.pattern.allowances),
                          fmt::format("cloth: {:.2f} m, {:g} m wide", 1e-3 * made.cloth_length_mm, 1e-3 * width)});
}

std::string writePattern(const Scene& scene, const SceneInput& input, const MadePattern& made,
                         const std::filesystem::path& directory) {
  const Drawing& sheet = made.sheet;
  if (asksFor(scene, "svg")) writeWholeFile(directory / "pattern.svg", svgText(sheet));
  if (asksFor(scene, "pdf")) {
    writeWholeFile(directory / "pattern.pdf", pdfText(sheet, {wholePage(sheet)}));
    writeWholeFile(directory / ("pattern_" + scene.pattern.paper + ".pdf"),
                   pdfText(sheet, paperTiles(sheet, paperNamed(scene.pattern.paper))));
  }
  if (asksFor(scene, "dxf")) writeWholeFile(directory / "pattern.dxf", dxfText(sheet));
  if (asksFor(scene, "json")) writeWholeFile(directory / "pattern.json", patternJson(scene, made));
  writeFlatMesh(made, directory / "pattern.vtp");
  addToReport(scene, made, directory / "report.json");
  std::string text = summaryOf(scene, made);
  for (const std::string& reason : drawPatternPictures(scene, input, made, directory))
    text += "no picture: " + reason + "\n";
  return text;
}

}  // namespace ease
