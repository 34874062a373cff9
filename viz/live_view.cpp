#include "viz/live_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>

#include "solver/base/error.h"
#include "viz/kept_image.h"
#include "viz/lights.h"
#include "viz/live_surface.h"
#include "viz/mark_actors.h"
#include "viz/offscreen.h"
#include "viz/quiet.h"

namespace ease {

/// What a picture of the body alone depends on.
struct BodyView {
  Camera camera;
  PictureSize size{0, 0};
  std::array<double, 2> clipping = {0.0, 0.0};  // distances from the eye between which things are drawn, m
  long changes = -1;                            // of the body
  bool operator==(const BodyView&) const = default;
};

struct LiveView::Parts {
  explicit Parts(Renderer kind) : context(kind) {}

  /// Sets the distances between which things are drawn: as they were while all is between them and the camera stands
  /// still, so that depths can be compared with those of an earlier picture.
  std::array<double, 2> setClipping(const Camera& camera) {
    renderer->ResetCameraClippingRange();
    std::array<double, 2> needed{};
    renderer->GetActiveCamera()->GetClippingRange(needed.data());
    const std::array<double, 2> last = before.clipping;
    const bool holds = camera == before.camera && last[0] <= needed[0] && needed[1] <= last[1];
    std::array<double, 2> range = holds ? last : std::array<double, 2>{0.95 * needed[0], 1.05 * needed[1]};
    renderer->GetActiveCamera()->SetClippingRange(range.data());
    return range;
  }

  /// Draws the body without the rest.
  void drawBody() {
    const bool has_garment = garment.actor->GetVisibility() != 0;
    garment.actor->SetVisibility(false);
    for (const auto& mark : marks) mark->SetVisibility(false);
    window->Render();
    for (const auto& mark : marks) mark->SetVisibility(true);
    garment.actor->SetVisibility(has_garment);
  }

  /// Draws all but the body over the image of it that was kept.
  void drawOverBody() {
    body_image.put(*window);
    body.actor->SetVisibility(false);
    renderer->PreserveColorBufferOn();
    renderer->PreserveDepthBufferOn();
    window->Render();
    renderer->PreserveColorBufferOff();
    renderer->PreserveDepthBufferOff();
    body.actor->SetVisibility(true);
  }

  /// A body that stands still is drawn twice, the second time alone, and then no more.
  void drawAll(const BodyView& view) {
    const bool stands = view == before && body.actor->GetVisibility();
    before = view;
    if (stands && !(view == kept)) {
      drawBody();
      body_image.take(*window);
      kept = view;
    }
    if (stands)
      drawOverBody();
    else
      window->Render();
  }

  OffscreenContext context;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  LiveSurface body{kBodyColor}, garment{kClothColor};
  std::vector<vtkSmartPointer<vtkActor>> marks;
  std::vector<MarkLine> lines;  // of which the marks are made
  std::vector<MarkDot> dots;
  Picture picture;
  vtkNew<vtkUnsignedCharArray> pixels;
  BodyView before, kept;  // of the picture before, and of the image
  KeptImage body_image;
};

LiveView::LiveView(Renderer kind) : parts_(std::make_unique<Parts>(kind)) {
  const Quiet quiet;
  vtkGenericOpenGLRenderWindow* window = parts_->window;
  parts_->context.lend(*window);
  window->SetMultiSamples(parts_->context.isSoftware() ? 0 : 4);  // in software they take three times as long
  window->SetSize(64, 64);
  window->OpenGLInitContext();
  vtkRenderer* renderer = parts_->renderer;
  renderer->SetBackground(0.97, 0.97, 0.96);
  parts_->body.actor->GetProperty()->BackfaceCullingOn();  // a body is closed: nobody sees its inside
  renderer->AddActor(parts_->body.actor);
  renderer->AddActor(parts_->garment.actor);
  addLights(renderer);
  window->AddRenderer(renderer);
}

LiveView::~LiveView() {
  const Quiet quiet;
  parts_->context.makeCurrent();
  parts_->body_image.release(*parts_->window);
  parts_->window->Finalize();
}

void LiveView::setBody(const TriangleMesh& body) {
  parts_->body.set(body);
}

void LiveView::setGarment(const TriangleMesh& garment) {
  parts_->garment.set(garment);
}

void LiveView::moveBody(const Positions& positions) {
  parts_->body.move(positions);
}

void LiveView::moveGarment(const Positions& positions) {
  parts_->garment.move(positions);
}

void LiveView::colorGarment(const std::vector<Rgb>& colors) {
  parts_->garment.color(colors);
}

void LiveView::colorBody(const std::vector<Rgb>& colors) {
  parts_->body.color(colors);
}

void LiveView::showBody(bool is_shown) {
  parts_->body.actor->SetVisibility(is_shown);
}

void LiveView::showEdges(bool are_shown) {
  parts_->garment.actor->GetProperty()->SetEdgeVisibility(are_shown);
}

void LiveView::setMarks(const std::vector<MarkLine>& lines, const std::vector<MarkDot>& dots) {
  if (lines == parts_->lines && dots == parts_->dots) return;
  parts_->lines = lines;
  parts_->dots = dots;
  parts_->context.makeCurrent();
  for (const auto& actor : parts_->marks) parts_->renderer->RemoveActor(actor);
  parts_->marks = markActors(lines, dots);
  for (const auto& actor : parts_->marks) parts_->renderer->AddActor(actor);
}

const Picture& LiveView::draw(const Camera& camera, const PictureSize& size) {
  const Quiet quiet;
  parts_->context.makeCurrent();
  vtkCamera* view = parts_->renderer->GetActiveCamera();
  view->SetFocalPoint(camera.focus.data());
  view->SetPosition(camera.eye().data());
  view->SetViewUp(camera.up().data());
  view->SetViewAngle(camera.view_angle_deg);
  parts_->window->SetSize(size.width, size.height);
  const std::array<double, 2> clipping = parts_->setClipping(camera);
  parts_->drawAll({camera, size, clipping, parts_->body.changes});
  parts_->window->GetRGBACharPixelData(0, 0, size.width - 1, size.height - 1, 0, parts_->pixels);
  const auto count = static_cast<std::size_t>(4) * size.width * size.height;
  if (static_cast<std::size_t>(parts_->pixels->GetNumberOfValues()) != count)
    throw ComputationError("OpenGL gave no pixels back");
  parts_->picture.size = size;
  const unsigned char* first = parts_->pixels->GetPointer(0);
  parts_->picture.pixels.assign(first, first + count);
  return parts_->picture;
}

}  // namespace ease
