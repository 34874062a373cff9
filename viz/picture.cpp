#include "viz/picture.h"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>

#include "solver/base/error.h"
#include "viz/color_scale.h"
#include "viz/lights.h"
#include "viz/live_surface.h"
#include "viz/live_view.h"
#include "viz/overlay.h"
#include "viz/poly_data.h"
#include "viz/rendered_file.h"

namespace ease {

namespace {

constexpr int kWidth = 1600, kHeight = 1000;       // pixels
constexpr int kTitleBand = 84, kLegendBand = 124;  // pixels
constexpr int kGutter = 8;                         // pixels, white margin on the left and right of a view
constexpr double kViewAngle = 16;                  // degrees, over the whole height

void checkViews(const std::vector<StretchView>& views, double low, double high) {
  if (views.empty()) throw ComputationError("nothing to draw");
  if (!(low < high)) throw ComputationError(fmt::format("empty range of colours {}..{}", low, high));
  for (const StretchView& view : views) {
    if (static_cast<Eigen::Index>(view.values.size()) != view.garment->triangles.rows() || view.values.empty()) {
      throw ComputationError(fmt::format("view {}: {} values for {} triangles", view.title, view.values.size(),
                                         view.garment->triangles.rows()));
    }
  }
}

vtkSmartPointer<vtkActor> garmentActor(const StretchView& view, const ColorScale& scale) {
  LiveSurface surface(LiveView::kClothColor);
  surface.set(*view.garment);
  std::vector<Rgb> colors;
  for (float value : view.values) colors.push_back(scale.color(value));
  surface.color(colors);
  return surface.actor.Get();
}

vtkSmartPointer<vtkActor> bodyActor(const TriangleMesh& body) {
  LiveSurface surface(LiveView::kBodyColor);
  surface.set(body);
  surface.actor->GetProperty()->BackfaceCullingOn();  // a body is closed: nobody sees its inside
  return surface.actor.Get();
}

/// Makes an actor that draws a line.  The garment that it lies on does not hide it, but what is in front of both does.
vtkSmartPointer<vtkActor> lineActor(const ViewLine& line) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(toPolyLine(line.points, line.is_closed));
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(line.color[0] / 255.0, line.color[1] / 255.0, line.color[2] / 255.0);
  actor->GetProperty()->SetLineWidth(2.5 * kSamplesPerPixel);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// The part of space that every view must show: the bounding box of all garments, m.
struct Extent {
  Vec3 center, size;
};

Extent garmentExtent(const std::vector<StretchView>& views) {
  Vec3 lower = views.front().garment->positions.colwise().minCoeff();
  Vec3 upper = views.front().garment->positions.colwise().maxCoeff();
  for (const StretchView& view : views) {
    lower = lower.cwiseMin(view.garment->positions.colwise().minCoeff().transpose());
    upper = upper.cwiseMax(view.garment->positions.colwise().maxCoeff().transpose());
  }
  return {(lower + upper) / 2, 1.12 * (upper - lower)};
}

/// Places the camera a little above the garment.  It looks along -z at the front, since the wearer faces +z, or along
/// +z at the back.
void placeCamera(vtkRenderer* renderer, const Extent& extent, const Box& box, bool from_behind) {
  const double half_height = std::max(extent.size.y(), extent.size.x() * box.height / box.width) / 2;
  const double distance = half_height / std::tan(kViewAngle / 2 * M_PI / 180) + extent.size.z() / 2;
  const Vec3 towards = Vec3(0, 0.1, from_behind ? -1 : 1).normalized();
  const Vec3 eye = extent.center + distance * towards;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(extent.center.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(kViewAngle);
  renderer->ResetCameraClippingRange();
}

using Actors = std::vector<vtkSmartPointer<vtkActor>>;

/// Makes what each view shows.  A body that several show is made and handed to OpenGL once.
std::vector<Actors> makeActors(const std::vector<StretchView>& views, const ColorScale& scale) {
  std::vector<Actors> made;
  std::map<const TriangleMesh*, vtkSmartPointer<vtkActor>> bodies;
  for (const StretchView& view : views) {
    Actors& actors = made.emplace_back(Actors{garmentActor(view, scale)});
    if (view.body && !bodies[view.body]) bodies[view.body] = bodyActor(*view.body);
    if (view.body) actors.push_back(bodies[view.body]);
    for (const ViewLine& line : view.lines) actors.push_back(lineActor(line));
  }
  return made;
}

void addScene(vtkRenderWindow* window, const Actors& actors, const Extent& extent, const Box& box, bool from_behind) {
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport((box.x + kGutter) / kWidth, box.y / kHeight, (box.x + box.width - kGutter) / kWidth,
                        (box.y + box.height) / kHeight);
  renderer->SetBackground(1, 1, 1);
  for (const auto& actor : actors) renderer->AddActor(actor);
  addLights(renderer);
  placeCamera(renderer, extent, box, from_behind);
  window->AddRenderer(renderer);
}

/// Divides a panel into the boxes of the front and the back view: side by side or one above the other, whichever shows
/// the garment larger.
std::pair<Box, Box> splitPanel(const Box& panel, const Extent& extent) {
  const auto zoom = [&](const Box& box) { return std::min(box.width / extent.size.x(), box.height / extent.size.y()); };
  const Box left = {panel.x, panel.y, panel.width / 2, panel.height};
  const Box lower = {panel.x, panel.y, panel.width, panel.height / 2};
  if (zoom(left) > zoom(lower)) return {left, {panel.x + panel.width / 2, panel.y, panel.width / 2, panel.height}};
  return {{panel.x, panel.y + panel.height / 2, panel.width, panel.height / 2}, lower};
}

std::string summary(const StretchView& view, const ColorScale& scale) {
  if (!view.summary.empty()) return view.summary;
  const auto over = std::count_if(view.values.begin(), view.values.end(), [&](float v) { return scale.isOver(v); });
  return fmt::format("largest {:.2f}, {:.1f} % of triangles over the limit",
                     *std::max_element(view.values.begin(), view.values.end()),
                     100.0 * static_cast<double>(over) / static_cast<double>(view.values.size()));
}

void compose(vtkRenderWindow* window, Overlay& overlay, const std::vector<StretchView>& views, const ColorScale& scale,
             const std::string& label) {
  const Rgb grey = {110, 114, 118};
  vtkNew<vtkRenderer> paper;  // behind all others
  paper->SetBackground(1, 1, 1);
  window->AddRenderer(paper);
  const Extent extent = garmentExtent(views);
  const std::vector<Actors> actors = makeActors(views, scale);
  const double width = static_cast<double>(kWidth) / static_cast<double>(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Box panel = {static_cast<double>(i) * width, kLegendBand, width, kHeight - kLegendBand - kTitleBand};
    const auto [front, back] = splitPanel(panel, extent);
    addScene(window, actors[i], extent, front, false);
    addScene(window, actors[i], extent, back, true);
    overlay.text(front.x + 24, front.y + 18, Align::left, "front", {15, grey});
    overlay.text(back.x + 24, back.y + 18, Align::left, "back", {15, grey});
    const double middle = panel.x + width / 2;
    overlay.text(middle, kHeight - 44, Align::center, views[i].title, {28, {40, 44, 48}, true});
    overlay.text(middle, kHeight - 72, Align::center, summary(views[i], scale), {17, grey});
    if (i > 0) overlay.boxes({{panel.x - 0.5, panel.y, 1, panel.height + 60}}, {{205, 208, 211}});
  }
  drawScaleBar(overlay, scale, label, {kWidth / 2.0 - 360, 68, 720, 20});
}

}  // namespace

std::string drawStretch(const std::filesystem::path& file, const std::vector<StretchView>& views,
                        const std::string& label, double low, double high, double limit) {
  try {
    checkViews(views, low, high);
    const ColorScale scale(low, high, std::clamp(limit, low, high));
    renderToFile(file, kWidth, kHeight,
                 [&](vtkRenderWindow* window, Overlay& overlay) { compose(window, overlay, views, scale, label); });
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace ease
