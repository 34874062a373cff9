#include "viz/live_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <set>

#include "solver/base/error.h"
#include "viz/kept_image.h"
#include "viz/lights.h"
#include "viz/offscreen.h"
#include "viz/poly_data.h"
#include "viz/quiet.h"

namespace ease {

namespace {

void setColor(vtkActor* actor, const Rgb& color) {
  actor->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
}

/// A mesh whose points, normals and colours change from picture to picture.
class Surface {
 public:
  explicit Surface(const Rgb& color) {
    normals_->SetNumberOfComponents(3);
    mapper_->SetColorModeToDirectScalars();
    mapper_->SetScalarModeToUseCellData();
    actor->SetMapper(mapper_);
    actor->GetProperty()->SetInterpolationToPhong();
    actor->GetProperty()->SetAmbient(0.35);
    actor->GetProperty()->SetDiffuse(0.65);
    actor->GetProperty()->SetEdgeColor(0.25, 0.3, 0.35);
    setColor(actor, color);
    actor->SetVisibility(false);
  }

  void set(const TriangleMesh& mesh) {
    triangles_ = mesh.triangles;
    data_ = toPolyData(mesh.positions, toCells(mesh.triangles));
    data_->GetPointData()->SetNormals(normals_);
    mapper_->SetInputData(data_);
    shown_.resize(0, 3);
    colors_.clear();
    ++changes;
    move(mesh.positions);
    actor->SetVisibility(triangles_.rows() > 0);
  }

  void move(const Positions& x) {
    if (!data_ || x.rows() != data_->GetNumberOfPoints()) return;
    if (shown_.rows() == x.rows() && shown_ == x) return;  // a body that stands still costs nothing
    shown_ = x;
    ++changes;
    auto* points = vtkFloatArray::SafeDownCast(data_->GetPoints()->GetData());
    float* out = points->GetPointer(0);
    for (Eigen::Index i = 0; i < x.size(); ++i) out[i] = static_cast<float>(x.data()[i]);
    points->Modified();
    data_->GetPoints()->Modified();
    turnNormals(x);
    data_->Modified();
  }

  void color(const std::vector<Rgb>& colors) {
    if (!data_ || colors == colors_) return;
    colors_ = colors;
    ++changes;
    if (static_cast<Eigen::Index>(colors.size()) != triangles_.rows()) {
      data_->GetCellData()->SetScalars(nullptr);
      mapper_->ScalarVisibilityOff();
      return;
    }
    vtkNew<vtkUnsignedCharArray> values;
    values->SetNumberOfComponents(3);
    values->SetNumberOfTuples(static_cast<vtkIdType>(colors.size()));
    std::copy_n(colors.front().data(), 3 * colors.size(), values->GetPointer(0));
    data_->GetCellData()->SetScalars(values);
    mapper_->ScalarVisibilityOn();
  }

  vtkNew<vtkActor> actor;
  long changes = 0;  // of triangles, positions and colours so far

 private:
  /// Vertex normals, weighted by the areas of the triangles around.
  void turnNormals(const Positions& x) {
    sums_.setZero(x.rows(), 3);
    for (Eigen::Index t = 0; t < triangles_.rows(); ++t) {
      const auto corners = triangles_.row(t);
      const Vec3 normal = doubleAreaNormal(x.row(corners[0]), x.row(corners[1]), x.row(corners[2]));
      for (int k = 0; k < 3; ++k) sums_.row(corners[k]) += normal;
    }
    normals_->SetNumberOfTuples(x.rows());
    float* out = normals_->GetPointer(0);
    for (Eigen::Index v = 0; v < x.rows(); ++v) {
      const Vec3 normal = sums_.row(v).normalized();
      for (int k = 0; k < 3; ++k) *out++ = static_cast<float>(normal[k]);
    }
    normals_->Modified();
  }

  Triangles triangles_;
  Positions shown_, sums_;
  std::vector<Rgb> colors_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkPolyData> data_;
};

/// A mark lies on a surface and is drawn in front of it, by 1 / 65536 of the range of depths for each unit of `offset`
/// below 0: 24 are 1.5 mm at 3 m.  Surfaces that were drawn behind where they are would not hide each other early,
/// which takes the software half as long again.
vtkSmartPointer<vtkActor> markActor(vtkPolyData* data, double offset) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetColorModeToDirectScalars();
  mapper->SetScalarModeToUseCellData();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, offset);
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(offset);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// All lines of one width: an actor costs more than its lines.
vtkSmartPointer<vtkActor> lineActor(const std::vector<MarkLine>& lines, double width) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const MarkLine& line : lines) {
    if (line.width != width || line.points.size() < 2) continue;
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Vec3& x : line.points) points->InsertNextPoint(x.data());
    const auto count = static_cast<vtkIdType>(line.points.size()), ends = count + (line.is_closed ? 1 : 0);
    cells->InsertNextCell(static_cast<int>(ends));
    for (vtkIdType i = 0; i < ends; ++i) cells->InsertCellPoint(first + i % count);
    colors->InsertNextTypedTuple(line.color.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetCellData()->SetScalars(colors);
  auto actor = markActor(data, -24);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  return actor;
}

vtkSmartPointer<vtkActor> dotActor(const std::vector<MarkDot>& dots) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const MarkDot& dot : dots) {
    const vtkIdType id = points->InsertNextPoint(dot.at.data());
    cells->InsertNextCell(1, &id);
    colors->InsertNextTypedTuple(dot.color.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(cells);
  data->GetCellData()->SetScalars(colors);
  auto actor = markActor(data, -40);
  actor->GetProperty()->SetPointSize(10);
  actor->GetProperty()->RenderPointsAsSpheresOn();
  return actor;
}

}  // namespace

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
  Surface body{kBodyColor}, garment{kClothColor};
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
  parts_->marks.clear();
  std::set<double> widths;
  for (const MarkLine& line : lines) widths.insert(line.width);
  for (const double width : widths) parts_->marks.push_back(lineActor(lines, width));
  if (!dots.empty()) parts_->marks.push_back(dotActor(dots));
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
