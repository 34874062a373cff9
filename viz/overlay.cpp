#include "viz/overlay.h"

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace ease {

Overlay::Overlay(int scale) : scale_(scale), renderer_(vtkSmartPointer<vtkRenderer>::New()) {
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
}

void Overlay::text(double x, double y, Align align, const std::string& words, const TextStyle& style) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(words.c_str());
  actor->SetTextScaleModeToNone();
  actor->SetPosition(scale_ * x, scale_ * y);
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(scale_ * style.size);
  property->SetBold(style.bold);
  property->SetColor(style.color[0] / 255.0, style.color[1] / 255.0, style.color[2] / 255.0);
  if (align == Align::center) property->SetJustificationToCentered();
  renderer_->AddViewProp(actor);
}

void Overlay::boxes(const std::vector<Box>& boxes, const std::vector<Rgb>& colors) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> quad_colors;
  quad_colors->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& box = boxes[i];
    quads->InsertNextCell(4);
    for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      quads->InsertCellPoint(
          points->InsertNextPoint(scale_ * (box.x + right * box.width), scale_ * (box.y + up * box.height), 0.0));
    }
    quad_colors->InsertNextTypedTuple(colors[i].data());
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(quads);
  mesh->GetCellData()->SetScalars(quad_colors);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  renderer_->AddViewProp(actor);
}

void drawScaleBar(Overlay& overlay, const ColorScale& scale, const std::string& label, const Box& box) {
  const Rgb ink = {40, 44, 48};
  const double range = scale.high() - scale.low();
  const auto xOf = [&](double value) { return box.x + box.width * (value - scale.low()) / range; };

  const int columns = static_cast<int>(box.width);
  std::vector<Box> bar;
  std::vector<Rgb> bar_colors;
  for (int i = 0; i < columns; ++i) {
    bar.push_back({box.x + i, box.y, 1, box.height});
    bar_colors.push_back(scale.color(scale.low() + range * (i + 0.5) / columns));
  }
  overlay.boxes(bar, bar_colors);

  std::vector<Box> marks = {{box.x - 1, box.y - 1, box.width + 2, 1},
                            {box.x - 1, box.y + box.height, box.width + 2, 1},
                            {box.x - 1, box.y, 1, box.height},
                            {box.x + box.width, box.y, 1, box.height}};
  const double step = tickStep(range, 8);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  for (double k = std::ceil(scale.low() / step - 1e-9) + 0.0; k * step <= scale.high() + 1e-9 * range; ++k) {
    marks.push_back({xOf(k * step) - 0.75, box.y - 7, 1.5, 6});
    overlay.text(xOf(k * step), box.y - 25, Align::center, fmt::format("{:.{}f}", k * step, decimals), {16, ink});
  }
  if (scale.limit() > scale.low() && scale.limit() < scale.high()) {
    marks.push_back({xOf(scale.limit()) - 1, box.y - 1, 2, box.height + 9});
    overlay.text(xOf(scale.limit()), box.y + box.height + 13, Align::center, fmt::format("limit {:g}", scale.limit()),
                 {16, ink, true});
  }
  overlay.boxes(marks, std::vector<Rgb>(marks.size(), ink));
  overlay.text(box.x + box.width / 2, box.y - 50, Align::center, label, {17, ink});
}

}  // namespace ease
