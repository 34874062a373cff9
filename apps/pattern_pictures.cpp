#include "apps/pattern_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/scene_run.h"
#include "garment/pattern/sheet.h"
#include "garment/pattern/svg_file.h"
#include "viz/flat_picture.h"
#include "viz/picture.h"
#include "viz/vtp.h"

namespace ease {

namespace {

constexpr int kNameSize = 14, kDartNameSize = 11;  // pixels

/// The pieces on their sheet, m; pieces that are mirror images of others lie beside it.
TriangleMesh onSheet(const MadePattern& made) {
  const FlatPattern& flat = made.flat;
  TriangleMesh mesh{flat.x, flat.flat.triangles};
  std::vector<const DrawnPiece*> drawn(flat.pieces.size(), nullptr);
  for (const DrawnPiece& piece : made.sheet.pieces) drawn[piece.source] = &piece;
  std::vector<int> piece_of(flat.x.rows(), 0);
  for (int t = 0; t < flat.flat.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) piece_of[flat.flat.triangles(t, k)] = flat.cut.pieces.piece[t];
  double beside = 1e-3 * made.sheet.width;
  std::vector<PaperPoint> lower(flat.pieces.size());
  for (size_t p = 0; p < flat.pieces.size(); ++p) {
    if (drawn[p]) continue;
    std::vector<PaperPoint> points;
    for (const int v : flat.flat.outlines[p]) points.emplace_back(flat.x(v, 1), -flat.x(v, 0));
    const Bounds bounds = boundsOf(points);
    lower[p] = PaperPoint(beside, 0.0) - bounds.lower;
    beside += bounds.upper.x() - bounds.lower.x() + 0.02;
  }
  for (Eigen::Index v = 0; v < flat.x.rows(); ++v) {
    const auto p = static_cast<size_t>(piece_of[v]);
    const PaperPoint x =
        drawn[p] ? PaperPoint(1e-3 * (drawn[p]->axes * flat.x.row(v).head<2>().transpose() + drawn[p]->origin))
                 : PaperPoint(PaperPoint(flat.x(v, 1), -flat.x(v, 0)) + lower[p]);
    mesh.positions.row(v) << x.x(), x.y(), 0.0;
  }
  return mesh;
}

ViewLine viewLine(const std::vector<PaperPoint>& points, bool is_closed, Ink ink) {
  const int rgb = colourOf(ink);
  ViewLine line{
      {},
      is_closed,
      {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb)}};
  for (const PaperPoint& p : points) line.points.emplace_back(1e-3 * p.x(), 1e-3 * p.y(), 0.0);
  return line;
}

std::string drawSheetPicture(const Scene& scene, const MadePattern& made, const std::filesystem::path& file) {
  FlatView view;
  view.pieces = onSheet(made);
  double over = 0.0, area = 0.0;
  for (const FlatPiece& piece : made.flat.pieces) {
    over += piece.strain.area * piece.strain.thread_over_share;
    area += piece.strain.area;
  }
  const double limit = scene.pattern.limits.thread;
  for (const ThreadStrain& strain : made.flat.strains)
    view.values.push_back(static_cast<float>(100.0 * strain.worst()));
  for (const DrawnPiece& piece : made.sheet.pieces) {
    view.lines.push_back(viewLine(piece.cut, true, Ink::cut));
    view.lines.push_back(viewLine(piece.sew, true, Ink::sew));
    for (const Notch& notch : piece.notches) view.lines.push_back(viewLine(notchLine(notch).points, false, Ink::notch));
    for (const DrawnLine& line : piece.lines)
      if (line.ink == Ink::grain) view.lines.push_back(viewLine(line.points, false, Ink::grain));
    for (const DrawnText& text : piece.texts)
      if (text.in_picture)
        view.labels.push_back({{1e-3 * text.at.x(), 1e-3 * text.at.y(), 0.0},
                               text.words,
                               &text == &piece.texts.front() ? kNameSize : kDartNameSize});
  }
  view.title = scene.name + ": sewing pattern";
  view.summary = fmt::format(
      "{} pieces, {:.2f} m of cloth {:g} m wide; threads over the limit on {:.2f} % of the cloth",
      made.flat.pieces.size(), 1e-3 * made.cloth_length_mm, scene.pattern.fabric_width, 100.0 * over / area);
  return drawFlat(file, view, "stretch of the threads when sewn, %", 0.0, 200.0 * limit, 100.0 * limit);
}

std::string drawResewn(const Scene& scene, const SceneInput& input, const MadePattern& made,
                       const std::filesystem::path& file) {
  const Resewn& resewn = *made.resewn;
  const TriangleMesh designed{resewn.designed_end, input.garment.triangles},
      sewn{resewn.sewn_end, input.garment.triangles};
  const int last = scene.body ? posesOfMotion(replaySchedule(scene)).back() : 0;
  const TriangleMesh body = scene.body ? TriangleMesh{input.poses[last], input.body_triangles} : TriangleMesh();
  std::vector<float> away(input.garment.triangles.rows(), 0.0F);
  double largest = 0.0;
  for (size_t t = 0; t < away.size(); ++t) {
    double distance = 0.0;
    for (int k = 0; k < 3; ++k) {
      const int v = input.garment.triangles(static_cast<int>(t), k);
      distance += 1e3 / 3.0 * (designed.positions.row(v) - sewn.positions.row(v)).norm();
    }
    away[t] = static_cast<float>(distance);
    largest = std::max(largest, distance);
  }
  const TriangleMesh* on = scene.body ? &body : nullptr;
  std::vector<StretchView> views = {{"as designed", &designed, std::vector<float>(away.size(), 0.0F), on, " "},
                                    {"as sewn from the pattern", &sewn, away, on,
                                     fmt::format("RMS {:.1f} mm, {:.1f} mm at most", 1e3 * resewn.poses.back().rms_m,
                                                 1e3 * resewn.poses.back().max_m)}};
  for (StretchView& view : views)
    for (const CutLine& line : made.flat.lines)
      view.lines.push_back(
          {positionsOf(line.seam.vertices, view.garment->positions), line.seam.is_closed, {20, 20, 20}});
  constexpr double kShown = 15.0;  // mm
  return drawStretch(file, views, "distance from the design, mm", 0.0, 2.0 * kShown, kShown);
}

}  // namespace

void writeFlatMesh(const MadePattern& made, const std::filesystem::path& file) {
  const TriangleMesh mesh = onSheet(made);
  Frame frame{mesh.positions, {}, {}};
  NamedArray warp{"thread_warp", 1, {}}, weft{"thread_weft", 1, {}}, shear{"shear_deg", 1, {}}, piece{"piece", 1, {}},
      glue{"garment_vertex", 1, {}}, from{"garment_triangle", 1, {}};
  for (const ThreadStrain& strain : made.flat.strains) {
    warp.values.push_back(static_cast<float>(strain.warp));
    weft.values.push_back(static_cast<float>(strain.weft));
    shear.values.push_back(static_cast<float>(strain.shear * 180.0 / M_PI));
  }
  for (const int p : made.flat.cut.pieces.piece) piece.values.push_back(static_cast<float>(p));
  for (const int v : made.file_vertex) glue.values.push_back(static_cast<float>(v));
  for (size_t t = 0; t < made.flat.strains.size(); ++t)
    from.values.push_back(static_cast<float>(made.cuts ? made.cuts->cut.source[t] : static_cast<int>(t)));
  frame.triangle_arrays = {warp, weft, shear, piece, from};
  frame.vertex_arrays = {glue};
  writeVtp(file, mesh.triangles, frame);
}

std::vector<std::string> drawPatternPictures(const Scene& scene, const SceneInput& input, const MadePattern& made,
                                             const std::filesystem::path& directory) {
  std::vector<std::string> reasons = {drawSheetPicture(scene, made, directory / "pattern.png")};
  if (made.resewn) reasons.push_back(drawResewn(scene, input, made, directory / "pattern_resewn.png"));
  std::erase(reasons, "");
  return reasons;
}

}  // namespace ease
