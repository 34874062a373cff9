#include "apps/studio/tool.h"

#include <algorithm>
#include <cmath>

#include "apps/studio/boundary_tool.h"
#include "apps/studio/brush_tool.h"
#include "apps/studio/extension_tool.h"
#include "apps/studio/pin_tool.h"
#include "apps/studio/region_tool.h"
#include "apps/studio/seam_tool.h"
#include "garment/looped_mesh.h"

namespace ease {

namespace {

constexpr double kMirrorGap = 0.01;  // m: nearer to the middle than that, a loop and its mirrored copy would touch

}  // namespace

std::unique_ptr<Tool> makeTool(PartKind kind, Studio& studio) {
  switch (kind) {
    case PartKind::boundary:
      return std::make_unique<BoundaryTool>(studio);
    case PartKind::region:
      return std::make_unique<RegionTool>(studio);
    case PartKind::extension:
      return std::make_unique<ExtensionTool>(studio);
    case PartKind::pin:
      return std::make_unique<PinTool>(studio);
    case PartKind::seam:
      return std::make_unique<SeamTool>(studio);
    default:
      return std::make_unique<BrushTool>(kind, studio);
  }
}

const ToolText& textOf(PartKind kind) {
  static const ToolText kTexts[] = {{"Boundary", "Draws a closed loop on the body, where the garment ends."},
                                    {"Region", "Makes cloth of the part of the body between the boundaries."},
                                    {"Extension", "Pulls an edge of the garment out: a skirt, a wide sleeve."},
                                    {"Paint", "Adds cloth where you brush, or takes some away."},
                                    {"Comfort", "Sets the least distance between cloth and body where you brush."},
                                    {"Pin", "Lets an edge, or the cloth within a ball, follow the body."},
                                    {"Seam", "Draws lines along which the garment is cut for its sewing pattern."}};
  return kTexts[static_cast<int>(kind)];
}

MarkLine ringAround(const Vec3& at, const Vec3& normal, double radius, const Rgb& color) {
  const Vec3 along = normal.unitOrthogonal(), across = normal.cross(along);
  MarkLine ring{{}, true, color, 2.0};
  constexpr int kCorners = 48;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2.0 * M_PI * k / kCorners;
    ring.points.push_back(at + 0.004 * normal + radius * (std::cos(angle) * along + std::sin(angle) * across));
  }
  return ring;
}

std::vector<Vec3> mirrored(const std::vector<Vec3>& points) {
  std::vector<Vec3> other;
  for (const Vec3& point : points) other.push_back(mirrored(point));
  return other;
}

bool onOneSide(const std::vector<Vec3>& points) {
  const auto left = [](const Vec3& p) { return p.x() > kMirrorGap; };
  const auto right = [](const Vec3& p) { return p.x() < -kMirrorGap; };
  return !points.empty() &&
         (std::all_of(points.begin(), points.end(), left) || std::all_of(points.begin(), points.end(), right));
}

namespace {

bool isSelected(const Part* selected, PartKind kind, size_t number) {
  return selected && selected->kind == kind && selected->number == static_cast<int>(number);
}

/// The boundaries on the body, of a scene that has no garment yet.
void addBoundaryMarks(const Studio& studio, const Part* selected, Marks& marks) {
  for (size_t k = 0; k < studio.made()->loops.size(); ++k) {
    const EdgeCurve& curve = studio.made()->loops[k].curve;
    const bool is_lit = isSelected(selected, PartKind::boundary, k);
    if (!curve.points.empty())
      marks.lines.push_back(
          {placed(curve, studio.stage.body()), true, is_lit ? kHoverColor : kLoopColor, is_lit ? 6.0 : 3.0});
  }
}

/// The edges of the garment: those that are pinned, and the one of the selected boundary or extension, stand out.
void addEdgeMarks(const MadeGarment& made, const Positions& cloth, const Part* selected, Marks& marks) {
  const std::vector<PinScene>& pins = made.scene.garment.pins;
  const auto isPinned = [&](const std::string& loop) {
    return std::any_of(pins.begin(), pins.end(), [&](const PinScene& pin) {
      const auto* name = std::get_if<std::string>(&pin.what);
      return name && *name == loop;
    });
  };
  const auto isLit = [&](const std::string& loop) {
    if (!selected || !made.scene.garment.tools) return false;
    const GarmentTools& tools = *made.scene.garment.tools;
    const size_t k = selected->number;
    if (selected->kind == PartKind::boundary) return k < tools.boundaries.size() && tools.boundaries[k].name == loop;
    if (selected->kind == PartKind::extension) return k < tools.extensions.size() && tools.extensions[k].loop == loop;
    return false;
  };
  for (const NamedLoop& edge : made.edges)
    marks.lines.push_back({positionsOf(edge.vertices, cloth), true,
                           isLit(edge.name)      ? kHoverColor
                           : isPinned(edge.name) ? kPinColor
                                                 : kLoopColor,
                           isLit(edge.name) ? 7.0 : 3.0});
}

/// The strokes of the selected paint or comfort.
void addStrokeMarks(const Stage& stage, PartKind kind, const std::vector<Brush>& strokes, const Part* selected,
                    Marks& marks) {
  const TriangleMesh& mesh = stage.clothAsMade();
  for (size_t k = 0; k < strokes.size(); ++k) {
    if (!isSelected(selected, kind, k)) continue;
    std::vector<Vec3> line = strokes[k].stroke;
    if (line.empty()) line.push_back(strokes[k].at);
    for (Vec3& x : line) x = placeOn(nearestPlace(x, mesh.positions, mesh.triangles), stage.cloth(), mesh.triangles);
    for (const Vec3& x : line) marks.dots.push_back({x, kHoverColor});
    marks.lines.push_back({line, false, kHoverColor, 4.0});
  }
}

}  // namespace

void addPartMarks(const Studio& studio, const Part* selected, Marks& marks) {
  const Stage& stage = studio.stage;
  if (!stage.hasCloth()) {
    if (studio.made()) addBoundaryMarks(studio, selected, marks);
    return;
  }
  const MadeGarment& made = stage.made();
  addEdgeMarks(made, stage.cloth(), selected, marks);
  if (made.input.authored)
    for (size_t k = 0; k < made.input.authored->seams.size(); ++k) {
      const Seam& seam = made.input.authored->seams[k];
      const bool is_lit = isSelected(selected, PartKind::seam, k);
      marks.lines.push_back({positionsOf(seam.vertices, stage.cloth()), seam.is_closed,
                             is_lit ? kHoverColor : kSeamColor, is_lit ? 6.0 : 3.0});
    }
  const std::vector<PinScene>& pins = made.scene.garment.pins;
  for (size_t k = 0; k < pins.size(); ++k) {
    if (!std::holds_alternative<Brush>(pins[k].what)) continue;
    for (const int v : made.input.pins[k])
      marks.dots.push_back({stage.cloth().row(v), isSelected(selected, PartKind::pin, k) ? kHoverColor : kPinColor});
  }
  addStrokeMarks(stage, PartKind::paint, made.scene.garment.paint, selected, marks);
  addStrokeMarks(stage, PartKind::comfort, made.scene.garment.comfort_regions, selected, marks);
}

}  // namespace ease
