#include "viz/mark_actors.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <set>

namespace ease {

namespace {

/// A mark lies on a surface and is drawn in front of it, by about 1 / 65536 of the range of depths for each unit of
/// `offset` below 0: 24 are 1.5 mm at 3 m where 1.5 to 5 m are drawn.  If surfaces were drawn further back instead,
/// they would not hide each other early, and a picture would take the software 30 instead of 23 ms (4,271 vertices on a
/// scan).
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

std::vector<vtkSmartPointer<vtkActor>> markActors(const std::vector<MarkLine>& lines,
                                                  const std::vector<MarkDot>& dots) {
  std::vector<vtkSmartPointer<vtkActor>> actors;
  std::set<double> widths;
  for (const MarkLine& line : lines) widths.insert(line.width);
  for (const double width : widths) actors.push_back(lineActor(lines, width));
  if (!dots.empty()) actors.push_back(dotActor(dots));
  return actors;
}

}  // namespace ease
