#include "viz/flat_picture.h"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "solver/base/error.h"
#include "viz/poly_data.h"
#include "viz/rendered_file.h"

namespace ease {

namespace {

constexpr int kWidth = 1600;                       // pixels
constexpr int kTitleBand = 84, kLegendBand = 124;  // pixels
constexpr int kMargin = 24;                        // pixels

void addSurface(vtkRenderer* renderer, const FlatView& view, const ColorScale& scale) {
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const float value : view.values) colors->InsertNextTypedTuple(scale.color(value).data());
  const auto surface = toPolyData(view.pieces.positions, toCells(view.pieces.triangles));
  surface->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void addLine(vtkRenderer* renderer, const ViewLine& line, double above) {
  std::vector<Vec3> raised = line.points;
  for (Vec3& x : raised) x.z() = above;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(toPolyLine(raised, line.is_closed));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(line.color[0] / 255.0, line.color[1] / 255.0, line.color[2] / 255.0);
  actor->GetProperty()->SetLineWidth(1.6 * kSamplesPerPixel);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

}  // namespace

std::string drawFlat(const std::filesystem::path& file, const FlatView& view, const std::string& label, double low,
                     double high, double limit) {
  try {
    if (view.values.empty() || static_cast<Eigen::Index>(view.values.size()) != view.pieces.triangles.rows())
      throw ComputationError(
          fmt::format("{} values for {} triangles", view.values.size(), view.pieces.triangles.rows()));
    Vec3 lower = view.pieces.positions.colwise().minCoeff(), upper = view.pieces.positions.colwise().maxCoeff();
    for (const ViewLine& line : view.lines)
      for (const Vec3& x : line.points) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
      }
    const Vec3 size = upper - lower;
    const double wanted = (kWidth - 2.0 * kMargin) * size.y() / size.x() + 2.0 * kMargin;
    const int inner = static_cast<int>(std::clamp(wanted, 400.0, 1400.0));
    const int height = inner + kTitleBand + kLegendBand;
    const double zoom = std::min((kWidth - 2.0 * kMargin) / size.x(), (inner - 2.0 * kMargin) / size.y());
    const ColorScale scale(low, high, std::clamp(limit, low, high));
    renderToFile(file, kWidth, height, [&](vtkRenderWindow* window, Overlay& overlay) {
      vtkNew<vtkRenderer> renderer;
      renderer->SetBackground(1, 1, 1);
      addSurface(renderer, view, scale);
      const double above = size.norm();
      for (const ViewLine& line : view.lines) addLine(renderer, line, 1e-3 * above);
      const Vec3 middle = 0.5 * (lower + upper);
      vtkCamera* camera = renderer->GetActiveCamera();
      camera->ParallelProjectionOn();
      camera->SetParallelScale(0.5 * height / zoom);
      const double shift = 0.5 * (kLegendBand - kTitleBand) / zoom;  // the pieces' middle lies above the window's
      camera->SetFocalPoint(middle.x(), middle.y() - shift, 0.0);
      camera->SetPosition(middle.x(), middle.y() - shift, above);
      camera->SetViewUp(0, 1, 0);
      camera->SetClippingRange(0.1 * above, 2.0 * above);
      window->AddRenderer(renderer);
      const auto pixel = [&](const Vec3& x) {
        return std::pair(0.5 * kWidth + zoom * (x.x() - middle.x()),
                         0.5 * height + zoom * (x.y() - middle.y()) + zoom * shift);
      };
      for (const FlatLabel& at : view.labels) {
        const auto [x, y] = pixel(at.at);
        overlay.text(x, y, Align::center, at.words, {at.size, {20, 24, 28}, true});
      }
      const Rgb grey = {110, 114, 118};
      overlay.text(kWidth / 2.0, height - 44, Align::center, view.title, {28, {40, 44, 48}, true});
      overlay.text(kWidth / 2.0, height - 72, Align::center, view.summary, {17, grey});
      drawScaleBar(overlay, scale, label, {kWidth / 2.0 - 360, 68, 720, 20});
    });
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace ease
